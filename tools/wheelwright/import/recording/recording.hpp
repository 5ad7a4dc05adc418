// What a foreign file holds, before anybody says what it means: streams of numbers with the names and units
// that the file gives them. Every reader of a format makes one of these, and knows nothing of robots.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

namespace wheelwright::import {

// In a row that has no value.
inline constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// One column of a table, one field of a message, one vector of a MATLAB file.
struct Channel {
  std::string name;  // as in the file: "posL", "twist.linear.x", "position[wheel_left]"; "3" where the
                     // file has no names (the third column)
  std::string unit;  // as the file states it ("ms" of "t [ms]"), or of a time that was text: "hms" (seconds
                     // since midnight), "iso" (seconds since 1970); empty where the file says nothing
  std::vector<double> values;  // one per row of the stream; not-a-number where nothing stands there
};

// Rows that were written together: the table of a text file, a topic of a bag, the vectors of a MATLAB file
// that are equally long.
struct Stream {
  std::string name;      // the topic, or the label of rows of a kind; empty where the file has one table
  std::string type;      // of its messages: "geometry_msgs/Twist"; empty where there are none
  std::size_t rows = 0;  // messages or lines, also where they could not be decoded
  std::vector<double> received_s;  // when each row was recorded, seconds since 1970; empty where the file has
                                   // no time beside the channels
  std::vector<Channel> channels;   // empty where the rows could not be decoded
  std::vector<std::size_t> places;  // line of each row in a text file, for messages; empty elsewhere
  std::vector<std::size_t>
      run_starts;           // rows at which a run begins for sure; empty where the file does not say
  std::string not_decoded;  // why there are no channels, in one line; empty where there are

  const Channel* find(std::string_view channel) const;
};

struct Recording {
  std::string name;  // of the file or folder, for messages
  std::string
      format;  // in words: "CSV: ';' between fields, decimal comma, no header row", "ROS 2 bag (MCAP, zstd)"
  std::vector<std::pair<std::string, std::string>>
      metadata;  // "# key: value" lines above a table, and their like
  std::vector<Stream> streams;
  // What the reader met and how it read on, one line each, with the line or the offset: "line 301: the header
  // row once more, left out", "cut short after 812 messages: the rest cannot be read".
  std::vector<std::string> remarks;

  const Stream* find(std::string_view stream) const;
};

// A recording, or one line that names the file, what is wrong with it, where, and what would be right.
using ReadResult = tl::expected<Recording, std::string>;

}  // namespace wheelwright::import
