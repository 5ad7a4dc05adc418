#include "model/effects/library/effect_library.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "model/effects/library/each_wheel_variants.hpp"
#include "model/effects/library/wheel_load_variants.hpp"

namespace wheelwright {

namespace effects {
std::vector<EffectInfo> all();  // made by the build
}

namespace {

std::string number(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

void check_parameters(const EffectSetting& setting) {
  const auto parameters = parameters_of(setting);
  if (setting.parameters.size() != parameters.size()) {
    throw std::invalid_argument("effect '" + setting.name + "' has " +
                                std::to_string(setting.parameters.size()) + " parameters, but must have " +
                                std::to_string(parameters.size()));
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const ParameterInfo& expected = parameters[i];
    if (!(setting.parameters[i] >= expected.lower && setting.parameters[i] <= expected.upper)) {
      throw std::invalid_argument(
          "effect '" + setting.name + "': " + expected.name + " is " + number(setting.parameters[i]) + " " +
          expected.unit + ", but must be from " + number(expected.lower) + " to " + number(expected.upper));
    }
  }
}

}  // namespace

std::span<const EffectInfo> effect_library() {
  static const std::vector<EffectInfo> library = [] {
    std::vector<EffectInfo> all = effects::all();
    for (auto& info : all) {
      if (info.may_load_wheels) info = with_wheel_load_variants(std::move(info));
      if (info.by_wheel) info = with_each_wheel_variants(std::move(info));
    }
    return all;
  }();
  return library;
}

const EffectInfo* find_effect(std::string_view name) {
  const auto library = effect_library();
  const auto found = std::ranges::find(library, name, &EffectInfo::name);
  return found == library.end() ? nullptr : &*found;
}

std::size_t variant_index(const EffectInfo& info, std::string_view variant) {
  if (variant.empty()) return 0;
  std::string known;
  for (std::size_t i = 0; i < info.variants.size(); ++i) {
    if (info.variants[i].name == variant) return i;
    known += (i > 0 ? ", " : "") + info.variants[i].name;
  }
  throw std::invalid_argument("effect '" + info.name + "' has no variant '" + std::string(variant) + "'" +
                              (known.empty() ? "" : "; there is " + known));
}

std::span<const ParameterInfo> parameters_of(const EffectSetting& setting) {
  const EffectInfo* info = find_effect(setting.name);
  if (info == nullptr) return {};
  return info->parameters_of(variant_index(*info, setting.variant));
}

bool acts_first(const EffectSetting& setting) {
  const EffectInfo* info = find_effect(setting.name);
  return info != nullptr && info->variants[variant_index(*info, setting.variant)].acts_first;
}

std::unique_ptr<Effect> make_effect(const EffectSetting& setting) {
  const EffectInfo* info = find_effect(setting.name);
  if (info == nullptr) {
    throw std::invalid_argument("there is no effect '" + setting.name + "'; see 'wheelwright effects'");
  }
  check_parameters(setting);
  return info->make({setting.parameters, variant_index(*info, setting.variant)});
}

}  // namespace wheelwright
