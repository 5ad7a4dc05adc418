// A score as JSON: the form of `score --json` and of gap.json.
#pragma once

#include <nlohmann/json.hpp>

#include "model/prediction/score.hpp"

namespace wheelwright::tools {

// Figures that a log cannot show are absent.
nlohmann::ordered_json score_to_json(const Score& score);

}  // namespace wheelwright::tools
