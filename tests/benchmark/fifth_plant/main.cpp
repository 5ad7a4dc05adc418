// Writes the cases of the fifth plant.
#include "tests/benchmark/fifth_plant/case_list.hpp"

int main(int argc, char** argv) {
  const plants::Exam exam{"fifth_plant",
                          "Writes drive logs of a delivery platform in which effects are hidden.",
                          plants::fifth::make_cases};
  return plants::run_exam(exam, argc, argv);
}
