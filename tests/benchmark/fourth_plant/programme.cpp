#include "tests/benchmark/fourth_plant/programme.hpp"

#include <algorithm>
#include <array>

#include "tests/benchmark/fourth_plant/script.hpp"

namespace plants::fourth {

namespace {

void write_bent_stairs(Script& script, Random& random) {
  write_stairs(script, random, false);
}
void write_straight_stairs(Script& script, Random& random) {
  write_stairs(script, random, true);
}

struct Author {
  Programme programme;
  const char* name;
  void (*write)(Script& script, Random& random);
};

constexpr std::array authors{
    Author{Programme::random_steps, "random_steps", write_random_steps},
    Author{Programme::multi_sine, "multi_sine", write_multi_sine},
    Author{Programme::waypoints, "waypoints", write_waypoints},
    Author{Programme::laps, "laps", write_laps},
    Author{Programme::stairs, "stairs", write_bent_stairs},
    Author{Programme::straight_stairs, "straight_stairs", write_straight_stairs},
    Author{Programme::chirp, "chirp", write_chirp},
    Author{Programme::stop_and_go, "stop_and_go", write_stop_and_go},
    Author{Programme::spins, "spins", write_spins},
};

const Author& author_of(Programme programme) {
  return *std::ranges::find(authors, programme, &Author::programme);
}

}  // namespace

std::string name_of(Programme programme) {
  return author_of(programme).name;
}

std::vector<PerWheel<double>> make_commands(Programme programme, const DriveLimits& limits, double period_s,
                                            double duration_s, Random random) {
  constexpr double rest_s = 1.0;
  Script driven(limits, period_s, duration_s - 2.0 * rest_s);
  author_of(programme).write(driven, random);
  const auto rest_rows = static_cast<std::size_t>(rest_s / period_s);
  std::vector<PerWheel<double>> commands(rest_rows);
  for (const PerWheel<double>& command : driven.take()) commands.push_back(command);
  commands.insert(commands.end(), rest_rows, PerWheel<double>{});
  return commands;
}

}  // namespace plants::fourth
