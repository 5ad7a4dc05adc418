// From the text of a foreign log to runs, for tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/foreign_drive.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/wheelwright/import/import_files.hpp"

namespace wheelwright::test {

inline std::string number(double value) {
  return std::to_string(value);
}

inline std::filesystem::path file_of(const std::string& name, const std::string& text) {
  const auto path = temporary_folder() / ("wheelwright_import_" + name);
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

inline bool has_words(const std::vector<std::string>& lines, const std::string& words) {
  return std::ranges::any_of(lines,
                             [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

struct ImportOutcome {
  import::Understood understood;
  tl::expected<import::Conversion, std::string> conversion;

  bool found(const std::string& words) const { return has_words(understood.inference.findings, words); }
  bool doubts(const std::string& words) const { return has_words(understood.inference.doubts, words); }
  bool remarks(const std::string& words) const { return conversion && has_words(conversion->remarks, words); }
};

inline ImportOutcome import_text(const std::string& text, const std::vector<std::string>& settings = {}) {
  auto understood =
      import::understand({{file_of("log.txt", text)}, std::nullopt, import::GivenMapping("", settings)});
  REQUIRE(understood);
  auto conversion = import::to_runs(*understood);
  return {std::move(*understood), std::move(conversion)};
}

// Commands and counts of the run are those of the drive.
inline void check_same(const ImportOutcome& outcome, const ForeignDrive& drive,
                       double command_tolerance_m_s = 1e-3, double scale_tolerance = 0.02) {
  if (!outcome.conversion) FAIL(outcome.conversion.error());
  REQUIRE(outcome.conversion->runs.size() == 1);
  const DriveLog& log = outcome.conversion->runs.front();
  REQUIRE(log.samples.size() == drive.rows.size());
  REQUIRE(log.has_ticks());
  CHECK_THAT(log.period_s, WithinRel(drive.period_s, 0.01));
  CHECK_THAT(log.samples.back().t_s, WithinRel(drive.rows.back().t_s, 0.001));
  const auto& last = drive.rows.back();
  const auto metres = [&](std::int64_t WheelTicks::*side, double WheelPair::*scale) {
    return static_cast<double>((*log.samples.back().ticks).*side - (*log.samples.front().ticks).*side) *
           (*log.metres_per_tick).*scale;
  };
  CHECK_THAT(
      metres(&WheelTicks::left, &WheelPair::left),
      WithinRel(static_cast<double>(last.counts_left) * ForeignDrive::metres_per_count, scale_tolerance));
  CHECK_THAT(
      metres(&WheelTicks::right, &WheelPair::right),
      WithinRel(static_cast<double>(last.counts_right) * ForeignDrive::metres_per_count, scale_tolerance));
  double worst = 0.0;
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    worst = std::max(worst, std::abs(log.samples[k].command_m_s.left - drive.rows[k].command_left));
    worst = std::max(worst, std::abs(log.samples[k].command_m_s.right - drive.rows[k].command_right));
  }
  CHECK(worst < command_tolerance_m_s);
}

inline std::string counts(const ForeignRow& row) {
  return std::to_string(row.counts_left) + "," + std::to_string(row.counts_right);
}

}  // namespace wheelwright::test
