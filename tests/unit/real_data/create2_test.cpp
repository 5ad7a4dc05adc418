// FIR models of a real Create 2, where its logs are.
#include <filesystem>
#include <sstream>

#include "config/load/drive_log_file.hpp"
#include "model/identification/fir_fit.hpp"
#include "model/prediction/free_run.hpp"
#include "model/prediction/score.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/create2_logs.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/wheelwright/common/command_line.hpp"

using namespace wheelwright;

TEST_CASE(
    "A model of one run of a Create 2 predicts the repeat to 1 mm, and shows that later runs are faster") {
  const auto folder = test::create2_folder();
  if (!folder) return;
  const DriveLog training = config::load_drive_log(*folder / "run1.csv");
  const auto fit = fit_fir(std::span(&training, 1));
  REQUIRE(fit);

  const DriveLog repeat = config::load_drive_log(*folder / "run2.csv");
  CHECK(*score_run(free_run(fit->model, repeat), repeat).distance_rms_m <= 0.001);

  for (const std::string name : {"run3.csv", "run4.csv"}) {
    INFO(name);
    const DriveLog faster = config::load_drive_log(*folder / name);
    const auto motion = free_run(fit->model, faster);
    CHECK(*score_run(motion, faster).distance_rms_m > 0.05);
    const auto error = end_distance_error_m(motion, faster);
    CHECK(error->left < -0.05);  // the model falls behind
    CHECK(error->right < -0.05);
  }
}

TEST_CASE("The garbage in the first row of a real log is refused by fit, with its line") {
  const auto folder = test::create2_folder();
  if (!folder) return;
  const auto model = test::temporary_folder() / "wheelwright_garbage.yaml";
  std::ostringstream out;
  std::ostringstream err;
  const auto status = tools::run_command_line(
      {"fit", (*folder / "counter_clockwise.csv").string(), "-o", model.string()}, {out, err});
  CHECK(status == tools::ExitStatus::bad_input);
  CHECK_THAT(err.str(), ContainsSubstring("counter_clockwise.csv:8: a command of 8.224 m/s"));
  CHECK_THAT(err.str(), ContainsSubstring("delete the row"));
  CHECK_FALSE(std::filesystem::exists(model));
}
