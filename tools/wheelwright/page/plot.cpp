#include "tools/wheelwright/page/plot.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "config/load/printable_text.hpp"
#include "config/load/text_format.hpp"
#include "tools/wheelwright/page/gnuplot.hpp"
#include "tools/wheelwright/page/html.hpp"

namespace wheelwright::tools {
namespace {

using config::plain_number;

std::string in_quotes(const std::string& text) {
  std::string result = "'";
  for (const char character : config::printable(text))  // a line break would end the text
    result += character == '\'' ? std::string("''") : std::string(1, character);
  return result + "'";
}

std::string colour(Ink ink) {
  return "lc rgb '" + std::string(placeholder(ink)) + "'";
}

std::string number(double value) {
  if (!std::isfinite(value)) return "NaN";
  // Seven digits are more than any screen shows.
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 7).ptr;
  return {buffer.data(), end};
}

}  // namespace

Plot& Plot::axes(const std::string& x, const std::string& y) {
  settings_ += "set xlabel " + in_quotes(x) + "\nset ylabel " + in_quotes(y) + "\n";
  return *this;
}

Plot& Plot::height(int pixels) {
  height_ = pixels;
  return *this;
}

Plot& Plot::half() {
  half_ = true;
  return *this;
}

Plot& Plot::equal_scales() {
  equal_scales_ = true;
  settings_ += "set size ratio -1\nset offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05\n";
  return *this;
}

Plot& Plot::logarithmic(double up_to_x, double from_y) {
  settings_ +=
      "set logscale xy\nset xrange [*:" + number(up_to_x) + "]\nset yrange [" + number(from_y) + ":*]\n";
  return *this;
}

Plot& Plot::from_zero() {
  settings_ += "set yrange [0:*]\n";
  return *this;
}

Plot& Plot::range(double half) {
  const std::string to = number(half);
  settings_ += "set xrange [-" + to + ":" + to + "]\nset yrange [-" + to + ":" + to + "]\n";
  return *this;
}

Plot& Plot::add(std::string title, std::string style, PlotPoints points, std::string error_column) {
  if (!points.empty())
    series_.push_back({std::move(title), std::move(style), std::move(error_column), std::move(points)});
  return *this;
}

Plot& Plot::line(std::string title, Ink ink, PlotPoints points, int dash) {
  return add(std::move(title), "with lines lw 1.6 dt " + std::to_string(dash) + " " + colour(ink),
             std::move(points));
}

Plot& Plot::steps(std::string title, Ink ink, PlotPoints points) {
  return add(std::move(title), "with steps lw 1.2 " + colour(ink), std::move(points));
}

Plot& Plot::points(std::string title, Ink ink, PlotPoints points, double size) {
  return add(std::move(title), "with points pt 7 ps " + plain_number(size) + " " + colour(ink),
             std::move(points));
}

Plot& Plot::dotted_line(std::string title, Ink ink, PlotPoints points) {
  return add(std::move(title), "with linespoints pt 7 ps 0.4 lw 1.4 " + colour(ink), std::move(points));
}

Plot& Plot::error_bars(std::string title, Ink ink, PlotPoints points) {
  return add(std::move(title), "with yerrorbars pt 7 ps 0.4 lw 1.2 " + colour(ink), std::move(points), ":3");
}

Plot& Plot::boxes(std::string title, Ink ink, PlotPoints points) {
  return add(std::move(title), "with boxes fs transparent solid 0.4 border lw 1 " + colour(ink),
             std::move(points), ":(2*$3)");
}

Plot& Plot::mark(double x, const std::string& word, double height) {
  const std::string at = number(x);
  settings_ += "set arrow from first " + at + ", graph 0 to first " + at + ", graph 1 nohead lw 1 dt 2 " +
               colour(Ink::quiet) + "\nset label " + in_quotes(word) + " at first " + at + ", graph " +
               plain_number(height) + " offset 0.4,0 textcolor rgb '" + std::string(placeholder(Ink::quiet)) +
               "'\n";
  return *this;
}

Plot& Plot::circle(double x, double y, double radius, int dash) {
  settings_ += "set object " + std::to_string(++objects_) + " circle at first " + number(x) + "," +
               number(y) + " size first " + number(radius) + " fs empty border " + colour(Ink::quiet) +
               " lw 1.2 dt " + std::to_string(dash) + "\n";
  return *this;
}

Plot& Plot::label(double x, double y, const std::string& word) {
  settings_ += "set label " + in_quotes(word) + " at first " + number(x) + ", first " + number(y) +
               " offset 0.5,0.5 textcolor rgb '" + std::string(placeholder(Ink::quiet)) + "'\n";
  return *this;
}

// The same step on both axes: gnuplot counts its own by the axes' usual lengths, and where a picture is
// narrow they run into each other.
std::string Plot::equal_tics() const {
  double largest = 0.0;
  for (const auto coordinate : {&PlotPoint::x, &PlotPoint::y}) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const Series& series : series_) {
      for (const PlotPoint& point : series.points) {
        if (!std::isfinite(point.*coordinate)) continue;
        least = std::min(least, point.*coordinate);
        most = std::max(most, point.*coordinate);
      }
    }
    largest = std::max(largest, most - least);
  }
  if (!(largest > 0.0)) return "";
  constexpr double steps = 6.0;
  const double decade = std::pow(10.0, std::floor(std::log10(largest / steps)));
  const double digit = largest / steps / decade;
  const std::string step = number(decade * (digit <= 2.0 ? 2.0 : digit <= 5.0 ? 5.0 : 10.0));
  return "set xtics " + step + "\nset ytics " + step + "\n";
}

std::string Plot::script() const {
  std::string data;
  std::string plot;
  for (std::size_t i = 0; i < series_.size(); ++i) {
    const Series& series = series_[i];
    const std::string name = "$data" + std::to_string(i);
    data += name + " << end\n";
    for (const PlotPoint& point : series.points) {
      data += number(point.x) + " " + number(point.y);
      if (!series.error_column.empty()) data += " " + number(point.error);
      data += "\n";
    }
    data += "end\n";
    plot += (plot.empty() ? "plot " : ", ") + name + " using 1:2" + series.error_column + " " + series.style +
            (series.title.empty() ? " notitle" : " title " + in_quotes(series.title));
  }
  return settings_ + (equal_scales_ ? equal_tics() : "") + data + plot + "\n";
}

Figures draw(std::span<const Plot> plots) {
  std::vector<GnuplotPicture> pictures;
  for (const Plot& plot : plots) {
    if (!plot.empty()) pictures.push_back({plot.script(), plot.width(), plot.height()});
  }
  auto drawn = run_gnuplot_for(pictures);
  if (!drawn) return {{}, drawn.error()};
  Figures figures;
  std::size_t next = 0;
  for (const Plot& plot : plots) {
    if (!plot.empty())
      figures.figures.push_back({plot.caption(), std::move((*drawn)[next++]), plot.is_half()});
  }
  return figures;
}

std::string figures_html(const Figures& figures) {
  if (!figures.problem.empty()) return html::element("p", "Pictures: " + figures.problem + ".");
  std::string text = "<div class=\"figures\">\n";
  for (const auto& figure : figures.figures) {
    text += std::string("<figure") + (figure.half ? " class=\"half\"" : "") + "><div class=\"picture\">" +
            figure.svg + "</div>" + html::element("figcaption", figure.caption) + "</figure>\n";
  }
  return figures.figures.empty() ? "" : text + "</div>\n";
}

PlotPoints thinned(const PlotPoints& points) {
  constexpr std::size_t segments = 700;
  if (points.size() <= 2 * segments) return points;
  PlotPoints result;
  for (std::size_t i = 0; i < segments; ++i) {
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(points.size() * i / segments);
    const auto last = points.begin() + static_cast<std::ptrdiff_t>(points.size() * (i + 1) / segments);
    const auto [low, high] = std::minmax_element(
        first, last, [](const PlotPoint& one, const PlotPoint& two) { return one.y < two.y; });
    result.push_back(*std::min(low, high));
    if (low != high) result.push_back(*std::max(low, high));
  }
  return result;
}

}  // namespace wheelwright::tools
