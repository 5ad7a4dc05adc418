// transport_delay: more delay than the linear model holds.
#include <array>
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class TransportDelay final : public EffectOf<TransportDelay> {
 public:
  explicit TransportDelay(const EffectArguments& arguments) : delay_s_(arguments.parameters[0]) {}

  // A delay between whole periods takes its share of both commands, as the mean over a period does.
  void command(WheelPair& command_m_s, const StepContext& context) override {
    past_[at_ % past_.size()] = command_m_s;
    const double periods = std::fmin(delay_s_ / context.period_s, static_cast<double>(past_.size() - 2));
    const auto whole = static_cast<std::size_t>(periods);
    const double share = periods - static_cast<double>(whole);
    const WheelPair& newer = past_[(at_ + past_.size() - whole) % past_.size()];
    const WheelPair& older = past_[(at_ + past_.size() - whole - 1) % past_.size()];
    command_m_s = {newer.left + share * (older.left - newer.left),
                   newer.right + share * (older.right - newer.right)};
    at_ = (at_ + 1) % past_.size();
  }
  void reset() override {
    past_.fill({});
    at_ = 0;
  }

 private:
  double delay_s_;
  std::array<WheelPair, 512> past_{};
  std::size_t at_ = 0;
};

}  // namespace

EffectInfo transport_delay() {
  return {
      "transport_delay",
      "more delay than the linear model holds",
      "Radio, USB or buffering between the program and the motors. A pure shift in time; fast changes of the "
      "command distinguish it from lag.",
      {{"", EffectStage::command}},
      {{"delay",
        "s",
        "time that passes before a command acts, beyond that of the linear part",
        0.0,
        3.0,
        {0.01, 0.02, 0.036, 0.054, 0.08, 0.11, 0.15, 0.2, 0.3, 0.42, 0.57, 0.75, 1.0, 1.35, 1.8, 2.4},
        0.015}},
      {},
      [](const EffectArguments& arguments) { return std::make_unique<TransportDelay>(arguments); },
      false,
      true};
}

}  // namespace wheelwright::effects
