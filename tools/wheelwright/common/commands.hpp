// The subcommands of `wheelwright`: each is one file that ends in one function of this list, and one line in
// the table of command_line.cpp.
#pragma once

#include <functional>
#include <iosfwd>
#include <stdexcept>

#include <CLI/CLI.hpp>

namespace wheelwright::tools {

// What the shell gets back. The same for every program of the project.
enum class ExitStatus {
  done = 0,
  answer_is_no = 1,  // it ran, and a check failed or the data cannot show what was asked
  bad_input = 2,     // usage, configuration or input
};

struct Streams {
  std::ostream& out;
  std::ostream& err;
};

// Ends a command with one line on standard error.
class UsageError : public std::runtime_error {  // bad_input
 public:
  using std::runtime_error::runtime_error;
};
class DataRefusal : public std::runtime_error {  // answer_is_no
 public:
  using std::runtime_error::runtime_error;
};

using Action = std::function<ExitStatus(Streams)>;

// Adds a subcommand with its options to `app` and returns what to do once they are parsed.
Action add_fit(CLI::App& app);
Action add_simulate(CLI::App& app);
Action add_score(CLI::App& app);
Action add_effects(CLI::App& app);
Action add_gap(CLI::App& app);
Action add_replay(CLI::App& app);
Action add_evaluate(CLI::App& app);
Action add_doctor(CLI::App& app);
Action add_inspect(CLI::App& app);
Action add_import(CLI::App& app);
Action add_export(CLI::App& app);
Action add_report(CLI::App& app);
Action add_circle(CLI::App& app);
Action add_status(CLI::App& app);

}  // namespace wheelwright::tools
