// A drive beside the poses that something saw of it, for tests.
#pragma once

#include <cmath>
#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "tests/unit/tools/wheelwright/import/import_text.hpp"

namespace wheelwright::test {

inline const std::vector<std::string> seen_settings{"robot.wheel_base_m=0.3",
                                                    "wheels.metres_per_count=0.0005"};

// A field of a row and the comma before it.
inline std::string field(double value) {
  std::string text = ",";
  text += number(value);
  return text;
}

// `pose` are the fields of a row from their first comma on.
inline ImportOutcome import_seen(const ForeignDrive& drive, const std::string& names,
                                 const std::function<std::string(const ForeignRow&)>& pose,
                                 const std::vector<std::string>& settings = seen_settings) {
  return import_text(foreign_text(drive, "t,cmd_left,cmd_right,enc_left,enc_right," + names,
                                  [&](const ForeignRow& row) {
                                    return number(row.t_s) + "," + number(row.command_left) + "," +
                                           number(row.command_right) + "," + counts(row) + pose(row);
                                  }),
                     settings);
}

// Places, and headings where there are any, are those of the drive, but for a shift and a turn of the floor.
inline void check_seen(const ImportOutcome& outcome, const ForeignDrive& drive, double tolerance_m = 1e-3) {
  if (!outcome.conversion) FAIL(outcome.conversion.error());
  const DriveLog& log = outcome.conversion->runs.front();
  REQUIRE(log.samples.size() == drive.rows.size());
  std::complex<double> seen_mean;
  std::complex<double> true_mean;
  double count = 0.0;
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    if (!log.samples[k].reference_x_m || !log.samples[k].reference_y_m) continue;
    seen_mean += std::complex(*log.samples[k].reference_x_m, *log.samples[k].reference_y_m);
    true_mean += std::complex(drive.rows[k].x, drive.rows[k].y);
    count += 1.0;
  }
  REQUIRE(count > 20.0);
  std::complex<double> turn;
  const auto apart = [&](std::size_t k) {
    const std::complex seen(*log.samples[k].reference_x_m, *log.samples[k].reference_y_m);
    return std::pair(seen - seen_mean / count,
                     std::complex(drive.rows[k].x, drive.rows[k].y) - true_mean / count);
  };
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    if (!log.samples[k].reference_x_m || !log.samples[k].reference_y_m) continue;
    turn += apart(k).first * std::conj(apart(k).second);
  }
  double worst_m = 0.0;
  double worst_rad = 0.0;
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    const DriveSample& sample = log.samples[k];
    if (!sample.reference_x_m || !sample.reference_y_m) continue;
    const auto [seen, truth] = apart(k);
    worst_m = std::max(worst_m, std::abs(seen - truth * turn / std::abs(turn)));
    if (!sample.reference_theta_rad) continue;
    const double off = *sample.reference_theta_rad - drive.rows[k].theta - std::arg(turn);
    worst_rad = std::max(worst_rad, std::abs(std::remainder(off, 2.0 * 3.14159265358979)));
  }
  CHECK(worst_m < tolerance_m);
  CHECK(worst_rad < 0.01);
}

}  // namespace wheelwright::test
