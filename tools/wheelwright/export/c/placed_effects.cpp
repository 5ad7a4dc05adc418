#include "tools/wheelwright/export/c/placed_effects.hpp"

#include <algorithm>
#include <utility>

#include "model/effects/library/each_wheel_variants.hpp"
#include "model/effects/library/effect_library.hpp"

namespace wheelwright::tools {
namespace {

PlacedEffect place(const AddedEffect& effect, const CFragment& fragment, std::size_t number,
                   std::optional<WheelSide> wheel) {
  const EffectInfo& info = *find_effect(effect.setting.name);
  const EffectSetting setting = wheel ? as_at(*wheel, effect.setting) : effect.setting;
  const std::size_t variant = variant_index(info, setting.variant);
  const std::size_t own = info.may_load_wheels ? info.variants.size() / 2 : info.variants.size();
  const std::string name = "effect_" + std::to_string(number);
  return {&effect,
          &fragment,
          info.variants[variant].stage,
          variant % own,
          variant >= own,
          make_effect(setting)->hooks().load,
          fragment.has("reset") ? name : std::string(),
          "ww_" + name,
          places_at(wheel.value_or(WheelSide::left), effect.setting),
          setting,
          wheel};
}

}  // namespace

PlacedEffects place_effects(const RobotModel& model) {
  PlacedEffects header;
  for (const AddedEffect& effect : model.effects) {
    const CFragment* fragment = find_c_fragment(effect.setting.name);
    if (fragment == nullptr) {
      header.unsaid.push_back({effect.setting.name, "nobody has written it in C yet"});
    } else if (std::string reason = fragment->remark("Not said:"); !reason.empty()) {
      header.unsaid.push_back({effect.setting.name, std::move(reason)});
    } else if (is_of_each_wheel(effect.setting)) {
      for (const WheelSide wheel : {WheelSide::left, WheelSide::right})
        header.placed.push_back(place(effect, *fragment, header.placed.size() + 1, wheel));
    } else {
      header.placed.push_back(place(effect, *fragment, header.placed.size() + 1, std::nullopt));
    }
  }
  std::stable_partition(header.placed.begin(), header.placed.end(),
                        [](const PlacedEffect& one) { return acts_first(one.effect->setting); });
  return header;
}

}  // namespace wheelwright::tools
