// What `wheelwright doctor` found out: one line per check, and the verdict over all of them.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace wheelwright::tools::doctor {

enum class State : std::uint8_t {
  ok,
  attention,   // it will drive, but something is not as good as it could be
  failed,      // it will not drive, or not as configured
  not_tested,  // could not be looked at, or was not asked for
};

struct Finding {
  std::string check;
  std::string text;  // what was found, with its unit
  State state = State::ok;
  std::string remedy;                                       // one line; empty where there is nothing to do
  std::vector<std::pair<std::string, double>> values = {};  // for machines; the unit ends each name
};

struct Verdict {
  bool fit_to_drive = false;
  std::string sentence;
};

// Fit to drive where nothing failed.
Verdict verdict_on(const std::vector<Finding>& findings);

// A table, then a line of remedy for each finding that has one, then the verdict.
void print_report(std::ostream& out, const std::vector<Finding>& findings, bool coloured);

// The same as one JSON object.
void print_json(std::ostream& out, const std::string& device, const std::vector<Finding>& findings);

}  // namespace wheelwright::tools::doctor
