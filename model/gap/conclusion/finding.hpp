// What was found, and how sure that is.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/gap/candidates/testability.hpp"
#include "model/gap/data_checks/data_gate.hpp"
#include "model/gap/selection/search.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::gap {

struct Rival {
  std::string effect;  // "decoy" for one without a name
  double posterior = 0.0;
};

struct Finding {
  EffectSetting setting;
  std::vector<ParameterInterval> intervals;
  double heldout_gain_nats = 0.0;        // deflated for correlation of the residuals
  std::optional<double> test_gain_nats;  // the same on untouched runs
  bool acts_untouched = false;           // whether it moves anything there
  double p_value = 1.0;
  double posterior = 0.0;
  double rival_share = 0.0;   // of what it explains, what the best rival would explain in its place
  std::vector<Rival> rivals;  // the most probable first
};

// All that a search accepted. The effect that was found first comes first, unless the model loses far more
// without another one. The rest follows by how much the model loses without each. The posterior of a name
// compares it with its rivals, beside all other names.
std::vector<Finding> findings_of(const GapSearch& search);

// An effect that these runs cannot show may do the same in them as one that was found: then it is a rival as
// good. A constant loss in one direction and at one heading may be a slope; a loss on starting alone, play; a
// gain that falls evenly, and no voltage in the logs, the battery.
void add_rivals_that_cannot_show(std::span<Finding> found, std::span<const Untestable> untestable,
                                 double longest_run_s);

// The names of effects with one size whose 95 % interval contains 0: what they explain is the shape of
// something else. A limit is no such size. Effects with several are never among them: the estimates are
// correlated, and each interval can contain 0 while the effect is there.
std::vector<std::string> names_without_size(std::span<const Finding> found);

inline constexpr std::string_view dropout_name = "encoder_dropout";

// Counts that stood still are an effect of the library, but one that the data gate finds. A single time is a
// fault of the data and no more.
std::optional<Finding> dropout_finding(std::span<const Dropout> dropouts, double watched_s);

}  // namespace wheelwright::gap
