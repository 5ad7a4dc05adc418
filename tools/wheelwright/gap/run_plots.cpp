#include "tools/wheelwright/gap/run_plots.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "config/load/text_format.hpp"
#include "model/free_run.hpp"
#include "tools/wheelwright/evaluation/end_point_plot.hpp"

namespace wheelwright::tools {
namespace {

namespace fs = std::filesystem;
using config::fixed_number;

// Colours that stand for those of the page until the picture is in it.
constexpr const char* ink = "#010203";
constexpr const char* before_colour = "#040506";
constexpr const char* after_colour = "#070809";
constexpr std::size_t most_points = 1500;  // of a line, so that the page stays small

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

struct Drawing {
  std::string caption;
  std::string data;      // blank separated columns
  std::string commands;  // of gnuplot, plotting 'data'
};

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

// gnuplot writes a colour in one of three ways, and black where none is asked for.
void give_page_colours(std::string& svg) {
  replace_all(svg, "color:black", "color:inherit");
  replace_all(svg, "rgb(1,2,3)", "currentColor");
  replace_all(svg, "rgb(  1,   2,   3)", "currentColor");
  replace_all(svg, "rgb(  4,   5,   6)", "var(--before)");
  replace_all(svg, "rgb(  7,   8,   9)", "var(--after)");
  replace_all(svg, ink, "currentColor");
  replace_all(svg, before_colour, "var(--before)");
  replace_all(svg, after_colour, "var(--after)");
}

std::string settings(int height) {
  return "set terminal svg size 860," + std::to_string(height) +
         " dynamic font 'sans-serif,13'\nset output 'figure.svg'\n"
         "set border 3 lc rgb '" +
         ink + "'\nset tics nomirror textcolor rgb '" + ink + "'\nset key textcolor rgb '" + ink +
         "' outside top center horizontal\nset xlabel textcolor rgb '" + ink +
         "'\nset ylabel textcolor rgb '" + ink + "'\nset grid lc rgb '#8f96a3' lw 0.3\n";
}

std::string line(const std::string& index, const std::string& columns, const std::string& colour,
                 const std::string& title, const std::string& dash = "1") {
  return "'data' index " + index + " using " + columns + " with lines lw 1.5 dt " + dash + " lc rgb '" +
         colour + "' title '" + title + "'";
}

// Free runs of one log; `after` only where something was added.
struct FreeRuns {
  const std::vector<PredictedMotion>& before;
  const std::vector<PredictedMotion>* after;
  std::string name_of_before() const { return after == nullptr ? "model" : "before"; }
};

Drawing travel_error(const DriveLog& run, const FreeRuns& models) {
  Drawing drawing;
  drawing.caption = run.name + ": predicted minus measured travel of each wheel (solid: left, dashed: right)";
  const auto first =
      std::ranges::find_if(run.samples, [](const DriveSample& sample) { return sample.ticks.has_value(); });
  const auto start = static_cast<std::size_t>(first - run.samples.begin());
  const std::size_t stride = std::max<std::size_t>(1, run.samples.size() / most_points);
  for (std::size_t i = start; i < run.samples.size(); i += stride) {
    const auto& ticks = run.samples[i].ticks;
    if (!ticks) continue;
    const double left = static_cast<double>(ticks->left - first->ticks->left) * run.metres_per_tick->left;
    const double right = static_cast<double>(ticks->right - first->ticks->right) * run.metres_per_tick->right;
    drawing.data += fixed_number(run.samples[i].t_s, 3);
    for (const auto* motion : {&models.before, models.after}) {
      if (motion == nullptr) continue;
      const WheelPair& begun = (*motion)[start].distance_m;
      const WheelPair& now = (*motion)[i].distance_m;
      drawing.data += " " + fixed_number(1000.0 * (now.left - begun.left - left), 3) + " " +
                      fixed_number(1000.0 * (now.right - begun.right - right), 3);
    }
    drawing.data += "\n";
  }
  drawing.commands = settings(320) + "set xlabel 'time [s]'\nset ylabel 'error of travel [mm]'\nplot " +
                     line("0", "1:2", before_colour, models.name_of_before()) + ", " +
                     line("0", "1:3", before_colour, "", "2") +
                     (models.after == nullptr ? ""
                                              : ", " + line("0", "1:4", after_colour, "after") + ", " +
                                                    line("0", "1:5", after_colour, "", "2")) +
                     "\n";
  return drawing;
}

Drawing path(const DriveLog& run, const FreeRuns& models) {
  Drawing drawing;
  drawing.caption = run.name + ": path on the floor from commands alone, beside the measured one";
  const std::size_t stride = std::max<std::size_t>(1, run.samples.size() / most_points);
  std::string reference;
  for (std::size_t i = 0; i < run.samples.size(); ++i) {
    const auto& sample = run.samples[i];
    const bool measured = sample.reference_x_m && sample.reference_y_m;
    if (i % stride != 0 && !(measured && i + 1 == run.samples.size())) continue;
    for (const auto* motion : {&models.before, models.after}) {
      if (motion == nullptr) continue;
      const Pose& pose = (*motion)[i].pose;
      drawing.data += fixed_number(pose.x_m, 4) + " " + fixed_number(pose.y_m, 4) + " ";
    }
    drawing.data += "\n";
    if (measured) {
      reference +=
          fixed_number(*sample.reference_x_m, 4) + " " + fixed_number(*sample.reference_y_m, 4) + "\n";
    }
  }
  drawing.data += "\n\n" + reference;
  drawing.commands = settings(560) +
                     "set size ratio -1\nset xlabel 'x [m]'\nset ylabel 'y [m]'\n"
                     "plot 'data' index 1 using 1:2 with linespoints pt 7 ps 0.15 lw 1.5 lc rgb '" +
                     std::string(ink) + "' title 'measured', " +
                     line("0", "1:2", before_colour, models.name_of_before()) +
                     (models.after == nullptr ? "" : ", " + line("0", "3:4", after_colour, "after")) + "\n";
  return drawing;
}

bool has_path(const DriveLog& run) {
  return std::ranges::count_if(run.samples, [](const DriveSample& sample) {
           return sample.reference_x_m && sample.reference_y_m && sample.reference_theta_rad;
         }) >= 2;
}

// Returns what stood in the way, or nothing.
std::optional<std::string> draw(const Drawing& drawing, const fs::path& folder, Figures& figures) {
  std::ofstream(folder / "data") << drawing.data;
  std::ofstream(folder / "script") << drawing.commands;
  if (auto problem = run_gnuplot(folder / "script")) return problem;
  std::ifstream file(folder / "figure.svg");
  std::ostringstream text;
  text << file.rdbuf();
  std::string svg = text.str();
  // What stands before the element is for files, not for pages.
  svg.erase(0, std::min(svg.find("<svg"), svg.size()));
  give_page_colours(svg);
  figures.figures.push_back({drawing.caption, std::move(svg)});
  return std::nullopt;
}

}  // namespace

Figures run_figures(const RobotModel& before, const std::optional<RobotModel>& after,
                    std::span<const DriveLog> runs) {
  Figures figures;
  const Workshop workshop;
  if (workshop.folder().empty()) return {{}, "not drawn: no temporary folder can be made"};
  for (const auto& run : runs) {
    const auto without = free_run(before, run);
    const auto with = after ? free_run(*after, run) : std::vector<PredictedMotion>{};
    const FreeRuns models{without, after ? &with : nullptr};
    std::vector<Drawing> drawings;
    if (run.has_ticks()) drawings.push_back(travel_error(run, models));
    if (has_path(run)) drawings.push_back(path(run, models));
    for (const auto& drawing : drawings) {
      if (const auto problem = draw(drawing, workshop.folder(), figures)) return {{}, *problem};
    }
  }
  return figures;
}

}  // namespace wheelwright::tools
