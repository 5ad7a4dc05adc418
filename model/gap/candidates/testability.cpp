#include "model/gap/candidates/testability.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>

#include "model/effects/library/effect_library.hpp"
#include "model/gap/candidates/decoys.hpp"
#include "model/gap/candidates/travel_directions.hpp"
#include "model/gap/runs/gyro_turns.hpp"
#include "model/statistics/significant_digits.hpp"

namespace wheelwright::gap {
namespace {

constexpr double min_voltage_change = 0.01;  // relative, over all logs

constexpr double level_m_s = 0.005;  // commands nearer than this count as one size
constexpr double min_level_s = 0.3;  // in all, for a size of command to count
constexpr std::size_t enough_levels = 4;

struct Contents {
  std::map<long, double> levels_s;  // time at each size of command, of either wheel
  bool counts = false;
  bool reference = false;
  bool place = false;
  bool gyro = false;
  std::string scale_from;         // of the counts; empty where it is stated
  bool scaled_by_counts = false;  // the reference
  Excitation excitation;
  TravelDirections directions;
  double lowest_v = std::numeric_limits<double>::infinity();
  double highest_v = 0.0;
};

Contents contents_of(std::span<const DriveLog> logs) {
  Contents contents;
  for (const auto& log : logs) {
    if (log.has_ticks()) contents.counts = true;
    if (log.has_ticks() && has_gyro(log)) contents.gyro = true;
    contents.directions.add(log);
    contents.scaled_by_counts = contents.scaled_by_counts || log.reference_scaled_by_counts;
    for (const auto& [key, value] : log.other_metadata) {
      if (key == scale_from_key) contents.scale_from = value;
    }
    std::size_t references = 0;
    for (std::size_t i = 0; i < log.samples.size(); ++i) {
      const auto& sample = log.samples[i];
      const double duration = i + 1 < log.samples.size() ? log.samples[i + 1].t_s - sample.t_s : 0.0;
      const WheelPair& u = sample.command_m_s;
      contents.excitation.reverse_m += duration * std::max(0.0, -std::min(u.left, u.right));
      contents.excitation.forward_m += duration * std::max(0.0, std::max(u.left, u.right));
      contents.excitation.turned_rad += duration * std::abs(u.right - u.left) / log.wheel_base_m;
      for (const double command : {u.left, u.right}) {
        const long level = std::lround(std::abs(command) / level_m_s);
        if (level > 0) contents.levels_s[level] += duration;
      }
      if (sample.reference_theta_rad) ++references;
      if (sample.reference_pose()) contents.place = true;
      if (sample.battery_v) {
        contents.lowest_v = std::min(contents.lowest_v, *sample.battery_v);
        contents.highest_v = std::max(contents.highest_v, *sample.battery_v);
      }
    }
    if (references >= 2) contents.reference = true;
  }
  return contents;
}

std::string missing_for(const EffectInfo& info, const Contents& contents) {
  const EffectNeeds& needs = info.needs;
  if (needs.encoders && !contents.counts) return "the logs hold no encoder counts";
  if (needs.reference && !contents.reference && !(needs.or_gyro && contents.gyro)) {
    return contents.gyro ? "the logs hold no reference poses, and a gyro alone does not show it"
                         : "the logs hold no reference poses";
  }
  if (needs.place && !contents.place) return "the logs hold no reference positions";
  if (needs.scale && !contents.scale_from.empty()) {
    return "how far a count goes was found from the " + contents.scale_from +
           "; give wheels.metres_per_count as its maker states it";
  }
  if (needs.scale && contents.scaled_by_counts)
    return "the reference's metre was made that of the counts, since it is not the same in all directions";
  if (needs.battery && !(contents.highest_v > 0.0)) return "the logs hold no battery voltage";
  if (needs.battery && contents.highest_v < (1.0 + min_voltage_change) * contents.lowest_v) {
    return "the battery voltage does not change in these logs";
  }
  // However little there is of either, what it shows is for the noise to say: detectable_sizes.
  const Excitation& driven = contents.excitation;
  if (needs.reversal && !(driven.reverse_m > 0.0 && driven.forward_m > 0.0))
    return "the runs hold no reversal";
  if (needs.turning && !(driven.turned_rad > 0.0)) return "the runs hold no turn";
  // What depends on the heading itself.
  if (needs.turning && info.by_pose && !contents.directions.all_round()) {
    return "the robot went in directions within half a turn only, where it looks like a scale";
  }
  const auto levels = static_cast<std::size_t>(
      std::ranges::count_if(contents.levels_s, [](const auto& level) { return level.second > min_level_s; }));
  if (needs.variety && levels < enough_levels) {
    return levels < 2 ? "the runs hold one size of command only"
                      : "the runs hold only " + std::to_string(levels) + " sizes of command";
  }
  return "";
}

// Where no size of it would show: of what there was too little, if that can be said.
std::string too_little_for(const EffectInfo& info, const Excitation& driven) {
  const std::string no_size = "no size within reason would show";
  const double min_m = std::min(driven.reverse_m, driven.forward_m);
  if (info.needs.turning)
    return "the runs turn by " + in_digits(driven.turned_rad, 2) + " rad in all: " + no_size;
  if (info.needs.reversal) {
    return "the runs go " + in_digits(min_m, 2) + " m" +
           (driven.reverse_m < driven.forward_m ? " backward" : " forward") + " in all: " + no_size;
  }
  return no_size + " in these drives";
}

// Where it cannot be seen what an effect does to the body, it may still load the wheels.
bool shows_at_wheels(EffectInfo info, const Contents& contents) {
  if (!info.may_load_wheels || !contents.counts) return false;
  info.needs.reference = info.needs.heading = info.needs.place = false;
  return missing_for(info, contents).empty();
}

}  // namespace

Testability testability(std::span<const DriveLog> logs) {
  const Contents contents = contents_of(logs);
  Testability result;
  result.excitation = contents.excitation;
  for (const auto& info : effect_library()) {
    const std::string why = missing_for(info, contents);
    if (!why.empty()) {
      const bool at_wheels = shows_at_wheels(info, contents);
      result.untestable.push_back(
          {info.name, why + (at_wheels ? "; only what it does to the wheels shows" : "")});
      if (at_wheels) result.candidate_effects.push_back(&info);
    } else if (info.variants.front().stage != EffectStage::counts) {
      result.candidate_effects.push_back(&info);
    }
  }
  for (const auto& decoy : decoys()) {
    if (missing_for(decoy, contents).empty()) result.candidate_effects.push_back(&decoy);
  }
  return result;
}

std::vector<Detectable> detectable_sizes(const Screening& look, const Excitation& driven,
                                         double nats_to_be_named, double autocorrelation_factor,
                                         std::vector<Untestable>& untestable) {
  // Mean and spread of a log likelihood ratio: with 80 % probability it exceeds its mean less 0.84
  // deviations.
  const double wanted = autocorrelation_factor *
                        std::pow(0.5 * (0.84 + std::sqrt(0.84 * 0.84 + 4.0 * 0.5 * nats_to_be_named)), 2) *
                        2.0;
  struct Best {
    const Visibility* seen = nullptr;  // the weakest size that shows
    const Visibility* strongest = nullptr;
  };
  std::map<std::string, Best> best;
  for (const auto& visibility : look.visibility) {
    if (std::ranges::count(untestable, visibility.effect.info->name, &Untestable::effect) > 0) continue;
    if (visibility.effect.variant != 0 && best.contains(visibility.effect.info->name) &&
        best[visibility.effect.info->name].seen != nullptr) {
      continue;
    }
    Best& entry = best[visibility.effect.info->name];
    if (entry.strongest == nullptr || visibility.nats > entry.strongest->nats) entry.strongest = &visibility;
    if (visibility.nats < wanted) continue;
    if (entry.seen == nullptr || visibility.nats < entry.seen->nats) entry.seen = &visibility;
  }
  std::vector<Detectable> sizes;
  for (const auto& [name, entry] : best) {
    const Visibility& at = entry.seen != nullptr ? *entry.seen : *entry.strongest;
    const auto& parameters = at.effect.info->parameters_of(at.effect.variant);
    const auto parameter = std::ranges::find_if(parameters, &ParameterInfo::scales_effect);
    const auto index = static_cast<std::size_t>(parameter - parameters.begin());
    const bool grows_with_size = parameter->lower <= 0.0;
    double size = std::abs(at.effect.parameters[index]);
    // Near to nothing, what shows grows with the square of the size.
    if (grows_with_size && at.nats > 0.0) size *= std::sqrt(wanted / at.nats);
    const bool possible =
        size <= parameter->upper && (entry.seen != nullptr || grows_with_size) && at.nats > 1e-9;
    if (possible) {
      sizes.push_back({name, parameter->name, parameter->unit, size});
    } else {
      untestable.push_back({name, too_little_for(*at.effect.info, driven)});
    }
  }
  return sizes;
}

}  // namespace wheelwright::gap
