// Rows such as "1,5": two columns, or one number with a decimal comma? Decided from the whole sample, never
// in silence.
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/import/formats/text/dialect_sniffer.hpp"
#include "tools/wheelwright/import/formats/text/text_sample.hpp"

namespace wheelwright::import {

enum class CommaMeaning { separator, decimal, both };

struct CommaVerdict {
  CommaMeaning meaning = CommaMeaning::separator;
  std::string text;  // a remark, or for `both` why the file is refused; empty where nothing is in doubt
};

// `header`: the names above rows that were parted at commas; empty without them.
CommaVerdict judge_comma(const TextSample& sample, const Dialect& dialect,
                         const std::vector<std::string>& header);

// The table as one column of numbers with decimal commas.
SniffedTable as_single_decimal_column(SniffedTable table);

}  // namespace wheelwright::import
