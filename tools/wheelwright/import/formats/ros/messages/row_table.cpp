#include "tools/wheelwright/import/formats/ros/messages/row_table.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "config/load/printable_text.hpp"

namespace wheelwright::import::ros {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t longest_name = 200;

void reorder(std::vector<double>& values, const std::vector<std::size_t>& order) {
  std::vector<double> sorted(values.size());
  std::ranges::transform(order, sorted.begin(), [&](std::size_t from) { return values[from]; });
  values = std::move(sorted);
}

}  // namespace

std::size_t RowTable::add_channel(std::string_view name) {
  if (channels_.size() >= max_channels) {
    lacks_channels_ = true;
    return no_channel;
  }
  budget_->used += rows() + sizeof(Channel) / sizeof(double);
  if (budget_->is_spent()) return no_channel;
  channels_.push_back({config::printable(name, longest_name), "", std::vector<double>(rows(), missing)});
  row_.push_back(missing);
  return channels_.size() - 1;
}

void RowTable::commit_row(double received_s) {
  budget_->used += 1 + channels_.size();
  if (budget_->is_spent()) return;
  received_s_.push_back(received_s);
  for (std::size_t i = 0; i < channels_.size(); ++i) channels_[i].values.push_back(row_[i]);
  clear_row();
}

void RowTable::clear_row() {
  std::ranges::fill(row_, missing);
}

void RowTable::take_row(RowTable& other) {
  for (std::size_t i = channels_.size(); i < other.channels_.size(); ++i)
    add_channel(other.channels_[i].name);
  std::copy_n(other.row_.begin(), std::min(row_.size(), other.row_.size()), row_.begin());
  other.clear_row();
}

bool RowTable::sort_by_time() {
  if (std::ranges::is_sorted(received_s_)) return false;
  std::vector<std::size_t> order(received_s_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t row) { return received_s_[row]; });
  reorder(received_s_, order);
  for (Channel& channel : channels_) reorder(channel.values, order);
  return true;
}

void RowTable::move_to(Stream& stream) {
  stream.rows = rows();
  stream.received_s = std::move(received_s_);
  stream.channels = std::move(channels_);
}

}  // namespace wheelwright::import::ros
