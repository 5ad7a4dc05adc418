// What a command makes sure of before it believes a log.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "model/drive_log.hpp"
#include "model/linear_model.hpp"

namespace wheelwright::tools {

// All runs of all files, in order. Throws config::LogError.
std::vector<DriveLog> load_all_runs(const std::vector<std::string>& paths);

// Throws UsageError where the output of a command would replace one of its inputs.
void check_output(const std::string& output, const std::vector<std::string>& inputs);

// As the log's `# robot:` says, or "unknown".
std::string robot_name(const DriveLog& log);

// The first command of a log that its robot cannot have been given, as one line with file and line; nothing
// where there is none. Serial lines do lose bytes: a row of blanks reads as 8.224 m/s. The limit in m/s is
// `limit_m_s` where given, else 0.5 where the log's `# robot:` names a Roomba or a Create, else 5.
std::optional<std::string> find_impossible_command(const DriveLog& log, std::optional<double> limit_m_s);

// Writes one line to `err` for each thing that makes a comparison of model and log doubtful.
void warn_of_doubtful_log(const DriveLog& log, const LinearModel& model, std::ostream& err);

}  // namespace wheelwright::tools
