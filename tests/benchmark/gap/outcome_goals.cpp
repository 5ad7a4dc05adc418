#include "tests/benchmark/gap/outcome_goals.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "config/load/text_format.hpp"

namespace wheelwright::test {
namespace {

using config::fixed_number;

// Wilson's 95 % interval of a rate, in per cent.
std::string rate(int hits, std::size_t of) {
  if (of == 0) return "no case";
  const double n = static_cast<double>(of);
  const double p = hits / n;
  constexpr double z = 1.96;
  const double middle = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
  const double half = z / (1.0 + z * z / n) * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
  return std::to_string(hits) + " of " + std::to_string(of) + ", " + fixed_number(100.0 * p, 1) + " % (" +
         fixed_number(100.0 * (middle - half), 0) + " to " + fixed_number(100.0 * (middle + half), 0) + ")";
}

Goal rate_goal(const std::string& what, int hits, std::size_t of, const char* goal, double least) {
  const double share = of == 0 ? 0.0 : static_cast<double>(hits) / static_cast<double>(of);
  return {what, rate(hits, of), goal, of == 0 ? std::nullopt : std::optional(share >= least)};
}

// None in a handful of logs is no proof of at most one in a hundred.
Goal false_name_goal(const Outcomes& answered) {
  constexpr std::size_t enough = 100;
  const int falsely = count(answered, Judgement::false_name);
  Goal goal{
      "clean logs that were answered: false names", rate(falsely, answered.size()), "at most 1 in 100", {}};
  if (100.0 * falsely > static_cast<double>(answered.size())) {
    goal.met = false;
  } else if (answered.size() >= enough) {
    goal.met = true;
  }
  return goal;
}

}  // namespace

Outcomes that(const std::vector<CaseOutcome>& outcomes, const Condition& condition) {
  Outcomes chosen;
  for (const auto& outcome : outcomes) {
    if (condition(outcome)) chosen.push_back(&outcome);
  }
  return chosen;
}

Outcomes that(const Outcomes& outcomes, const Condition& condition) {
  Outcomes chosen;
  std::copy_if(outcomes.begin(), outcomes.end(), std::back_inserter(chosen),
               [&](const CaseOutcome* outcome) { return condition(*outcome); });
  return chosen;
}

int count(const Outcomes& outcomes, Judgement judgement) {
  return static_cast<int>(
      std::count_if(outcomes.begin(), outcomes.end(),
                    [judgement](const CaseOutcome* outcome) { return outcome->judgement == judgement; }));
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool single(const CaseOutcome& outcome) {
  return outcome.expected == "named" && outcome.hidden.find('+') == std::string::npos;
}
bool several(const CaseOutcome& outcome) {
  return outcome.expected == "named" && outcome.hidden.find('+') != std::string::npos;
}
bool clean(const CaseOutcome& outcome) {
  return outcome.expected == "nothing_missing";
}

std::vector<Goal> goals_of(const std::vector<CaseOutcome>& outcomes) {
  std::vector<Goal> goals;
  const auto singles = that(outcomes, single);
  goals.push_back(rate_goal("single effects that can be told: right name first",
                            count(singles, Judgement::hit), singles.size(), "95 %", 0.95));
  const auto combined = that(outcomes, several);
  goals.push_back(rate_goal("several effects: all of them named", count(combined, Judgement::hit),
                            combined.size(), "80 %", 0.8));
  goals.push_back(false_name_goal(that(
      outcomes, [](const CaseOutcome& one) { return clean(one) && one.judgement != Judgement::error; })));
  const auto blind = that(outcomes, [](const CaseOutcome& one) { return one.expected == "not_named"; });
  goals.push_back(rate_goal("logs that cannot tell: no name given", count(blind, Judgement::silent_right),
                            blind.size(), "100 %", 1.0));
  const auto outside = that(outcomes, [](const CaseOutcome& one) { return one.expected == "unnamed"; });
  goals.push_back(rate_goal("outside the library: 'unnamed'", count(outside, Judgement::unnamed_right),
                            outside.size(), "", 0.0));
  goals.back().met.reset();
  const auto measured = that(
      outcomes, [](const CaseOutcome& one) { return one.expected == "named" && one.closed.has_value(); });
  const auto closed = that(measured, [](const CaseOutcome& one) { return *one.closed >= 0.8; });
  std::vector<double> shares;
  for (const auto* one : measured) shares.push_back(*one->closed);
  if (!shares.empty()) {
    goals.push_back({"reducible gap closed on held-out runs, median",
                     fixed_number(100.0 * median(shares), 0) + " %", "80 %", median(shares) >= 0.8});
  }
  goals.push_back(
      rate_goal("cases with 80 % of it closed", static_cast<int>(closed.size()), measured.size(), "", 0.0));
  goals.back().met.reset();
  return goals;
}

}  // namespace wheelwright::test
