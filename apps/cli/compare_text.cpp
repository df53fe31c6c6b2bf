#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cli/compare_command.h"
#include "cli/formatted.h"
#include "mirrorball/base/size_text.h"
#include "mirrorball/base/text.h"

namespace mirrorball::cli {
namespace {

/// "FLIP      0.0123      lower is better; LDR-FLIP, 0 to 1"
std::string comparisonLine(std::string_view name, std::string fact, const std::string& meaning) {
  constexpr std::size_t kFactColumn = 10;
  constexpr std::size_t kMeaningColumn = 12;
  std::string line(name);
  line.resize(kFactColumn, ' ');
  if (meaning.empty()) return line + fact;
  fact.resize(std::max(fact.size() + 1, kMeaningColumn), ' ');
  return line + fact + meaning;
}

std::string pixelText(glm::ivec2 pixel) {
  return "pixel (" + std::to_string(pixel.x) + ", " + std::to_string(pixel.y) + ")";
}

/// What a metric compares, with the settings on which its value depends.
std::string meaningOf(const MetricText& metric, const ToldComparison& told) {
  const bool is_light = told.comparison.kind == ImageKind::light;
  std::string meaning(is_light ? metric.of_light : metric.of_pictures);
  if (metric.metric == Metric::flip) {
    meaning += formatted(", %.4g pixels per degree", double(told.options.pixels_per_degree));
    const ExposureRange& exposures = told.comparison.exposures;
    if (is_light)
      meaning += ", " + counted(std::size_t(exposures.count), "exposure") +
                 formatted(" from %.3g to %.3g stops", double(exposures.start_ev), double(exposures.stop_ev));
  }
  if (is_light && (metric.metric == Metric::psnr || metric.metric == Metric::ssim))
    meaning += " (" + std::string(choiceAt(toneMapText(), static_cast<int>(told.options.display.tone_map))) + ", " +
               shortText(double(told.options.display.exposure_ev)) + " stops)";
  return (metric.higher_is_better ? "higher is better; " : "lower is better; ") + meaning;
}

}  // namespace

std::vector<std::string> linesOf(const ToldComparison& told) {
  const Comparison& comparison = told.comparison;
  const bool is_light = comparison.kind == ImageKind::light;
  std::vector<std::string> lines{comparisonLine("images",
                                                std::string(is_light ? "light" : "pictures") + " of " +
                                                    sizeText({comparison.flip.width(), comparison.flip.height()}),
                                                "")};
  for (const MetricText& metric : kMetrics) {
    const auto& value = comparison.value(metric.metric);
    if (value) lines.push_back(comparisonLine(metric.label, valueText(metric.metric, *value), meaningOf(metric, told)));
    if (!value && metric.metric == Metric::ssim)
      lines.push_back(comparisonLine(metric.label, "none", "its window of 11x11 pixels does not fit"));
  }
  lines.push_back(comparisonLine("worst",
                                 pixelText(comparison.worst) + ": " + shortText(comparison.test_at_worst) +
                                     " against " + shortText(comparison.reference_at_worst),
                                 ""));
  lines.push_back(
      comparisonLine("", pixelText(comparison.worst_flip) + ": FLIP " + shortText(double(comparison.max_flip)), ""));
  return lines;
}

}  // namespace mirrorball::cli
