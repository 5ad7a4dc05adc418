#include "tests/support/gap_plant/gap_case.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <stdexcept>

#include "tests/support/gap_plant/gap_plant.hpp"

namespace wheelwright::test {
namespace {

constexpr std::array<std::string_view, 6> channel_names{"ticks", "ticks+ref", "ticks+sparse",
                                                        "ends",  "ref",       "sparse"};
constexpr std::array<std::string_view, 4> expected_names{"nothing_missing", "named", "unnamed", "not_named"};
constexpr std::size_t sparse_rows = 25;

bool has_ticks(Channels channels) {
  return channels != Channels::ref && channels != Channels::sparse;
}

bool has_reference(Channels channels) {
  return channels != Channels::ticks;
}

std::optional<std::string> why_not(const HiddenEffect& effect, const GapCaseSpec& spec, bool moves_encoders) {
  const Needs& needs = effect.needs;
  const bool ticks = has_ticks(spec.channels);
  const bool by_gyro = ticks && spec.gyro && needs.turns_it;
  const bool reference = has_reference(spec.channels) || by_gyro;
  const bool many_poses = reference && (spec.channels != Channels::ticks_ends || by_gyro);
  const bool turns = spec.program == Program::mixed || spec.program == Program::forward_only;
  const bool reversals = spec.program == Program::mixed || spec.program == Program::straight_only;
  if (needs.ticks && !ticks) return "no encoder counts";
  if (needs.reference && !reference) return "no reference poses";
  if (needs.both && !reference) return "counts alone know nothing of the floor";
  if (needs.both && !ticks) return "of poses alone the linear part takes it up";
  if (needs.many_poses && !many_poses && !(ticks && moves_encoders)) return "too few reference poses";
  if (needs.reversals && !reversals) return "no reversal";
  if (needs.turns && !turns) return "no turn";
  if (needs.speeds && spec.program == Program::one_speed) return "one speed only";
  if (needs.battery && !spec.battery) return "no battery voltage";
  return std::nullopt;
}

void keep_channels(DriveLog& log, const GapCaseSpec& spec) {
  const bool ticks = has_ticks(spec.channels);
  if (!ticks) log.metres_per_tick.reset();
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    DriveSample& sample = log.samples[k];
    if (!ticks) sample.ticks.reset();
    if (!spec.battery) sample.battery_v.reset();
    if (!spec.gyro) sample.gyro_z_rad_s.reset();
    const bool at_end = k == 0 || k + 1 == log.samples.size();
    const bool keep = spec.channels == Channels::ticks_ref || spec.channels == Channels::ref ||
                      (spec.channels == Channels::ticks_ends && at_end) ||
                      ((spec.channels == Channels::ticks_sparse || spec.channels == Channels::sparse) &&
                       (at_end || k % sparse_rows == 0));
    if (keep) continue;
    sample.reference_x_m.reset();
    sample.reference_y_m.reset();
    sample.reference_theta_rad.reset();
  }
}

class CaseMaker {
 public:
  explicit CaseMaker(const GapCaseSpec& spec)
      : spec_(spec), random_(spec.seed), robot_(random_robot(spec.seed)) {}

  GapCase make() {
    GapCase made;
    made.spec = spec_;
    hide_effects(made);
    draw_plans();
    if (robot_.patch_share > 0.0) place_patch();
    for (std::size_t run = 0; run < plans_.size(); ++run) {
      made.runs.push_back(drive_plant(robot_, commands(run), plans_[run]).log);
      keep_channels(made.runs.back(), spec_);
    }
    return made;
  }

 private:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  void hide_effects(GapCase& made) {
    const auto effects = effects_of_case(spec_.name);
    if (!effects) throw std::invalid_argument("no case '" + spec_.name + "'");
    for (const HiddenEffect* effect : *effects) {
      const double size = effect->size(spec_.severity);
      made.hidden.push_back(
          {effect, size, hide(robot_, *effect, size, spec_.seed, !has_reference(spec_.channels)), {}});
    }
    for (HiddenInCase& hidden : made.hidden)
      hidden.why_not = why_not(*hidden.effect, spec_, moves_encoders(hidden));
    made.expected = expected(made.hidden);
  }

  bool moves_encoders(const HiddenInCase& hidden) const {
    return hidden.effect->name == "wheel_eccentricity" || robot_.upset_loads_motors;
  }

  static Expected expected(const std::vector<HiddenInCase>& hidden) {
    if (hidden.empty()) return Expected::nothing_missing;
    const auto shown = [&](bool outside) {
      return std::any_of(hidden.begin(), hidden.end(), [outside](const HiddenInCase& one) {
        return !one.why_not && is_outside_library(*one.effect) == outside;
      });
    };
    if (shown(false)) return Expected::named;
    return shown(true) ? Expected::unnamed : Expected::not_named;
  }

  // The same mark on the floor for each run, met to some centimetres; the battery goes on falling, and some
  // runs are done in the morning.
  void draw_plans() {
    const Pose mark{between(-1.0, 1.0), between(-1.0, 1.0), between(-3.1, 3.1)};
    const bool wrap = between(0.0, 1.0) < 0.5;
    for (int i = 0; i < spec_.runs; ++i) {
      GapRunPlan plan;
      plan.period_s = spec_.period_s;
      plan.start = {mark.x_m + between(-0.03, 0.03), mark.y_m + between(-0.03, 0.03),
                    mark.theta_rad + between(-0.08, 0.08)};
      plan.charge_used = static_cast<double>(i) / spec_.runs;
      plan.charge_used_at_end = (static_cast<double>(i) + 0.8) / spec_.runs;
      plan.hour = between(6.0, 20.0);
      plan.wrap_heading = wrap;
      plan.seed = spec_.seed * 1000 + static_cast<std::uint64_t>(i) + 1;
      plans_.push_back(plan);
    }
  }

  std::vector<WheelPair> commands(std::size_t run) const {
    return drive_commands(spec_.program, spec_.seconds, spec_.period_s, robot_.wheel_base_m,
                          plans_[run].seed);
  }

  // Where the robot is a good part of the time: of some places that it passes, the one with 15 to 50 % of all
  // rows on it, or the nearest to that.
  void place_patch() {
    std::vector<Pose> passed;
    PlantParameters without = robot_;
    without.patch_share = 0.0;
    for (std::size_t run = 0; run < plans_.size(); ++run) {
      const auto truth = drive_plant(without, commands(run), plans_[run]).truth;
      for (std::size_t k = 0; k < truth.size(); k += 20) passed.push_back(truth[k].pose);
    }
    double best = 1.0;
    for (int attempt = 0; attempt < 20; ++attempt) {
      const Pose& middle = passed[std::uniform_int_distribution<std::size_t>(0, passed.size() - 1)(random_)];
      const auto inside = std::count_if(passed.begin(), passed.end(), [&](const Pose& pose) {
        const Pose seen = wheelwright::between(middle, pose);
        return std::abs(seen.x_m) < 0.5 * robot_.patch_length_m &&
               std::abs(seen.y_m) < 0.5 * robot_.patch_width_m;
      });
      const double off = std::abs(static_cast<double>(inside) / static_cast<double>(passed.size()) - 0.3);
      if (off >= best) continue;
      best = off;
      robot_.patch = middle;
    }
  }

  GapCaseSpec spec_;
  std::mt19937_64 random_;
  PlantParameters robot_;
  std::vector<GapRunPlan> plans_;
};

}  // namespace

std::string_view name_of(Channels channels) {
  return channel_names.at(static_cast<std::size_t>(channels));
}

std::optional<Channels> channels_named(std::string_view name) {
  const auto* found = std::find(channel_names.begin(), channel_names.end(), name);
  if (found == channel_names.end()) return std::nullopt;
  return static_cast<Channels>(found - channel_names.begin());
}

std::string_view name_of(Expected expected) {
  return expected_names.at(static_cast<std::size_t>(expected));
}

std::string GapCaseSpec::folder_name() const {
  std::string text = name;
  if (name != "clean") text += "." + std::string(name_of(severity));
  text += "." + std::string(name_of(channels));
  if (program != Program::mixed) text += "." + std::string(name_of(program));
  if (!battery) text += ".no_battery";
  return text + ".s" + std::to_string(seed);
}

GapCase make_gap_case(const GapCaseSpec& spec) {
  return CaseMaker(spec).make();
}

}  // namespace wheelwright::test
