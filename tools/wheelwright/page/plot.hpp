// Pictures for a page: what is to be seen, said once, and drawn by gnuplot as SVG that takes its colours from
// the page around it, light or dark.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace wheelwright::tools {

// One value of a series. `error` is half an interval, where the series is drawn with error bars.
struct PlotPoint {
  double x = 0.0;
  double y = 0.0;
  double error = 0.0;
};
using PlotPoints = std::vector<PlotPoint>;

// Roles that colours stand for, the same in every picture; the page says which they are (html::page).
enum class Ink : unsigned char {
  text,    // measured: what is true as far as anyone knows
  accent,  // the model, or after
  other,   // odometry, or before
  third,   // the filter
  quiet,   // commands, plans, marks
};

class Plot {
 public:
  explicit Plot(std::string caption) : caption_(std::move(caption)) {}

  // Names of the axes, with units: "time [s]".
  Plot& axes(const std::string& x, const std::string& y);
  Plot& height(int pixels);  // 300 unless told
  Plot& half();              // so wide that two stand side by side where there is room
  Plot& equal_scales();      // one metre is as long upwards as sideways
  Plot& range(double half);  // both axes, to either side of zero
  Plot& from_zero();         // the vertical axis begins at zero
  // Both axes; values must be above zero. Shown are all x up to one, and all y from one on.
  Plot& logarithmic(double up_to_x, double from_y);

  // Series, drawn in the order in which they are added; an empty title leaves it out of the legend. A point
  // that is not finite interrupts a line.
  Plot& line(std::string title, Ink ink, PlotPoints points, int dash = 1);
  Plot& steps(std::string title, Ink ink, PlotPoints points);
  Plot& points(std::string title, Ink ink, PlotPoints points, double size = 0.5);
  Plot& dotted_line(std::string title, Ink ink, PlotPoints points);
  Plot& error_bars(std::string title, Ink ink, PlotPoints points);
  // A histogram: boxes about their x, `error` to either side, y high.
  Plot& boxes(std::string title, Ink ink, PlotPoints points);
  // A mark across the picture at one x, with a word beside it at a height from 0 to 1.
  Plot& mark(double x, const std::string& word, double height = 0.95);
  // A circle about (x, y), in units of the axes.
  Plot& circle(double x, double y, double radius, int dash = 1);
  // A word at a point.
  Plot& label(double x, double y, const std::string& word);

  bool empty() const { return series_.empty(); }
  const std::string& caption() const { return caption_; }
  // Everything that gnuplot needs, except where to write.
  std::string script() const;
  int width() const { return half_ ? 420 : 780; }
  int height() const { return height_; }
  bool is_half() const { return half_; }

 private:
  struct Series {
    std::string title;
    std::string style;         // gnuplot's words
    std::string error_column;  // gnuplot's words for it; empty where points have none
    PlotPoints points;
  };
  std::string equal_tics() const;
  Plot& add(std::string title, std::string style, PlotPoints points, std::string error_column = "");

  std::string caption_;
  std::string settings_;
  int height_ = 300;
  bool half_ = false;
  bool equal_scales_ = false;
  std::vector<Series> series_;
  int objects_ = 0;
};

struct DrawnPlot {
  std::string caption;
  std::string svg;
  bool half = false;  // two stand side by side where there is room
};

struct Figures {
  std::vector<DrawnPlot> figures;  // one per plot
  std::string problem;             // why there are none, in one line; empty where there are
};

// Draws all plots with one run of gnuplot.
Figures draw(std::span<const Plot> plots);

// Figures as elements of a page, or the one line that says why there are none.
std::string figures_html(const Figures& figures);

// At most about 1500 points that look the same: of each segment the lowest and the highest.
PlotPoints thinned(const PlotPoints& points);

}  // namespace wheelwright::tools
