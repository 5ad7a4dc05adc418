#include "daemon/model_watch/model_watch.hpp"

#include <spdlog/spdlog.h>
#include <time.h>

#include "config/load/model_file.hpp"
#include "config/load/output_file.hpp"
#include "daemon/model_watch/recorded_drives.hpp"
#include "daemon/wiring/plan.hpp"

namespace wheelwright::daemon {
namespace {

namespace fs = std::filesystem;

constexpr long poll_period_ns = 100'000'000;
constexpr std::string_view folder_name = "gap";

// Installed or built, the command stands beside the daemon.
fs::path workflow_program() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path() / "wheelwright";
}

std::optional<RobotModel> model_in(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) return std::nullopt;
  try {
    return config::load_model(file);
  } catch (const std::exception& problem) {
    spdlog::warn("gap.watch: {}", problem.what());
    return std::nullopt;
  }
}

// Why the configuration would not start with this model; nothing where it would.
std::optional<std::string> refusal_of(config::DaemonConfig config, const RobotModel& model) {
  config.calibrate = config::CalibrateWhen::never;
  try {
    make_plan(config, model);
    return std::nullopt;
  } catch (const std::exception& problem) {
    return problem.what();
  }
}

}  // namespace

void ModelWatch::drive_ended(bool recalibration_due) {
  const bool wanted = config_.gap_watch == config::GapWatch::after_run ||
                      (config_.gap_watch == config::GapWatch::when_due && recalibration_due);
  if (wanted && !search_) begin();
}

void ModelWatch::begin() {
  const auto model = model_in(config_.model_file);
  if (!model) return say("there is no model yet that a drive could be compared with");
  DriveChoice choice;
  choice.robot = config_.robot_name;
  choice.not_before = model->created;
  drives_ = recorded_drives(config_.log_folder, run_folder_, choice);
  if (drives_.empty()) return say("no drive is recorded that is long enough to be compared with the model");
  const fs::path folder = run_folder_ / folder_name;
  std::error_code error;
  fs::create_directory(folder, error);
  std::vector<std::string> arguments{"gap", "--model",       config_.model_file.string(),
                                     "-o",  folder.string(), "--train"};
  for (const fs::path& drive : drives_) arguments.push_back(drive.string());
  search_ = std::make_unique<IdleProcess>(workflow_program(), arguments, folder / "messages.txt", limits_);
  spdlog::info("gap.watch: looks at {} {} for what the model lacks", drives_.size(),
               drives_.size() == 1 ? "drive" : "drives");
}

void ModelWatch::look() {
  if (!search_) return;
  const auto status = search_->ended();
  if (!status) return;
  search_.reset();
  // 1: the data cannot show what was asked; gap.json says why.
  if (*status != 0 && *status != 1) {
    return say("the search ended with status " + std::to_string(*status) + "; " +
               (run_folder_ / folder_name / "messages.txt").string() + " says more");
  }
  if (const auto before = model_in(config_.model_file)) report(*before);
}

void ModelWatch::say(const std::string& answer) {
  answer_ = answer;
  spdlog::info("gap.watch: {}", answer);
}

void ModelWatch::report(const RobotModel& before) {
  const fs::path folder = run_folder_ / folder_name;
  const auto answer = read_gap_answer(folder / "gap.json");
  if (!answer) return say(answer.error());
  if (!answer->differs) {
    return say(answer->verdict == "nothing_missing"
                   ? "the model holds on " + std::to_string(drives_.size()) + " drives"
                   : answer->summary);
  }
  auto after = model_in(folder / "model.yaml");
  if (after && config_.pose_source == PoseSource::fir) after->linear_part = as_fir(after->linear_part);
  std::string since = run_time(drives_.front().parent_path());
  if (!since.empty()) since = since.substr(0, 16) + "Z";
  std::string sentences;
  if (after) {
    for (const std::string& change : effect_changes(before, *after, *answer, since))
      sentences += (sentences.empty() ? "" : "; ") + change;
  }
  say(sentences.empty() ? answer->summary : sentences);
  spdlog::warn("gap.watch: {} {}", answer->summary, (folder / "report.html").string());
  if (after) take_up(before, *after, *answer);
}

void ModelWatch::take_up(const RobotModel& before, const RobotModel& after, const GapAnswer& answer) {
  if (!answer.proven) {
    spdlog::info("gap.watch: the new model stays in {}: it is not proven on drives that it has not seen",
                 (run_folder_ / folder_name).string());
    return;
  }
  if (const auto refusal = refusal_of(config_, after)) {
    spdlog::info("gap.watch: the new model stays in {}: {}", (run_folder_ / folder_name).string(), *refusal);
    return;
  }
  const fs::path kept = run_folder_ / folder_name / "former_model.yaml";
  try {
    config::save_model(before, kept);
    config::save_model(after, config_.model_file);
  } catch (const std::exception& problem) {
    spdlog::error("gap.watch: {}", problem.what());
    return;
  }
  spdlog::info(
      "gap.watch: {} holds the new model from the next start on: on drives that it has not seen, the travel "
      "of a "
      "wheel is {:.1f} mm off instead of {:.1f} mm; {} is the former one",
      config_.model_file.string(), 1e3 * answer.untouched_after_m, 1e3 * answer.untouched_before_m,
      kept.string());
}

void ModelWatch::wait(const sigset_t& signals) {
  const timespec patience{0, poll_period_ns};
  while (search_) {
    if (::sigtimedwait(&signals, nullptr, &patience) > 0) {
      search_.reset();
      return say("ended by a signal before there was an answer");
    }
    look();
  }
}

}  // namespace wheelwright::daemon
