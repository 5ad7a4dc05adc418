#include "model/gap/candidates/decoys.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/effects/library/wheel_load_variants.hpp"

namespace wheelwright::gap {
namespace {

constexpr double default_speed_m_s = 0.2;

// A smooth even map of the command.
class SmoothEven final : public EffectOf<SmoothEven> {
 public:
  explicit SmoothEven(const EffectArguments& arguments) : size_(arguments.parameters[0]) {}
  void command(WheelPair& command_m_s, const StepContext&) override {
    both(command_m_s, [this](double u) { return u + size_ * u * u / default_speed_m_s; });
  }

 private:
  double size_;
};

// The other wheel's command, or its size, takes from this one's.
class CrossTalk final : public EffectOf<CrossTalk> {
 public:
  explicit CrossTalk(const EffectArguments& arguments)
      : size_(arguments.parameters[0]), variant_(arguments.variant) {}
  void command(WheelPair& command_m_s, const StepContext&) override {
    const WheelPair u = command_m_s;
    command_m_s = {u.left + size_ * share(u.left, u.right), u.right + size_ * share(u.right, u.left)};
  }

 private:
  double share(double own, double other) const {
    if (variant_ == 0) return std::abs(other);
    return own * std::abs(other) / default_speed_m_s;
  }
  double size_;
  std::size_t variant_;
};

// The gain follows what was commanded over the last seconds: later than a bend of the gain would, and sooner
// than what warms up.
class HistoryGain final : public EffectOf<HistoryGain> {
 public:
  explicit HistoryGain(const EffectArguments& arguments)
      : size_(arguments.parameters[0]), time_s_(arguments.parameters[1]) {}
  void command(WheelPair& command_m_s, const StepContext& context) override {
    const double share = context.period_s / (context.period_s + time_s_);
    past_.left += share * (std::abs(command_m_s.left) - past_.left);
    past_.right += share * (std::abs(command_m_s.right) - past_.right);
    command_m_s.left *= 1.0 + size_ * past_.left / default_speed_m_s;
    command_m_s.right *= 1.0 + size_ * past_.right / default_speed_m_s;
  }
  void reset() override { past_ = {}; }

 private:
  double size_;
  double time_s_;
  WheelPair past_;
};

// The speed of a moment ago holds the wheel back or pushes it on, more than in proportion.
class SpeedMemory final : public EffectOf<SpeedMemory> {
 public:
  explicit SpeedMemory(const EffectArguments& arguments)
      : size_(arguments.parameters[0]), time_s_(arguments.parameters[1]) {}
  void command(WheelPair& command_m_s, const StepContext& context) override {
    const double share = context.period_s / (context.period_s + time_s_);
    past_.left += share * (context.speed_m_s.left - past_.left);
    past_.right += share * (context.speed_m_s.right - past_.right);
    command_m_s.left += size_ * past_.left * std::abs(past_.left) / default_speed_m_s;
    command_m_s.right += size_ * past_.right * std::abs(past_.right) / default_speed_m_s;
  }
  void reset() override { past_ = {}; }

 private:
  double size_;
  double time_s_;
  WheelPair past_;
};

// A swing of the gain with time.
class SlowSwing final : public EffectOf<SlowSwing> {
 public:
  explicit SlowSwing(const EffectArguments& arguments)
      : sine_(arguments.parameters[0]),
        cosine_(arguments.parameters[1]),
        period_s_(arguments.parameters[2]) {}
  void command(WheelPair& command_m_s, const StepContext& context) override {
    const double angle = 2.0 * 3.14159265358979 * context.time_s / period_s_;
    const double gain = 1.0 + sine_ * std::sin(angle) + cosine_ * std::cos(angle);
    both(command_m_s, [gain](double u) { return gain * u; });
  }

 private:
  double sine_;
  double cosine_;
  double period_s_;
};

// Smooth odd and even maps of the body's motion onto itself.
class BodyCoupling final : public EffectOf<BodyCoupling> {
 public:
  explicit BodyCoupling(const EffectArguments& arguments)
      : size_(arguments.parameters[0]), variant_(arguments.variant) {}
  void body(Twist& twist, const StepContext&) override {
    const Twist t = twist;
    if (variant_ == 0) twist.v_m_s += size_ * t.v_m_s * t.w_rad_s;
    if (variant_ == 1) twist.w_rad_s += size_ * t.v_m_s * std::abs(t.v_m_s) / default_speed_m_s;
    if (variant_ == 2) twist.w_rad_s += size_ * t.w_rad_s * std::abs(t.v_m_s) / default_speed_m_s;
    if (variant_ == 3) twist.v_m_s += size_ * t.v_m_s * std::abs(t.v_m_s) / default_speed_m_s;
    if (variant_ == 4) twist.w_rad_s += size_ * std::abs(t.w_rad_s);
  }

 private:
  double size_;
  std::size_t variant_;
};

// `as_if` completes "it is as if".
template <typename Decoy>
EffectInfo decoy(const std::string& name, const std::string& as_if, std::vector<std::string> variants,
                 EffectStage stage, std::vector<ParameterInfo> parameters) {
  EffectInfo info{
      name, as_if, "", {}, std::move(parameters), {.variety = true}, [](const EffectArguments& arguments) {
        return std::make_unique<Decoy>(arguments);
      }};
  for (auto& variant : variants) info.variants.push_back({std::move(variant), stage});
  return info;
}

ParameterInfo size(double smallest) {
  return {"size", "1", "", -1.0, 1.0, {-smallest, smallest}};
}

std::vector<EffectInfo> make_decoys() {
  return {
      decoy<SmoothEven>("decoy_even",
                        "wheels were quicker forward and slower backward the larger the command", {""},
                        EffectStage::command, {size(0.05)}),
      decoy<CrossTalk>("decoy_cross_talk", "the command of one wheel took from the other wheel",
                       {"size", "product"}, EffectStage::command, {size(0.05)}),
      decoy<HistoryGain>(
          "decoy_history", "the gain followed how hard the wheels were driven in the seconds before", {""},
          EffectStage::command, {size(0.05), {"time", "s", "", 1.5, 8.0, {2.0, 6.0}, 0.0, false}}),
      decoy<SpeedMemory>("decoy_memory", "the speed of the seconds before held a wheel back or pushed it on",
                         {""}, EffectStage::command,
                         {size(0.05), {"time", "s", "", 0.3, 10.0, {0.4, 1.5}, 0.0, false}}),
      decoy<SlowSwing>("decoy_swing", "the gain swung slowly with time", {""}, EffectStage::command,
                       {{"sine", "1", "", -0.5, 0.5, {0.05}},
                        {"cosine", "1", "", -0.5, 0.5, {0.05}},
                        {"period", "s", "", 2.0, 300.0, {5.0, 15.0, 40.0}, 0.0, false}}),
      with_wheel_load_variants(decoy<BodyCoupling>("decoy_body", "travelling and turning acted on each other",
                                                   {"v*w", "v*|v| to w", "w*|v|", "v*|v|", "|w|"},
                                                   EffectStage::body, {size(0.05)})),
  };
}

}  // namespace

std::span<const EffectInfo> decoys() {
  static const std::vector<EffectInfo> all = make_decoys();
  return all;
}

bool is_decoy(const EffectInfo& info) {
  return info.name.starts_with("decoy_");
}

}  // namespace wheelwright::gap
