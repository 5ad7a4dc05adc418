// A counter of few bits that goes more than half around between rows: what it shows fits several travels, of
// which the command says which.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace wheelwright::import {

// How the counts of a row are predicted from the command.
struct CounterPrediction {
  double counts_per_travel = 0.0;  // of what is commanded: command times duration
  std::size_t lag = 0;             // rows by which the wheel is behind
  double smoothing = 0.0;          // share of its speed that it keeps in a row
  double agreement = 0.0;          // 0 to 1: all steps modulo 2^bits are as predicted
  double next_agreement = 0.0;     // of the best prediction that is another one
  bool is_sure() const { return agreement > 0.8 && agreement > next_agreement + 0.15; }
};

// Whether counts of whole numbers fill a range of 2^bits while their steps do too, so that jumps do not tell
// which way the counter went.
bool is_fast_counter(std::span<const double> counts, int bits);

// `travel`: what is commanded for each row over the time since the row before; both have a value in each row,
// or not-a-number. `counts_per_travel`: where the scale is known.
CounterPrediction predict_counter(std::span<const double> counts, std::span<const double> travel, int bits,
                                  std::optional<double> counts_per_travel);

// Takes for each step, of those that the counter may have made, the one nearest to the prediction.
void unwrap_by_prediction(std::span<double> counts, std::span<const double> travel, int bits,
                          const CounterPrediction& prediction);

}  // namespace wheelwright::import
