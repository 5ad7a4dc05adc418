#include "tests/benchmark/fifth_plant/person.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace plants::fifth {

std::string name_of(Programme programme) {
  constexpr std::array names{std::pair{Programme::teleoperation, "teleoperation"},
                             std::pair{Programme::docking, "docking"},
                             std::pair{Programme::laps, "laps"},
                             std::pair{Programme::patrol, "patrol"},
                             std::pair{Programme::slow, "slow"},
                             std::pair{Programme::corridor, "corridor"},
                             std::pair{Programme::straight_on, "straight_on"},
                             std::pair{Programme::turning, "turning"},
                             std::pair{Programme::errands, "errands"}};
  return std::ranges::find(names, programme, &std::pair<Programme, const char*>::first)->second;
}

Person::Person(Programme programme, const Style& style, double period_s, double duration_s,
               const Random& random)
    : style_(style),
      period_s_(period_s),
      duration_s_(duration_s),
      intent_(make_intent(programme, style, random)) {
  if (programme == Programme::errands) style_.hurry_m_s2 = std::max(style_.hurry_m_s2, 3.0);
}

PerWheel<double> Person::command(double time_s, const Pose& seen) {
  constexpr double rest_s = 1.2;
  constexpr double turning_per_forward = 3.5;  // rad/s^2 for a m/s^2: the stick turns quicker than it pushes
  const bool resting = time_s < rest_s || time_s > duration_s_ - rest_s;
  const Twist wanted = resting ? Twist{} : intent_->want(time_s, seen);
  const double max_m_s = style_.hurry_m_s2 * period_s_;
  const double max_rad_s = turning_per_forward * max_m_s;
  stick_.forward_m_s += std::clamp(wanted.forward_m_s - stick_.forward_m_s, -max_m_s, max_m_s);
  stick_.turn_rad_s += std::clamp(wanted.turn_rad_s - stick_.turn_rad_s, -max_rad_s, max_rad_s);
  const double half_turn_m_s = 0.5 * style_.wheel_base_m * stick_.turn_rad_s;
  PerWheel<double> command_m_s{stick_.forward_m_s - half_turn_m_s, stick_.forward_m_s + half_turn_m_s};
  const double fastest = std::max(std::abs(command_m_s[left_side]), std::abs(command_m_s[right_side]));
  const double share = std::min(1.0, style_.top_m_s / std::max(fastest, 1e-9));
  for (double& speed : command_m_s) speed = std::round(1000.0 * share * speed) / 1000.0;
  return command_m_s;
}

}  // namespace plants::fifth
