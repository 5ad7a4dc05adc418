#pragma once

#include <functional>
#include <vector>

#include "tests/benchmark/plants/pose.hpp"
#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/plants/wheels.hpp"

namespace plants::fourth {

// What every block of the diagram may look at in one step of the simulation.
struct Moment {
  double time_s = 0.0;
  double step_s = 0.0;
  double battery_v = 0.0;
  Pose pose;
  Random* random = nullptr;  // of this run; noise of the innocent robot has a stream of its own
};

// Of the body: forward and sideways speed and turn rate.
struct Twist {
  double forward_m_s = 0.0;
  double left_m_s = 0.0;
  double turn_rad_s = 0.0;
};

// Blocks may carry a state; a run works on copies, so that each starts afresh.
using Block = std::function<double(double input, const Moment& moment)>;
using PairBlock = std::function<PerWheel<double>(PerWheel<double> input, const Moment& moment)>;
using BodyBlock = std::function<Twist(Twist input, const Moment& moment)>;

using Chain = std::vector<Block>;

inline double through(Chain& chain, double value, const Moment& moment) {
  for (Block& block : chain) value = block(value, moment);
  return value;
}

// The same imperfection in both wheels, each with its own state.
inline void add_to_both(PerWheel<Chain>& chains, const Block& block) {
  for (Chain& chain : chains) chain.push_back(block);
}

}  // namespace plants::fourth
