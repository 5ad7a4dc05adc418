// A table of a text file as streams: dates joined with the time beside them, rows parted by the label of
// their kind, columns that only count the rows left out.
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/import/formats/text/text_table.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// `name` is given to the stream, or stands before the labels; empty where the file has one table.
std::vector<Stream> make_streams(TextTable table, const std::string& name, std::vector<std::string>& remarks);

}  // namespace wheelwright::import
