// How far series swing with a given period, in a phase that need not last.
#pragma once

#include <cstddef>
#include <span>

namespace wheelwright::gap {

// Of the sine with the period that is found by least squares beside a line in each four periods by
// themselves. From each figure is taken what the neighbourhood has without a swing: the geometric mean of
// that at half the frequency and at one and a half of it, where a sine of the period has no part.
class SwingAmplitude {
 public:
  explicit SwingAmplitude(double period) : period_(period) {}

  // `at` holds where each value stands, in the unit of the period. What spans less than four periods is left
  // out.
  void add(std::span<const double> values, std::span<const double> at);

  // Where it swings most: the root of the mean of squares, each weighted by itself. A swing that is struck
  // now and then, and dies away, has the size that a plot shows. 0 where there is none.
  double amplitude() const;
  // Mean of the squared amplitude over all, with no weights.
  double mean_square() const;

  // The four periods in which it swings most: of the series that was added so many others before, the values
  // in [from, to).
  struct Window {
    std::size_t series = 0;
    std::size_t from = 0;
    std::size_t to = 0;
  };
  const Window& strongest() const { return strongest_; }

 private:
  struct Sums {
    double count = 0.0;
    double squares = 0.0;          // of the amplitude
    double squared_squares = 0.0;  // of the amplitude to the fourth
    void add(double squared);
    double mean() const { return count > 0.0 ? squares / count : 0.0; }
    double weighted_mean() const { return squares > 0.0 ? squared_squares / squares : 0.0; }
  };

  double period_;
  std::size_t series_ = 0;
  Window strongest_;
  double strongest_squared_ = 0.0;
  Sums swing_;
  Sums below_;
  Sums above_;
};

}  // namespace wheelwright::gap
