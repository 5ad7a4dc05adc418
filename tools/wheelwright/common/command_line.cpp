#include "tools/wheelwright/common/command_line.hpp"

#include <algorithm>
#include <array>
#include <new>
#include <ostream>

#include "config/load/printable_text.hpp"
#include "config/load/yaml_reader.hpp"
#include "tools/wheelwright/common/printable_stream.hpp"

namespace wheelwright::tools {
namespace {

constexpr std::array commands{add_fit,    add_simulate, add_score,  add_gap,     add_effects,
                              add_replay, add_evaluate, add_doctor, add_inspect, add_import,
                              add_export, add_report,   add_circle, add_status};

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return config::printable(text);
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  return names;
}

void check_command_name(const CLI::App& app, const std::vector<std::string>& arguments) {
  const auto names = command_names(app);
  if (arguments.empty()) throw UsageError("no command given; use one of: " + joined(names));
  const std::string& first = arguments.front();
  if (first.starts_with('-') || std::find(names.begin(), names.end(), first) != names.end()) return;
  const std::string near = config::nearest_word(first, names);
  throw UsageError("unknown command '" + first + "'; " +
                   (near.empty() ? "use one of: " + joined(names) : "did you mean '" + near + "'?"));
}

bool is_key_with_value(const std::string& argument) {
  const std::string key = argument.substr(0, argument.find('='));
  const bool is_key = key.find('.') != std::string::npos &&
                      key.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_.") == std::string::npos;
  return key.size() < argument.size() && is_key;
}

// `--set a.b=1 c.d=2` sets both, and what follows that is no KEY=VALUE is an argument of its own again, which
// CLI11 cannot say.
std::vector<std::string> with_each_key_set(const std::vector<std::string>& arguments) {
  std::vector<std::string> all;
  std::string option;
  for (const std::string& argument : arguments) {
    if (argument == "--set" || argument == "--simulation-set") {
      option = argument;
    } else if (!option.empty() && is_key_with_value(argument)) {
      if (all.back() != option) all.push_back(option);
    } else {
      option.clear();
    }
    all.push_back(argument);
  }
  return all;
}

// CLI11 says which word it did not expect; the nearest option is more help.
std::string explain(const CLI::App& app, const CLI::ParseError& error) {
  const auto selected = app.get_subcommands();
  const CLI::App& command = selected.empty() ? app : *selected.back();
  std::string text = one_line(error.what());
  const auto unexpected = app.remaining(true);
  if (!unexpected.empty()) {
    std::vector<std::string> options;
    for (const CLI::Option* option : command.get_options()) {
      for (const auto& name : option->get_lnames()) options.push_back("--" + name);
    }
    text = "'" + unexpected.front() + "' is not expected here";
    const std::string near = config::nearest_word(unexpected.front(), options);
    if (!near.empty()) text += "; did you mean '" + near + "'?";
  }
  const std::string name = selected.empty() ? "wheelwright" : "wheelwright " + command.get_name();
  return text + " (see '" + name + " --help')";
}

ExitStatus report(std::ostream& err, const std::string& what, ExitStatus status) {
  err << "wheelwright: " << one_line(what) << "\n";
  return status;
}

ExitStatus parse_and_run(std::vector<std::string> arguments, Streams streams) {
  CLI::App app{"Calibrates models of a differential-drive robot from drive logs, simulates and judges them.",
               "wheelwright"};
  app.set_version_flag("--version", "wheelwright " WHEELWRIGHT_VERSION);
  app.require_subcommand(1);
  app.footer("Example: wheelwright fit run1.csv -o robot.yaml && wheelwright score robot.yaml run2.csv");
  std::vector<Action> actions;
  actions.reserve(commands.size());
  for (const auto add : commands) actions.push_back(add(app));

  check_command_name(app, arguments);
  try {
    arguments = with_each_key_set(arguments);
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
    app.parse(arguments);
  } catch (const CLI::Success& wanted) {
    app.exit(wanted, streams.out, streams.err);
    return ExitStatus::done;
  } catch (const CLI::ParseError& error) {
    throw UsageError(explain(app, error));
  }
  const auto names = command_names(app);
  const auto chosen = std::find(names.begin(), names.end(), app.get_subcommands().front()->get_name());
  return actions[static_cast<std::size_t>(chosen - names.begin())](streams);
}

}  // namespace

ExitStatus run_command_line(std::vector<std::string> arguments, Streams streams) {
  try {
    PrintableStream out(streams.out);
    return parse_and_run(std::move(arguments), {out, streams.err});
  } catch (const DataRefusal& refusal) {
    return report(streams.err, refusal.what(), ExitStatus::answer_is_no);
  } catch (const std::bad_alloc&) {
    return report(streams.err, "not enough memory is free for this; give fewer or shorter runs",
                  ExitStatus::bad_input);
  } catch (const std::exception& error) {
    return report(streams.err, error.what(), ExitStatus::bad_input);
  }
}

}  // namespace wheelwright::tools
