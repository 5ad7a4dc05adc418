// Text from elsewhere (fields of a log, keys and values of a file, names, bytes of a serial line), made fit
// for a terminal, a journal or a page: it can neither move a cursor, nor change a colour, nor turn the
// direction of writing, nor start a line of its own.
//
// Letters of every script stay as they are. Control characters and bytes that are not UTF-8 come out as \x1b,
// the control characters beyond ASCII, line separators and marks of writing direction as \u202e. What is
// printable already does not change, so a text may pass more than once.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace wheelwright::config {

inline constexpr std::size_t longest_message = 4000;  // bytes

// In one line. What is longer than `longest` bytes ends in "...".
std::string printable(std::string_view text, std::size_t longest = longest_message);

// Line breaks and tabulators stay, and so does the length.
std::string printable_lines(std::string_view text);

bool is_utf8(std::string_view text);

// Bytes of the UTF-8 character that a text begins with; 0 where it begins with none.
std::size_t utf8_length(std::string_view text);

// As much of it as a message quotes.
std::string excerpt(std::string_view text);

// A JSON text with the same characters escaped as JSON has it, and other bytes than UTF-8 as U+FFFD. They
// occur in its strings only. Line breaks and tabulators between its values stay.
std::string printable_json(std::string_view json);

}  // namespace wheelwright::config
