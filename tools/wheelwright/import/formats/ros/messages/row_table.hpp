// A table that grows by rows and, where a message brings a field that none before it had, by channels.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import::ros {

inline constexpr std::size_t max_channels = 1000;
inline constexpr std::size_t no_channel = static_cast<std::size_t>(-1);

// What the numbers of all tables of a recording may be, and how many they are.
struct NumberBudget {
  std::size_t most = 100'000'000;  // 0.8 GB
  std::size_t used = 0;
  bool is_spent() const { return used > most; }
};

class RowTable {
 public:
  explicit RowTable(NumberBudget& budget) : budget_(&budget) {}

  // The place of a new channel, which has not-a-number in the rows so far; no_channel beyond max_channels.
  std::size_t add_channel(std::string_view name);
  // Sets a value of the row that is being filled.
  void set(std::size_t channel, double value) {
    if (channel != no_channel) row_[channel] = value;
  }
  // Appends the row and begins another; what was not set is not a number.
  void commit_row(double received_s);
  void clear_row();
  // Takes the row that another table with the same channels has filled.
  void take_row(RowTable& other);

  // Counts memory of another kind as so many numbers.
  void charge(std::size_t numbers) { budget_->used += numbers; }

  std::size_t rows() const { return received_s_.size(); }
  std::size_t channels() const { return channels_.size(); }
  bool lacks_channels() const { return lacks_channels_; }
  // Puts rows in order of their time; true where they were not.
  bool sort_by_time();
  // Moves the rows and channels to a stream.
  void move_to(Stream& stream);

 private:
  NumberBudget* budget_;
  std::vector<double> received_s_;
  std::vector<Channel> channels_;
  std::vector<double> row_;
  bool lacks_channels_ = false;
};

}  // namespace wheelwright::import::ros
