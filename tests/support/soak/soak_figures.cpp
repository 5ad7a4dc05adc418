#include "tests/support/soak/soak_figures.hpp"

#include <cstdarg>
#include <cstdio>

namespace wheelwright::soak {
namespace {

[[gnu::format(printf, 1, 2)]] std::string line(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  std::string text(160, '\0');
  const int length = std::vsnprintf(text.data(), text.size(), format, arguments);
  va_end(arguments);
  text.resize(std::min(static_cast<std::size_t>(std::max(length, 0)), text.size() - 1));
  return text;
}

long long number(std::int64_t value) {
  return static_cast<long long>(value);
}

KindFigures total(const SoakFigures& figures) {
  KindFigures sum;
  for (const KindFigures& kind : figures.kinds) {
    sum.injected += kind.injected;
    sum.idle += kind.idle;
    sum.unnoticed += kind.unnoticed;
    sum.cost_samples += kind.cost_samples;
    sum.stopped_run += kind.stopped_run;
  }
  return sum;
}

std::string row(std::string_view name, const KindFigures& kind) {
  return line("  %-14.*s %8lld %8lld %10lld %13lld %12lld\n", static_cast<int>(name.size()), name.data(),
              number(kind.injected), number(kind.idle), number(kind.unnoticed), number(kind.cost_samples),
              number(kind.stopped_run));
}

std::string recovery_line(const char* what, const Recovery& recovery) {
  return line("  %-44s %lld of %lld within 1 s, longest %.2f s\n", what, number(recovery.within_1_s),
              number(recovery.count), recovery.longest_s);
}

}  // namespace

std::int64_t SoakFigures::injected() const {
  return total(*this).injected;
}

std::vector<std::string> shortcomings(const SoakFigures& figures) {
  std::vector<std::string> found;
  const auto must_hold = [&](bool holds, const std::string& otherwise) {
    if (!holds) found.push_back(otherwise);
  };
  const KindFigures sum = total(figures);
  must_hold(sum.injected == sum.idle + sum.unnoticed + sum.cost_samples + sum.stopped_run,
            "faults are missing from the table");
  const std::int64_t bad = figures.missing + figures.incomplete + figures.garbled;
  must_hold(figures.asked - figures.sound - bad >= 0 && figures.asked - figures.sound - bad <= 1,
            "queries asked are not replies sound, missing, incomplete and garbled");
  must_hold(figures.lost_outside == 0,
            line("%lld replies lost that no fault hit", number(figures.lost_outside)));
  must_hold(figures.wrong_outside == 0,
            line("%lld samples with wrong counts that no fault hit", number(figures.wrong_outside)));
  must_hold(figures.moving_orders_disarmed == 0,
            line("%lld orders to move while not armed", number(figures.moving_orders_disarmed)));
  must_hold(figures.not_at_rest_when_blind == 0, line("%lld times the wheels of a blind robot kept turning",
                                                      number(figures.not_at_rest_when_blind)));
  must_hold(figures.recovery.within_1_s == figures.recovery.count,
            line("%lld returns of the link took longer than a second",
                 number(figures.recovery.count - figures.recovery.within_1_s)));
  must_hold(figures.failed_recoveries == 0,
            line("%lld times the link did not come back", number(figures.failed_recoveries)));
  return found;
}

std::string to_text(const SoakFigures& figures) {
  std::string text = line("%lld faults in %.0f s, %.0f m driven\n", number(figures.injected()),
                          figures.duration_s, figures.driven_m);
  text += "  kind           injected     idle  unnoticed  cost samples  stopped run\n";
  for (int kind = 0; kind < simulation::cable_fault_kinds; ++kind) {
    text += row(name_of(static_cast<simulation::CableFaultKind>(kind)),
                figures.kinds.at(static_cast<std::size_t>(kind)));
  }
  text += row("all", total(figures));
  text += line("  replies: %lld asked, %lld sound, %lld missing, %lld incomplete, %lld garbled\n",
               number(figures.asked), number(figures.sound), number(figures.missing),
               number(figures.incomplete), number(figures.garbled));
  text += line(
      "  lost after a fault: %lld while the robot was away, %lld in half commands; for no reason: %lld\n",
      number(figures.lost_while_away), number(figures.lost_in_half_commands), number(figures.lost_outside));
  text += line("  wrong counts taken: %lld in faults, %lld outside\n", number(figures.wrong_in_faults),
               number(figures.wrong_outside));
  text += "  stops:";
  for (const auto& [reason, count] : figures.stops) {
    text += line(" %lld %s;", number(count), std::string(name_of(reason)).c_str());
  }
  text += line("\n  orders to move while not armed: %lld\n", number(figures.moving_orders_disarmed));
  text +=
      line("  blind beyond the limit: %lld; wheels not at rest: %lld; longest way to rest %.2f s\n",
           number(figures.blind_segments), number(figures.not_at_rest_when_blind), figures.longest_to_rest_s);
  text += line("  could not hear and rolled on: %lld; longest way to rest after the return %.2f s\n",
               number(figures.runaways), figures.longest_rest_after_return_s);
  text += recovery_line("link back after a fault:", figures.recovery);
  text += recovery_line("once booted, where damaged bytes did that:", figures.recovery_of_reset_robot);
  text += line("  had to be switched off and on: %lld; link not back: %lld\n",
               number(figures.switched_off_and_on), number(figures.failed_recoveries));
  return text;
}

}  // namespace wheelwright::soak
