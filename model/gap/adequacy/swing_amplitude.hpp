// How far series swing with a given period, in a phase that need not last.
#pragma once

#include <cstddef>
#include <span>

namespace wheelwright::gap {

// Of the sine with the period that is found by least squares beside a line in each four periods by
// themselves. From each figure is taken what the neighbourhood has without a swing: the geometric mean of
// that at three and at five quarters of the frequency, where a sine of the period has next to no part.
class SwingAmplitude {
 public:
  // In the unit of `at` below, and positive.
  explicit SwingAmplitude(double period) : period_(period) {}

  // `at` holds where each value stands, and may go to and fro. `breaks` is 1 where a value has nothing to do
  // with the one before; empty: nowhere. A part without a break that covers less than four periods is left
  // out, and so are four periods of too few readings to hold a sine.
  void add(std::span<const double> values, std::span<const double> at, std::span<const char> breaks = {});

  // Where it swings most: the root of the mean of squares, each weighted by itself. A swing that is struck
  // now and then, and dies away, has the size that a plot shows. 0 where there is none.
  double amplitude() const;
  // Mean of the squared amplitude over all, with no weights.
  double mean_square() const;

  // The four periods in which it swings most: of the series that was added after so many others, the values
  // in [from, to). Empty where nothing was measured.
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

  void add_part(std::span<const double> values, std::span<const double> at, std::size_t offset);
  void add_window(std::span<const double> values, std::span<const double> at, const Window& window);

  double period_;
  std::size_t series_ = 0;
  Window strongest_;
  double strongest_squared_ = 0.0;
  Sums swing_;
  Sums below_;
  Sums above_;
};

}  // namespace wheelwright::gap
