#include "tools/wheelwright/page/gnuplot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "config/load/text_file.hpp"

namespace wheelwright::tools {
namespace {

namespace fs = std::filesystem;

struct Colour {
  std::string_view stand_in;  // as a script has it
  std::string_view spaced;    // as gnuplot may write it
  std::string_view dense;
  std::string_view page;  // what the page calls it
};

constexpr std::array<Colour, 5> colours{{
    {"#010203", "rgb(  1,   2,   3)", "rgb(1,2,3)", "var(--text)"},
    {"#070809", "rgb(  7,   8,   9)", "rgb(7,8,9)", "var(--after)"},
    {"#040506", "rgb(  4,   5,   6)", "rgb(4,5,6)", "var(--before)"},
    {"#0a0b0c", "rgb( 10,  11,  12)", "rgb(10,11,12)", "var(--third)"},
    {"#0d0e0f", "rgb( 13,  14,  15)", "rgb(13,14,15)", "var(--time)"},
}};

// A folder for gnuplot's files, gone when done.
class Workshop {
 public:
  Workshop() {
    std::string name = (fs::temp_directory_path() / "wheelwright_report_XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr) folder_ = name;
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;
  ~Workshop() {
    std::error_code ignored;
    if (!folder_.empty()) fs::remove_all(folder_, ignored);
  }
  const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
};

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

// gnuplot writes a colour in one of three ways, and has ideas of its own where none is asked for; what it
// calls the current colour has to be the page's.
void give_page_colours(std::string& svg) {
  replace_all(svg, "color:black", "color:inherit");
  replace_all(svg, " color=\"black\"", " color=\"inherit\"");
  replace_all(svg, " color=\"white\"", " color=\"var(--page)\"");
  replace_all(svg, " color='white'", " color='var(--page)'");
  replace_all(svg, " stroke='white'", " stroke='var(--page)'");
  replace_all(svg, "stroke=\"black\"", "stroke=\"currentColor\"");
  for (const Colour& colour : colours) {
    replace_all(svg, colour.dense, colour.page);
    replace_all(svg, colour.spaced, colour.page);
    replace_all(svg, colour.stand_in, colour.page);
  }
}

// Names inside one picture must not meet those of another on the same page.
void give_own_names(std::string& svg, std::size_t number) {
  const std::string own = "p" + std::to_string(number) + "_";
  replace_all(svg, "gnuplot_plot_", own + "plot_");
  replace_all(svg, "id='gp", "id='" + own + "gp");
  replace_all(svg, "id=\"gp", "id=\"" + own + "gp");
  replace_all(svg, "#gp", "#" + own + "gp");
}

std::string settings(const GnuplotPicture& picture, std::size_t number) {
  const std::string ink(placeholder(Ink::text));
  return "reset session\nset terminal svg size " + std::to_string(picture.width) + "," +
         std::to_string(picture.height) + " dynamic font 'sans-serif,14'\nset output 'figure" +
         std::to_string(number) + ".svg'\nset encoding utf8\nset border 3 lc rgb '" + ink +
         "'\nset tics nomirror textcolor rgb '" + ink + "'\nset key textcolor rgb '" + ink +
         "' outside top center horizontal\nset xlabel textcolor rgb '" + ink +
         "'\nset ylabel textcolor rgb '" + ink + "'\nset grid lc rgb '#8f96a3' lw 0.3\n";
}

}  // namespace

std::string_view placeholder(Ink ink) {
  return colours.at(static_cast<std::size_t>(ink)).stand_in;
}

tl::expected<std::vector<std::string>, std::string> run_gnuplot_for(
    std::span<const GnuplotPicture> pictures) {
  std::vector<std::string> drawn;
  if (pictures.empty()) return drawn;
  const Workshop workshop;
  if (workshop.folder().empty())
    return tl::unexpected(std::string("not drawn: no temporary folder can be made"));
  {
    std::ofstream script(workshop.folder() / "script");
    for (std::size_t i = 0; i < pictures.size(); ++i)
      script << settings(pictures[i], i) << pictures[i].script << "unset output\n";
  }
  if (auto problem = run_gnuplot(workshop.folder() / "script")) return tl::unexpected(std::move(*problem));
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const auto written =
        config::read_text(workshop.folder() / ("figure" + std::to_string(i) + ".svg"), config::record_file);
    if (!written) return tl::unexpected("not drawn: " + written.error());
    std::string svg = *written;
    // What stands before the element is for files, not for pages.
    svg.erase(0, std::min(svg.find("<svg"), svg.size()));
    give_page_colours(svg);
    give_own_names(svg, i);
    drawn.push_back(std::move(svg));
  }
  return drawn;
}

std::optional<std::string> run_gnuplot(const fs::path& script) {
  const std::string name = script.filename().string();
  std::string program = "gnuplot";
  std::string argument = name;
  std::array<char*, 3> arguments{program.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, script.parent_path().c_str());
  // It warns of lines that are flat, which is no concern of a reader.
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int error = posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return "not drawn: needs gnuplot (package gnuplot-nox)";
  int status = 0;
  if (waitpid(child, &status, 0) != child || status != 0) return "not drawn: gnuplot failed on " + name;
  return std::nullopt;
}

}  // namespace wheelwright::tools
