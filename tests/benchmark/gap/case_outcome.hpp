// What the gap workflow answered to a case, against what was hidden.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace wheelwright::test {

enum class Judgement {
  hit,              // the right name first; of several hidden effects all
  part,             // of several hidden effects some, and none that is not there
  ambiguous_truth,  // "ambiguous", and all hidden names are among the candidates
  near_name,        // a name that ordinary logs cannot tell from the right one
  false_name,       // a name of something that is not there
  lucky,            // the right name, which these logs cannot show
  silent_right,     // no name, and none was to be given
  unnamed_right,    // "unnamed", of an effect that no library holds
  fault_said,       // lost counts reported as a fault of the data
  missed,           // nothing was found that was there
  unnamed,          // "unnamed", or "ambiguous" without the truth, where a name was to be given
  error             // no answer
};

std::string_view name_of(Judgement judgement);

struct CaseOutcome {
  std::string folder;
  std::string hidden;  // as the case is called
  std::string severity;
  std::string channels;
  std::string program;
  std::string expected;
  std::vector<std::string> hidden_names;  // that the logs can show
  std::string verdict;                    // "error" without an answer
  std::vector<std::string> named;         // in the order of the answer
  bool extra_names = false;               // beside a hit: further ones that are not there
  Judgement judgement = Judgement::error;
  // Share of the reducible gap that was closed on held-out runs, the mean over the channels of gap.json:
  // (before - after) / (before - floor) of the errors, and the same of their squares.
  std::optional<double> closed;
  std::optional<double> closed_squared;
  double seconds = 0.0;
  std::string trouble;  // of an error
};

// `answer` as gap_cases wrote it; `gap` the answer of the workflow, null where there is none.
CaseOutcome judge_case(const nlohmann::json& answer, const nlohmann::json& gap);

}  // namespace wheelwright::test
