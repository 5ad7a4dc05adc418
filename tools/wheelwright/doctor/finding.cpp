#include "tools/wheelwright/doctor/finding.hpp"

#include <algorithm>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string_view>

#include "tools/wheelwright/common/json_text.hpp"
#include "tools/wheelwright/common/printable_stream.hpp"

namespace wheelwright::tools::doctor {
namespace {

std::string word_for(State state) {
  switch (state) {
    case State::ok:
      return "ok";
    case State::attention:
      return "attention";
    case State::failed:
      return "failed";
    case State::not_tested:
      return "-";
  }
  return "-";
}

std::string_view colour_of(State state) {
  switch (state) {
    case State::ok:
      return "\033[32m";
    case State::attention:
      return "\033[33m";
    case State::failed:
      return "\033[31m";
    case State::not_tested:
      return "";
  }
  return "";
}

void put_word(std::ostream& out, State state, bool coloured) {
  coloured = coloured && state != State::not_tested;
  if (coloured) put_escape_sequence(out, colour_of(state));
  out << word_for(state);
  if (coloured) put_escape_sequence(out, "\033[0m");
}

// "baud", "baud and battery", "baud, battery and mode"; empty where no finding is in this state.
std::string checks_in(State state, const std::vector<Finding>& findings) {
  std::vector<std::string> names;
  for (const auto& finding : findings) {
    if (finding.state == state) names.push_back(finding.check);
  }
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
    text += names[i];
  }
  return text;
}

}  // namespace

Verdict verdict_on(const std::vector<Finding>& findings) {
  const std::string failed = checks_in(State::failed, findings);
  const std::string attention = checks_in(State::attention, findings);
  const std::string untested = checks_in(State::not_tested, findings);
  if (!failed.empty()) return {false, "Not fit to drive: see " + failed + "."};
  std::string sentence = "Fit to drive";
  if (!attention.empty()) sentence += ", but have a look at " + attention;
  if (!untested.empty()) sentence += (attention.empty() ? ", " : "; ") + untested + " not tested";
  return {true, sentence + "."};
}

void print_report(std::ostream& out, const std::vector<Finding>& findings, bool coloured) {
  std::size_t check_width = 0;
  std::size_t text_width = 0;
  for (const auto& finding : findings) {
    check_width = std::max(check_width, finding.check.size());
    text_width = std::max(text_width, finding.text.size());
  }
  for (const auto& finding : findings) {
    out << "  " << std::left << std::setw(static_cast<int>(check_width)) << finding.check << "  "
        << std::setw(static_cast<int>(text_width)) << finding.text << "  ";
    put_word(out, finding.state, coloured);
    out << "\n";
  }
  bool first = true;
  for (const auto& finding : findings) {
    if (finding.remedy.empty()) continue;
    out << (first ? "\nWhat to do\n" : "") << "  " << finding.check << ": " << finding.remedy << "\n";
    first = false;
  }
  out << "\n" << verdict_on(findings).sentence << "\n";
}

void print_json(std::ostream& out, const std::string& device, const std::vector<Finding>& findings) {
  const Verdict verdict = verdict_on(findings);
  nlohmann::ordered_json checks = nlohmann::ordered_json::array();
  for (const auto& finding : findings) {
    nlohmann::ordered_json check = {{"check", finding.check}, {"finding", finding.text}};
    check["state"] = finding.state == State::not_tested ? "not tested" : word_for(finding.state);
    if (!finding.remedy.empty()) check["remedy"] = finding.remedy;
    for (const auto& [name, value] : finding.values) check["values"][name] = value;
    checks.push_back(std::move(check));
  }
  const nlohmann::ordered_json json = {{"device", device},
                                       {"fit_to_drive", verdict.fit_to_drive},
                                       {"verdict", verdict.sentence},
                                       {"checks", std::move(checks)}};
  out << json_text(json) << "\n";
}

}  // namespace wheelwright::tools::doctor
