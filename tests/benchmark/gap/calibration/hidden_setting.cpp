#include "tests/benchmark/gap/calibration/hidden_setting.hpp"

#include <algorithm>
#include <cmath>

#include "model/prediction/free_run.hpp"

namespace wheelwright::calibration {
namespace {

// Between the weakest and the strongest size of the sign that chance picks, evenly in the logarithm.
double random_size(const ParameterInfo& parameter, Random& random) {
  std::vector<double> sizes = parameter.sizes;
  std::erase(sizes, 0.0);
  if (sizes.empty()) return 0.5 * (parameter.lower + parameter.upper);
  std::uniform_int_distribution<std::size_t> any(0, sizes.size() - 1);
  const bool negative = sizes[any(random)] < 0.0;
  std::erase_if(sizes, [negative](double size) { return (size < 0.0) != negative; });
  const auto [weakest, strongest] =
      std::ranges::minmax(sizes, {}, [](double size) { return std::abs(size); });
  std::uniform_real_distribution<double> share(0.0, 1.0);
  return weakest * std::pow(strongest / weakest, share(random));
}

double fastest_command_m_s(const DriveLog& drive) {
  double fastest_m_s = 0.0;
  for (const DriveSample& sample : drive.samples)
    fastest_m_s =
        std::max({fastest_m_s, std::abs(sample.command_m_s.left), std::abs(sample.command_m_s.right)});
  return fastest_m_s;
}

}  // namespace

EffectSetting random_setting(const EffectInfo& info, const RobotModel& model, const DriveLog& drive,
                             Random& random) {
  EffectSetting setting{info.name, info.variants.front().name, {}};
  const auto& parameters = info.parameters_of(0);
  do {
    setting.parameters.clear();
    for (const ParameterInfo& parameter : parameters)
      setting.parameters.push_back(random_size(parameter, random));
  } while (info.in_character && !info.in_character({setting.parameters, 0}, fastest_command_m_s(drive)));
  const auto x = std::ranges::find(parameters, "x", &ParameterInfo::name);
  if (x == parameters.end()) return setting;
  const auto motion = free_run(model, drive);
  std::uniform_int_distribution<std::size_t> row(motion.size() / 8, motion.size() / 3);
  const Pose& at = motion[row(random)].pose;
  const auto place = static_cast<std::size_t>(x - parameters.begin());
  setting.parameters[place] = at.x_m;
  setting.parameters[place + 1] = at.y_m;
  return setting;
}

}  // namespace wheelwright::calibration
