#include "tools/wheelwright/import/inference/named_reference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "config/load/ascii_text.hpp"
#include "tools/wheelwright/import/conversion/stream_time.hpp"
#include "tools/wheelwright/import/inference/column_names.hpp"
#include "tools/wheelwright/import/inference/column_shapes.hpp"
#include "tools/wheelwright/import/inference/name_words.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

class ReferenceFinder {
 public:
  ReferenceFinder(std::span<const Recording> recordings, const NamedChannels& named, bool has_wheels,
                  std::vector<std::string>& findings)
      : recordings_(recordings), named_(named), has_wheels_(has_wheels), findings_(findings) {}

  std::optional<ReferenceMapping> find() {
    find_reference();
    return std::move(found_);
  }

 private:
  // In a recording of this daemon all poses but these are of its own model, counts and filter.
  bool is_of_a_run(const Named& x) const {
    if (x.stream->find("model_version") != nullptr) return true;
    if (x.stream->name == "/pose/reference" || x.stream->name == "/pose/truth") return false;
    return std::ranges::any_of(recordings_, [&](const Recording& recording) {
      return recording.find("/pose/model") != nullptr && recording.find(x.stream->name) == x.stream;
    });
  }

  // How much a stream looks like a measurement from outside of the robot.
  int trust(const Named& x) const {
    const std::string words =
        config::lower_case(x.stream->name + " " + x.channel->name + " " + x.stream->type);
    const auto says = [&](std::string_view word) { return words.find(word) != std::string::npos; };
    if (is_of_a_run(x)) return -1;
    if (says("odom")) return has_wheels_ ? -1 : 0;  // what the robot makes of its own counts
    if (says("mocap") || says("vicon") || says("opti") || says("truth") || says("gt") || says("ref"))
      return 3;
    return says("amcl") || says("map") || says("pose") ? 2 : 1;
  }

  // Frames that are bolted to each other do not.
  static bool moves(const Channel& channel) {
    constexpr double min_m = 0.01;
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();
    for (const double value : channel.values) {
      if (!std::isfinite(value)) continue;
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
    return highest - lowest > min_m;
  }

  bool find_tum() {
    for (const auto& recording : recordings_) {
      for (const auto& stream : recording.streams) {
        if (!is_tum(stream)) continue;
        const auto column = [&](const char* number) { return ChannelName{stream.name, number}; };
        found_ = ReferenceMapping{};
        found_->x = column("2");
        found_->y = column("3");
        found_->qx = column("5");
        found_->qy = column("6");
        found_->qz = column("7");
        found_->qw = column("8");
        findings_.push_back("the reference is a trajectory in the TUM format (t x y z qx qy qz qw)");
        return true;
      }
    }
    return false;
  }

  void find_reference() {
    if (find_tum()) return;
    const Named* best = nullptr;
    std::string others;
    for (const auto& named : named_.list()) {
      if (named.meaning.quantity != Quantity::x || !named_.beside(named, Quantity::y)) continue;
      if (is_of_a_run(named))
        findings_.push_back(named.name().text() + " is the run's own pose, and no measurement of it");
      if (trust(named) < 0) continue;
      if (!moves(*named.channel) && !moves(*named_.beside(named, Quantity::y)->channel)) continue;
      if (best != nullptr && trust(named) <= trust(*best)) {
        others += ", " + named.name().text();
        continue;
      }
      if (best != nullptr) others += ", " + best->name().text();
      best = &named;
    }
    if (best == nullptr) return find_heading_alone();
    ReferenceMapping reference;
    reference.x = best->name();
    reference.y = named_.beside(*best, Quantity::y)->name();
    if (find_unit(distance_units(), best->meaning.unit)) reference.unit = best->meaning.unit;
    take_heading(*best, reference);
    if (!others.empty())
      findings_.push_back("reference: " + best->name().text() + " was taken; there are also " +
                          others.substr(2));
    found_ = reference;
  }

  void take_heading(const Named& x, ReferenceMapping& reference) const {
    const Named* qz = named_.beside(x, Quantity::qz);
    const Named* qw = named_.beside(x, Quantity::qw);
    if (qz != nullptr && qw != nullptr) {
      reference.qz = qz->name();
      reference.qw = qw->name();
      if (const Named* qx = named_.beside(x, Quantity::qx)) reference.qx = qx->name();
      if (const Named* qy = named_.beside(x, Quantity::qy)) reference.qy = qy->name();
    } else if (const Named* theta = named_.beside(x, Quantity::heading);
               theta != nullptr && trust(*theta) >= 0) {
      reference.theta = theta->name();
      if (find_unit(angle_units(), theta->meaning.unit)) reference.angle_unit = theta->meaning.unit;
    } else {
      take_angle(x, reference);
    }
  }

  // Beside a place, an angle that says no more is the heading.
  static void take_angle(const Named& x, ReferenceMapping& reference) {
    for (const Channel& channel : x.stream->channels) {
      const NameWords words(channel.name);
      const NameMeaning meaning = meaning_of(*x.stream, channel);
      if (!words.has_any({"phi", "angle", "rot", "rotation", "rz", "bearing", "azimuth", "course", "winkel",
                          "kurs", "richtung", "cap", "angulo", "rumbo", "angolo"}) ||
          words.has_any({"steer", "steering", "wheel", "joint", "motor", "rate", "vel", "speed", "roll",
                         "pitch", "odom"}) ||
          meaning.side != NamedSide::none || is_held(channel.values))
        continue;
      reference.theta = ChannelName{x.stream->name, channel.name};
      if (find_unit(angle_units(), meaning.unit)) reference.angle_unit = meaning.unit;
      return;
    }
  }

  void find_heading_alone() {
    const auto headings = named_.all(Quantity::heading, NamedSide::none);
    if (headings.empty() || trust(headings.front()) < 0) return;
    ReferenceMapping reference;
    reference.theta = headings.front().name();
    if (find_unit(angle_units(), headings.front().meaning.unit))
      reference.angle_unit = headings.front().meaning.unit;
    found_ = reference;
  }

  std::span<const Recording> recordings_;
  const NamedChannels& named_;
  bool has_wheels_;
  std::vector<std::string>& findings_;
  std::optional<ReferenceMapping> found_;
};

}  // namespace

std::optional<ReferenceMapping> find_named_reference(std::span<const Recording> recordings,
                                                     const NamedChannels& named, bool has_wheels,
                                                     std::vector<std::string>& findings) {
  return ReferenceFinder(recordings, named, has_wheels, findings).find();
}

}  // namespace wheelwright::import
