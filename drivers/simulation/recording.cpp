#include "drivers/simulation/recording.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace wheelwright::simulation {
namespace {

using open_interface::PacketId;

std::int32_t mm_s(double m_s) {
  return static_cast<std::int32_t>(std::lround(1000.0 * m_s));
}

std::int32_t wrapped(std::int64_t counts) {
  return static_cast<std::int16_t>(static_cast<std::uint64_t>(counts));
}

}  // namespace

Recording recording_of(const DriveLog& log) {
  Recording recording;
  for (const DriveSample& sample : log.samples) {
    if (!sample.ticks) continue;
    recording.samples.push_back({nanoseconds(sample.t_s), mm_s(sample.command_m_s.left),
                                 mm_s(sample.command_m_s.right), sample.ticks->left, sample.ticks->right});
  }
  if (recording.samples.empty()) {
    throw std::runtime_error(log.name + ": holds no encoder counts to replay; choose a log with ticks_left");
  }
  return recording;
}

Player::Player(Recording recording) : recording_(std::move(recording)) {
  const auto& samples = recording_.samples;
  while (position_ + 1 < samples.size() && samples[position_].requested_left_mm_s == 0 &&
         samples[position_].requested_right_mm_s == 0) {
    ++position_;
  }
}

void Player::drive_commanded(Nanoseconds now) {
  if (!started_) started_ = now - recording_.samples[position_].at;
}

void Player::answer(SensorBoard& sensors, Nanoseconds now) {
  const auto& samples = recording_.samples;
  while (started_ && position_ + 1 < samples.size() && *started_ + samples[position_ + 1].at <= now)
    ++position_;
  const RecordedSample& sample = samples[position_];
  sensors.set(PacketId::requested_left_velocity, started_ ? sample.requested_left_mm_s : 0);
  sensors.set(PacketId::requested_right_velocity, started_ ? sample.requested_right_mm_s : 0);
  sensors.set(PacketId::left_encoder_counts, wrapped(sample.counts_left));
  sensors.set(PacketId::right_encoder_counts, wrapped(sample.counts_right));
}

}  // namespace wheelwright::simulation
