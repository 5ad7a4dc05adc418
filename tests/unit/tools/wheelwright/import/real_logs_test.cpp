// One drive in the forms of others: ../shared/data/logs.
#include <cmath>
#include <map>

#include "config/load/drive_log_file.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/shared_data.hpp"
#include "tools/wheelwright/import/import_files.hpp"

using namespace wheelwright;
using namespace wheelwright::import;

namespace {

tl::expected<Conversion, std::string> import_log(const std::filesystem::path& file,
                                                 const std::vector<std::string>& settings = {}) {
  const auto understood = understand({{file}, std::nullopt, GivenMapping("", settings)});
  if (!understood) return tl::unexpected(understood.error());
  return to_runs(*understood);
}

}  // namespace

TEST_CASE("One drive in every dialect is the same drive") {
  const auto folder = test::shared_data("logs");
  if (!folder) return;
  const DriveLog base = config::load_drive_log(*folder / "00_base.csv");
  for (const char* name : {"00_base",
                           "01_bom",
                           "02_crlf",
                           "03_cr_only",
                           "04_semicolon",
                           "05_semicolon_decimal_comma",
                           "06_tab",
                           "08_quoted_header",
                           "09_quoted_cells",
                           "10_no_header",
                           "11_hash_header",
                           "12_epoch_seconds",
                           "14_ms_no_period",
                           "14b_ms_with_period",
                           "16_same_stamp_twice",
                           "17_two_rows_swapped_below_1s",
                           "20_log_on_change",
                           "25_theta_degrees",
                           "27_upper_case_names",
                           "30_header_repeated",
                           "33_bunched_stamps"}) {
    INFO(name);
    const auto conversion = import_log(*folder / (std::string(name) + ".csv"));
    if (!conversion) FAIL(conversion.error());
    REQUIRE(conversion->runs.size() == 1);
    const DriveLog& log = conversion->runs.front();
    REQUIRE(log.samples.size() == base.samples.size());
    CHECK_THAT(log.period_s, WithinAbs(base.period_s, 1e-4));
    CHECK_THAT(log.metres_per_tick->left, WithinRel(base.metres_per_tick->left, 0.02));
    std::size_t differ = 0;
    for (std::size_t k = 0; k < base.samples.size(); ++k) {
      const auto& is = log.samples[k];
      const auto& was = base.samples[k];
      const bool same = is.ticks && is.ticks->left == was.ticks->left &&
                        is.ticks->right == was.ticks->right &&
                        std::abs(is.command_m_s.left - was.command_m_s.left) < 1e-6 &&
                        std::abs(is.t_s - was.t_s) < 0.04 && is.reference_x_m == was.reference_x_m;
      if (!same) ++differ;
    }
    CHECK(differ == 0);
  }
}

TEST_CASE("Faults of a log are put right where they can be, and said") {
  const auto folder = test::shared_data("logs");
  if (!folder) return;
  const std::map<std::string, std::string> said{{"16_same_stamp_twice", "line 309"},
                                                {"17_two_rows_swapped_below_1s", "line 19: out of order"},
                                                {"18_clock_set_back_3s", "line 608: the clock goes back"},
                                                {"21_int16_wrapped", "16 bits wraps"},
                                                {"30_header_repeated", "header row once more"},
                                                {"33_bunched_stamps", "bunches"},
                                                {"48_log_cut_in_last_row", "line 1207"}};
  for (const auto& [name, words] : said) {
    INFO(name);
    const auto conversion = import_log(*folder / (name + ".csv"));
    if (!conversion) FAIL(conversion.error());
    std::string all;
    for (const auto& remark : conversion->remarks) all += remark + "\n";
    CHECK_THAT(all, ContainsSubstring(words));
  }
}

TEST_CASE("What a log does not say is asked for by its option") {
  const auto folder = test::shared_data("logs");
  if (!folder) return;
  CHECK_THAT(import_log(*folder / "40_no_commands.csv").error(), ContainsSubstring("--set command.left="));
  CHECK_THAT(import_log(*folder / "41_no_metadata.csv").error(),
             ContainsSubstring("--set robot.wheel_base_m="));
}

TEST_CASE("A Pioneer whose counters wrap went 1.15 m forward and once around") {
  const auto folder = test::shared_data("robots/pioneer-kamilgos");
  if (!folder) return;
  const std::vector<std::string> known{"robot.wheel_base_m=0.33", "wheels.metres_per_count=7.9975e-6",
                                       "command.left=velL", "command.right=velR", "command.unit=mm/s"};
  const auto travel = [&](const char* name) {
    const auto conversion = import_log(*folder / name, known);
    if (!conversion) FAIL(conversion.error());
    const DriveLog& log = conversion->runs.front();
    const auto& first = *log.samples.front().ticks;
    const auto& last = *log.samples.back().ticks;
    return WheelPair{7.9975e-6 * static_cast<double>(last.left - first.left),
                     7.9975e-6 * static_cast<double>(last.right - first.right)};
  };
  const WheelPair forward = travel("forward.csv");
  CHECK_THAT(0.5 * (forward.left + forward.right), WithinAbs(1.15, 0.03));
  const WheelPair turn = travel("left_full_turn.csv");
  CHECK(turn.left < 0.0);
  CHECK(turn.right > 0.0);
}

TEST_CASE("A TurtleBot's bag gives its counts, its commands and the size of a count") {
  const auto folder = test::shared_data("robots/turtlebot3-rob521");
  if (!folder) return;
  const auto conversion = import_log(*folder / "sample_data.bag", {"robot.wheel_base_m=0.287"});
  if (!conversion) FAIL(conversion.error());
  REQUIRE(conversion->runs.size() == 1);
  const DriveLog& log = conversion->runs.front();
  CHECK(log.samples.size() == 614);
  CHECK(log.samples.back().ticks->left == 31795);
  CHECK_THAT(log.metres_per_tick->left, WithinRel(2.0 * 3.14159265 * 0.033 / 4096.0, 0.02));
}

TEST_CASE("The battery of a real motor, in mV and nearly constant, is no command about a neutral") {
  const auto folder = test::shared_data("robots");
  if (!folder) return;
  const auto understood =
      understand({{*folder / "ev3-itmo" / "lab2_lab2.4.csv"}, std::nullopt, GivenMapping()});
  if (!understood) FAIL(understood.error());
  const Mapping& mapping = understood->mapping;
  REQUIRE(mapping.command);
  REQUIRE(mapping.wheels);
  CHECK(mapping.command->first.channel != "4");
  CHECK(mapping.command->kind != CommandKind::twist);
  CHECK_FALSE(mapping.wheels->right);
}
