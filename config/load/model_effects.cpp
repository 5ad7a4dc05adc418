#include "config/load/model_effects.hpp"

#include "config/load/text_format.hpp"
#include "model/effects/library/effect_library.hpp"

namespace wheelwright::config {
namespace {

std::string known_effects() {
  std::string names;
  for (const auto& info : effect_library()) names += (names.empty() ? "" : ", ") + info.name;
  return names;
}

const EffectInfo& read_name(YamlReader& entry) {
  const std::string name = entry.text("name");
  if (const EffectInfo* info = find_effect(name)) return *info;
  std::vector<std::string> names;
  for (const auto& info : effect_library()) names.push_back(info.name);
  const std::string nearest = nearest_word(name, names);
  entry.fail("name",
             "is '" + name + "', which is no effect; " +
                 (nearest.empty() ? "there are " + known_effects() : "did you mean '" + nearest + "'?"));
}

void read_intervals(YamlReader& entry, AddedEffect& effect) {
  auto section = entry.section("ci95");
  if (!section) return;
  for (const auto& parameter : parameters_of(effect.setting)) {
    if (parameter.if_absent && !section->has(parameter.name)) {
      effect.intervals.push_back({*parameter.if_absent, *parameter.if_absent});
      continue;
    }
    const std::vector<double> ends = section->numbers(parameter.name, {-1e9, 1e9});
    if (ends.size() != 2) section->fail(parameter.name, "must be [lowest, highest]");
    effect.intervals.push_back({ends[0], ends[1]});
  }
  section->finish();
}

AddedEffect read_effect(YamlReader entry) {
  const EffectInfo& info = read_name(entry);
  AddedEffect effect;
  effect.setting.name = info.name;
  effect.setting.variant = entry.text("variant", info.variants.front().name);
  try {
    variant_index(info, effect.setting.variant);
  } catch (const std::invalid_argument& error) {
    entry.fail("variant", error.what());
  }
  auto parameters = entry.section("parameters");
  if (!parameters) entry.fail("parameters", "is missing here; it must hold the effect's parameters");
  for (const auto& parameter : parameters_of(effect.setting)) {
    const Range range{parameter.lower, parameter.upper, parameter.unit};
    effect.setting.parameters.push_back(parameter.if_absent
                                            ? parameters->number(parameter.name, range, *parameter.if_absent)
                                            : parameters->number(parameter.name, range));
  }
  parameters->finish();
  read_intervals(entry, effect);
  effect.source = entry.texts("source");
  effect.created = entry.text("created", "");
  if (entry.has("heldout_gain_nats"))
    effect.heldout_gain_nats = entry.number("heldout_gain_nats", {-1e12, 1e12});
  if (entry.has("p_value")) effect.p_value = entry.number("p_value", {0.0, 1.0});
  entry.finish();
  return effect;
}

std::string effect_to_yaml(const AddedEffect& effect) {
  const EffectInfo* info = find_effect(effect.setting.name);
  const auto parameters = parameters_of(effect.setting);
  if (info == nullptr || parameters.size() != effect.setting.parameters.size()) {
    throw ConfigError("effect '" + effect.setting.name + "' is not one of the library and cannot be written");
  }
  std::string text = "  - name: " + info->name + "  # " + info->summary + "\n";
  if (!effect.setting.variant.empty()) text += "    variant: " + effect.setting.variant + "\n";
  text += "    parameters:\n";
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const ParameterInfo& parameter = parameters[i];
    text += "      " + parameter.name + ": " + plain_number(effect.setting.parameters[i]) + "  # " +
            (parameter.unit == "1" ? "" : parameter.unit + ", ") + parameter.meaning + "\n";
  }
  if (!effect.intervals.empty()) text += "    ci95:\n";
  for (std::size_t i = 0; i < effect.intervals.size(); ++i) {
    text += "      " + parameters[i].name + ": [" + plain_number(effect.intervals[i].lower) + ", " +
            plain_number(effect.intervals[i].upper) + "]\n";
  }
  if (!effect.source.empty()) text += "    source:\n";
  for (const auto& source : effect.source) text += "      - " + quoted(source) + "\n";
  if (!effect.created.empty()) text += "    created: " + quoted(effect.created) + "\n";
  if (effect.heldout_gain_nats) {
    text += "    heldout_gain_nats: " + plain_number(*effect.heldout_gain_nats) +
            "  # of log likelihood, on runs that were not used to fit it\n";
  }
  if (effect.p_value) text += "    p_value: " + plain_number(*effect.p_value) + "\n";
  return text;
}

}  // namespace

std::vector<AddedEffect> read_effects(YamlReader& file) {
  std::vector<AddedEffect> effects;
  for (auto& entry : file.sections("effects")) effects.push_back(read_effect(std::move(entry)));
  return effects;
}

std::string effects_to_yaml(const std::vector<AddedEffect>& effects) {
  if (effects.empty()) return "";
  std::string text =
      "\n# What the linear part lacks, in the order in which it acts; 'wheelwright effects' explains each.\n"
      "effects:\n";
  for (const auto& effect : effects) text += effect_to_yaml(effect);
  return text;
}

}  // namespace wheelwright::config
