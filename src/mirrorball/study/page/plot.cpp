#include "mirrorball/study/page/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "mirrorball/base/text.h"
#include "mirrorball/study/page/markup.h"
#include "mirrorball/study/page/page_files.h"

namespace mirrorball {
namespace {

// In units of the drawing.
constexpr double kWidth = 420.0;
constexpr double kHeight = 260.0;
constexpr double kLeft = 48.0;
constexpr double kRight = 12.0;
constexpr double kTop = 30.0;
constexpr double kBottom = 42.0;
constexpr double kLegendLine = 17.0;
constexpr std::size_t kColors = 8;

/// On a page they follow its theme (page.css).
const std::string kFileColors =
    ".plot { font-family: sans-serif; }\n.plot text { fill: #1d1d1b; }\n.plot .mark { fill: #6b6a66; }\n"
    ".plot .grid { stroke: #dcd9d1; stroke-width: 1; }\n";

/// An axis from a number to another, with a mark each step.
struct Axis {
  double first;
  double last;
  double step;

  double share(double number) const { return (number - first) / (last - first); }
};

/// The least of 1, 2 and 5 times a power of ten with which at most six steps cover an extent.
double stepFor(double extent) {
  const double power = std::pow(10.0, std::floor(std::log10(extent / 6.0)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (extent / (factor * power) <= 6.0) return factor * power;
  return 10.0 * power;
}

/// step     0: a round number
Axis axisOf(double first, double last, double step = 0.0) {
  if (!(last > first)) last = first + 1.0;
  if (step == 0.0) step = stepFor(last - first);
  return {step * std::floor(first / step + 1e-9), step * std::ceil(last / step - 1e-9), step};
}

std::string shortNumber(double number) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g", std::abs(number) < 1e-12 ? 0.0 : number);
  return text;
}

std::string at(double length) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.1f", length);
  return text;
}

/// From numbers to places of the drawing.
struct Frame {
  Axis x;
  Axis y;

  double left(double number) const { return kLeft + x.share(number) * (kWidth - kLeft - kRight); }
  double down(double number) const { return kHeight - kBottom - y.share(number) * (kHeight - kTop - kBottom); }
};

Frame frameOf(const Plot& plot) {
  glm::dvec2 low(INFINITY), high(-INFINITY);
  for (const Curve& curve : plot.curves)
    for (const glm::dvec2& point : curve.points) {
      low = glm::dvec2(std::min(low.x, point.x), std::min(low.y, point.y));
      high = glm::dvec2(std::max(high.x, point.x), std::max(high.y, point.y));
    }
  if (!(low.x <= high.x)) return {axisOf(0.0, 1.0), axisOf(0.0, 1.0)};
  return {axisOf(low.x, high.x, plot.x_step), axisOf(plot.y_from_zero ? 0.0 : low.y, high.y)};
}

std::string text(double x, double y, const char* kind, const std::string& words) {
  return "<text class=\"" + std::string(kind) + "\" x=\"" + at(x) + "\" y=\"" + at(y) + "\">" + escaped(words) +
         "</text>\n";
}

std::string gridOf(const Plot& plot, const Frame& frame) {
  std::string marks;
  const auto line = [&](double x1, double y1, double x2, double y2) {
    marks += "<line class=\"grid\" x1=\"" + at(x1) + "\" y1=\"" + at(y1) + "\" x2=\"" + at(x2) + "\" y2=\"" + at(y2) +
             "\"/>\n";
  };
  const auto countOf = [](const Axis& axis) { return std::lround((axis.last - axis.first) / axis.step); };
  for (long i = 0; i <= countOf(frame.x); ++i) {
    const double number = frame.x.first + double(i) * frame.x.step;
    line(frame.left(number), kTop, frame.left(number), kHeight - kBottom);
    marks += text(frame.left(number), kHeight - kBottom + 15.0, "mark", shortNumber(number));
  }
  for (long i = 0; i <= countOf(frame.y); ++i) {
    const double number = frame.y.first + double(i) * frame.y.step;
    line(kLeft, frame.down(number), kWidth - kRight, frame.down(number));
    marks += text(kLeft - 6.0, frame.down(number) + 4.0, "mark of-y", shortNumber(number));
  }
  marks += text((kLeft + kWidth - kRight) / 2.0, kHeight - 8.0, "mark", plot.x_label);
  return marks + text(4.0, kTop - 12.0, "label", plot.y_label);
}

std::string curveOf(const Curve& curve, const Frame& frame, const std::string& color, bool marks_points) {
  std::string places;
  std::string points;
  for (const glm::dvec2& point : curve.points) {
    const std::string x = at(frame.left(point.x));
    const std::string y = at(frame.down(point.y));
    places += (places.empty() ? "" : " ") + x + "," + y;
    if (!marks_points) continue;
    points += "<circle cx=\"" + x + "\" cy=\"" + y + "\" r=\"3.5\"><title>" +
              escaped(curve.name + ": " + shortNumber(point.y) + " at " + shortNumber(point.x)) + "</title></circle>\n";
  }
  return "<g class=\"" + color + "\"><polyline points=\"" + places + "\"/>\n" + points + "</g>\n";
}

/// What an element <svg> of a plot holds, and how high it is.
struct Drawing {
  std::string inside;
  double height;
};

Drawing drawingOf(const Plot& plot) {
  const Frame frame = frameOf(plot);
  Drawing drawing{gridOf(plot, frame), kHeight + 8.0};
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    const std::string color = "curve" + std::to_string(i % kColors);
    drawing.inside += curveOf(plot.curves[i], frame, color, plot.marks_points);
    // Two names a line.
    const double x = kLeft + (i % 2 == 0 ? 0.0 : (kWidth - kLeft) / 2.0);
    const std::string y = at(drawing.height - 4.0);
    drawing.inside += "<g class=\"" + color + "\"><line x1=\"" + at(x) + "\" y1=\"" + y + "\" x2=\"" + at(x + 16.0) +
                      "\" y2=\"" + y + "\"/></g>" + text(x + 22.0, drawing.height, "name", plot.curves[i].name);
    if (i % 2 == 1 || i + 1 == plot.curves.size()) drawing.height += kLegendLine;
  }
  return drawing;
}

std::string viewBoxOf(double height) { return " viewBox=\"0 0 " + at(kWidth) + " " + at(height) + "\""; }

}  // namespace

std::string svgOf(const Plot& plot, const std::string& id) {
  const Drawing drawing = drawingOf(plot);
  return "<svg id=\"" + id + "\" class=\"plot\"" + viewBoxOf(drawing.height) + " role=\"img\" aria-labelledby=\"" + id +
         "-title\">\n<title id=\"" + id + "-title\">" + escaped(plot.title) + "</title>\n" + drawing.inside +
         "</svg>\n";
}

std::string svgFileOf(std::span<const Plot> plots) {
  std::string inside;
  double height = 0.0;
  for (const Plot& plot : plots) {
    const Drawing drawing = drawingOf(plot);
    inside += "<g transform=\"translate(0 " + at(height) + ")\">\n" + drawing.inside + "</g>\n";
    height += drawing.height;
  }
  const std::string title = plots.empty() ? "" : "<title>" + escaped(plots.front().title) + "</title>\n";
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\"" + viewBoxOf(height) + " width=\"" +
         at(2.0 * kWidth) + "\" height=\"" + at(2.0 * height) + "\">\n" + title + "<style>\n" + kFileColors +
         std::string(pageFile("plot.css").value()) +
         "</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" + inside + "</svg>\n";
}

}  // namespace mirrorball
