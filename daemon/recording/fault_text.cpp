#include "daemon/recording/fault_text.hpp"

#include <spdlog/fmt/fmt.h>

#include "config/load/text_format.hpp"

namespace wheelwright::daemon {
namespace {

std::string_view name_of(FaultyWheel wheel) {
  if (wheel == FaultyWheel::both) return "both";
  return wheel == FaultyWheel::left ? "left" : "right";
}

std::string_view name_of(FaultEvent::Stage stage) {
  if (stage == FaultEvent::Stage::began) return "began";
  return stage == FaultEvent::Stage::named ? "named" : "ended";
}

bool is_seen_by_current(FaultKind kind) {
  return kind == FaultKind::stalled || kind == FaultKind::slipping;
}

}  // namespace

std::string sentence_of(const FaultEvent& event) {
  const std::string wheel =
      event.wheel == FaultyWheel::both ? "both wheels" : fmt::format("{} wheel", name_of(event.wheel));
  const auto kind = wheelwright::name_of(event.kind);
  const bool ended = event.stage == FaultEvent::Stage::ended;
  if (event.kind == FaultKind::lifted)
    return ended ? "no wheel hangs in the air any more" : "a wheel hangs in the air";
  if (is_seen_by_current(event.kind)) {
    return ended ? fmt::format("{}: no longer '{}'", wheel, kind)
                 : fmt::format("{}: {}, the motor draws {:.2f} A more than it should need", wheel, kind,
                               event.size);
  }
  const double size_mm = 1e3 * event.size;
  if (event.stage == FaultEvent::Stage::began) {
    return fmt::format("{}: readings are {:.1f} mm off the model and are discarded", wheel, size_mm);
  }
  if (!ended) return fmt::format("{}: {}, {:.1f} mm off", wheel, kind, size_mm);
  return fmt::format("{}: readings are used again after '{}', {:.1f} mm kept out of the pose", wheel, kind,
                     size_mm);
}

std::string field_of(const FaultEvents& events) {
  std::string text;
  for (const FaultEvent& event : events) {
    if (!text.empty()) text += "; ";
    text += fmt::format("{} {} {} {}", name_of(event.stage), wheelwright::name_of(event.kind),
                        name_of(event.wheel), config::fixed_number(event.size, 4));
  }
  return text;
}

}  // namespace wheelwright::daemon
