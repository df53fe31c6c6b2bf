#include "mirrorball/study/page/page.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "mirrorball/base/text.h"
#include "mirrorball/study/page/markup.h"
#include "mirrorball/study/page/page_files.h"
#include "mirrorball/study/page/plot.h"

namespace mirrorball {
namespace {

/// The metrics that a page tells, of those that there are.
constexpr std::array kTold{Metric::psnr, Metric::flip, Metric::relmse, Metric::ssim};

std::string formatted(const char* format, double number) {
  char text[64];
  std::snprintf(text, sizeof(text), format, number);
  return text;
}

std::string element(std::string_view tag, const std::string& inside) {
  return "<" + std::string(tag) + ">" + inside + "</" + std::string(tag) + ">";
}

std::string cell(const std::string& text) { return element("td", escaped(text)); }

std::string bytesText(std::size_t bytes) { return formatted("%.2f MiB", double(bytes) / 1048576.0); }

/// As many digits as a table wants: `compare` tells more.
std::string metricText(Metric metric, const std::optional<double>& value) {
  if (!value) return "–";
  return std::isinf(*value) || metric == Metric::psnr ? valueText(metric, *value) : formatted("%.3g", *value);
}

std::string traceText(const TraceCost& cost) {
  return counted(std::size_t(cost.paths), "path") + " a pixel, standard error at most " +
         formatted("%.2g", double(cost.noise)) + " of white, " + formatted("%.1f s", cost.time_s);
}

/// The three cells of what a picture took: time, memory, look-ups.
std::string costCells(const StudiedPicture& picture) {
  if (picture.traced)
    return cell(formatted("%.1f s", picture.traced->time_s)) + cell("–") +
           cell(counted(std::size_t(picture.traced->paths), "path"));
  return cell(formatted("%.2f ms", picture.drawn->frame_ms)) + cell(bytesText(picture.drawn->light.texture_bytes)) +
         cell(std::to_string(picture.drawn->light.reads));
}

constexpr std::string_view kCostHeads = "<th>Time</th><th>Textures</th><th>Look-ups</th>";

/// All of the layers of a shot, each a picture of the same place.
Result<std::string> layersOf(const StudiedShot& shot) {
  std::string layers;
  const auto add = [&](std::size_t technique, const char* map, const std::string& name,
                       const Image8& picture) -> Result<void> {
    MIRRORBALL_TRY(address, dataAddressOf(picture));
    layers += "<img data-technique=\"" + std::to_string(technique) + "\" data-map=\"" + map + "\" width=\"" +
              std::to_string(picture.width()) + "\" height=\"" + std::to_string(picture.height()) + "\" alt=\"" +
              escaped(name) + "\" src=\"" + address + "\">\n";
    return {};
  };
  MIRRORBALL_TRY_VOID(add(0, "picture", "reference", shot.reference));
  for (std::size_t i = 0; i < shot.pictures.size(); ++i) {
    const StudiedPicture& picture = shot.pictures[i];
    MIRRORBALL_TRY_VOID(add(i + 1, "picture", picture.technique, picture.picture));
    MIRRORBALL_TRY_VOID(add(i + 1, "flip", picture.technique + ", FLIP", picture.flip));
    MIRRORBALL_TRY_VOID(add(i + 1, "difference", picture.technique + ", difference", picture.difference));
  }
  return layers;
}

std::string tableOf(const StudiedShot& shot) {
  std::string rows;
  for (const StudiedPicture& picture : shot.pictures) {
    rows += "<tr><th scope=\"row\">" + escaped(picture.technique) +
            (picture.settings.empty() ? "" : "<br><code>" + escaped(picture.settings) + "</code>") + "</th>";
    for (const Metric metric : kTold)
      rows += cell(metricText(metric, picture.values[static_cast<std::size_t>(metric)]));
    rows += costCells(picture) + "</tr>\n";
  }
  std::string heads;
  for (const Metric metric : kTold) heads += element("th", std::string(textOf(metric).label));
  return "<div class=\"wide\"><table><thead><tr><th>Technique</th>" + heads + std::string(kCostHeads) +
         "</tr></thead>\n<tbody>" + rows + "</tbody></table></div>\n";
}

Result<std::string> shotOf(const StudiedShot& shot, const std::string& id) {
  MIRRORBALL_TRY(layers, layersOf(shot));
  return "<article class=\"shot\" id=\"" + id + "\" data-label=\"" + escaped(shot.label) + "\">\n<h3>" +
         escaped(shot.label) + "</h3>\n<div class=\"stage\">\n" + layers +
         "</div>\n<p class=\"note\">Reference: " + traceText(shot.cost) +
         ". The difference of radiance has its full colour at " + formatNumber(double(shot.scale)) + ".</p>\n" +
         tableOf(shot) + "</article>\n";
}

/// A metric of every technique over the series.
Plot plotOverSeries(const StudiedSection& section, Metric metric) {
  const MetricText& text = textOf(metric);
  Plot plot{.title = std::string(text.label) + " over " + section.axis,
            .x_label = section.axis,
            .y_from_zero = !text.higher_is_better,
            .y_label = std::string(text.label) + (text.unit.empty() ? "" : " [" + std::string(text.unit) + "]") +
                       (text.higher_is_better ? ", higher is better" : ", lower is better")};
  for (const StudiedShot& shot : section.shots) {
    if (!shot.value) continue;
    plot.curves.resize(shot.pictures.size());
    for (std::size_t i = 0; i < shot.pictures.size(); ++i) {
      plot.curves[i].name = shot.pictures[i].technique;
      const auto& value = shot.pictures[i].values[static_cast<std::size_t>(metric)];
      if (value && std::isfinite(*value)) plot.curves[i].points.emplace_back(*shot.value, *value);
    }
  }
  return plot;
}

/// The first technique's error over n·v, a curve for each shot.
Plot plotOverAngle(const StudiedSection& section) {
  const std::string technique = section.shots.front().pictures.front().technique;
  Plot plot{.title = "Error over n·v",
            .x_label = "n·v (0 is grazing)",
            .y_label = "root of relMSE of " + technique + ", by " + section.axis};
  for (const StudiedShot& shot : section.shots) {
    if (!section.axis.empty() && !shot.value) continue;
    Curve curve{.name = shot.label};
    const ErrorByAngle& errors = shot.pictures.front().by_angle;
    for (std::size_t step = 0; step < kAngleSteps; ++step)
      if (errors[step]) curve.points.emplace_back((double(step) + 0.5) / double(kAngleSteps), *errors[step]);
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

std::string plotsOf(const StudiedSection& section) {
  std::string plots;
  const auto values = std::count_if(section.shots.begin(), section.shots.end(),
                                    [](const StudiedShot& shot) { return shot.value.has_value(); });
  if (values > 1) {
    plots += svgOf(plotOverSeries(section, Metric::psnr), section.id + "-psnr");
    plots += svgOf(plotOverSeries(section, Metric::flip), section.id + "-flip");
  }
  if (section.by_angle) plots += svgOf(plotOverAngle(section), section.id + "-angle");
  return plots.empty() ? "" : "<div class=\"plots\">\n" + plots + "</div>\n";
}

Result<std::string> sectionOf(const StudiedSection& section) {
  std::string shots;
  for (std::size_t i = 0; i < section.shots.size(); ++i) {
    MIRRORBALL_TRY(shot, shotOf(section.shots[i], section.id + "-" + std::to_string(i)));
    shots += shot;
  }
  return "<section id=\"" + section.id + "\" aria-labelledby=\"" + section.id + "-title\" data-axis=\"" +
         escaped(section.axis) + "\">\n<h2 id=\"" + section.id + "-title\">" + escaped(section.title) +
         "</h2>\n<p class=\"teaches\">" + escaped(section.teaches) +
         "</p>\n<p class=\"note\">Compared with paths of light with " + escaped(section.compared_with) + ".</p>\n" +
         shots + plotsOf(section) + "</section>\n";
}

/// The shot in which a technique is farthest from the truth, by its PSNR.
const StudiedShot& worstShot(const StudiedSection& section, std::size_t technique) {
  const auto psnrOf = [technique](const StudiedShot& shot) {
    return shot.pictures[technique].values[static_cast<std::size_t>(Metric::psnr)].value_or(INFINITY);
  };
  return *std::min_element(section.shots.begin(), section.shots.end(),
                           [&](const StudiedShot& a, const StudiedShot& b) { return psnrOf(a) < psnrOf(b); });
}

/// All techniques in one table.
std::string glanceOf(const Study& study) {
  std::string rows;
  for (const StudiedSection& section : study.sections) {
    const std::vector<StudiedPicture>& pictures = section.shots.front().pictures;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      rows += "<tr>";
      if (i == 0)
        rows += "<th scope=\"rowgroup\" rowspan=\"" + std::to_string(pictures.size()) + "\"><a href=\"#" + section.id +
                "\">" + escaped(section.title) + "</a></th>";
      const StudiedShot& shot = worstShot(section, i);
      const StudiedPicture& picture = shot.pictures[i];
      const auto valueCell = [&](Metric metric) {
        return cell(metricText(metric, picture.values[static_cast<std::size_t>(metric)]));
      };
      rows += cell(picture.technique) + cell(shot.label) + valueCell(Metric::psnr) + valueCell(Metric::flip) +
              costCells(picture) + "</tr>\n";
    }
  }
  return "<section id=\"glance\" aria-labelledby=\"glance-title\">\n<h2 id=\"glance-title\">At a glance</h2>\n"
         "<p class=\"note\">Of each technique the picture that is farthest from the truth, by its PSNR, with its own "
         "numbers and cost.</p>\n"
         "<div class=\"wide\"><table><thead><tr><th>Subject</th><th>Technique</th><th>Worst in</th><th>PSNR</th>"
         "<th>FLIP</th>" +
         std::string(kCostHeads) + "</tr></thead>\n<tbody>" + rows + "</tbody></table></div>\n</section>\n";
}

std::string navigationOf(const Study& study) {
  std::string links = "<a href=\"#glance\">At a glance</a>\n";
  for (const StudiedSection& section : study.sections)
    links += "<a href=\"#" + section.id + "\">" + escaped(section.title) + "</a>\n";
  return links + "<a href=\"#numbers\">About the numbers</a>\n";
}

/// How much of the page is missing.
std::string interruptionOf(const Study& study) {
  if (!study.isInterrupted()) return "";
  return "<p class=\"note\">Interrupted: " + std::to_string(study.sections.size()) + " of " +
         counted(study.planned, "subject") + " are here.</p>\n";
}

/// What the numbers mean, and on what they were measured.
std::string aboutOf(const Study& study, const PageText& text) {
  std::string about =
      "<p>Each picture is compared with its reference as linear light. PSNR and SSIM see both as they are shown here; "
      "relMSE is of radiance; FLIP is HDR-FLIP. The noise that is left in the reference counts as error "
      "too.</p>\n<p>Time: the median of the frames of one sample a pixel that the "
      "picture is the mean of, " +
      std::to_string(study.size.x) + " × " + std::to_string(study.size.y) + " pixels, " +
      counted(std::size_t(study.samples), "sample") + ", on " + escaped(study.driver) +
      "; of what is path-traced, the whole picture.</p>\n<p>Textures: those that hold the arriving light and are read, "
      "with all of their levels. Look-ups: reads of these textures for one sample of a pixel, counted in the formulas "
      "that the shaders consist of; one of them is always the irradiance.</p>\n";
  if (!text.made_by.empty()) about += "<p>Made by <code>" + escaped(text.made_by) + "</code></p>\n";
  return "<section id=\"numbers\" aria-labelledby=\"numbers-title\">\n<h2 id=\"numbers-title\">About the "
         "numbers</h2>\n" +
         about + "</section>\n";
}

}  // namespace

Result<std::string> pageOf(const Study& study, const PageText& text) {
  std::string sections;
  for (const StudiedSection& section : study.sections) {
    MIRRORBALL_TRY(one, sectionOf(section));
    sections += one;
  }
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         escaped(text.title) + "</title>\n<style>\n" + std::string(pageFile("page.css").value()) +
         std::string(pageFile("plot.css").value()) +
         "</style>\n<script>document.documentElement.classList.add('scripted')</script>\n</"
         "head>\n<body>\n<header>\n<h1>" +
         escaped(text.title) + "</h1>\n<nav>" + navigationOf(study) + "</nav>\n</header>\n<main>\n" +
         interruptionOf(study) + glanceOf(study) + sections + aboutOf(study, text) + "</main>\n<script>\n" +
         std::string(pageFile("page.js").value()) + "</script>\n</body>\n</html>\n";
}

}  // namespace mirrorball
