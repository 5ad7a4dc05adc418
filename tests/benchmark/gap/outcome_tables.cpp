#include "tests/benchmark/gap/outcome_tables.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>

#include "config/load/text_format.hpp"
#include "tests/benchmark/gap/outcome_goals.hpp"

namespace wheelwright::test {
namespace {

using config::fixed_number;

constexpr std::array<const char*, 3> severities{"small", "medium", "large"};

std::string left(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size() + 1), ' ');
  return text;
}
std::string right(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width - 1, text.size()), ' ') + text;
}

// Hits of all, "-" where there are none.
std::string hits_of(const Outcomes& outcomes) {
  if (outcomes.empty()) return "-";
  return std::to_string(count(outcomes, Judgement::hit)) + "/" + std::to_string(outcomes.size());
}

std::string closed_of(const Outcomes& outcomes) {
  std::vector<double> closed;
  for (const auto* outcome : outcomes) {
    if (outcome->closed) closed.push_back(*outcome->closed);
  }
  return closed.empty() ? "-" : fixed_number(100.0 * median(closed), 0) + " %";
}

struct Column {
  const char* title;
  Judgement judgement;
};
constexpr std::array<Column, 8> other_columns{{{"ambig+", Judgement::ambiguous_truth},
                                               {"part", Judgement::part},
                                               {"near", Judgement::near_name},
                                               {"false", Judgement::false_name},
                                               {"missed", Judgement::missed},
                                               {"unnamd", Judgement::unnamed},
                                               {"fault", Judgement::fault_said},
                                               {"error", Judgement::error}}};

std::string hit_row(const std::string& title, const Outcomes& outcomes) {
  std::string line = "  " + left(title, 46);
  for (const char* severity : severities) {
    const auto chosen =
        that(outcomes, [severity](const CaseOutcome& one) { return one.severity == severity; });
    line += right(hits_of(chosen), 8);
  }
  for (const Column& column : other_columns) {
    const int n = count(outcomes, column.judgement);
    line += right(n == 0 ? "." : std::to_string(n), 7);
  }
  return line + right(closed_of(outcomes), 8) + "\n";
}

std::string hit_table(const std::string& title, const Outcomes& outcomes,
                      const std::function<std::string(const CaseOutcome&)>& group) {
  if (outcomes.empty()) return {};
  std::string text = "\n" + left(title, 48);
  for (const char* severity : severities) text += right(severity, 8);
  for (const Column& column : other_columns) text += right(column.title, 7);
  text += right("closed", 8) + "\n";
  std::map<std::string, Outcomes> groups;
  for (const auto* outcome : outcomes) groups[group(*outcome)].push_back(outcome);
  for (const auto& [name, members] : groups) text += hit_row(name, members);
  return text + hit_row("all", outcomes);
}

std::string first_word(const CaseOutcome& outcome) {
  return outcome.verdict == "named" && !outcome.named.empty() ? outcome.named.front() : outcome.verdict;
}

using Confusion = std::map<std::string, std::map<std::string, int>>;

// Hidden alone, and clean logs, against the first name or the verdict.
Confusion confusion_of(const std::vector<CaseOutcome>& outcomes) {
  Confusion confusion;
  for (const auto& outcome : outcomes) {
    if (outcome.hidden.find('+') != std::string::npos) continue;
    ++confusion[outcome.expected == "not_named" ? outcome.hidden + " (cannot be told)" : outcome.hidden]
               [first_word(outcome)];
  }
  return confusion;
}

std::string confusion_table(const Confusion& confusion) {
  std::map<std::string, std::size_t> columns;
  for (const auto& [hidden, row] : confusion) {
    for (const auto& [named, n] : row) columns.emplace(named, 0);
  }
  std::string text = "\nConfusion: hidden against the first name or the verdict. Columns:";
  std::size_t next = 0;
  for (auto& [named, column] : columns) {
    column = next++;
    text += (column % 5 == 0 ? "\n    " : ", ") + std::to_string(column + 1) + " " + named;
  }
  text += "\n  " + left("hidden", 44);
  for (std::size_t i = 0; i < columns.size(); ++i) text += right(std::to_string(i + 1), 4);
  text += "\n";
  for (const auto& [hidden, row] : confusion) {
    text += "  " + left(hidden, 44);
    for (const auto& [named, column] : columns) {
      const auto found = row.find(named);
      text += right(found == row.end() ? "." : std::to_string(found->second), 4);
    }
    text += "\n";
  }
  return text;
}

std::string goal_table(const std::vector<Goal>& goals) {
  std::string text = "\n" + left("figure", 54) + left("measured (95 % interval)", 36) + "goal\n";
  for (const Goal& goal : goals) {
    text += "  " + left(goal.what, 52) + left(goal.measured, 36) + left(goal.goal, 14);
    text += !goal.met ? "\n" : (*goal.met ? "met\n" : "NOT MET\n");
  }
  return text;
}

std::string time_line(const std::vector<CaseOutcome>& outcomes) {
  std::vector<double> seconds;
  for (const auto& outcome : outcomes) {
    if (outcome.judgement != Judgement::error) seconds.push_back(outcome.seconds);
  }
  if (seconds.empty()) return "\nno case was answered\n";
  return "\n" + std::to_string(outcomes.size()) +
         " cases; time of an answered case, with as many at once as were asked for: median " +
         fixed_number(median(seconds), 1) + " s, largest " +
         fixed_number(*std::max_element(seconds.begin(), seconds.end()), 1) + " s\n";
}

std::string wrong_answers(const std::vector<CaseOutcome>& outcomes) {
  std::string text;
  for (const auto& one : outcomes) {
    const bool wrong = one.judgement == Judgement::false_name || one.judgement == Judgement::near_name ||
                       one.judgement == Judgement::lucky || one.judgement == Judgement::error ||
                       one.extra_names;
    if (!wrong) continue;
    std::string named;
    for (const auto& name : one.named) named += (named.empty() ? "" : " ") + name;
    if (one.judgement == Judgement::error) named = one.trouble;
    text += "  " + left(one.folder, 10) +
            left(one.extra_names ? "hit and more" : std::string(name_of(one.judgement)), 17) + one.hidden +
            " " + one.severity + " " + one.channels + " " + one.program + ": " + named + "\n";
  }
  return text.empty() ? text : "\nWrong or surplus names, and errors\n" + text;
}

}  // namespace

std::string outcome_tables(const std::vector<CaseOutcome>& outcomes) {
  std::string text =
      "Hits of cases by size. ambig+: 'ambiguous' with the truth among the candidates; part: some of the "
      "hidden;\n"
      "near: a name that ordinary logs cannot tell from it; false: a name of what is not there; fault: lost "
      "counts\n"
      "reported as a fault of the data; closed: median share of the reducible gap closed on held-out runs.\n";
  text += hit_table(
      "effect, counts and poses on each row",
      that(outcomes, [](const CaseOutcome& one) { return single(one) && one.channels == "ticks+ref"; }),
      [](const CaseOutcome& one) { return one.hidden; });
  text += hit_table("single effects by channels", that(outcomes, single),
                    [](const CaseOutcome& one) { return one.channels; });
  text += hit_table("several effects", that(outcomes, several),
                    [](const CaseOutcome& one) { return one.hidden; });
  text += confusion_table(confusion_of(outcomes));
  text += wrong_answers(outcomes);
  text += goal_table(goals_of(outcomes));
  return text + time_line(outcomes);
}

nlohmann::json outcome_json(const std::vector<CaseOutcome>& outcomes) {
  nlohmann::json cases = nlohmann::json::array();
  for (const auto& one : outcomes) {
    nlohmann::json entry{{"folder", one.folder},
                         {"hidden", one.hidden},
                         {"severity", one.severity},
                         {"channels", one.channels},
                         {"program", one.program},
                         {"expected", one.expected},
                         {"hidden_names", one.hidden_names},
                         {"verdict", one.verdict},
                         {"named", one.named},
                         {"judgement", name_of(one.judgement)},
                         {"extra_names", one.extra_names},
                         {"seconds", one.seconds}};
    if (one.closed) entry["gap_closed"] = *one.closed;
    if (one.closed_squared) entry["gap_closed_squared"] = *one.closed_squared;
    if (!one.trouble.empty()) entry["trouble"] = one.trouble;
    cases.push_back(std::move(entry));
  }
  nlohmann::json goals = nlohmann::json::array();
  for (const Goal& goal : goals_of(outcomes)) {
    goals.push_back({{"what", goal.what}, {"measured", goal.measured}, {"goal", goal.goal}});
    if (goal.met) goals.back()["met"] = *goal.met;
  }
  return {{"cases", cases}, {"goals", goals}, {"confusion", confusion_of(outcomes)}};
}

}  // namespace wheelwright::test
