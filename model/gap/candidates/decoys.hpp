// Effects that have no name and no cause: as flexible as the library's, so that a name has to beat them
//. Where one of them explains the data best, something is missing that the library does not
// hold.
#pragma once

#include <span>

#include "model/effects/effect.hpp"

namespace wheelwright::gap {

std::span<const EffectInfo> decoys();

bool is_decoy(const EffectInfo& info);

}  // namespace wheelwright::gap
