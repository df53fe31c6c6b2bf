#include "plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace mirrorball::bench {
namespace {

constexpr double kLeft = 84.0;
constexpr double kTop = 48.0;
constexpr double kPlotWidth = 560.0;
constexpr double kPlotHeight = 400.0;
constexpr double kLegendWidth = 240.0;

/// Colours that colour-blind people tell apart (Okabe and Ito 2008), without the yellow.
constexpr std::array<const char*, 8> kColors{"#d55e00", "#0072b2", "#009e73", "#cc79a7",
                                             "#56b4e9", "#e69f00", "#000000", "#888888"};

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g", value);
  return text;
}

/// A number beside an axis: without an exponent, so that those of an axis look alike.
std::string tickLabel(double value) {
  const int decimals = value > 0.0 && value < 1.0 ? static_cast<int>(std::round(-std::log10(value))) : 0;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '&')
      result += "&amp;";
    else if (letter == '<')
      result += "&lt;";
    else
      result += letter;
  }
  return result;
}

std::string line(glm::dvec2 from, glm::dvec2 to, const char* style) {
  return "<line x1=\"" + number(from.x) + "\" y1=\"" + number(from.y) + "\" x2=\"" + number(to.x) + "\" y2=\"" +
         number(to.y) + "\" " + style + "/>\n";
}

std::string words(glm::dvec2 at, const std::string& text, const std::string& style) {
  return "<text x=\"" + number(at.x) + "\" y=\"" + number(at.y) + "\" " + style + ">" + escaped(text) + "</text>\n";
}

/// An axis with its range, whole decades or whole numbers.
struct Scale {
  bool is_logarithmic;
  double begin = std::numeric_limits<double>::infinity();
  double end = -std::numeric_limits<double>::infinity();

  Scale(const Axis& axis, const std::vector<Curve>& curves, int component) : is_logarithmic(axis.is_logarithmic) {
    for (const Curve& curve : curves)
      for (const glm::dvec2& point : curve.points) {
        begin = std::min(begin, raw(point[component]));
        end = std::max(end, raw(point[component]));
      }
    begin = std::floor(begin);
    end = std::max(std::ceil(end), begin + 1.0);
  }

  double raw(double value) const { return is_logarithmic ? std::log10(value) : value; }
  /// 0 to 1 along the axis.
  double at(double value) const { return (raw(value) - begin) / (end - begin); }

  struct Tick {
    double value;
    bool has_label;
  };
  std::vector<Tick> ticks() const {
    std::vector<Tick> ticks;
    for (double step = begin; step <= end; step += 1.0) {
      ticks.push_back({is_logarithmic ? std::pow(10.0, step) : step, true});
      if (!is_logarithmic || step == end) continue;
      for (int digit = 2; digit < 10; ++digit) ticks.push_back({digit * std::pow(10.0, step), false});
    }
    return ticks;
  }
};

struct Frame {
  Scale across;
  Scale up;

  glm::dvec2 place(glm::dvec2 point) const {
    return {kLeft + across.at(point.x) * kPlotWidth, kTop + (1.0 - up.at(point.y)) * kPlotHeight};
  }
};

std::string grid(const Frame& frame) {
  const auto style = [](bool has_label) { return has_label ? "stroke=\"#c8c8c8\"" : "stroke=\"#eeeeee\""; };
  std::string svg;
  for (const Scale::Tick& tick : frame.across.ticks()) {
    const double x = kLeft + frame.across.at(tick.value) * kPlotWidth;
    svg += line({x, kTop}, {x, kTop + kPlotHeight}, style(tick.has_label));
    if (tick.has_label) svg += words({x, kTop + kPlotHeight + 20.0}, tickLabel(tick.value), "text-anchor=\"middle\"");
  }
  for (const Scale::Tick& tick : frame.up.ticks()) {
    const double y = kTop + (1.0 - frame.up.at(tick.value)) * kPlotHeight;
    svg += line({kLeft, y}, {kLeft + kPlotWidth, y}, style(tick.has_label));
    if (tick.has_label) svg += words({kLeft - 8.0, y + 5.0}, tickLabel(tick.value), "text-anchor=\"end\"");
  }
  return svg;
}

std::string drawn(const Curve& curve, const Frame& frame, const std::string& color) {
  std::string svg = "<polyline fill=\"none\" stroke-width=\"2.5\" stroke=\"" + color + "\" points=\"";
  for (const glm::dvec2& point : curve.points) {
    const glm::dvec2 place = frame.place(point);
    svg += number(place.x) + "," + number(place.y) + " ";
  }
  svg += "\"/>\n";
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const glm::dvec2 place = frame.place(curve.points[i]);
    svg += "<circle r=\"5\" cx=\"" + number(place.x) + "\" cy=\"" + number(place.y) + "\" fill=\"" + color + "\"/>\n";
    if (i < curve.labels.size())
      svg += words(place + glm::dvec2(0.0, -10.0), curve.labels[i],
                   "text-anchor=\"middle\" font-size=\"13\" fill=\"" + color + "\"");
  }
  return svg;
}

}  // namespace

std::string svgPlot(const std::string& title, const Axis& across, const Axis& up, const std::vector<Curve>& curves) {
  const Frame frame{Scale(across, curves, 0), Scale(up, curves, 1)};
  const double width = kLeft + kPlotWidth + kLegendWidth;
  const double height = kTop + kPlotHeight + 60.0;
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(width) + " " + number(height) +
                    "\" font-family=\"sans-serif\" font-size=\"15\">\n<rect width=\"100%\" height=\"100%\" " +
                    "fill=\"white\"/>\n";
  svg += words({kLeft, 28.0}, title, "font-size=\"17\" font-weight=\"bold\"");
  svg += grid(frame);
  svg += words({kLeft + kPlotWidth / 2, kTop + kPlotHeight + 46.0}, across.label, "text-anchor=\"middle\"");
  svg += words({22.0, kTop + kPlotHeight / 2}, up.label,
               "text-anchor=\"middle\" transform=\"rotate(-90 22 " + number(kTop + kPlotHeight / 2) + ")\"");
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::string color = kColors[i % kColors.size()];
    svg += drawn(curves[i], frame, color);
    const glm::dvec2 entry(kLeft + kPlotWidth + 18.0, kTop + 20.0 + 26.0 * static_cast<double>(i));
    svg += "<circle r=\"5\" cx=\"" + number(entry.x) + "\" cy=\"" + number(entry.y - 5.0) + "\" fill=\"" + color +
           "\"/>\n";
    svg += words(entry + glm::dvec2(12.0, 0.0), curves[i].name, "font-size=\"14\"");
  }
  return svg + "</svg>\n";
}

}  // namespace mirrorball::bench
