// The last row of a file that lost its end: to a power cut, a full disk, a copy that was broken off.
#pragma once

#include <string_view>

namespace wheelwright::config {

// What a reader says of such a row.
inline constexpr std::string_view cut_row_text =
    "the last row is cut short, without a line break at its end; delete it";

// Whether the last field of a row that ends without a line break has lost figures that matter: some before
// the decimal point, or all behind it, where the row above has them. Many programs write no line break at the
// end of a file; where only the last decimals may be gone, the row is taken as it is.
bool has_lost_figures(std::string_view last_field, std::string_view field_above);

}  // namespace wheelwright::config
