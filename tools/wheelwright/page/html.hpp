// Pieces of a self-contained page.
#pragma once

#include <string>
#include <vector>

namespace wheelwright::tools::html {

// Text with the characters that HTML takes for its own replaced.
std::string escaped(const std::string& text);

// <tag>text</tag>, the text escaped.
std::string element(const std::string& tag, const std::string& text);

// A table with a header row; cells are escaped, and numbers (and dashes) set to the right. Empty without
// rows.
std::string table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows);

// A whole page around a body, light or dark as its reader prefers.
std::string page(const std::string& title, const std::string& body);

}  // namespace wheelwright::tools::html
