// gnuplot, as this project calls it.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "tools/wheelwright/page/plot.hpp"

namespace wheelwright::tools {

struct GnuplotPicture {
  std::string script;  // settings, data and a plot command
  int width = 780;     // pixels
  int height = 300;
};

// The SVG element of each picture, in the page's colours. Or what stood in the way, in one line.
tl::expected<std::vector<std::string>, std::string> run_gnuplot_for(std::span<const GnuplotPicture> pictures);

// The colour that a script uses for an ink, until the picture is in a page.
std::string_view placeholder(Ink ink);

// Runs a script in its own folder. Returns what stood in the way, in one line, or nothing.
std::optional<std::string> run_gnuplot(const std::filesystem::path& script);

}  // namespace wheelwright::tools
