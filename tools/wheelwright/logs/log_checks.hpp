// What a command makes sure of before it believes a log.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "config/load/output_file.hpp"
#include "model/log/drive_log.hpp"
#include "model/simulation/linear_model.hpp"

namespace wheelwright::tools {

// Throws UsageError where the output of a command may not be written: see config/load/output_file.hpp.
void check_output(const config::OutputFile& output, const std::vector<std::string>& inputs);

// As the log's `# robot:` says, or "unknown".
std::string robot_name(const DriveLog& log);

// The first command of a log that its robot cannot have been given, as one line with file and line; nothing
// where there is none. Serial lines do lose bytes: a row of blanks reads as 8.224 m/s. The limit in m/s is
// `limit_m_s` where given, else 0.5 where the log's `# robot:` names a Roomba or a Create, else 5.
std::optional<std::string> find_impossible_command(const DriveLog& log, std::optional<double> limit_m_s);

// The first jump of the encoder counts that no wheel makes (four times the same limit), in the same form.
std::optional<std::string> find_impossible_counts(const DriveLog& log, std::optional<double> limit_m_s);

// Throws UsageError, with the file and what differs, where runs cannot be fitted together: no encoder counts
// (unless the fit is by poses), rows much farther apart than `period_s` says, another robot, wheel base or
// encoder scale than that of the first run, or a period that is not near.
void check_runs_of_one_robot(const std::vector<DriveLog>& runs, bool by_poses);

// Throws UsageError where the log's period is not near that of the model. Writes one line to `err` for each
// thing that makes a comparison of the two doubtful.
void check_log_for_model(const DriveLog& log, const LinearModel& model, std::ostream& err);

// The holes of a log that has encoder counts, as "run.csv:204: no rows for 3.6 s"; a few of them, then how
// many more. Nothing where there is none.
std::vector<std::string> describe_holes(const DriveLog& log);

// What in a run contradicts itself, as `gap` will say it: a reference in another unit, mirrored or frozen,
// counters of the wrong side or sign, counts that stand still. One line each, "run.csv:8: ..."; the first
// ten, then how many more.
std::vector<std::string> describe_contradictions(const std::vector<DriveLog>& runs);

}  // namespace wheelwright::tools
