#include "config/load/cut_row.hpp"

#include <cstddef>

namespace wheelwright::config {
namespace {

constexpr std::string_view decimal_digits = "0123456789";

struct Figures {
  bool is_plain = false;  // digits with at most a sign and a point
  bool has_point = false;
  std::size_t before_point = 0;
  std::size_t behind_point = 0;
};

std::size_t count_digits(std::string_view text) {
  const auto end = text.find_first_not_of(decimal_digits);
  return end == std::string_view::npos ? text.size() : end;
}

Figures figures_of(std::string_view field) {
  Figures figures;
  if (!field.empty() && (field.front() == '-' || field.front() == '+')) field.remove_prefix(1);
  figures.before_point = count_digits(field);
  field.remove_prefix(figures.before_point);
  if (!field.empty() && field.front() == '.') {
    field.remove_prefix(1);
    figures.has_point = true;
    figures.behind_point = count_digits(field);
    field.remove_prefix(figures.behind_point);
  }
  figures.is_plain = field.empty();
  return figures;
}

}  // namespace

bool has_lost_figures(std::string_view last_field, std::string_view field_above) {
  const Figures last = figures_of(last_field);
  const Figures above = figures_of(field_above);
  if (last_field.empty() || !last.is_plain || !above.is_plain || last.behind_point > 0) return false;
  // A bare 0 below 0.2 is how some programs write a robot that stops.
  return last.before_point < above.before_point || (last.has_point && above.behind_point > 0);
}

}  // namespace wheelwright::config
