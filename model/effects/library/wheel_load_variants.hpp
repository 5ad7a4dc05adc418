// An effect on the body that the wheels feel: its force loads the motors, so that the wheels themselves turn
// as the body does and the encoders see it. The same effect, at another place. The body turns as the wheels
// roll on the floor, which unequal wheels do otherwise than they are counted (StepContext::rolling).
#pragma once

#include <memory>

#include "model/effects/effect.hpp"

namespace wheelwright {

// Makes the wheel stage out of the body stage of `effect`.
std::unique_ptr<Effect> wheel_load_variants(std::unique_ptr<Effect> effect);

// Gives an effect whose variants act on the body a second set of variants, named with "at_wheels", that act
// on the wheels.
EffectInfo with_wheel_load_variants(EffectInfo info);

}  // namespace wheelwright
