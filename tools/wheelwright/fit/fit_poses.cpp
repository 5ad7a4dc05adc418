#include "tools/wheelwright/fit/fit_poses.hpp"

#include <iomanip>
#include <ostream>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/common/parallel_for.hpp"
#include "tools/wheelwright/common/progress_line.hpp"

namespace wheelwright::tools {
namespace {

using nlohmann::ordered_json;

void print_estimate(std::ostream& out, const std::string& what, const gap::Estimate& estimate, double factor,
                    int digits) {
  const auto text = [&](double value) { return config::fixed_number(factor * value, digits); };
  out << "  " << std::left << std::setw(24) << what << std::right << std::setw(10) << text(estimate.value)
      << "   95 % " << text(estimate.interval.lower) << " to " << text(estimate.interval.upper) << "\n";
}

ordered_json estimate_json(const gap::Estimate& estimate) {
  return {{"value", estimate.value}, {"ci95", {estimate.interval.lower, estimate.interval.upper}}};
}

}  // namespace

gap::PoseFit fit_poses(const std::vector<DriveLog>& runs, std::ostream& err) {
  ProgressLine progress(err);
  auto fit = gap::fit_from_poses(runs, parallel_for(), progress.callback());
  progress.clear();
  if (!fit) throw DataRefusal(fit.error().reason);
  return std::move(*fit);
}

void print_pose_fit(std::ostream& out, const gap::PoseFit& fit, std::size_t runs) {
  out << "arma model from " << runs << (runs == 1 ? " run, " : " runs, ") << fit.poses
      << " reference poses and no encoder counts\n\n";
  print_estimate(out, "gain, left wheel", fit.left_gain, 1.0, 4);
  print_estimate(out, "gain, right wheel", fit.right_gain, 1.0, 4);
  print_estimate(out, "lag [ms]", fit.lag_s, 1000.0, 1);
  print_estimate(out, "wheel base [m]", fit.wheel_base_m, 1.0, 4);
  out << "\n  gain is m/s reached per m/s commanded; lag is that of the poses behind the commands: delay, "
         "motors "
         "and\n  what the reference itself is late; the wheel base is that which turning shows (the logs say "
      << config::plain_number(fit.given_wheel_base_m)
      << " m)\n  both wheels have one response but for a gain of each: counts would tell them apart\n";
}

ordered_json pose_fit_json(const gap::PoseFit& fit, std::size_t runs, const std::string& model_file) {
  return {{"model", model_file},
          {"runs", runs},
          {"type", "arma"},
          {"by", "poses"},
          {"poses", fit.poses},
          {"gain_left", estimate_json(fit.left_gain)},
          {"gain_right", estimate_json(fit.right_gain)},
          {"lag_s", estimate_json(fit.lag_s)},
          {"wheel_base_m", estimate_json(fit.wheel_base_m)}};
}

}  // namespace wheelwright::tools
