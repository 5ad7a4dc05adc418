// Kinds of outputs, as their first bytes show them.
#include <algorithm>
#include <charconv>

#include "config/load/output_file.hpp"

namespace wheelwright::config {
namespace {

using std::string_view;

bool has_line(string_view head, string_view start) {
  return head.starts_with(start) || head.find("\n" + std::string(start)) != string_view::npos;
}

bool has(string_view head, string_view text) {
  return head.find(text) != string_view::npos;
}

string_view first_line(string_view head) {
  return head.substr(0, head.find('\n'));
}

bool has_column(string_view header, string_view name) {
  return ("," + std::string(header) + ",").find("," + std::string(name) + ",") != std::string::npos;
}

// TUM: eight numbers a line, with blanks between them.
bool is_trajectory(string_view line) {
  std::size_t numbers = 0;
  while (!line.empty()) {
    double ignored = 0.0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), ignored);
    if (error != std::errc()) return false;
    ++numbers;
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    line.remove_prefix(std::min(line.find_first_not_of(" \r"), line.size()));
  }
  return numbers == 8;
}

bool is_page(string_view head) {
  return head.starts_with("<!DOCTYPE html>") && (has(head, "name=\"generator\" content=\"wheelwright\"") ||
                                                 (has(head, "--before:") && has(head, "--after:")));
}

bool is_plain_csv(string_view header) {
  return has_column(header, "t") && (has_column(header, "cmd_left") || has_column(header, "speed_left"));
}

}  // namespace

bool is_of_kind(OutputKind kind, string_view head) {
  switch (kind) {
    case OutputKind::any:
      return true;
    case OutputKind::model:
      return has_line(head, "wheelwright_model:");
    case OutputKind::drive_log:
      return has_line(head, "# wheelwright_drive_log:");
    case OutputKind::pose_log:
      return has_line(head, "# wheelwright_pose_log:");
    case OutputKind::motion:
      return head.starts_with("t,speed_left,speed_right,v,w,x,y,theta\n");
    case OutputKind::plain_csv:
      return is_plain_csv(first_line(head));
    case OutputKind::trajectory:
      return is_trajectory(first_line(head));
    case OutputKind::mcap:
      return head.starts_with("\x89MCAP0\r\n") && has(head.substr(0, 256), "wheelwright");
    case OutputKind::page:
      return is_page(head);
    case OutputKind::gap:
      return head.starts_with("{") && has(head, "\"verdict\"") && has(head, "\"summary\"");
    case OutputKind::evaluation:
      return head.starts_with("{") && has(head, "\"robot\"") && has(head, "\"route\"") &&
             has(head, "\"models\"");
    case OutputKind::status:
      return head.starts_with("{") && has(head, "\"wheelwright_status\"");
    case OutputKind::lateness:
      return has_line(head, "# wheelwright_lateness:");
    case OutputKind::truth:
      return has_line(head, "# wheelwright_truth:");
    case OutputKind::cable_faults:
      return has_line(head, "# wheelwright_cable_faults:");
    case OutputKind::c_header:
      return head.starts_with("/* wheelwright_c_header:");
    case OutputKind::ros2_control:
      return has_line(head, "# wheelwright_ros2_control:");
    case OutputKind::sdf:
      return head.starts_with("<!-- wheelwright_sdf:");
    case OutputKind::mujoco:
      return head.starts_with("<!-- wheelwright_mujoco:");
    case OutputKind::ranges:
      return has_line(head, "wheelwright_ranges:");
  }
  return false;
}

}  // namespace wheelwright::config
