// What is wrong with a log before any model is asked: faults of the data are not effects.
//
// Rows that cannot be true are taken out and named; counts that stand still while their wheel turns, or of
// which a part or all is missing, are a dropout of the encoder; signs, sides and units that contradict the
// commands explain a gap on their own, and no effect is looked for behind them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "model/gap/runs/run.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright::gap {

struct DataFault {
  std::string log;
  std::size_t row = 0;  // line of the file
  std::string what;
  bool distorts = false;  // any model fitted to this row would be wrong
  bool explains = false;  // the columns do not mean what they say: no effect can be judged
  bool happened = false;  // true of the robot: no fault of the data
  std::string treatment;  // what the gate did about it; empty where nothing

  std::string text() const { return treatment.empty() ? what : what + "; " + treatment; }
};

struct Dropout {
  double start_s = 0.0;
  double duration_s = 0.0;
};

// Of travel that counts seem to have lost, what references saw the wheels roll: near `lost_m` where counts
// were lost indeed, near zero where the wheels were held.
struct SeenRolling {
  double lost_m = 0.0;
  double rolled_m = 0.0;

  SeenRolling& operator+=(const SeenRolling& other);
};

// Of the counters of one run or several.
struct CounterEvidence {
  std::size_t surely_frozen = 0;  // so often counts stood still in the midst of driving
  SeenRolling frozen;             // where counts stand still
  SeenRolling thinned;            // where they miss edges

  bool tells_anything() const { return surely_frozen > 0 || frozen.lost_m > 0.0 || thinned.lost_m > 0.0; }
  CounterEvidence& operator+=(const CounterEvidence& other);
};

struct GatedLog {
  DriveLog log;  // without the rows that cannot be true
  RowFlags flags;
  std::vector<DataFault> faults;
  std::vector<Dropout> dropouts;
  CounterEvidence counters;
};

GatedLog gate(const DriveLog& log);

// Runs of one robot. Where counts surely froze more than once, they may have frozen at turns and stops as
// well, in every run; what froze once may be a wheel that something held. Whether counts were lost or wheels
// held, the references of all runs decide together: those of one may see too few.
std::vector<GatedLog> gate_together(std::span<const DriveLog> logs);

}  // namespace wheelwright::gap
