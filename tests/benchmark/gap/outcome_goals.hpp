// The figures of the gap benchmark that have a goal, and how outcomes are picked and counted for them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/benchmark/gap/case_outcome.hpp"

namespace wheelwright::test {

using Outcomes = std::vector<const CaseOutcome*>;
using Condition = std::function<bool(const CaseOutcome&)>;

Outcomes that(const std::vector<CaseOutcome>& outcomes, const Condition& condition);
Outcomes that(const Outcomes& outcomes, const Condition& condition);
int count(const Outcomes& outcomes, Judgement judgement);
double median(std::vector<double> values);  // of at least one; of an even number the upper of the middle two

bool single(const CaseOutcome& outcome);   // one effect that can be told
bool several(const CaseOutcome& outcome);  // more, of which one or more can be told
bool clean(const CaseOutcome& outcome);

struct Goal {
  std::string what;
  std::string measured;     // rates with Wilson's 95 % interval
  std::string goal;         // empty where none is set
  std::optional<bool> met;  // absent without a goal or without cases
};

std::vector<Goal> goals_of(const std::vector<CaseOutcome>& outcomes);

}  // namespace wheelwright::test
