#include "tests/benchmark/gap/case_outcome.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <sstream>

namespace wheelwright::test {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 12> names{"hit",        "part",   "ambiguous_truth", "near_name",
                                                 "false_name", "lucky",  "silent_right",    "unnamed_right",
                                                 "fault_said", "missed", "unnamed",         "error"};

std::vector<std::string> effects_in(const json& object, const char* key) {
  std::vector<std::string> found;
  if (!object.is_object() || !object.contains(key) || !object.at(key).is_array()) return found;
  for (const json& entry : object.at(key)) {
    if (entry.is_string()) found.push_back(entry.get<std::string>());
    if (entry.is_object() && entry.contains("effect")) found.push_back(entry.at("effect").get<std::string>());
  }
  return found;
}

// Everything that an "ambiguous" answer leaves in the running.
std::set<std::string> candidate_effects(const json& gap) {
  std::set<std::string> all;
  const auto take = [&all](const std::vector<std::string>& effects) {
    all.insert(effects.begin(), effects.end());
  };
  take(effects_in(gap, "added"));
  take(effects_in(gap, "rivals"));
  if (gap.contains("added") && gap.at("added").is_array()) {
    for (const json& added : gap.at("added")) take(effects_in(added, "rivals"));
  }
  if (gap.contains("next_experiment")) take(effects_in(gap.at("next_experiment"), "separates"));
  return all;
}

struct Hidden {
  std::set<std::string> shown;  // that the logs can show
  std::set<std::string> all;
  std::set<std::string> confusable;
};

Hidden hidden_of(const json& answer) {
  Hidden hidden;
  for (const json& one : answer.at("hidden")) {
    const auto name = one.at("effect").get<std::string>();
    hidden.all.insert(name);
    if (one.at("can_be_told").get<bool>()) hidden.shown.insert(name);
    std::istringstream words(one.at("confusable").get<std::string>());
    for (std::string word; words >> word;) hidden.confusable.insert(word);
  }
  return hidden;
}

Judgement judge_names(const CaseOutcome& outcome, const Hidden& hidden) {
  const auto is_hidden = [&](const std::string& name) { return hidden.all.contains(name); };
  const bool all_hidden = std::all_of(outcome.named.begin(), outcome.named.end(), is_hidden);
  if (outcome.expected == "not_named" && all_hidden) return Judgement::lucky;
  if (outcome.expected != "named") return Judgement::false_name;
  const bool complete = std::all_of(hidden.shown.begin(), hidden.shown.end(), [&](const std::string& name) {
    return std::find(outcome.named.begin(), outcome.named.end(), name) != outcome.named.end();
  });
  if (complete && is_hidden(outcome.named.front())) return Judgement::hit;
  if (all_hidden) return Judgement::part;
  const bool near = std::all_of(outcome.named.begin(), outcome.named.end(), [&](const std::string& name) {
    return is_hidden(name) || hidden.confusable.contains(name);
  });
  return near ? Judgement::near_name : Judgement::false_name;
}

Judgement judge(const CaseOutcome& outcome, const Hidden& hidden, const json& gap) {
  if (outcome.verdict == "named" && !outcome.named.empty()) return judge_names(outcome, hidden);
  if (outcome.expected == "named") {
    const bool said_fault = gap.contains("data_faults") && !gap.at("data_faults").empty();
    if (said_fault && hidden.shown == std::set<std::string>{"encoder_dropout"}) return Judgement::fault_said;
    if (outcome.verdict == "ambiguous") {
      const auto left = candidate_effects(gap);
      const bool truth = std::includes(left.begin(), left.end(), hidden.shown.begin(), hidden.shown.end());
      return truth ? Judgement::ambiguous_truth : Judgement::unnamed;
    }
    return outcome.verdict == "unnamed" ? Judgement::unnamed : Judgement::missed;
  }
  if (outcome.expected == "unnamed") {
    return outcome.verdict == "unnamed" ? Judgement::unnamed_right : Judgement::missed;
  }
  return Judgement::silent_right;
}

void measure_closing(CaseOutcome& outcome, const json& gap) {
  if (!gap.contains("gap") || !gap.at("gap").is_object()) return;
  double sum = 0.0;
  double sum_squared = 0.0;
  int channels = 0;
  for (const auto& [name, channel] : gap.at("gap").items()) {
    if (!channel.is_object() || !channel.contains("test") || !channel.at("test").is_object()) continue;
    const json& test = channel.at("test");
    const auto number = [&test](const char* key) {
      return test.contains(key) && test.at(key).is_number() ? test.at(key).get<double>() : -1.0;
    };
    const double before = number("before");
    const double after = number("after");
    const double floor = number("floor");
    constexpr double worth_closing = 1.1;  // times the floor; below that the quotient is noise
    if (before < 0.0 || after < 0.0 || floor < 0.0 || before <= worth_closing * floor) continue;
    sum += (before - after) / (before - floor);
    sum_squared += (before * before - after * after) / (before * before - floor * floor);
    ++channels;
  }
  if (channels == 0) return;
  outcome.closed = sum / channels;
  outcome.closed_squared = sum_squared / channels;
}

}  // namespace

std::string_view name_of(Judgement judgement) {
  return names.at(static_cast<std::size_t>(judgement));
}

CaseOutcome judge_case(const json& answer, const json& gap) {
  CaseOutcome outcome;
  outcome.hidden = answer.at("case").get<std::string>();
  outcome.severity = answer.at("severity").get<std::string>();
  outcome.channels = answer.at("channels").get<std::string>();
  outcome.program = answer.at("program").get<std::string>();
  outcome.expected = answer.at("expected").get<std::string>();
  const Hidden hidden = hidden_of(answer);
  outcome.hidden_names.assign(hidden.shown.begin(), hidden.shown.end());
  outcome.verdict = "error";
  if (!gap.is_object() || !gap.contains("verdict") || !gap.at("verdict").is_string()) {
    outcome.trouble = "no verdict in gap.json";
    return outcome;
  }
  outcome.verdict = gap.at("verdict").get<std::string>();
  outcome.named = effects_in(gap, "added");
  outcome.judgement = judge(outcome, hidden, gap);
  outcome.extra_names = outcome.judgement == Judgement::hit &&
                        std::any_of(outcome.named.begin(), outcome.named.end(),
                                    [&](const std::string& name) { return !hidden.all.contains(name); });
  measure_closing(outcome, gap);
  return outcome;
}

}  // namespace wheelwright::test
