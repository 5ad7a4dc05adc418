#include "tools/wheelwright/evaluation/end_point_plot.hpp"

#include <algorithm>
#include <cmath>

#include "config/load/text_format.hpp"

namespace wheelwright::tools {
namespace {

using config::fixed_number;
using config::plain_number;

// Half the width of a panel: all end points and published circles fit, in steps of 0.1 m.
double half_width_m(const std::vector<AttemptOutcome>& outcomes) {
  double farthest_m = 0.0;
  for (const Candidate& candidate : candidates) {
    if (candidate.published) farthest_m = std::max(farthest_m, candidate.published->mean_m);
  }
  for (const AttemptOutcome& outcome : outcomes) {
    for (const auto& drive : outcome) {
      if (drive && drive->end)
        farthest_m = std::max({farthest_m, std::abs(drive->end->x_m), std::abs(drive->end->y_m)});
    }
  }
  return 0.1 * std::ceil(10.5 * farthest_m);
}

std::string panel(const Candidate& candidate, const std::string& csv_name) {
  const std::string key(candidate.key);
  std::string text = "set title \"" + std::string(candidate.title) + "\"\nunset object 1\n";
  if (candidate.published) {
    text += "set object 1 circle at 0,0 size " + plain_number(candidate.published->mean_m) +
            " fillstyle empty border lc rgb '#d1495b' dt 2\n";
  }
  return text + "plot '" + csv_name + "' using (strcol(1) eq '" + key +
         "' ? $3 : NaN):4 with points pt 7 ps 0.4 lc rgb '#1f6fb4' notitle, "
         "'+' using (0):(0) with points pt 2 ps 1 lw 2 lc rgb 'black' notitle\n";
}

std::string estimate_fields(const std::optional<EndEstimate>& estimate) {
  if (!estimate) return ",,,,,,,";
  std::string fields;
  for (const double value : {estimate->pose.x_m, estimate->pose.y_m, estimate->pose.theta_rad}) {
    fields += "," + fixed_number(value, 6);
  }
  const Eigen::Matrix3d& covariance = estimate->covariance;
  for (const double value : {covariance(0, 0), covariance(0, 1), covariance(1, 1), covariance(2, 2)}) {
    fields += "," + fixed_number(value, 12);
  }
  return fields;
}

}  // namespace

std::string end_points_csv(const std::vector<AttemptOutcome>& outcomes) {
  std::string text =
      "model,attempt,x,y,theta,estimate_x,estimate_y,estimate_theta,cov_xx,cov_xy,cov_yy,cov_thetatheta\n";
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    for (std::size_t attempt = 0; attempt < outcomes.size(); ++attempt) {
      const auto& drive = outcomes[attempt].at(i);
      if (!drive || !drive->end) continue;
      const Pose& end = *drive->end;
      text += std::string(candidates.at(i).key) + "," + std::to_string(attempt) + "," +
              fixed_number(end.x_m, 6) + "," + fixed_number(end.y_m, 6) + "," +
              fixed_number(end.theta_rad, 6) + estimate_fields(drive->estimate) + "\n";
    }
  }
  return text;
}

std::string end_points_script(const std::vector<AttemptOutcome>& outcomes, const std::string& csv_name,
                              const std::string& svg_name) {
  const std::string half = plain_number(half_width_m(outcomes));
  std::vector<Candidate> drawn;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (outcomes.front().at(i)) drawn.push_back(candidates.at(i));
  }
  const std::string panels = std::to_string(drawn.size());
  std::string text = "set terminal svg size " + std::to_string(360 * drawn.size()) +
                     ",400 font 'sans,12' background rgb 'white'\n"
                     "set output '" +
                     svg_name +
                     "'\n"
                     "set datafile separator ','\n"
                     "set size square\nset grid lc rgb '#dddddd'\nset samples 2\n"
                     "set xrange [-" +
                     half + ":" + half + "]\nset yrange [-" + half + ":" + half +
                     "]\n"
                     "set xlabel 'x [m]'\nset ylabel 'y [m]'\n"
                     "set multiplot layout 1," +
                     panels +
                     " title 'End points of each attempt; cross: start; dashed: published mean offset'\n";
  for (const Candidate& candidate : drawn) text += panel(candidate, csv_name);
  return text + "unset multiplot\n";
}

}  // namespace wheelwright::tools
