// How answers of the gap workflow are judged against what was hidden.
#include "tests/benchmark/gap/case_outcome.hpp"

#include "tests/benchmark/gap/outcome_tables.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::test;
using nlohmann::json;

namespace {

json hidden(const std::string& effect, bool can_be_distinguished = true, const std::string& confusable = "") {
  return {{"effect", effect}, {"can_be_told", can_be_distinguished}, {"confusable", confusable}};
}

json answer(const std::string& expected, const std::vector<json>& effects) {
  return {{"case", "a case"},   {"severity", "medium"}, {"channels", "ticks+ref"},
          {"program", "mixed"}, {"expected", expected}, {"hidden", effects}};
}

json named(const std::vector<std::string>& effects) {
  json added = json::array();
  for (const auto& effect : effects) added.push_back({{"effect", effect}});
  return {{"verdict", "named"}, {"added", added}};
}

Judgement judged(const json& answer, const json& gap) {
  return judge_case(answer, gap).judgement;
}

}  // namespace

TEST_CASE("A hit is the right name first, and a further wrong one is noted") {
  const json truth = answer("named", {hidden("dead_zone", true, "stiction")});
  CHECK(judged(truth, named({"dead_zone"})) == Judgement::hit);
  CHECK(judge_case(truth, named({"dead_zone", "yaw_bias"})).extra_names);
  CHECK(judged(truth, named({"yaw_bias", "dead_zone"})) != Judgement::hit);
  CHECK(judged(truth, named({"stiction"})) == Judgement::near_name);
  CHECK(judged(truth, named({"yaw_bias"})) == Judgement::false_name);
}

TEST_CASE("Of several hidden effects all that the logs show must be named") {
  const json pair = answer("named", {hidden("dead_zone"), hidden("saturation")});
  CHECK(judged(pair, named({"saturation", "dead_zone"})) == Judgement::hit);
  CHECK(judged(pair, named({"saturation"})) == Judgement::part);
  const json half_shown = answer("named", {hidden("dead_zone"), hidden("lever_arm", false)});
  CHECK(judged(half_shown, named({"dead_zone"})) == Judgement::hit);
}

TEST_CASE("An ambiguous answer counts by itself, wherever it names the truth") {
  const json truth = answer("named", {hidden("dead_zone")});
  const json rivals = {
      {"verdict", "ambiguous"},
      {"added",
       json::array({{{"effect", "stiction"}, {"rivals", json::array({{{"effect", "dead_zone"}}})}}})}};
  const json separates = {{"verdict", "ambiguous"},
                          {"next_experiment", {{"separates", {"stiction", "dead_zone"}}}}};
  CHECK(judged(truth, rivals) == Judgement::ambiguous_truth);
  CHECK(judged(truth, separates) == Judgement::ambiguous_truth);
  CHECK(judged(truth, {{"verdict", "ambiguous"}, {"next_experiment", nullptr}}) == Judgement::unnamed);
}

TEST_CASE("A name is false where nothing can be named, and silence is right there") {
  const json clean = answer("nothing_missing", {});
  CHECK(judged(clean, named({"yaw_bias"})) == Judgement::false_name);
  CHECK(judged(clean, {{"verdict", "nothing_missing"}}) == Judgement::silent_right);
  const json blind = answer("not_named", {hidden("backlash", false)});
  CHECK(judged(blind, {{"verdict", "not_testable"}}) == Judgement::silent_right);
  CHECK(judged(blind, named({"backlash"})) == Judgement::lucky);
  const json outside = answer("unnamed", {hidden("outside_resonance")});
  CHECK(judged(outside, {{"verdict", "unnamed"}}) == Judgement::unnamed_right);
  CHECK(judged(outside, named({"backlash"})) == Judgement::false_name);
}

TEST_CASE("Without an answer a case is an error, not a silence") {
  const json clean = answer("nothing_missing", {});
  CHECK(judged(clean, nullptr) == Judgement::error);
  CHECK(judged(clean, json::object()) == Judgement::error);
}

TEST_CASE("The gap closed is measured on held-out runs, where there is something to close") {
  json gap = named({"dead_zone"});
  gap["gap"]["position_rms_m"] = {{"horizon_s", 10},
                                  {"test", {{"before", 0.1}, {"after", 0.03}, {"floor", 0.0}}}};
  gap["gap"]["wheel_speed_rms_m_s"] = {{"test", {{"before", 0.0101}, {"after", 0.01}, {"floor", 0.01}}}};
  const auto outcome = judge_case(answer("named", {hidden("dead_zone")}), gap);
  CHECK_THAT(*outcome.closed, WithinAbs(0.7, 1e-12));
  CHECK_THAT(*outcome.closed_squared, WithinAbs(0.91, 1e-12));
}

TEST_CASE("The report holds each case and says which goal was not met") {
  const json truth = answer("named", {hidden("dead_zone")});
  const std::vector<CaseOutcome> outcomes{judge_case(truth, named({"dead_zone"})),
                                          judge_case(truth, {{"verdict", "nothing_missing"}})};
  CHECK_THAT(outcome_tables(outcomes), ContainsSubstring("1 of 2, 50.0 %"));
  CHECK_THAT(outcome_tables(outcomes), ContainsSubstring("NOT MET"));
  CHECK(outcome_json(outcomes).at("cases").size() == 2);
}
