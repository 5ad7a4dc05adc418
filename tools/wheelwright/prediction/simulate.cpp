// wheelwright simulate: a model and a log's commands in, predicted motion out.
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "config/load/drive_log_file.hpp"
#include "config/load/model_file.hpp"
#include "config/load/output_file.hpp"
#include "config/load/text_format.hpp"
#include "model/prediction/free_run.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/common/json_text.hpp"
#include "tools/wheelwright/common/output.hpp"
#include "tools/wheelwright/logs/log_checks.hpp"
#include "tools/wheelwright/logs/log_input.hpp"

namespace wheelwright::tools {
namespace {

struct SimulateOptions {
  std::string model;
  std::string log;
  ImportOptions import;
  std::string output;
  bool json = false;
};

std::string to_csv(const std::vector<PredictedMotion>& motion) {
  constexpr int decimals = 9;
  std::string text = "t,speed_left,speed_right,v,w,x,y,theta\n";
  for (const auto& row : motion) {
    text += config::plain_number(row.t_s);
    for (const double value : {row.speed_m_s.left, row.speed_m_s.right, row.twist.v_m_s, row.twist.w_rad_s,
                               row.pose.x_m, row.pose.y_m, row.pose.theta_rad}) {
      text += "," + config::fixed_number(value, decimals);
    }
    text += "\n";
  }
  return text;
}

double length_s(const std::vector<PredictedMotion>& motion) {
  return motion.back().t_s - motion.front().t_s;
}

void print(std::ostream& out, const std::vector<PredictedMotion>& motion, const SimulateOptions& options) {
  const Pose& end = motion.back().pose;
  out << motion.size() << " rows, " << config::fixed_number(length_s(motion), 1) << " s; ends at x "
      << config::fixed_number(end.x_m, 3) << " m, y " << config::fixed_number(end.y_m, 3) << " m, theta "
      << config::fixed_number(end.theta_rad, 3) << " rad\nwrote " << options.output << "\n";
}

nlohmann::ordered_json to_json(const std::vector<PredictedMotion>& motion, const SimulateOptions& options) {
  const Pose& end = motion.back().pose;
  return {{"rows", motion.size()},
          {"duration_s", length_s(motion)},
          {"end", {{"x_m", end.x_m}, {"y_m", end.y_m}, {"theta_rad", end.theta_rad}}},
          {"output", options.output}};
}

ExitStatus run_simulate(const SimulateOptions& options, Streams streams) {
  check_output({options.output, config::OutputKind::motion}, {options.model, options.log});
  const RobotModel model = config::load_model(options.model);
  const DriveLog log = load_one_run({{options.log}, options.import}, streams.err);
  check_log_for_model(log, model.linear_part, streams.err);
  ProgressLine progress(streams.err);
  const auto say = progress.callback();
  say("simulating", 0.3);
  const auto motion = free_run(model, log);
  say("writing " + options.output, 0.6);
  write({options.output, config::OutputKind::motion}, to_csv(motion));
  progress.clear();
  if (options.json) {
    streams.out << json_text(to_json(motion, options)) << "\n";
  } else {
    print(streams.out, motion, options);
  }
  return ExitStatus::done;
}

}  // namespace

Action add_simulate(CLI::App& app) {
  const auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = app.add_subcommand("simulate", "Free run of a model over the commands of a log");
  command->add_option("MODEL", options->model, "Model file")->required();
  command->add_option("LOG", options->log, "Drive log of one run; its measurements are not used")->required();
  command->add_option("-o,--output", options->output, "CSV to write: t, wheel speeds, v, w, x, y, theta")
      ->required();
  add_import_options(*command, options->import);
  command->add_flag("--json", options->json,
                    "Rows, duration and end as JSON; the motion goes to the CSV all the same");
  command->footer("Example: wheelwright simulate robot.yaml run2.csv -o predicted.csv");
  return [options](Streams streams) { return run_simulate(*options, streams); };
}

}  // namespace wheelwright::tools
