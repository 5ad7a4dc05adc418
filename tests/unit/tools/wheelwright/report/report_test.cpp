#include <filesystem>
#include <fstream>
#include <sstream>

#include "daemon/recording/lateness_file.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/logged_run.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/wheelwright/common/command_line.hpp"
#include "tools/wheelwright/page/plot.hpp"
#include "tools/wheelwright/report/calibration_section.hpp"
#include "tools/wheelwright/report/true_path.hpp"
#include "tools/wheelwright/report/wheel_plots.hpp"

using namespace wheelwright;
using tools::ExitStatus;

namespace {

struct Outcome {
  ExitStatus status;
  std::string err;
};

Outcome command(const std::vector<std::string>& arguments) {
  std::ostringstream out;
  std::ostringstream err;
  const ExitStatus status = tools::run_command_line(arguments, {out, err});
  return {status, err.str()};
}

std::string contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::filesystem::path empty_folder(const std::string& name) {
  const auto folder = test::temporary_folder() / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

bool has_pictures(const std::string& page) {
  const bool drawn = page.find("<svg") != std::string::npos;
  if (!drawn) WARN("no gnuplot here: nothing that stands in a picture or below it was looked at");
  return drawn;
}

void check_stands_alone(const std::string& page) {
  for (const char* link : {"src=", "<script", "@import", "url(http", "https://"}) {
    CHECK_THAT(page, !ContainsSubstring(link));
  }
  const bool drawn = page.find("<svg") != std::string::npos;
  const bool excused = page.find("needs gnuplot") != std::string::npos;
  CHECK(drawn != excused);
  CHECK_THAT(page, !ContainsSubstring("rgb(1,2,3)"));  // ink of a picture that does not follow the page's
}

}  // namespace

TEST_CASE("The report of a run shows its calibrations, its route, and what happened") {
  const auto folder = empty_folder("wheelwright_report_run");
  const auto config = test::short_configuration();
  const auto run = test::run_of(config, 1);
  REQUIRE(run.finished);
  test::write_logs(run, config, folder);
  roomba::LatenessHistogram lateness;
  for (int k = 0; k < 1000; ++k) lateness.add(std::chrono::microseconds(20 + k));
  std::ofstream(folder / "lateness.txt")
      << daemon::lateness_text(daemon::lateness_record(lateness, {}, 0.018, "SCHED_FIFO 80"));
  REQUIRE(command({"report", folder.string()}).status == ExitStatus::done);
  const std::string page = contents(folder / "report.html");
  for (const char* part : {"Calibration A: encoder scale", "metres per tick", "Calibration B: responses",
                           "gain, own motor", "The run", "checkpoints visited", "3 of 3", "Events and faults",
                           "encoder_turn", "How late the loop was", "SCHED_FIFO 80"}) {
    CHECK_THAT(page, ContainsSubstring(part));
  }
  if (has_pictures(page)) {
    CHECK_THAT(page, ContainsSubstring("numbers are checkpoints") && ContainsSubstring("lateness [us]"));
  }
  check_stands_alone(page);
}

TEST_CASE("The report of a run without a route speaks of no checkpoints, and without its lateness of none") {
  const auto folder = empty_folder("wheelwright_report_no_route");
  auto config = test::short_configuration();
  config.route.reset();
  test::write_logs(test::run_of(config, 1), config, folder);
  REQUIRE(command({"report", folder.string()}).status == ExitStatus::done);
  const std::string page = contents(folder / "report.html");
  if (has_pictures(page)) CHECK_THAT(page, ContainsSubstring("Where the robot was"));
  CHECK_THAT(page, !ContainsSubstring("checkpoint") && !ContainsSubstring("How late the loop was"));
}

TEST_CASE(
    "The picture of orders marks the model's own order, and the one that would be chosen if that was given") {
  OrderSweep sweep;
  for (std::size_t order = 1; order <= 9; ++order) {
    OrderSweepRow row;
    row.order = order;
    row.held_out_distance_rms_m = 0.001;
    row.standard_error_m = 0.0001;
    sweep.rows.push_back(row);
  }
  sweep.chosen = 2;
  const auto given = tools::order_plot(sweep, 9);
  CHECK_THAT(given.script(),
             ContainsSubstring("'given: 9' at first 9") && ContainsSubstring("'auto: 2' at first 2"));
  CHECK_THAT(given.script(), !ContainsSubstring("chosen"));
  const auto chosen = tools::order_plot(sweep, 2);
  CHECK_THAT(chosen.script(), ContainsSubstring("'chosen: 2' at first 2") && !ContainsSubstring("given"));
}

TEST_CASE("The picture of a heading counts full turns, and begins at the first heading that was measured") {
  DriveLog log;
  std::vector<PredictedMotion> motion;
  for (int second = 0; second <= 40; ++second) {
    DriveSample sample;
    sample.t_s = second;
    if (second > 0) sample.reference_theta_rad = wrap_angle(1.5 * second);
    log.samples.push_back(sample);
    PredictedMotion predicted;
    predicted.t_s = sample.t_s;
    predicted.pose.theta_rad = 0.3 + 1.6 * second;
    motion.push_back(predicted);
  }
  REQUIRE(tools::has_headings(log));
  const tools::DrawnRun run{"model", tools::Ink::accent, &motion};
  CHECK_THAT(tools::heading_error_plot(log, {&run, 1}).script(),
             ContainsSubstring("\n1 0\n") && ContainsSubstring("\n40 3900\n"));
}

TEST_CASE("The report of a log from elsewhere shows what is in it") {
  const auto folder = empty_folder("wheelwright_report_log");
  std::ofstream log(folder / "mine.csv");
  log << "# wheelwright_drive_log: 1\n# wheel_base_m: 0.3\n# metres_per_tick_left: 0.001\n"
         "# metres_per_tick_right: 0.001\nt,cmd_left,cmd_right,ticks_left,ticks_right\n";
  for (int k = 0; k < 200; ++k) log << 0.02 * k << ",0.1,0.1," << 2 * k << "," << 2 * k << "\n";
  log.close();
  REQUIRE(command({"report", (folder / "mine.csv").string()}).status == ExitStatus::done);
  const std::string page = contents(folder / "mine.html");
  CHECK_THAT(page, ContainsSubstring("The log"));
  check_stands_alone(page);
}

TEST_CASE("The report of an evaluation has its table beside the paper's") {
  const auto folder = empty_folder("wheelwright_report_evaluation");
  REQUIRE(command({"evaluate", "--runs", "2", "--threads", "2", "-o", folder.string()}).status ==
          ExitStatus::done);
  REQUIRE(command({"report", folder.string()}).status == ExitStatus::done);
  const std::string page = contents(folder / "report.html");
  for (const char* part : {"odometry", "moving average, sensor-less", "0.332", "2 of 2"}) {
    CHECK_THAT(page, ContainsSubstring(part));
  }
  check_stands_alone(page);
}

TEST_CASE("A folder without logs, or a file that is none, is no report") {
  const auto folder = empty_folder("wheelwright_report_none");
  CHECK(command({"report", folder.string()}).status == ExitStatus::bad_input);
  std::ofstream(folder / "other.csv") << "a,b\n1,2\n";
  const Outcome other = command({"report", (folder / "other.csv").string()});
  CHECK(other.status == ExitStatus::bad_input);
  CHECK_THAT(other.err, ContainsSubstring("no commands and no wheels were found"));
}

TEST_CASE("The page of the gap workflow is pointed at, not overwritten") {
  const auto folder = empty_folder("wheelwright_report_gap");
  std::ofstream(folder / "gap.json") << "{}";
  const Outcome outcome = command({"report", folder.string()});
  CHECK(outcome.status == ExitStatus::bad_input);
  CHECK_THAT(outcome.err, ContainsSubstring("report.html"));
  CHECK_FALSE(std::filesystem::exists(folder / "report.html"));
}

TEST_CASE("A thinned line keeps its peaks") {
  tools::PlotPoints points;
  for (int k = 0; k < 100000; ++k) points.push_back({0.001 * k, k == 54321 ? 7.0 : k == 200 ? -7.0 : 0.0});
  const auto thin = tools::thinned(points);
  CHECK(thin.size() < 1600);
  CHECK_THAT(std::ranges::max(thin, {}, &tools::PlotPoint::y).x, WithinAbs(54.321, 1e-6));
  CHECK_THAT(std::ranges::min(thin, {}, &tools::PlotPoint::y).x, WithinAbs(0.2, 1e-6));
  CHECK(std::ranges::is_sorted(thin, {}, &tools::PlotPoint::x));
}

TEST_CASE("The true route begins where the last long stand ends, in the robot's own frame there") {
  std::string text = "t,x,y,theta,speed_left,speed_right\n";
  const auto row = [&](double t, double x, double y, double speed) {
    text += std::to_string(t) + "," + std::to_string(x) + "," + std::to_string(y) + ",1.5707963267949," +
            std::to_string(speed) + "," + std::to_string(speed) + "\n";
  };
  for (int k = 0; k < 10; ++k) row(0.1 * k, 1.0, 0.1 * k, 0.2);                // drives
  for (int k = 10; k < 30; ++k) row(0.1 * k, 1.0, 1.0, 0.0);                   // stands for 2 s
  for (int k = 30; k < 40; ++k) row(0.1 * k, 1.0, 1.0 + 0.1 * (k - 29), 0.2);  // drives along y, ahead for it
  const auto path = tools::true_path(config::CsvTable::parse(text, "truth"));
  CHECK_THAT(path.closure_m, WithinAbs(1.0, 1e-6));
  CHECK_THAT(path.points.back().x, WithinAbs(1.0, 1e-6));
  CHECK_THAT(path.points.back().y, WithinAbs(0.0, 1e-6));
}
