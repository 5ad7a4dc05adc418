#include "tools/wheelwright/page/html.hpp"

#include "config/load/printable_text.hpp"

namespace wheelwright::tools::html {
namespace {

constexpr const char* style = R"(
:root { color-scheme: light dark; --text: #1d2330; --quiet: #5c6575; --line: #d9dde5; --page: #fdfdfc;
        --before: #c8553d; --after: #22807a; --third: #7a5bb8; --time: #9aa3b2; }
@media (prefers-color-scheme: dark) {
  :root { --text: #e4e7ec; --quiet: #98a1b0; --line: #353c48; --page: #15181e;
          --before: #e98168; --after: #4fc0b3; --third: #b59be8; --time: #6a7383; } }
body { margin: 2rem auto; max-width: 60rem; padding: 0 1rem; background: var(--page); color: var(--text);
       font: 16px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.25; margin-bottom: .2rem; overflow-wrap: anywhere; }
h2 { font-size: 1.2rem; margin: 2.2rem 0 .4rem; }
h3 { font-size: 1rem; margin: 1.4rem 0 .3rem; }
p { margin: .4rem 0; } .quiet, figcaption { color: var(--quiet); font-size: .9rem; }
.verdict { font-size: 1.15rem; }
table { border-collapse: collapse; margin: .6rem 0; font-size: .9rem; display: block; overflow-x: auto; }
th, td { padding: .25rem .8rem .25rem 0; border-bottom: 1px solid var(--line); text-align: left;
         vertical-align: top; }
th { color: var(--quiet); font-weight: 600; }
td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.figures { display: grid; grid-template-columns: 1fr 1fr; gap: 1.2rem 1.5rem; margin: 1rem 0; }
figure { margin: 0; grid-column: 1 / -1; min-width: 0; } figure.half { grid-column: auto; }
.picture { overflow-x: auto; } .picture svg { display: block; width: 100%; height: auto; color: var(--text); }
@media (max-width: 44rem) {
  .figures { grid-template-columns: 1fr; }
  figure:not(.half) .picture svg { min-width: 36rem; } }
.bars { display: grid; grid-template-columns: minmax(10rem, max-content) 1fr; gap: .3rem 1rem; font-size: .9rem; }
.bar { height: .65rem; border-radius: 2px; min-width: 2px; display: inline-block; vertical-align: middle; }
.gap { background: var(--before); } .time { background: var(--time); }
details { margin: .4rem 0; } summary { cursor: pointer; }
)";

bool is_number(const std::string& cell) {
  if (cell.empty()) return false;
  return cell == "-" || cell.find_first_not_of("0123456789.-+[], e%\u00b1") == std::string::npos;
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string result;
  for (const char character : config::printable_lines(text)) {
    switch (character) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += character;
    }
  }
  return result;
}

std::string element(const std::string& tag, const std::string& text) {
  return "<" + tag + ">" + escaped(text) + "</" + tag + ">\n";
}

std::string table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows) {
  if (rows.empty()) return "";
  std::string text = "<table><tr>";
  for (const auto& cell : header) text += "<th>" + escaped(cell) + "</th>";
  text += "</tr>\n";
  for (const auto& row : rows) {
    text += "<tr>";
    for (const auto& cell : row) {
      text += (is_number(cell) ? "<td class=\"number\">" : "<td>") + escaped(cell) + "</td>";
    }
    text += "</tr>\n";
  }
  return text + "</table>\n";
}

std::string page(const std::string& title, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<meta name=\"generator\" "
         "content=\"wheelwright\">\n<title>" +
         escaped(title) + "</title>\n<style>" + style + "</style></head>\n<body>\n" + body +
         "</body></html>\n";
}

}  // namespace wheelwright::tools::html
