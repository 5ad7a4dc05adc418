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

struct GatedLog {
  DriveLog log;  // without the rows that cannot be true
  RowFlags flags;
  std::vector<DataFault> faults;
  std::vector<Dropout> dropouts;
  std::size_t surely_frozen = 0;  // of the dropouts: counts stood still in the midst of driving
};

GatedLog gate(const DriveLog& log);

// Runs of one robot. Where counts surely froze more than once, they may have frozen at turns and stops as
// well, in every run; what froze once may be a wheel that something held.
std::vector<GatedLog> gate_together(std::span<const DriveLog> logs);

}  // namespace wheelwright::gap
