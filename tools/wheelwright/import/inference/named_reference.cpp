#include "tools/wheelwright/import/inference/named_reference.hpp"

#include <algorithm>
#include <array>

#include "config/load/ascii_text.hpp"
#include "tools/wheelwright/import/columns/column_names.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/columns/name_words.hpp"
#include "tools/wheelwright/import/columns/pose_names.hpp"
#include "tools/wheelwright/import/conversion/stream_time.hpp"
#include "tools/wheelwright/import/conversion/value_range.hpp"
#include "tools/wheelwright/import/inference/floor_plane.hpp"
#include "tools/wheelwright/import/inference/named_heading.hpp"
#include "tools/wheelwright/import/inference/quaternion_columns.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"
#include "tools/wheelwright/import/inference/wanted_path.hpp"
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
    return range_of(channel.values).size() > min_m;
  }

  bool find_tum() {
    for (const auto& recording : recordings_) {
      for (const auto& stream : recording.streams) {
        if (!is_tum(stream)) continue;
        const auto column = [&](std::size_t number) { return &stream.channels[number - 1]; };
        const bool real_first = has_real_part_first(std::span(stream.channels).subspan<4, 4>());
        findings_.push_back(real_first
                                ? "the reference is t x y z qw qx qy qz, by which parts stay small"
                                : "the reference is a trajectory in the TUM format (t x y z qx qy qz qw)");
        found_ = ReferenceMapping{};
        const bool y_is_up = take_places(stream, {column(2), column(3), column(4)}, *found_);
        const std::array<const Channel*, 4> parts =
            real_first ? std::array{column(6), column(7), column(8), column(5)}
                       : std::array{column(5), column(6), column(7), column(8)};
        take_quaternion(stream, parts, y_is_up, *found_);
        return true;
      }
    }
    return false;
  }

  // In the plane of the floor; true where y points up.
  bool take_places(const Stream& stream, const std::array<const Channel*, 3>& xyz,
                   ReferenceMapping& reference) {
    const auto name = [&stream](const Channel& channel) { return ChannelName{stream.name, channel.name}; };
    const auto& [x, y, z] = xyz;
    const FloorPlane plane = z == nullptr ? FloorPlane::x_y : floor_plane(x->values, y->values, z->values);
    reference.x = name(plane == FloorPlane::z_x ? *z : *x);
    reference.y = name(plane == FloorPlane::z_x ? *x : *y);
    if (plane == FloorPlane::z_x) {
      findings_.push_back(name(*y).text() + " points up: it hardly changes while the robot moves in " +
                          name(*z).text() + " and " + name(*x).text());
    } else if (plane == FloorPlane::unclear) {
      findings_.push_back(name(*z).text() + " changes more than " + name(*y).text() +
                          "; if that points up: --set reference.x=" + name(*z).text() +
                          " --set reference.y=" + name(*x).text());
    }
    return plane == FloorPlane::z_x;
  }

  // Its format says that "ref_x" is the reference.
  bool is_of_a_drive_log(const Named& x) const {
    return std::ranges::any_of(recordings_, [&](const Recording& recording) {
      return recording.find(x.stream->name) == x.stream &&
             std::ranges::any_of(recording.metadata,
                                 [](const auto& entry) { return entry.first == "wheelwright_drive_log"; });
    });
  }

  // Places of the same stream by whose name nobody would take them for a path that is wanted.
  const Named* measured_beside(const Named& x) const {
    const auto found = std::ranges::find_if(named_.list(), [&](const Named& named) {
      return named.meaning.quantity == Quantity::x && named.stream == x.stream &&
             !may_be_wanted(NameWords(named.channel->name)) && named_.beside(named, Quantity::y) != nullptr;
    });
    return found == named_.list().end() ? nullptr : &*found;
  }

  // Whether places are those that a controller wants, by their name and by what the others do.
  bool are_wanted(const Named& x, const Named& y) {
    if (!may_be_wanted(NameWords(x.channel->name)) || is_of_a_drive_log(x)) return false;
    const std::string both = x.name().text() + " and " + y.name().text();
    const Named* other = measured_beside(x);
    if (other == nullptr) {
      const bool stand = is_held(x.channel->values) && is_held(y.channel->values);
      if (stand) findings_.push_back(both + " stand for many rows each: places to go to, and no measurement");
      return stand;
    }
    const Channel& other_y = *named_.beside(*other, Quantity::y)->channel;
    const PathKind kind =
        path_kind({x.channel->values, y.channel->values}, {other->channel->values, other_y.values});
    if (kind == PathKind::unclear && trust(*other) < 0) return false;
    if (kind == PathKind::wanted)
      findings_.push_back(both + " are the path that is wanted: " + other->name().text() + " follows it");
    if (kind == PathKind::unclear)
      findings_.push_back(both +
                          " are taken for the path that is wanted, by their names; if they were "
                          "measured: --set reference.x=" +
                          x.name().text() + " --set reference.y=" + y.name().text());
    return kind != PathKind::measured;
  }

  // The best of the places, and the others in `others`.
  const Named* find_places(std::string& others) {
    const Named* best = nullptr;
    for (const auto& named : named_.list()) {
      const Named* y = named_.beside(named, Quantity::y);
      if (named.meaning.quantity != Quantity::x || y == nullptr) continue;
      if (is_of_a_run(named))
        findings_.push_back(named.name().text() + " is the run's own pose, and no measurement of it");
      if (trust(named) < 0) continue;
      const Named* z = named_.beside(named, Quantity::z);
      if (!moves(*named.channel) && !moves(*y->channel) && (z == nullptr || !moves(*z->channel))) continue;
      if (are_wanted(named, *y)) continue;
      if (best != nullptr && trust(named) <= trust(*best)) {
        others += ", " + named.name().text();
        continue;
      }
      if (best != nullptr) others += ", " + best->name().text();
      best = &named;
    }
    return best;
  }

  void find_reference() {
    if (find_tum()) return;
    std::string others;
    const Named* best = find_places(others);
    if (best == nullptr) {
      find_fixes();
      if (!found_) find_heading_alone();
      if (!found_) say_wanted();
      return;
    }
    ReferenceMapping reference;
    const Named* z = named_.beside(*best, Quantity::z);
    const bool y_is_up = take_places(
        *best->stream,
        {best->channel, named_.beside(*best, Quantity::y)->channel, z == nullptr ? nullptr : z->channel},
        reference);
    if (find_unit(distance_units(), best->meaning.unit) || best->meaning.unit == pixel_unit)
      reference.unit = best->meaning.unit;
    reference.y_points_right = !y_is_up && is_northward(NameWords(reference.x->channel)) &&
                               is_eastward(NameWords(reference.y->channel));
    take_heading(*best, y_is_up, has_trusted_heading(*best), named_, reference);
    if (!reference.theta && !reference.qw) take_numbered_quaternion(*best->stream, y_is_up, reference);
    if (!others.empty())
      findings_.push_back("reference: " + best->name().text() + " was taken; there are also " +
                          others.substr(2));
    found_ = reference;
  }

  // "q0" to "q3", of which the real part may be the first or the last.
  void take_numbered_quaternion(const Stream& stream, bool y_is_up, ReferenceMapping& reference) {
    std::vector<const Channel*> numbered;
    for (const Channel& channel : stream.channels) {
      const NameWords words(channel.name);
      if (words.words().size() == 2 && words.words().front() == "q" && config::is_digit(words.last().front()))
        numbered.push_back(&channel);
    }
    const auto found = find_quaternion(stream, numbered);
    if (!found) return;
    take_quaternion(stream, {found->x, found->y, found->z, found->w}, y_is_up, reference);
    findings_.push_back(found->x->name + ", " + found->y->name + ", " + found->z->name + " and " +
                        found->w->name +
                        " are x, y, z and the real part of a quaternion, by which stay small");
  }

  // Of a satellite receiver.
  void find_fixes() {
    constexpr double farthest_deg = 0.5;
    const auto latitudes = named_.all(Quantity::latitude, NamedSide::none);
    if (latitudes.empty()) return;
    const Named& latitude = latitudes.front();
    const Named* longitude = named_.beside(latitude, Quantity::longitude);
    if (longitude == nullptr) return;
    if (largest(latitude.channel->values) > 90.0 || largest(longitude->channel->values) > 180.0) {
      findings_.push_back(latitude.name().text() + " and " + longitude->name().text() +
                          " are not in degrees (more than 90 or 180), and were not taken for a reference");
      return;
    }
    const auto moves_little = [](const Channel& channel) {
      std::vector<double> fixes = channel.values;
      std::ranges::replace(fixes, 0.0, nothing);
      return range_of(fixes).size() < farthest_deg;
    };
    if (!moves_little(*latitude.channel) || !moves_little(*longitude->channel)) return;
    ReferenceMapping reference;
    reference.x = longitude->name();
    reference.y = latitude.name();
    reference.unit = geographic_unit;
    take_heading(latitude, false, has_trusted_heading(latitude), named_, reference);
    findings_.push_back("the reference is " + latitude.name().text() + " and " + longitude->name().text() +
                        ", in metres to the north and east of the first fix");
    found_ = reference;
  }

  bool has_trusted_heading(const Named& x) const {
    const Named* theta = named_.beside(x, Quantity::heading);
    return theta != nullptr && trust(*theta) >= 0;
  }

  void say_wanted() {
    const auto wanted = named_.all(Quantity::wanted, NamedSide::none);
    if (wanted.empty()) return;
    findings_.push_back(wanted.front().name().text() +
                        " is of a place to go to, and no measurement; if it is one: --set reference.x=COLUMN "
                        "--set reference.y=COLUMN");
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
