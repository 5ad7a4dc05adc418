// Formats that no reader knows, but that can be told by their first bytes, so that a refusal says what a file
// is and what to do with it.
#pragma once

#include <string>
#include <string_view>

namespace wheelwright::import {

// "a gzip archive; decompress it (gunzip)"; empty where the bytes are not known.
std::string describe_unread_format(std::string_view head);

}  // namespace wheelwright::import
