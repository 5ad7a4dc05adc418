// Writes the cases of the fourth plant.
#include "tests/benchmark/fourth_plant/case_list.hpp"

int main(int argc, char** argv) {
  const plants::Exam exam{"fourth_plant", "Writes drive logs of a fourth robot in which effects are hidden.",
                          plants::fourth::make_cases};
  return plants::run_exam(exam, argc, argv);
}
