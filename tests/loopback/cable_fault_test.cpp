// A cable on which one fault follows the other, between the real daemon and the simulated robot, and an
// operator who arms the robot again when it has been stopped. tests/soak/run runs the long form.
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tests/loopback/bench/bench.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::bench;

namespace {

constexpr double blind_limit_s = 0.25;
constexpr double braking_s = 0.8;  // the longest way to rest, and the truth's and the fault log's resolution

struct WallSoak {
  int faults = 0;
  int hit = 0;             // faults that bytes were hit by
  int blinding = 0;        // that kept the robot's replies away for longer than the blind limit and braking
  int never_rested = 0;    // of these, with the wheels still turning
  int could_not_hear = 0;  // of these, because the stop could not reach the robot; it rests after the return
  int answered = 0;
  int answered_within_1_s = 0;
  double longest_answer_s = 0.0;
  int armings = 0;
  int batteries_out = 0;
  double memory_early_mb = 0.0;
  double memory_late_mb = 0.0;
  Replies replies;
};

std::size_t rows_in(const std::filesystem::path& log) {
  std::ifstream file(log);
  std::size_t rows = 0;
  for (std::string line; std::getline(file, line);) rows += !line.empty() && line.front() != '#' ? 1U : 0U;
  return rows == 0 ? 0 : rows - 1;  // without the header
}

// Where `text` was said last; -1 where it was not.
long last(const std::string& said, const char* text) {
  return static_cast<long>(said.rfind(text));
}

bool answers(const std::string& said) {
  return last(said, "the robot answers") > last(said, "does not answer any more");
}

bool run_is_over(const std::string& said) {
  return std::max(last(said, "stopped at "), last(said, "finished")) > last(said, "armed: the robot obeys");
}

// Arms the robot again when its run is over. Damaged bytes can send a robot to sleep, or make it talk at
// another speed: then no byte helps, and the battery is taken out and put in again.
class Operator {
 public:
  Operator(const ChildProcess& daemon, const ChildProcess& robot) : daemon_(daemon), robot_(robot) {}

  void look() {
    const std::string said = daemon_.err();
    const auto now = std::chrono::steady_clock::now();
    if (answers(said)) last_answer_ = now;
    if (answers(said) && run_is_over(said) && now - last_armed_ > 500ms) {
      daemon_.signal(SIGUSR1);
      last_armed_ = now;
      ++armings;
    }
    if (now - last_answer_ > 6s) {
      robot_.signal(SIGUSR1);
      std::this_thread::sleep_for(200ms);
      robot_.signal(SIGUSR1);
      last_answer_ = now;
      ++batteries_out;
    }
  }

  int armings = 0;
  int batteries_out = 0;

 private:
  const ChildProcess& daemon_;
  const ChildProcess& robot_;
  std::chrono::steady_clock::time_point last_answer_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_armed_;
};

double speed_at(const Table& truth, double unix_s) {
  const double t = unix_s - 1e-3 * std::stod(truth.metadata("started_unix_ms"));
  const double row = t / std::stod(truth.metadata("period_s"));
  if (row < 0.0 || row >= static_cast<double>(truth.rows())) return 0.0;
  const auto at = static_cast<std::size_t>(row);
  return std::max(std::abs(truth.number(at, "speed_left")), std::abs(truth.number(at, "speed_right")));
}

bool rests_between(const Table& truth, double from_s, double to_s) {
  for (double t = from_s; t < to_s; t += 0.01) {
    if (speed_at(truth, t) < 0.005) return true;
  }
  return false;
}

void judge_faults(WallSoak& soak, const Table& faults, const Table& truth) {
  for (std::size_t row = 0; row < faults.rows(); ++row) {
    ++soak.faults;
    soak.hit += faults.number(row, "bytes_hit") + faults.number(row, "bytes_added") > 0.0 ? 1 : 0;
    if (!faults.empty(row, "answered_after_s")) {
      const double answer_s = faults.number(row, "answered_after_s");
      ++soak.answered;
      soak.answered_within_1_s += answer_s <= 1.0 ? 1 : 0;
      soak.longest_answer_s = std::max(soak.longest_answer_s, answer_s);
    }
    const std::string& kind = faults.word(row, "kind");
    const double from_s = faults.number(row, "from_unix_s");
    const double until_s = faults.number(row, "until_unix_s");
    const bool blinding =
        (kind == "freeze" || kind == "disconnect") && until_s - from_s > blind_limit_s + braking_s + 0.05;
    if (!blinding) continue;
    ++soak.blinding;
    const bool moves = speed_at(truth, from_s + blind_limit_s + braking_s + 0.05) > 0.005;
    if (faults.number(row, "to_robot") != 0.0) {
      soak.could_not_hear += moves ? 1 : 0;
      // The stop is said again as soon as the port is open again; soon after, the robot may be armed again.
      soak.never_rested += moves && !rests_between(truth, until_s, until_s + 1.0 + braking_s) ? 1 : 0;
    } else {
      soak.never_rested += moves ? 1 : 0;
    }
  }
}

WallSoak run_soak(int faults, int seed) {
  Bench bench;
  // On an endless floor: a robot that has reached a wall stands still however often it is armed.
  const std::string floor = std::string(WHEELWRIGHT_SOURCE_DIR) + "/config/robots/rooms/empty.yaml";
  const auto robot = bench.start_robot("default", "", {"--room", floor});
  const auto fault_log = bench.folder() / "faults.csv";
  ChildProcess cable(
      {SERIAL_FAULTS, "--robot", bench.device().string(), "--link", (bench.folder() / "faulty").string(),
       "--seed", std::to_string(seed), "--faults", std::to_string(faults), "--first", "5", "--shortest-pause",
       "2.2", "--longest-pause", "2.8", "--log", fault_log.string()},
      bench.folder() / "cable_said", Scheduling::like_hardware);
  REQUIRE(eventually(5s, [&] { return std::filesystem::is_symlink(bench.folder() / "faulty"); }));
  const auto daemon =
      bench.start_daemon(bench.configure({.device = "faulty", .run = "at_end: stay", .route = "[[3, 0]]"}));
  REQUIRE(daemon->says("the robot answers", 10s));

  WallSoak soak;
  Operator person(*daemon, *robot);
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20 + 6 * faults);
  std::size_t known = 0;
  while (known < static_cast<std::size_t>(faults) && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(200ms);
    known = rows_in(fault_log);
    if (soak.memory_early_mb == 0.0 && known * 5 >= static_cast<std::size_t>(faults)) {
      soak.memory_early_mb = daemon->resident_mb();
    }
    person.look();
  }
  std::this_thread::sleep_for(1500ms);
  soak.memory_late_mb = daemon->resident_mb();
  soak.armings = person.armings;
  soak.batteries_out = person.batteries_out;
  INFO(daemon->err());
  CHECK(daemon->end() < 2);  // 1 where the last run was stopped
  soak.replies = replies_of(daemon->out());
  robot->end();
  cable.wait(5s);  // its robot is gone
  judge_faults(soak, Table::load(fault_log), bench.truth());
  return soak;
}

std::string to_text(const WallSoak& soak) {
  std::array<char, 800> text{};
  const Replies& replies = soak.replies;
  std::snprintf(
      text.data(), text.size(),
      "%d faults on the wall clock, %d hit bytes; armed again %d times, battery out and in %d times\n"
      "  replies: %d asked, %d sound, %d missing, %d incomplete, %d garbled\n"
      "  blind for long: %d; could not hear the stop: %d; wheels not at rest: %d\n"
      "  heard again after %d faults, %d of them within 1 s, longest %.2f s\n"
      "  memory: %.1f MB after a fifth, %.1f MB at the end\n",
      soak.faults, soak.hit, soak.armings, soak.batteries_out, replies.asked, replies.sound, replies.missing,
      replies.incomplete, replies.garbled, soak.blinding, soak.could_not_hear, soak.never_rested,
      soak.answered, soak.answered_within_1_s, soak.longest_answer_s, soak.memory_early_mb,
      soak.memory_late_mb);
  return text.data();
}

void check(const WallSoak& soak) {
  INFO(to_text(soak));
  const Replies& replies = soak.replies;
  const int bad = replies.missing + replies.incomplete + replies.garbled;
  CHECK(replies.asked - replies.sound - bad >= 0);
  CHECK(replies.asked - replies.sound - bad <= 1);
  CHECK(soak.never_rested == 0);
  CHECK(soak.memory_late_mb - soak.memory_early_mb < 3.0);
}

int number_from(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::atoi(text);
}

}  // namespace

TEST_CASE("The daemon survives a cable on which one fault follows the other") {
  const WallSoak soak = run_soak(7, 3);
  check(soak);
  CHECK(soak.faults == 7);
  CHECK(soak.hit >= 5);
}

TEST_CASE("The daemon survives some hundreds of faults", "[.soak]") {
  const WallSoak soak = run_soak(number_from("SOAK_FAULTS", 200), number_from("SOAK_SEED", 1));
  std::fputs(to_text(soak).c_str(), stdout);
  check(soak);
}
