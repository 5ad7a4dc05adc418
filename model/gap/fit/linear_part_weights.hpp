// Weights of commands in a linear part, and the parameters that stand for them.
#pragma once

#include <vector>

#include "model/gap/fit/trial_model.hpp"

namespace wheelwright::gap {

// Later by a part of a period, the gain being the same.
std::vector<double> delayed(const std::vector<double>& weights, double periods);

// Times 1 - pole z^-1.
std::vector<double> times_a_pole(const std::vector<double>& polynomial, double pole);

// Of the other wheel's command; as many as there are `own`, of the wheel's own command, or one more. `values`
// are the parameters behind those of the own weights.
std::vector<double> cross_coupling_weights(const LinearPartShape& shape, const std::vector<double>& own,
                                           const double* values);

// Adds these weights to a linear part, as parameters of that cross coupling, which is one by weights.
void add_cross_coupling_weights(std::vector<double>& linear_part, CrossCoupling cross_coupling,
                                const std::vector<double>& weights);

// Of two polynomials in z^-1.
std::vector<double> product(const std::vector<double>& one, const std::vector<double>& other);

// How travel answers, or turns (CrossCoupling::modes): weights B over past A = 1 - sum a_i z^-i.
struct Mode {
  std::vector<double> past;
  std::vector<double> weights;
};

// Of the parameters `values`: poles, then weights.
Mode mode_of(const LinearPartShape& shape, const double* values);

struct Modes {
  Mode travel;
  Mode turn;
};

// Of the parameters of one wheel: travel, then turns. Of CrossCoupling::balanced_modes the last weight of
// turns is what makes both gains equal.
Modes modes_of(const LinearPartShape& shape, const double* values);

// Adds their parameters to a linear part.
void add_modes(std::vector<double>& linear_part, const Modes& modes, CrossCoupling cross_coupling);

}  // namespace wheelwright::gap
