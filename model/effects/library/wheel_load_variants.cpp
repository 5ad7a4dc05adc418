#include "model/effects/library/wheel_load_variants.hpp"

#include <utility>

namespace wheelwright {
namespace {

class AtTheWheels final : public Effect {
 public:
  explicit AtTheWheels(std::unique_ptr<Effect> inner) : inner_(std::move(inner)) {}

  void wheel(WheelPair& speed_m_s, const StepContext& context) override {
    StepContext now = context;
    now.next_speed_m_s = speed_m_s;
    const WheelPair& rolling = context.rolling;
    Twist twist = twist_of_wheels({speed_m_s.left * rolling.left, speed_m_s.right * rolling.right},
                                  context.wheel_base_m);
    inner_->body(twist, now);
    const WheelPair floor_m_s = wheels_of_twist(twist, context.wheel_base_m);
    speed_m_s = {floor_m_s.left / rolling.left, floor_m_s.right / rolling.right};
  }
  EffectHooks hooks() const override { return {.wheel = true, .load = true}; }
  void reset() override { inner_->reset(); }
  std::unique_ptr<Effect> clone() const override { return wheel_load_variants(inner_->clone()); }
  void assign(const Effect& other) override {
    inner_->assign(*static_cast<const AtTheWheels&>(other).inner_);
  }

 private:
  std::unique_ptr<Effect> inner_;
};

}  // namespace

std::unique_ptr<Effect> wheel_load_variants(std::unique_ptr<Effect> effect) {
  return std::make_unique<AtTheWheels>(std::move(effect));
}

EffectInfo with_wheel_load_variants(EffectInfo info) {
  const std::size_t count = info.variants.size();
  for (std::size_t i = 0; i < count; ++i) {
    EffectVariant variant = info.variants[i];
    variant.name += variant.name.empty() ? "at_wheels" : "_at_wheels";
    variant.stage = EffectStage::wheel;
    info.variants.push_back(std::move(variant));
  }
  info.make = [make = std::move(info.make), count](const EffectArguments& arguments) {
    if (arguments.variant < count) return make(arguments);
    return wheel_load_variants(make({arguments.parameters, arguments.variant - count}));
  };
  return info;
}

}  // namespace wheelwright
