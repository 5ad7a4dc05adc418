// What a statistic of the predictive check found, in words and figures for a person.
#pragma once

#include <string_view>

#include "model/gap/adequacy/covariates.hpp"
#include "model/gap/adequacy/dependence.hpp"
#include "model/gap/adequacy/drift.hpp"
#include "model/gap/adequacy/intermittent_events.hpp"
#include "model/gap/adequacy/offset_over_heading.hpp"
#include "model/gap/adequacy/periodic_residual.hpp"
#include "model/gap/adequacy/predictive_check.hpp"
#include "model/gap/adequacy/reversal_residual.hpp"

namespace wheelwright::gap {

struct ChannelWords {
  Channel channel;
  std::string_view name;
  bool angle;
};

// The error from which a person sees it in a plot of the channel, m or rad.
double visible_size(Channel channel);

// `heading_swing_rad`: what a swing of a wheel is of the heading (heading_swing.hpp).
CheckStatistic statistic_of(const ChannelWords& of, const PeriodicResidual& found, double heading_swing_rad);
CheckStatistic statistic_of(const ChannelWords& of, const Covariate& covariate, const Dependence& found);
CheckStatistic statistic_of(const ChannelWords& of, const OffsetOverHeading& found);
// `problem` has the names of the runs.
CheckStatistic statistic_of(const ChannelWords& of, const FitProblem& problem,
                            const IntermittentEvents& found);
CheckStatistic statistic_of(const ChannelWords& of, const ReversalResidual& found);
CheckStatistic statistic_of(const ChannelWords& of, const Drift& found);

}  // namespace wheelwright::gap
