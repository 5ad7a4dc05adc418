#include "model/effects/library/each_wheel_variants.hpp"

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "model/effects/library/effect_library.hpp"

namespace wheelwright {
namespace {

// Two effects, each of which has the size of one wheel, and what each does to that wheel.
class EachWheel final : public Effect {
 public:
  EachWheel(std::unique_ptr<Effect> left, std::unique_ptr<Effect> right)
      : left_(std::move(left)), right_(std::move(right)) {}

  void command(WheelPair& command_m_s, const StepContext& context) override {
    act(&Effect::command, command_m_s, context);
  }
  void wheel(WheelPair& speed_m_s, const StepContext& context) override {
    act(&Effect::wheel, speed_m_s, context);
  }
  void floor(WheelPair& speed_m_s, const StepContext& context) override {
    act(&Effect::floor, speed_m_s, context);
  }
  WheelPair rolling() const override { return {left_->rolling().left, right_->rolling().right}; }
  EffectHooks hooks() const override { return left_->hooks(); }
  void reset() override {
    left_->reset();
    right_->reset();
  }
  std::unique_ptr<Effect> clone() const override {
    return std::make_unique<EachWheel>(left_->clone(), right_->clone());
  }
  void assign(const Effect& other) override {
    const auto& from = static_cast<const EachWheel&>(other);
    left_->assign(*from.left_);
    right_->assign(*from.right_);
  }

 private:
  void act(void (Effect::*hook)(WheelPair&, const StepContext&), WheelPair& pair,
           const StepContext& context) {
    WheelPair of_left = pair;
    WheelPair of_right = pair;
    ((*left_).*hook)(of_left, context);
    ((*right_).*hook)(of_right, context);
    pair = {of_left.left, of_right.right};
  }

  std::unique_ptr<Effect> left_;
  std::unique_ptr<Effect> right_;
};

std::vector<ParameterInfo> of_each(const std::vector<ParameterInfo>& alike) {
  std::vector<ParameterInfo> parameters;
  for (const ParameterInfo& parameter : alike) {
    if (!parameter.scales_effect) {
      parameters.push_back(parameter);
      continue;
    }
    for (const char* side : {"left", "right"}) {
      ParameterInfo& own = parameters.emplace_back(parameter);
      own.name += std::string("_") + side;
      own.meaning += std::string(", ") + side + " wheel";
    }
  }
  return parameters;
}

// Where the parameters of the effect that has the size of one wheel at both stand.
std::vector<std::size_t> places(WheelSide wheel, const std::vector<ParameterInfo>& alike) {
  std::vector<std::size_t> at;
  std::size_t next = 0;
  for (const ParameterInfo& parameter : alike) {
    const bool is_of_right = parameter.scales_effect && wheel == WheelSide::right;
    at.push_back(next + (is_of_right ? 1 : 0));
    next += parameter.scales_effect ? 2 : 1;
  }
  return at;
}

std::vector<double> taken(std::span<const double> values, const std::vector<std::size_t>& at) {
  std::vector<double> some;
  some.reserve(at.size());
  for (const std::size_t place : at) some.push_back(values[place]);
  return some;
}

}  // namespace

EffectInfo with_each_wheel_variants(EffectInfo info) {
  const std::size_t count = info.variants.size();
  const EffectInfo alike = info;
  for (std::size_t i = 0; i < count; ++i) {
    EffectVariant variant = alike.variants[i];
    variant.name += variant.name.empty() ? "each_wheel" : "_each_wheel";
    variant.parameters = of_each(alike.parameters_of(i));
    variant.alike = i;
    info.variants.push_back(std::move(variant));
  }
  const auto at = [alike, count](WheelSide wheel, const EffectArguments& arguments) {
    return taken(arguments.parameters, places(wheel, alike.parameters_of(arguments.variant - count)));
  };
  info.cause += " 'each_wheel': not alike at both wheels.";
  info.make = [alike, count, at](const EffectArguments& arguments) -> std::unique_ptr<Effect> {
    if (arguments.variant < count) return alike.make(arguments);
    const std::size_t variant = arguments.variant - count;
    const std::vector<double> left = at(WheelSide::left, arguments);
    const std::vector<double> right = at(WheelSide::right, arguments);
    return std::make_unique<EachWheel>(alike.make({left, variant}), alike.make({right, variant}));
  };
  if (alike.in_character) {
    info.in_character = [alike, count, at](const EffectArguments& arguments, double largest_command_m_s) {
      if (arguments.variant < count) return alike.in_character(arguments, largest_command_m_s);
      const std::vector<double> left = at(WheelSide::left, arguments);
      const std::vector<double> right = at(WheelSide::right, arguments);
      return alike.in_character({left, arguments.variant - count}, largest_command_m_s) ||
             alike.in_character({right, arguments.variant - count}, largest_command_m_s);
    };
  }
  return info;
}

EffectSetting as_at(WheelSide wheel, const EffectSetting& setting) {
  if (!is_of_each_wheel(setting)) return setting;
  const EffectInfo& info = *find_effect(setting.name);
  const std::size_t alike = *info.variants[variant_index(info, setting.variant)].alike;
  return {setting.name, info.variants[alike].name,
          taken(setting.parameters, places(wheel, info.parameters_of(alike)))};
}

std::vector<std::size_t> places_at(WheelSide wheel, const EffectSetting& setting) {
  std::vector<std::size_t> all(setting.parameters.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  if (!is_of_each_wheel(setting)) return all;
  const EffectInfo& info = *find_effect(setting.name);
  return places(wheel, info.parameters_of(*info.variants[variant_index(info, setting.variant)].alike));
}

bool is_of_each_wheel(const EffectSetting& setting) {
  const EffectInfo* info = find_effect(setting.name);
  return info != nullptr && info->variants[variant_index(*info, setting.variant)].alike.has_value();
}

EffectSetting of_each_wheel(const EffectSetting& setting) {
  const EffectInfo* info = find_effect(setting.name);
  if (info == nullptr) return setting;
  const std::size_t alike = variant_index(*info, setting.variant);
  const auto variant = std::ranges::find(info->variants, std::optional(alike), &EffectVariant::alike);
  if (variant == info->variants.end()) return setting;
  EffectSetting each{setting.name, variant->name, {}};
  const std::vector<ParameterInfo>& parameters = info->parameters_of(alike);
  for (std::size_t i = 0; i < parameters.size(); ++i)
    each.parameters.insert(each.parameters.end(), parameters[i].scales_effect ? 2 : 1, setting.parameters[i]);
  return each;
}

}  // namespace wheelwright
