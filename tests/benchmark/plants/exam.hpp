// An exam: cases of a robot in which something is hidden, written as drive logs in folders that do not tell,
// with the answers sealed as gap_cases does.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/benchmark/plants/run.hpp"
#include "tests/benchmark/plants/sensors.hpp"

namespace plants {

inline constexpr int runs_of_a_case = 5;

struct HiddenEffect {
  std::string name;
  std::string how;         // the physics of it
  std::string confusable;  // effects, apart by spaces, that ordinary logs cannot tell from it
};

enum class CaseKind { effects, clean, cannot_tell, outside };

struct ExamCase {
  std::string name;  // for --matching
  CaseKind kind = CaseKind::effects;
  std::vector<HiddenEffect> hidden;
  std::string size;
  Sensing sensing = Sensing::ticks;
  SensorSet sensors;
  std::string programme;  // how it is driven, in a word
  std::uint64_t seed = 0;
  std::function<std::vector<Run>()> drive;
  // The same drives by the robot without what is hidden.
  std::function<std::vector<Run>(const std::vector<Run>& driven)> drive_innocent;
};

struct Exam {
  const char* program = "";
  const char* description = "";
  std::vector<ExamCase> (*make_cases)(std::uint64_t seed) = nullptr;
};

// As in s1.020.coulomb_friction.small.ticks; an empty size is left out.
std::string case_name(std::uint64_t seed, std::size_t index, const std::string& subject,
                      const std::string& size, Sensing sensing);

// The program of an exam; returns its exit status.
int run_exam(const Exam& exam, int argc, char** argv);

}  // namespace plants
