#include "tools/wheelwright/import/conversion/own_rows.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright::import {

std::optional<std::vector<std::size_t>> rows_of_its_own(std::span<const double> wheel,
                                                        std::span<const std::vector<double>* const> others) {
  constexpr double most_of_own = 0.8;      // of all rows: beyond, those without a value have lost it
  constexpr double least_of_others = 0.8;  // of the rows without a value
  std::vector<std::size_t> rows;
  std::size_t of_others = 0;
  for (std::size_t i = 0; i < wheel.size(); ++i) {
    if (std::isfinite(wheel[i])) {
      rows.push_back(i);
    } else if (std::ranges::any_of(others, [i](const auto* values) { return std::isfinite((*values)[i]); })) {
      ++of_others;
    }
  }
  const auto all = static_cast<double>(wheel.size());
  const auto without = static_cast<double>(wheel.size() - rows.size());
  const bool are_own =
      rows.size() >= 2 &&
      static_cast<double>(rows.size())<most_of_own * all&& static_cast<double>(of_others)> least_of_others *
          without;
  return are_own ? std::optional(std::move(rows)) : std::nullopt;
}

std::vector<double> at_rows(std::span<const double> values, std::span<const std::size_t> rows) {
  std::vector<double> chosen;
  chosen.reserve(rows.size());
  for (const std::size_t row : rows) chosen.push_back(values[row]);
  return chosen;
}

std::vector<double> join_own_rows(std::span<const double> t_s, std::span<const double> values,
                                  std::span<const std::size_t> rows, Joining joining) {
  std::vector<double> at_all = at_rows(values, rows);
  if (std::ranges::all_of(at_all, [](double value) { return std::isfinite(value); })) return at_all;
  std::vector<double> own_t_s;
  std::vector<double> own;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i]) || !std::isfinite(t_s[i])) continue;
    own_t_s.push_back(t_s[i]);
    own.push_back(values[i]);
  }
  return join(own_t_s, own, at_rows(t_s, rows), joining);
}

}  // namespace wheelwright::import
