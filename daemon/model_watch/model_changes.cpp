#include "daemon/model_watch/model_changes.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "config/load/text_file.hpp"
#include "model/effects/library/each_wheel_variants.hpp"
#include "model/effects/library/effect_library.hpp"

namespace wheelwright::daemon {
namespace {

using nlohmann::json;

constexpr double proven_share = 0.97;

const AddedEffect* effect_in(const RobotModel& model, const std::string& name) {
  const auto found = std::ranges::find_if(
      model.effects, [&](const AddedEffect& effect) { return effect.setting.name == name; });
  return found == model.effects.end() ? nullptr : &*found;
}

struct Change {
  const AddedEffect& after;
  const ParameterInfo& parameter;
  std::size_t index;
};

std::string value_in_words(const Change& change, const std::string& how, const std::string& since) {
  std::string text = fmt::format("{}: {} {} {:.3g} {}", change.after.setting.name, change.parameter.name, how,
                                 change.after.setting.parameters[change.index], change.parameter.unit);
  if (!since.empty()) text += " since " + since;
  if (change.index < change.after.intervals.size()) {
    const ParameterInterval& interval = change.after.intervals[change.index];
    text += fmt::format(" (95 %: {:.3g} to {:.3g})", interval.lower, interval.upper);
  }
  return text;
}

bool moved(const AddedEffect& before, const Change& change) {
  if (change.index >= before.setting.parameters.size() || change.index >= change.after.intervals.size())
    return false;
  const double value = before.setting.parameters[change.index];
  const ParameterInterval& interval = change.after.intervals[change.index];
  return value < interval.lower || value > interval.upper;
}

// Both with a size for each wheel where one has it.
std::pair<std::optional<AddedEffect>, AddedEffect> comparable(const AddedEffect* before,
                                                              const AddedEffect& after) {
  if (before == nullptr) return {std::nullopt, after};
  const bool parted = is_of_each_wheel(before->setting);
  if (parted == is_of_each_wheel(after.setting)) return {*before, after};
  return parted ? std::pair(std::optional(*before), with_size_for_each_wheel(after))
                : std::pair(std::optional(with_size_for_each_wheel(*before)), after);
}

bool would_have_shown(const AddedEffect& effect, const GapAnswer& answer) {
  const EffectSetting setting = as_at(WheelSide::left, effect.setting);
  const auto seen = std::ranges::find(answer.detectable, setting.name, &GapAnswer::Detectable::effect);
  if (seen == answer.detectable.end()) return false;
  const auto parameters = parameters_of(setting);
  const auto parameter = std::ranges::find(parameters, seen->parameter, &ParameterInfo::name);
  if (parameter == parameters.end()) return false;
  const double size = std::abs(setting.parameters[static_cast<std::size_t>(parameter - parameters.begin())]);
  const bool is_limit = parameter->lower > 0.0;  // the lower, the more of it
  return is_limit ? size <= seen->size : size >= seen->size;
}

}  // namespace

std::vector<std::string> effect_changes(const RobotModel& before, const RobotModel& after,
                                        const GapAnswer& answer, const std::string& since) {
  std::vector<std::string> sentences;
  for (const AddedEffect& found : after.effects) {
    const EffectInfo* info = find_effect(found.setting.name);
    if (info == nullptr) continue;
    const AddedEffect* as_before = effect_in(before, found.setting.name);
    const auto [former, effect] = comparable(as_before, found);
    const auto& parameters = info->parameters_of(variant_index(*info, effect.setting.variant));
    for (std::size_t i = 0; i < effect.setting.parameters.size(); ++i) {
      if (!parameters[i].scales_effect) continue;
      const Change change{effect, parameters[i], i};
      if (!former) {
        sentences.push_back(value_in_words(change, "is new,", since));
        break;
      }
      if (!moved(*former, change)) continue;
      const double was = former->setting.parameters[i];
      sentences.push_back(value_in_words(
          change, fmt::format("{} from {:.3g} to", effect.setting.parameters[i] > was ? "rose" : "fell", was),
          since));
    }
  }
  for (const AddedEffect& effect : before.effects) {
    if (effect_in(after, effect.setting.name) == nullptr && would_have_shown(effect, answer))
      sentences.push_back(effect.setting.name + ": is not seen any more" +
                          (since.empty() ? "" : " since " + since));
  }
  return sentences;
}

tl::expected<GapAnswer, std::string> read_gap_answer(const std::filesystem::path& file) {
  const auto text = config::read_text(file, config::record_file);
  if (!text) return tl::make_unexpected(text.error());
  const json gap = json::parse(*text, nullptr, false);
  if (!gap.is_object() || !gap.contains("verdict"))
    return tl::make_unexpected(file.string() + ": is not the answer of wheelwright gap");
  const auto part = [](const json& of, const char* key) {
    return of.is_object() && of.contains(key) ? of.at(key) : json();
  };
  GapAnswer answer;
  answer.verdict = gap.value("verdict", "");
  answer.summary = gap.value("summary", answer.verdict);
  answer.differs = !part(gap, "added").empty() || !part(gap, "linear_changes").empty();
  const json detectable = part(gap, "detectable");
  for (const json& one : detectable) {
    if (one.is_object() && part(one, "size").is_number())
      answer.detectable.push_back({one.value("effect", ""), one.value("parameter", ""), one.at("size")});
  }
  const json untouched = part(part(gap, "data"), "untouched");
  const json passed = part(part(gap, "check"), "passed");
  const json travel = part(part(part(gap, "gap"), "distance_rms_m"), "test");
  const json before = part(travel, "before");
  const json after = part(travel, "after");
  if (!before.is_number() || !after.is_number()) return answer;
  answer.untouched_before_m = before.get<double>();
  answer.untouched_after_m = after.get<double>();
  answer.proven = untouched == json(true) && passed == json(true) &&
                  answer.untouched_after_m <= proven_share * answer.untouched_before_m;
  return answer;
}

}  // namespace wheelwright::daemon
