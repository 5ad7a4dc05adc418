// An effect that each wheel has by itself, and one wheel more of it than the other: no two motors and gears
// are alike. Where a variant has one size for both wheels, another one, named with "each_wheel", has a size
// for each: in the place of a parameter NAME that scales the effect stand NAME_left and NAME_right. All other
// parameters are of both wheels.
#pragma once

#include <cstddef>
#include <vector>

#include "model/effects/effect.hpp"
#include "model/geometry/wheel_side.hpp"

namespace wheelwright {

// Gives an effect a second set of variants. Requires one whose wheels do not feel each other.
EffectInfo with_each_wheel_variants(EffectInfo info);

// The effect that has the size of one wheel at both. `setting` itself where the wheels are alike. Requires a
// variant of the library.
EffectSetting as_at(WheelSide wheel, const EffectSetting& setting);

// The places of its parameters in those of `setting`.
std::vector<std::size_t> places_at(WheelSide wheel, const EffectSetting& setting);

// Whether it has a size for each wheel in the place of one. False where there is no effect of that name.
bool is_of_each_wheel(const EffectSetting& setting);

// The same with a size for each wheel; `setting` itself where there is no such variant, or it is one.
EffectSetting of_each_wheel(const EffectSetting& setting);

// The same of what holds a setting and an interval for each parameter, or none.
template <typename Sized>
Sized with_size_for_each_wheel(const Sized& alike) {
  Sized each = alike;
  each.setting = of_each_wheel(alike.setting);
  if (alike.intervals.size() != alike.setting.parameters.size()) return each;
  each.intervals.resize(each.setting.parameters.size());
  for (const WheelSide wheel : {WheelSide::left, WheelSide::right}) {
    const std::vector<std::size_t> places = places_at(wheel, each.setting);
    for (std::size_t i = 0; i < places.size(); ++i) each.intervals[places[i]] = alike.intervals[i];
  }
  return each;
}

}  // namespace wheelwright
