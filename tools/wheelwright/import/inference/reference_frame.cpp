#include "tools/wheelwright/import/inference/reference_frame.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "tools/wheelwright/import/columns/column_names.hpp"
#include "tools/wheelwright/import/conversion/stream_time.hpp"
#include "tools/wheelwright/import/inference/response_fit.hpp"
#include "tools/wheelwright/import/inference/response_rows.hpp"
#include "tools/wheelwright/import/inference/turning_sense.hpp"
#include "tools/wheelwright/import/inference/wheel_directions.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

constexpr double sure = 0.5;  // of a correlation, and of 1

class FrameFinder {
 public:
  FrameFinder(std::span<const Recording> recordings, const DriveColumns& columns, const GivenMapping& given,
              Mapping& mapping, std::vector<std::string>& findings, std::vector<std::string>& doubts)
      : recordings_(recordings),
        columns_(columns),
        given_(given),
        mapping_(mapping),
        reference_(*mapping.reference),
        findings_(findings),
        doubts_(doubts) {
    if (mapping.command && has_turning_wheels(columns, mapping)) {
      const auto rows = response_rows(columns, mapping);
      fits_ = {fit_response(rows[0]), fit_response(rows[1])};
      directions_ = wheel_directions(mapping, fits_);
    } else if (mapping.wheels) {
      directions_ = wheel_directions(mapping, fits_);
    }
    const bool unit_is_known =
        !reference_.theta || given.says("reference.angle_unit") || reference_.angle_unit != "rad";
    sense_ = turning_sense(columns, mapping, directions_, unit_is_known);
    robot_ = has_turning_wheels(columns, mapping) ? "the wheels" : "the commands";
  }

  bool run() {
    if (columns_.x.empty()) return judge_headings_alone();
    if (reference_.unit == geographic_unit || reference_.y_points_right) return judge_known_places();
    return columns_.theta_rad.empty() ? judge_places_alone() : judge_poses();
  }

 private:
  static bool is_clear(double one, double other) {
    constexpr double clear = 1.5;  // times the other sense
    return one > sure && one > clear * other;
  }
  bool with_motion() const { return is_clear(sense_.with, sense_.against); }
  bool against_motion() const { return is_clear(sense_.against, sense_.with); }

  bool judge_headings_alone() {
    if (sense_.headings > -sure) return false;
    reference_.clockwise = true;
    findings_.push_back("headings are clockwise: they turn against " + robot_);
    return true;
  }

  // The file says where they are: what turns against them is wrong.
  bool judge_known_places() {
    const double turn_with_robot = !columns_.theta_rad.empty() && std::abs(sense_.headings) > sure
                                       ? (against_motion() ? -1.0
                                          : with_motion()  ? 1.0
                                                           : 0.0) *
                                             sense_.headings
                                       : sense_.places;
    if (turn_with_robot < -sure)
      doubts_.push_back("the places of the reference turn right where " + robot_ +
                        " turn left: left and right are exchanged, or the reference is mirrored (--set "
                        "reference.y_axis)");
    const bool places_are_noisy = !against_motion() && !with_motion();
    if (!against_motion() && !(places_are_noisy && sense_.headings < -sure)) return false;
    reference_.clockwise = true;
    findings_.push_back("headings are clockwise: they turn against " +
                        (places_are_noisy ? robot_ : "the places of the reference"));
    return true;
  }

  bool judge_places_alone() {
    if (sense_.places > -sure) return false;
    if (!is_mirrored()) return judge_sides("x and y", "y points right of x (--set reference.y_axis=right)");
    reference_.y_points_right = true;
    findings_.push_back("the places are mirrored, so that y points right of x: they turn against " + robot_);
    return true;
  }

  // Two that agree are right. Sides that nobody names are exchanged.
  bool judge_sides(const std::string& what, const std::string& frame) {
    const std::string turn = what + " turn right where " + robot_ + " turn left";
    if (are_sides_open()) {
      exchange_sides();
      findings_.push_back(
          "the right wheel stands first: " + turn +
          "; or they are of a frame whose y points right, and left and right are exchanged in "
          "all results");
      return true;
    }
    if (twist_sense() < 0.0) {
      doubts_.push_back(turn +
                        ", and so does the angular command: the left and the right wheel are exchanged; "
                        "exchange wheels.left and wheels.right");
    } else {
      doubts_.push_back(turn + ": " + frame + ", or left and right are exchanged");
    }
    return false;
  }

  // Motors that are called 1 and 2, or A and B.
  bool are_sides_open() const {
    if (!mapping_.wheels || !mapping_.wheels->right || mapping_.wheels->body_motion ||
        mapping_.wheels->metres_per_count_right || given_.says("wheels.left") || given_.says("command.left"))
      return false;
    return side_of(mapping_.wheels->left) == NamedSide::none &&
           side_of(*mapping_.wheels->right) == NamedSide::none &&
           (!mapping_.command || mapping_.command->is_of_body() ||
            side_of(mapping_.command->first) == NamedSide::none);
  }

  NamedSide side_of(const ChannelName& name) const {
    const FoundChannel found = find_channel(recordings_, name);
    return found.channel == nullptr ? NamedSide::none : meaning_of(*found.stream, *found.channel).side;
  }

  void exchange_sides() {
    WheelMapping& wheels = *mapping_.wheels;
    std::swap(wheels.left, *wheels.right);
    std::swap(wheels.left_reversed, wheels.right_reversed);
    if (!mapping_.command || mapping_.command->is_of_body() || !mapping_.command->second) return;
    CommandMapping& command = *mapping_.command;
    std::swap(command.first, *command.second);
    std::swap(command.left_reversed, command.right_reversed);
    std::swap(command.direction[0], command.direction[1]);
  }

  bool judge_poses() {
    if (std::abs(sense_.headings) < sure) return false;
    const bool with_robot = sense_.headings > 0.0;
    if (against_motion() && !with_robot) {
      reference_.clockwise = true;
      findings_.push_back("headings are clockwise: x and y turn as " + robot_ +
                          " do, and headings against them");
      return true;
    }
    if (against_motion()) {
      reference_.y_points_right = true;
      findings_.push_back(
          "the places are mirrored, so that y points right or x and y are exchanged: headings turn as " +
          robot_ + " do, and x and y against them");
      return true;
    }
    if (with_motion()) return !with_robot && judge_frame_below();
    if (!with_robot)
      doubts_.push_back("headings turn against " + robot_ +
                        ", and x and y do not show which is right; if headings are clockwise: --set "
                        "reference.heading=clockwise");
    return false;
  }

  bool judge_frame_below() {
    if (!is_mirrored())
      return judge_sides("x, y and heading",
                         "in a frame whose z points down, --set reference.heading=clockwise --set "
                         "reference.y_axis=right");
    reference_.y_points_right = true;
    reference_.clockwise = true;
    findings_.push_back(
        "the reference is mirrored, as in a frame whose z points down: x, y and heading turn "
        "against " +
        robot_);
    return true;
  }

  // 1 where the wheels turn as an angular command says, -1 against it, 0 where neither is sure.
  double twist_sense() const {
    const bool has_twist = mapping_.command && mapping_.command->kind == CommandKind::twist &&
                           has_turning_wheels(columns_, mapping_);
    return has_twist && fits_[1].explained >= unit_explained ? std::copysign(1.0, fits_[1].gain) : 0.0;
  }

  // Whether the reference is wrong, and not the sides of the robot.
  bool is_mirrored() const {
    if (reference_.unit == pixel_unit || x_is_depth()) return true;
    if (twist_sense() > 0.0) return true;
    return gyro_sense(columns_, mapping_, directions_) > sure;
  }

  // Of a frame whose y points up no one says whether it is right-handed.
  bool x_is_depth() const {
    const FoundChannel x = find_channel(recordings_, *reference_.x);
    if (x.channel == nullptr) return false;
    return is_tum(*x.stream) ? x.channel == &x.stream->channels[3]
                             : meaning_of(*x.stream, *x.channel).quantity == Quantity::z;
  }

  std::span<const Recording> recordings_;
  const DriveColumns& columns_;
  const GivenMapping& given_;
  Mapping& mapping_;
  ReferenceMapping& reference_;
  std::vector<std::string>& findings_;
  std::vector<std::string>& doubts_;
  std::array<ResponseFit, 2> fits_;
  std::array<double, 2> directions_{1.0, 1.0};
  TurningSense sense_;
  std::string robot_;
};

bool can_be_judged(const DriveColumns& columns, const GivenMapping& given, const Mapping& mapping) {
  const bool has_commands = mapping.command && mapping.command->second && !columns.command[1].empty() &&
                            mapping.command->kind != CommandKind::throttle;
  const bool has_both = columns.x.empty() == columns.y.empty();
  return mapping.reference && (has_turning_wheels(columns, mapping) || has_commands) &&
         !given.says("reference.heading") && !given.says("reference.y_axis") && has_both &&
         (!columns.x.empty() || !columns.theta_rad.empty());
}

}  // namespace

bool infer_reference_frame(std::span<const Recording> recordings, const DriveColumns& columns,
                           const GivenMapping& given, Mapping& mapping, std::vector<std::string>& findings,
                           std::vector<std::string>& doubts) {
  if (!can_be_judged(columns, given, mapping)) return false;
  return FrameFinder(recordings, columns, given, mapping, findings, doubts).run();
}

}  // namespace wheelwright::import
