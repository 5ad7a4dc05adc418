// A case of the gap benchmark: runs of one robot with something hidden in it, and the answer.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/log/drive_log.hpp"
#include "tests/support/gap_plant/drive_program.hpp"
#include "tests/support/gap_plant/hidden_effect.hpp"

namespace wheelwright::test {

// What is logged. `sparse`: a reference pose on every 25th row; `ends`: on the first and the last row only.
enum class Channels { ticks, ticks_ref, ticks_sparse, ticks_ends, ref, sparse };

// "ticks", "ticks+ref", "ticks+sparse", "ends" (with ticks), "ref", "sparse".
std::string_view name_of(Channels channels);
std::optional<Channels> channels_named(std::string_view name);

struct GapCaseSpec {
  std::string name = "clean";  // "clean", or names of hidden_effects() joined by "+"
  Severity severity = Severity::medium;
  Channels channels = Channels::ticks_ref;
  Program program = Program::mixed;
  std::uint64_t seed = 1;
  int runs = 5;
  double seconds = 75.0;  // of a run
  double period_s = 0.018;
  bool battery = true;
  bool gyro = false;

  std::string folder_name() const;
};

struct HiddenInCase {
  const HiddenEffect* effect = nullptr;
  double size = 0.0;
  std::string how;                     // the physical way that was chosen
  std::optional<std::string> why_not;  // these logs cannot show it; absent where they can
};

// What a careful person would answer.
enum class Expected {
  nothing_missing,
  named,      // with all effects that the logs can show
  unnamed,    // something that no library holds
  not_named,  // hidden where the logs cannot show it: any answer that gives no name
};

std::string_view name_of(Expected expected);

struct GapCase {
  GapCaseSpec spec;
  std::vector<DriveLog> runs;
  std::vector<HiddenInCase> hidden;
  Expected expected = Expected::nothing_missing;
};

// Throws std::invalid_argument where the name is not known.
GapCase make_gap_case(const GapCaseSpec& spec);

}  // namespace wheelwright::test
