#include "model/gap/candidates/steady_response.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright::gap {
namespace {

constexpr int commands_each_way = 100;
constexpr double held_s = 6.0;           // until a wheel has come to its speed, behind any delay
constexpr double beyond_fastest = 1.25;  // what an effect may make of the fastest command

double held(ModelSimulation simulation, double command_m_s, double period_s) {
  for (double time_s = 0.0; time_s < held_s; time_s += period_s) simulation.step({command_m_s, command_m_s});
  const WheelPair speed_m_s = simulation.motion().wheel_m_s;
  return 0.5 * (speed_m_s.left + speed_m_s.right);
}

}  // namespace

SteadyResponse::SteadyResponse(const TrialModel& model, double fastest_m_s) {
  if (model.effects.empty() || fastest_m_s <= 0.0) return;
  TrialModel linear_part = model;
  linear_part.effects.clear();
  const double gain = held(linear_part.simulation(), 1.0, model.period_s);
  if (!(gain > 0.0)) return;
  apart_m_s_ = beyond_fastest * fastest_m_s / commands_each_way;
  ModelSimulation simulation = model.simulation();
  simulation.leave_out_place();
  for (int i = -commands_each_way; i <= commands_each_way; ++i)
    size_m_s_.push_back(held(simulation, i * apart_m_s_, model.period_s) / gain);
}

double SteadyResponse::at(double command_m_s) const {
  if (size_m_s_.empty()) return command_m_s;
  const double place = std::clamp(command_m_s / apart_m_s_ + commands_each_way, 0.0,
                                  static_cast<double>(size_m_s_.size() - 1));
  const std::size_t below = std::min(static_cast<std::size_t>(place), size_m_s_.size() - 2);
  const double share = place - static_cast<double>(below);
  return size_m_s_[below] + share * (size_m_s_[below + 1] - size_m_s_[below]);
}

double SteadyResponse::slope(double command_m_s) const {
  if (size_m_s_.empty()) return 1.0;
  return (at(command_m_s + apart_m_s_) - at(command_m_s - apart_m_s_)) / (2.0 * apart_m_s_);
}

}  // namespace wheelwright::gap
