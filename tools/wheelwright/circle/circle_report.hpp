// What came of the circle, for a person: hidden, named, offset before and after.
#pragma once

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tools/wheelwright/circle/hidden_robot.hpp"

namespace wheelwright::tools {

// The route, driven several times by one model.
struct Laps {
  std::vector<double> offsets_m;  // of those that came to their end
  std::size_t stopped = 0;        // that did not
  std::string failure;            // why the last of those did not
};

// A drive that the workflow asked for because it could not decide.
struct Experiment {
  std::string manoeuvre;
  double seconds = 0.0;
  std::vector<std::string> separates;
  std::string failure;  // why it did not come to its end
};

// Drives of the route and of tours, which a model drove itself and was not made from.
struct OwnDrives {
  std::optional<double> error_m;  // of its free run against the reference position, over those that ended
  std::size_t stopped = 0;        // that did not come to their end
  std::string failure;            // why the last of those did not
};

// The found model drives the route only if it is closer over drives of its own, and is stopped no more often.
struct Proof {
  OwnDrives calibrated;
  OwnDrives found;

  bool is_better() const {
    return found.error_m && found.stopped <= calibrated.stopped &&
           (!calibrated.error_m || *found.error_m < *calibrated.error_m);
  }
};

struct CircleReport {
  std::string sealed_file;
  std::vector<Imperfection> hidden;
  // What the robot has of its own, and what the calibration got wrong on it: right names, which nobody has
  // to find.
  std::vector<Imperfection> not_hidden;
  std::vector<Experiment> experiments;
  std::string verdict;             // of the gap workflow, at last
  std::vector<std::string> named;  // effects, the strongest first
  Laps before;
  Proof proof;
  Laps after;
};

// Of the metres per tick on the robot, beside the true ones; nothing where it is of no consequence.
std::optional<Imperfection> scale_error(double calibrated_m, double true_m);

// How many imperfections were named under one of their names, and how many names belong to none, nor to an
// error of the calibration.
struct NamingScore {
  std::size_t right = 0;
  std::size_t wrong = 0;
};
NamingScore naming_score(const CircleReport& report);

void print_circle(std::ostream& out, const CircleReport& report);

// Keys: before, after {offsets_m, mean_offset_m, stopped, failure}, proof {calibrated_m, found_m,
// calibrated_stopped, found_stopped, drives}, experiments [{manoeuvre, seconds, separates, failure}],
// verdict, named, hidden [{what, effects}], not_hidden [{what, effects}], sealed_file, named_rightly,
// named_falsely. Where no lap came to its end the mean is null, where all did the failure is.
nlohmann::ordered_json circle_json(const CircleReport& report);

}  // namespace wheelwright::tools
