// What `wheelwright fit` has to say of a fit: the model's own table, where its runs have holes, and what the
// settled speeds show that a linear model cannot.
#pragma once

#include <iosfwd>
#include <optional>
#include <variant>
#include <vector>

#include "model/identification/arma_fit.hpp"
#include "model/identification/command_hole.hpp"
#include "model/identification/fir_fit.hpp"
#include "model/identification/speed_curve.hpp"
#include "model/identification/steady_state_speeds.hpp"
#include "model/log/drive_log.hpp"
#include "model/prediction/score.hpp"

namespace wheelwright::tools {

struct FirReport {
  FirFit fit;
  Score score;  // of the free run over the same runs
};

struct FitReport {
  std::variant<FirReport, ArmaFit> fit;
  std::vector<DriveLog> runs;
  SteadyStateSpeeds speeds;
  SpeedCurve curve;
  std::optional<CommandHole> hole;

  const LinearModel& model() const;
  const WheelFit& left() const;
  const WheelFit& right() const;
};

FitReport report_of(FirFit fit, std::vector<DriveLog> runs);
FitReport report_of(ArmaFit fit, std::vector<DriveLog> runs);

void print_fit(std::ostream& out, const FitReport& report);

}  // namespace wheelwright::tools
