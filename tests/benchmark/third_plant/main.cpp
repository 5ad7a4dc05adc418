// Writes the cases of the third plant.
#include "tests/benchmark/plants/exam.hpp"
#include "tests/benchmark/third_plant/case_drive.hpp"
#include "tests/benchmark/third_plant/case_list.hpp"

namespace plants::third {

namespace {

ExamCase exam_case(const Case& item, const std::string& name) {
  ExamCase made;
  made.name = name;
  made.kind = item.kind;
  made.hidden = item.hidden;
  made.size = item.size;
  made.sensing = item.sensing;
  made.sensors = item.sensors;
  made.programme = name_of(item.style);
  made.seed = item.seed;
  made.drive = [item] { return drive(item); };
  made.drive_innocent = [item](const std::vector<Run>& driven) { return drive_innocent(item, driven); };
  return made;
}

std::vector<ExamCase> exam_cases(std::uint64_t seed) {
  const std::vector<Case> cases = make_cases(seed);
  std::vector<ExamCase> made;
  for (std::size_t index = 0; index < cases.size(); ++index) {
    const Case& item = cases[index];
    made.push_back(exam_case(item, case_name(seed, index, item.subject, item.size, item.sensing)));
  }
  return made;
}

}  // namespace

}  // namespace plants::third

int main(int argc, char** argv) {
  return plants::run_exam({"third_plant", "Writes drive logs of a third robot in which effects are hidden.",
                           plants::third::exam_cases},
                          argc, argv);
}
