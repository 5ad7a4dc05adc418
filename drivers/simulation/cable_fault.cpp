#include "drivers/simulation/cable_fault.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "drivers/simulation/serial_line.hpp"

namespace wheelwright::simulation {
namespace {

constexpr std::array<std::string_view, cable_fault_kinds> names{
    "delay", "jitter", "drop",        "duplicate",  "flip",
    "burst", "freeze", "half-packet", "wrong-baud", "disconnect"};

// The host's speeds that a robot at 115200 baud may meet: 57600, 38400, 19200 and twice its own.
constexpr std::array<double, 4> speed_ratios{1.0 / 2.0, 1.0 / 3.0, 1.0 / 6.0, 2.0};

}  // namespace

std::string_view name_of(CableFaultKind kind) {
  return names.at(static_cast<std::size_t>(kind));
}

std::optional<CableFaultKind> cable_fault_kind(std::string_view name) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names.at(i) == name) return static_cast<CableFaultKind>(i);
  }
  return std::nullopt;
}

CableFaultSequence::CableFaultSequence(const CableFaultConfig& config)
    : config_(config), noise_(config.seed), next_at_s_(config.first_after_s) {
  if (!config_.kinds.empty()) return;
  for (int kind = 0; kind < cable_fault_kinds; ++kind) {
    config_.kinds.push_back(static_cast<CableFaultKind>(kind));
  }
}

double CableFaultSequence::log_between(double low, double high) {
  return low * std::pow(high / low, noise_.uniform());
}

void CableFaultSequence::choose_directions(CableFault& fault) {
  const bool whole_cable =
      fault.kind == CableFaultKind::wrong_baud || fault.kind == CableFaultKind::disconnect;
  const double which = noise_.uniform();
  fault.to_host = whole_cable || which < 0.7;
  fault.to_robot = whole_cable || which >= 0.4;
}

CableFault CableFaultSequence::next() {
  CableFault fault;
  fault.kind = config_.kinds.at(noise_.bits() % config_.kinds.size());
  choose_directions(fault);
  double lasts_s = 0.0;
  switch (fault.kind) {
    case CableFaultKind::delay:
    case CableFaultKind::jitter:
      fault.amount = log_between(0.002, 0.1);
      lasts_s = log_between(0.05, 2.0);
      break;
    case CableFaultKind::drop:
    case CableFaultKind::duplicate:
    case CableFaultKind::flip:
      fault.amount = log_between(0.003, 0.3);
      lasts_s = log_between(0.02, 1.0);
      break;
    case CableFaultKind::burst:
      fault.amount = log_between(0.1, 1.0);
      lasts_s = log_between(0.002, 0.3);
      break;
    case CableFaultKind::freeze:
      lasts_s = log_between(0.02, 3.0);
      break;
    case CableFaultKind::half_packet:
      fault.amount = std::floor(between(0.0, 45.0));
      lasts_s = 0.04;  // more than two ticks: at least one whole packet begins
      break;
    case CableFaultKind::wrong_baud:
      fault.amount = speed_ratios.at(noise_.bits() % speed_ratios.size());
      lasts_s = log_between(0.02, 2.0);
      break;
    case CableFaultKind::disconnect:
      lasts_s = log_between(0.05, 4.0);
      break;
  }
  fault.from = nanoseconds(next_at_s_);
  fault.until = fault.from + nanoseconds(lasts_s);
  next_at_s_ += lasts_s + between(config_.shortest_pause_s, config_.longest_pause_s);
  return fault;
}

}  // namespace wheelwright::simulation
