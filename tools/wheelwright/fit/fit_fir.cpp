#include "tools/wheelwright/fit/fit_fir.hpp"

#include <iomanip>
#include <ostream>

#include "config/load/text_format.hpp"
#include "model/prediction/free_run.hpp"
#include "model/prediction/segments.hpp"

namespace wheelwright::tools {
namespace {

using config::fixed_number;

void print_wheel(std::ostream& out, const std::string& name, double own, double own_error, double other,
                 double other_error, const WheelFit& fit) {
  out << "  " << std::left << std::setw(7) << name << std::right << std::setw(9) << fixed_number(own, 4)
      << " +- " << fixed_number(own_error, 4) << std::setw(11) << fixed_number(other, 4) << " +- "
      << fixed_number(other_error, 4) << std::setw(13) << fixed_number(1000.0 * fit.position_noise_m, 3)
      << std::setw(18) << fixed_number(1000.0 * fit.drift_m_per_sqrt_s, 3) << "\n";
}

}  // namespace

Score score_of_fir_fit(const FirFit& fit, const std::vector<DriveLog>& runs) {
  ScoreSums sums;
  for (const auto& run : runs) {
    add_segments(free_run(fit.model, run), run, fit.model.period_s, sums);
  }
  return sums.score();
}

void print_fir_fit(std::ostream& out, const FirFit& fit, std::size_t runs, const Score& score) {
  const std::size_t taps = fit.model.left.from_left.size();
  out << "fir model from " << runs << (runs == 1 ? " run, " : " runs, ") << fit.rows << " rows; response of "
      << taps << (taps == 1 ? " period, " : " periods, ")
      << fixed_number(1000.0 * fit.model.period_s * static_cast<double>(taps), 1) << " ms\n\n"
      << "  wheel      gain, own motor  gain, other motor  noise [mm]  drift [mm/sqrt s]\n";
  const auto& left = fit.left;
  const auto& right = fit.right;
  print_wheel(out, "left", left.gain.from_left, left.gain_standard_error.from_left, left.gain.from_right,
              left.gain_standard_error.from_right, left);
  print_wheel(out, "right", right.gain.from_right, right.gain_standard_error.from_right, right.gain.from_left,
              right.gain_standard_error.from_left, right);
  out << "\n  gain is m/s reached per m/s commanded, +- one standard error; noise is of one reading of "
         "travel\n";
  out << "  free run on these runs: distance " << fixed_number(1000.0 * score.distance_rms_m.value_or(0.0), 2)
      << " mm RMS, wheel speed " << fixed_number(1000.0 * score.wheel_speed_rms_m_s.value_or(0.0), 2)
      << " mm/s RMS\n";
  if (fit.cut) {
    out << "  the wheels still answer after the " << taps
        << " periods of this response; its gain is that of a part: use --type arma\n";
  }
}

}  // namespace wheelwright::tools
