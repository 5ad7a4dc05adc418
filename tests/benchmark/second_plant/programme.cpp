#include "tests/benchmark/second_plant/programme.hpp"

#include <cmath>
#include <functional>

#include "tests/benchmark/second_plant/manoeuvres.hpp"

namespace plants::second {

namespace {

struct PlannedPose {
  double x_m = 0.0;
  double y_m = 0.0;
  double heading_rad = 0.0;
};

// Where an ideal robot would be after the manoeuvre.
PlannedPose planned(PlannedPose pose, const Programme& part, const ProgrammeLimits& limits) {
  for (const PerWheel<double>& command_m_s : part) {
    const double travel_m = 0.5 * (command_m_s[left_side] + command_m_s[right_side]) * limits.period_s;
    pose.heading_rad += (command_m_s[right_side] - command_m_s[left_side]) / limits.track_m * limits.period_s;
    pose.x_m += travel_m * std::cos(pose.heading_rad);
    pose.y_m += travel_m * std::sin(pose.heading_rad);
  }
  return pose;
}

std::size_t row_total(const ProgrammeLimits& limits) {
  return static_cast<std::size_t>(std::lround(limits.duration_s / limits.period_s));
}

// Strings manoeuvres together; of several draws takes the first that ends inside the room.
Programme roam(const ProgrammeLimits& limits, const std::function<Programme()>& draw) {
  constexpr int draws = 12;
  Programme programme;
  append_hold(programme, limits, {0.0, 0.0}, 0.5);
  PlannedPose pose;
  while (programme.size() < row_total(limits)) {
    Programme best;
    double nearest_m = 1.0e9;
    for (int attempt = 0; attempt < draws && nearest_m > limits.room_radius_m; ++attempt) {
      Programme part = draw();
      const PlannedPose end = planned(pose, part, limits);
      const double distance_m = std::hypot(end.x_m, end.y_m);
      if (distance_m >= nearest_m) continue;
      nearest_m = distance_m;
      best = std::move(part);
    }
    pose = planned(pose, best, limits);
    programme.insert(programme.end(), best.begin(), best.end());
  }
  return programme;
}

Programme gentle_forward(const ProgrammeLimits& limits, Random& random) {
  constexpr double kGentle_m_s2 = 0.04;
  Programme programme;
  const auto speed_m_s = [&] { return random.uniform(0.3, 0.9) * limits.fastest_m_s; };
  PerWheel<double> last_m_s{0.0, 0.0};
  while (programme.size() < row_total(limits)) {
    const PerWheel<double> next_m_s{speed_m_s(), speed_m_s()};
    const double change_m_s = std::max(std::abs(next_m_s[left_side] - last_m_s[left_side]),
                                       std::abs(next_m_s[right_side] - last_m_s[right_side]));
    append_ramp(programme, limits, last_m_s, next_m_s, change_m_s / kGentle_m_s2);
    append_hold(programme, limits, next_m_s, random.uniform(0.5, 3.0));
    last_m_s = next_m_s;
  }
  return programme;
}

Programme straight_only(const ProgrammeLimits& limits, Random& random) {
  return roam(limits, [&] {
    Programme part;
    const double speed_m_s = random.uniform(-limits.fastest_m_s, limits.fastest_m_s);
    const double to_m_s =
        random.chance(0.3) ? random.uniform(-limits.fastest_m_s, limits.fastest_m_s) : speed_m_s;
    append_ramp(part, limits, {speed_m_s, speed_m_s}, {to_m_s, to_m_s}, random.uniform(0.6, 2.5));
    return part;
  });
}

Programme one_speed(const ProgrammeLimits& limits, Random& random) {
  const double speed_m_s = one_speed_m_s(limits.fastest_m_s);
  Programme programme;
  while (programme.size() < row_total(limits)) {
    const bool straight = random.chance(0.4);
    const double left_m_s = random.chance(0.6) ? speed_m_s : 0.0;
    const double right_m_s = straight ? left_m_s : speed_m_s - left_m_s;
    append_hold(programme, limits, {left_m_s, right_m_s}, random.uniform(0.4, 2.0));
  }
  return programme;
}

Programme one_heading(const ProgrammeLimits& limits, Random& random) {
  Programme programme;
  while (programme.size() < row_total(limits)) {
    const double speed_m_s = random.uniform(0.35, 1.0) * limits.fastest_m_s;
    append_hold(programme, limits, {speed_m_s, speed_m_s}, random.uniform(0.6, 2.5));
  }
  return programme;
}

Programme draw_style(Style style, const ProgrammeLimits& limits, Random& random) {
  switch (style) {
    case Style::gentle_forward:
      return gentle_forward(limits, random);
    case Style::straight_only:
      return straight_only(limits, random);
    case Style::one_speed:
      return one_speed(limits, random);
    case Style::one_heading:
      return one_heading(limits, random);
    case Style::no_small_commands:
      return roam(limits, [&] { return bold_manoeuvre(limits, limits.fastest_m_s / 3.0, random); });
    case Style::rich:
      break;
  }
  return roam(limits, [&] { return rich_manoeuvre(limits, random); });
}

// The wire carries whole millimetres per second.
double on_the_wire_m_s(double command_m_s) {
  return 0.001 * std::round(1000.0 * command_m_s);
}

}  // namespace

Programme random_programme(Style style, const ProgrammeLimits& limits, Random random) {
  Programme programme = draw_style(style, limits, random);
  programme.resize(row_total(limits));
  for (PerWheel<double>& command_m_s : programme)
    for (double& speed_m_s : command_m_s) speed_m_s = on_the_wire_m_s(speed_m_s);
  return programme;
}

}  // namespace plants::second
