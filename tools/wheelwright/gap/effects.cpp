// wheelwright effects: the library of effects, or one in full.
#include "model/effects/effect.hpp"

#include <algorithm>
#include <iomanip>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "config/load/text_format.hpp"
#include "config/load/yaml_reader.hpp"
#include "model/effects/library/effect_library.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/common/json_text.hpp"

namespace wheelwright::tools {
namespace {

using nlohmann::ordered_json;

std::string_view stage_name(EffectStage stage) {
  switch (stage) {
    case EffectStage::command:
      return "command";
    case EffectStage::wheel:
      return "wheel";
    case EffectStage::floor:
      return "floor";
    case EffectStage::body:
      return "body";
    case EffectStage::observation:
      return "reference";
    case EffectStage::counts:
      return "counts";
  }
  return "";
}

void print_list(std::ostream& out) {
  out << "  effect                 acts on    what is seen\n";
  for (const auto& info : effect_library()) {
    out << "  " << std::left << std::setw(23) << info.name << std::setw(11)
        << stage_name(info.variants.front().stage) << info.summary << "\n";
  }
  out << "\n'wheelwright effects NAME' says what causes it, what it takes to see it, and its parameters.\n";
}

std::vector<std::string> needs_of(const EffectNeeds& needs) {
  std::vector<std::string> list;
  if (needs.encoders) list.emplace_back("encoder counts");
  if (needs.place) {
    list.emplace_back("reference positions");
  } else if (needs.reference) {
    list.push_back(std::string(needs.heading ? "reference headings" : "reference poses") +
                   (needs.or_gyro ? " or a gyro" : ""));
  }
  if (needs.battery) list.emplace_back("the battery's voltage");
  if (needs.reversal) list.emplace_back("drives forward and backward");
  if (needs.turning) list.emplace_back("turns");
  if (needs.variety) list.emplace_back("commands of several sizes");
  return list;
}

void print_parameters(std::ostream& out, const std::vector<ParameterInfo>& parameters) {
  for (const auto& parameter : parameters) {
    out << "  " << std::left << std::setw(16) << parameter.name << std::setw(10)
        << (parameter.unit == "1" ? "-" : parameter.unit) << parameter.meaning << "; from "
        << config::plain_number(parameter.lower) << " to " << config::plain_number(parameter.upper) << "\n";
  }
}

void print_effect(std::ostream& out, const EffectInfo& info) {
  out << info.name << ": " << info.summary << "\n\n" << info.cause << "\n\n";
  out << "acts on:";
  for (const auto& variant : info.variants) {
    out << " " << stage_name(variant.stage) << (variant.name.empty() ? "" : " (" + variant.name + ")");
  }
  out << "\nparameters:\n";
  print_parameters(out, info.parameters);
  for (const auto& variant : info.variants) {
    if (variant.parameters.empty()) continue;
    out << "of " << variant.name << ":\n";
    print_parameters(out, variant.parameters);
  }
  const auto needs = needs_of(info.needs);
  out << "to be seen it takes:";
  for (std::size_t i = 0; i < needs.size(); ++i) out << (i > 0 ? ", " : " ") << needs[i];
  out << (needs.empty() ? " encoder counts or reference poses" : "") << "\n";
}

ordered_json to_json(const std::vector<ParameterInfo>& parameters) {
  ordered_json json = ordered_json::array();
  for (const auto& parameter : parameters) {
    json.push_back({{"name", parameter.name},
                    {"unit", parameter.unit},
                    {"meaning", parameter.meaning},
                    {"lower", parameter.lower},
                    {"upper", parameter.upper}});
  }
  return json;
}

ordered_json to_json(const EffectInfo& info) {
  ordered_json json{{"effect", info.name}, {"summary", info.summary}, {"cause", info.cause}};
  for (const auto& variant : info.variants) {
    ordered_json entry{{"name", variant.name}, {"acts_on", stage_name(variant.stage)}};
    if (!variant.parameters.empty()) entry["parameters"] = to_json(variant.parameters);
    json["variants"].push_back(std::move(entry));
  }
  json["parameters"] = to_json(info.parameters);
  json["needs"] = needs_of(info.needs);
  return json;
}

void print_library_as_json(std::ostream& out) {
  ordered_json all = ordered_json::array();
  for (const auto& info : effect_library()) all.push_back(to_json(info));
  out << json_text(all) << "\n";
}

struct EffectsOptions {
  std::string name;
  bool json = false;
};

ExitStatus run_effects(const EffectsOptions& options, Streams streams) {
  const std::string& name = options.name;
  if (name.empty()) {
    if (options.json) print_library_as_json(streams.out);
    if (!options.json) print_list(streams.out);
    return ExitStatus::done;
  }
  const EffectInfo* info = find_effect(name);
  if (info == nullptr) {
    std::vector<std::string> names;
    for (const auto& known : effect_library()) names.push_back(known.name);
    const std::string nearest = config::nearest_word(name, names);
    throw UsageError(
        "there is no effect '" + name + "'; " +
        (nearest.empty() ? "'wheelwright effects' lists them" : "did you mean '" + nearest + "'?"));
  }
  if (options.json) {
    streams.out << json_text(to_json(*info)) << "\n";
  } else {
    print_effect(streams.out, *info);
  }
  return ExitStatus::done;
}

}  // namespace

Action add_effects(CLI::App& app) {
  const auto options = std::make_shared<EffectsOptions>();
  CLI::App* command =
      app.add_subcommand("effects", "The effects that a model can hold beside its linear part");
  command->add_option("NAME", options->name, "Only this one, in full");
  command->add_flag("--json", options->json, "As JSON");
  command->footer("Example: wheelwright effects backlash");
  return [options](Streams streams) { return run_effects(*options, streams); };
}

}  // namespace wheelwright::tools
