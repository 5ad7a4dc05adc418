#include "tools/wheelwright/fit/fit_arma.hpp"

#include <iomanip>
#include <ostream>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/common/progress_line.hpp"

namespace wheelwright::tools {
namespace {

using config::fixed_number;

std::string in_thousandths(double value, int digits) {
  return fixed_number(1000.0 * value, digits);
}

void print_row(std::ostream& out, const OrderSweepRow& row, const std::string& remark) {
  out << std::setw(7) << row.order;
  if (row.refusal) {
    out << "  " << row.refusal->reason << "\n";
    return;
  }
  out << std::setw(17) << in_thousandths(row.one_step_rms_m_s, 2) << std::setw(13)
      << in_thousandths(row.held_out_distance_rms_m, 3) << " +- " << in_thousandths(row.standard_error_m, 3)
      << std::setw(14) << fixed_number(row.largest_pole, 3) << std::setw(11) << fixed_number(row.condition, 0)
      << std::setw(17) << row.multiplications << remark << "\n";
}

void print_sweep(std::ostream& out, const OrderSweep& sweep) {
  out << "  order  one step [mm/s]  held out [mm]       largest pole  condition  multiplications\n";
  for (const auto& row : sweep.rows) {
    std::string remark;
    if (row.order == sweep.best) remark += "  best";
    if (row.order == sweep.chosen) remark += "  chosen";
    print_row(out, row, remark);
  }
  out << "\n  held out: free-run distance RMS on runs that the fit did not see, within 5 s, +- one standard\n"
         "  error over "
      << sweep.units
      << " runs or blocks; chosen is the smallest order within one standard error of the best\n\n";
}

void print_wheel(std::ostream& out, const std::string& name, const ArmaWheelFit& fit, double own,
                 double own_error, double other, double other_error) {
  out << "  " << std::left << std::setw(7) << name << std::right << std::setw(9) << fixed_number(own, 4)
      << " +- " << fixed_number(own_error, 4) << std::setw(11) << fixed_number(other, 4) << " +- "
      << fixed_number(other_error, 4) << std::setw(14) << fixed_number(fit.largest_pole, 3) << std::setw(11)
      << fixed_number(fit.condition, 0) << std::setw(8)
      << std::to_string(fit.rank) + "/" + std::to_string(fit.unknowns) << std::setw(17)
      << in_thousandths(fit.one_step_rms_m_s, 2) << "\n";
}

}  // namespace

tl::expected<ArmaFit, Refusal> fit_arma(const std::vector<DriveLog>& runs, ArmaFitOptions options,
                                        std::ostream& err) {
  ProgressLine progress(err);
  const double orders = static_cast<double>(options.largest_order);
  if (!options.order) {
    options.on_order = [say = progress.callback(), orders](std::size_t order) {
      // Each order costs about in proportion to its size.
      const double before = static_cast<double>(order) * static_cast<double>(order - 1);
      say("order " + std::to_string(order), before / (orders * (orders + 1.0)));
    };
  }
  auto fit = fit_arma(runs, options);
  progress.clear();
  return fit;
}

void print_arma_fit(std::ostream& out, const ArmaFit& fit, std::size_t runs) {
  if (fit.sweep) print_sweep(out, *fit.sweep);
  out << "arma model of order " << fit.model.left.from_own_past.size() << " from " << runs
      << (runs == 1 ? " run, " : " runs, ") << fit.rows << " rows\n\n"
      << "  wheel      gain, own motor  gain, other motor  largest pole  condition    rank  one step "
         "[mm/s]\n";
  const WheelFit& left = fit.left.quality;
  const WheelFit& right = fit.right.quality;
  print_wheel(out, "left", fit.left, left.gain.from_left, left.gain_standard_error.from_left,
              left.gain.from_right, left.gain_standard_error.from_right);
  print_wheel(out, "right", fit.right, right.gain.from_right, right.gain_standard_error.from_right,
              right.gain.from_left, right.gain_standard_error.from_left);
  out << "\n  gain is m/s reached per m/s commanded, +- one standard error; one step predicts from measured "
         "speeds\n  free run on these runs: distance "
      << in_thousandths(fit.free_run_distance_rms_m, 2) << " mm RMS\n";
}

}  // namespace wheelwright::tools
