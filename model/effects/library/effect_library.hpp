// All effects that there are: one per file of model/effects/, in order of name.
#pragma once

#include <span>
#include <string_view>

#include "model/effects/effect.hpp"

namespace wheelwright {

std::span<const EffectInfo> effect_library();

// Null where there is no effect of that name.
const EffectInfo* find_effect(std::string_view name);

// Makes the effect. Throws std::invalid_argument, saying what would be right, for an unknown name or variant,
// a wrong number of parameters, and parameters out of bounds.
std::unique_ptr<Effect> make_effect(const EffectSetting& setting);

// The place of a variant in its effect; the first for an empty name.
std::size_t variant_index(const EffectInfo& info, std::string_view variant);

// What the parameters of `setting` are; none where there is no effect of that name. Throws
// std::invalid_argument for an unknown variant.
std::span<const ParameterInfo> parameters_of(const EffectSetting& setting);

// Whether it acts before the others of its stage, wherever a model lists it. False where there is no effect
// of that name. Throws std::invalid_argument for an unknown variant.
bool acts_first(const EffectSetting& setting);

}  // namespace wheelwright
