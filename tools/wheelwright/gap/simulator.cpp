#include "tools/wheelwright/gap/simulator.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>

#include <array>
#include <chrono>
#include <csignal>
#include <optional>

#include "config/load/drive_log_file.hpp"
#include "config/load/printable_text.hpp"
#include "config/load/text_file.hpp"
#include "config/load/text_format.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/common/output.hpp"
#include "tools/wheelwright/import/conversion/repair_checks.hpp"

extern char** environ;  // NOLINT(readability-redundant-declaration): by POSIX, the program declares it

namespace wheelwright::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view commands_mark = "{commands}";
constexpr std::string_view out_mark = "{out}";

std::string quoted_for_shell(const std::string& text) {
  std::string quoted = "'";
  for (const char letter : text) quoted += letter == '\'' ? "'\\''" : std::string(1, letter);
  return quoted + "'";
}

void fill_in(std::string& text, std::string_view mark, const std::string& by) {
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + by.size()))
    text.replace(at, mark.size(), by);
}

// Commands and times alone: what was measured is the robot's.
DriveLog commands_of(const DriveLog& run) {
  DriveLog commands;
  commands.wheel_base_m = run.wheel_base_m;
  commands.period_s = run.period_s;
  for (const DriveSample& sample : run.samples) {
    DriveSample row;
    row.t_s = sample.t_s - run.samples.front().t_s;
    row.command_m_s = sample.command_m_s;
    commands.samples.push_back(row);
  }
  return commands;
}

// Ended by a signal to this program too, since it is no longer in its process group.
class ShellCommand {
 public:
  ShellCommand(std::string command, const fs::path& said) {
    sigemptyset(&signals_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals_, signal);
    pthread_sigmask(SIG_BLOCK, &signals_, &before_);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, said.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0644);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    posix_spawnattr_setsigmask(&attributes, &before_);
    std::string shell = "sh", option = "-c";
    std::array<char*, 4> arguments{shell.data(), option.data(), command.data(), nullptr};
    if (posix_spawn(&process_, "/bin/sh", &actions, &attributes, arguments.data(), environ) != 0)
      process_ = -1;
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
  }
  ShellCommand(const ShellCommand&) = delete;
  ShellCommand& operator=(const ShellCommand&) = delete;
  ~ShellCommand() {
    if (process_ > 0) ::kill(-process_, SIGKILL);  // and what it has started
    if (process_ > 0 && !ended_) ::waitpid(process_, nullptr, 0);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

  // Its status as the shell has it; nothing where it took longer.
  std::optional<int> ends_within(double limit_s) {
    if (process_ < 0) return 127;
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(limit_s);
    constexpr timespec a_while{0, 20'000'000};
    while (true) {
      int status = 0;
      if (::waitpid(process_, &status, WNOHANG) == process_) {
        ended_ = true;
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      }
      if (std::chrono::steady_clock::now() >= end) return std::nullopt;
      const int signal = ::sigtimedwait(&signals_, nullptr, &a_while);
      if (signal > 0) end_by(signal);
    }
  }

 private:
  void end_by(int signal) {
    ::kill(-process_, SIGKILL);
    ::signal(signal, SIG_DFL);
    pthread_sigmask(SIG_UNBLOCK, &signals_, nullptr);
    ::raise(signal);
  }

  pid_t process_ = -1;
  bool ended_ = false;
  sigset_t signals_{};
  sigset_t before_{};
};

std::string last_line_of(const fs::path& said) {
  const auto text = config::read_text(said, config::record_file);
  if (!text) return "nothing";
  const std::size_t end = text->find_last_not_of(" \r\n\t");
  if (end == std::string::npos) return "nothing";
  const std::size_t begin = text->find_last_of('\n', end);
  const std::size_t first = begin == std::string::npos ? 0 : begin + 1;
  return "'" + config::printable(text->substr(first, end + 1 - first)) + "'";
}

// Files of a run of the simulator; all but its commands are lost when it runs once more.
struct RunFiles {
  fs::path commands;
  fs::path out;
  fs::path said;
};

RunFiles files_of(const fs::path& folder, std::size_t run) {
  const std::string name = "run" + std::to_string(run + 1);
  return {folder / (name + "_commands.csv"), folder / (name + ".csv"), folder / (name + ".txt")};
}

// Only where its commands stand beside it a file is one that a simulator wrote for us; and none is lost that
// is being compared.
void check_may_be_replaced(const RunFiles& files, std::span<const DriveLog> runs) {
  std::error_code ignored;
  for (const fs::path& file : {files.out, files.said}) {
    if (!fs::exists(file, ignored)) continue;
    if (!import::is_drive_log(files.commands))
      throw UsageError(file.string() + ": is no file of an earlier --simulator; give another folder by -o");
  }
  for (const DriveLog& run : runs) {
    for (const fs::path& file : {files.commands, files.out, files.said}) {
      if (fs::equivalent(file, run.name, ignored))
        throw UsageError(file.string() + ": is one of the runs that are compared; give another folder by -o");
    }
  }
}

void run_once(const Simulator& simulator, const DriveLog& run, const RunFiles& files) {
  const auto& [commands, out, said] = files;
  config::save_drive_log(commands_of(run), commands.string());
  std::error_code ignored;
  fs::remove(out, ignored);  // what an earlier run wrote is not to be taken for this one's
  std::string command = simulator.command;
  fill_in(command, commands_mark, quoted_for_shell(commands.string()));
  fill_in(command, out_mark, quoted_for_shell(out.string()));
  ShellCommand shell(command, said);
  const auto status = shell.ends_within(simulator.limit_s);
  const std::string where =
      "--simulator: on the commands of " + run.name + ":" + std::to_string(run.first_line) + " ";
  const std::string last = "; its last line: " + last_line_of(said) + ", all of it in " + said.string();
  if (!status) {
    throw UsageError(where + "it took longer than " + config::plain_number(simulator.limit_s) +
                     " s and was ended" + last + "; --simulator-limit allows more");
  }
  if (*status != 0) throw UsageError(where + "it ended with status " + std::to_string(*status) + last);
  if (!fs::exists(out, ignored)) throw UsageError(where + "it wrote no " + out.string() + last);
}

}  // namespace

void check_simulator(const Simulator& simulator) {
  for (const std::string_view mark : {commands_mark, out_mark}) {
    if (simulator.command.find(mark) != std::string::npos) continue;
    throw UsageError("--simulator: '" + simulator.command + "' has no " + std::string(mark) +
                     "; give a command such as 'python3 my_simulator.py {commands} {out}'");
  }
}

std::vector<SimulatorRun> run_simulator(const Simulator& simulator, std::span<const DriveLog> runs,
                                        const fs::path& folder,
                                        const std::function<void(std::size_t)>& before_each) {
  make_folder(folder);
  const fs::path absolute = fs::absolute(folder);
  for (std::size_t i = 0; i < runs.size(); ++i) check_may_be_replaced(files_of(absolute, i), runs);
  std::vector<SimulatorRun> written;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    before_each(i);
    const RunFiles files = files_of(absolute, i);
    run_once(simulator, runs[i], files);
    written.push_back({files.commands, files.out});
  }
  return written;
}

}  // namespace wheelwright::tools
