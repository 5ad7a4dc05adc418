// Writes the cases of the second plant.
#include "tests/benchmark/plants/exam.hpp"
#include "tests/benchmark/second_plant/case_list.hpp"
#include "tests/benchmark/second_plant/run.hpp"

namespace plants::second {

namespace {

std::vector<Run> drive(const Case& item, const RobotSpec& robot) {
  const Random random(item.seed);
  const ProgrammeLimits limits{robot.period_s, item.duration_s, robot.fastest_m_s, robot.body.nominal_track_m,
                               1.2};
  std::vector<Run> runs;
  for (int index = 0; index < runs_of_a_case; ++index) {
    const Random stream = random.child(static_cast<std::uint64_t>(index));
    const auto programme = random_programme(item.style, limits, stream.child(0));
    runs.push_back(drive_run(robot, item.sensors, programme, index, item.keep_heading, stream));
  }
  return runs;
}

ExamCase exam_case(const Case& item) {
  ExamCase made;
  made.name = item.name;
  made.kind = item.kind;
  for (const std::string& effect : item.hidden) made.hidden.push_back({effect, item.note, ""});
  made.size = item.size;
  made.sensing = item.sensing;
  made.sensors = item.sensors;
  made.programme = "mixed";
  made.seed = item.seed;
  made.drive = [item] { return drive(item, item.robot); };
  made.drive_innocent = [item](const std::vector<Run>&) { return drive(item, item.innocent); };
  return made;
}

std::vector<ExamCase> exam_cases(std::uint64_t seed) {
  std::vector<ExamCase> cases;
  for (const Case& item : make_cases(seed)) cases.push_back(exam_case(item));
  return cases;
}

}  // namespace

}  // namespace plants::second

int main(int argc, char** argv) {
  return plants::run_exam({"second_plant", "Writes drive logs of a second robot in which effects are hidden.",
                           plants::second::exam_cases},
                          argc, argv);
}
