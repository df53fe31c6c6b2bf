#include <string>

#include "cli/compare_command.h"
#include "cli/json_values.h"

namespace mirrorball::cli {

std::string jsonOf(const ToldComparison& told) {
  const Comparison& comparison = told.comparison;
  const bool is_light = comparison.kind == ImageKind::light;
  Json json;
  json["test"] = told.test;
  json["reference"] = told.reference;
  json["kind"] = is_light ? "light" : "picture";
  json["size"] = {comparison.flip.width(), comparison.flip.height()};
  for (const MetricText& metric : kMetrics) {
    const auto& value = comparison.value(metric.metric);
    json["metrics"][std::string(metric.name)] = value ? numberOf(*value) : Json();
  }
  json["worst"] = {{"pixel", arrayOf(comparison.worst)},
                   {"test", arrayOf(comparison.test_at_worst)},
                   {"reference", arrayOf(comparison.reference_at_worst)}};
  json["flip"] = {
      {"pixels_per_degree", numberOf(double(told.options.pixels_per_degree))},
      {"worst", {{"pixel", arrayOf(comparison.worst_flip)}, {"flip", numberOf(double(comparison.max_flip))}}}};
  if (is_light) {
    const ExposureRange& exposures = comparison.exposures;
    json["flip"]["exposures"] = {{"start", numberOf(double(exposures.start_ev))},
                                 {"stop", numberOf(double(exposures.stop_ev))},
                                 {"count", exposures.count}};
    const Display& display = told.options.display;
    json["display"] = {{"exposure", numberOf(double(display.exposure_ev))},
                       {"tone_map", std::string(choiceAt(toneMapText(), static_cast<int>(display.tone_map)))}};
  }
  json["scale"] = numberOf(double(told.scale));
  json["thresholds"] = Json::array();
  for (const Threshold& threshold : told.options.thresholds) {
    const auto& value = comparison.value(threshold.metric);
    json["thresholds"].push_back({{"metric", std::string(textOf(threshold.metric).name)},
                                  {"value", numberOf(threshold.value)},
                                  {"kept", !value || !isWorse(threshold.metric, *value, threshold.value)}});
  }
  return printedJson(json);
}

}  // namespace mirrorball::cli
