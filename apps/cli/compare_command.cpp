#include "cli/compare_command.h"

#include <array>
#include <cstdint>
#include <memory>
#include <utility>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/picture_remarks.h"
#include "cli/standard_streams.h"
#include "cli/terminal.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/size_text.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/codec/picture_layers.h"
#include "mirrorball/image/resize.h"
#include "mirrorball/metric/picture/heat_map.h"

namespace mirrorball::cli {
namespace {

using CompareField = ParsedField<CompareOptions>;

std::vector<std::string_view> metricNames() {
  std::vector<std::string_view> names;
  for (const MetricText& metric : kMetrics) names.push_back(metric.name);
  return names;
}

/// "flip=0.05"
Result<void> parseThreshold(const OptionText& text, std::string_view written, CompareOptions& options) {
  const std::size_t equals = written.find('=');
  const auto value = equals == std::string_view::npos ? std::nullopt : parseNumber(written.substr(equals + 1));
  if (!value) return misused(text, "METRIC=VALUE, as in flip=0.05", written);
  const std::vector<std::string_view> names = metricNames();
  const std::string_view name = written.substr(0, equals);
  const auto index = indexOfName(name, names);
  if (!index) {
    Error error = unknownName("metric", name, names);
    error.message = std::string(text.name) + ": " + error.message;
    return tl::unexpected<Error>(error);
  }
  options.thresholds.push_back({kMetrics[*index].metric, *value});
  return {};
}

constexpr CompareField kThresholds{[](const CompareOptions&) { return std::string(); }, parseThreshold, true};

constexpr CompareField kCompareExposure{
    [](const CompareOptions& options) { return formatNumber(double(options.display.exposure_ev)); },
    [](const OptionText& text, std::string_view written, CompareOptions& options) -> Result<void> {
      MIRRORBALL_TRY(numbers, parseNumbers(text, written));
      options.display.exposure_ev = numbers[0];
      return {};
    }};

constexpr ChoiceField<CompareOptions> kCompareToneMap{
    [](const CompareOptions& options) { return static_cast<int>(options.display.tone_map); },
    [](CompareOptions& options, int index) { options.display.tone_map = static_cast<ToneMap>(index); }};

const std::string kThresholdHelp =
    "fail with exit code 1 if this metric is worse than VALUE, which is above it or, of psnr and ssim, below: " +
    join(metricNames()) + "; may be repeated";
const std::string kHeatMapHelp = "write a picture of the difference, as " + writtenExtensions(Holds::picture, " or ");
const std::string kSheetHelp =
    "write A, B and the heat map side by side with the numbers, as " + writtenExtensions(Holds::picture, " or ");

OptionText ofLight(OptionText text, std::string_view help) {
  text.help = help;
  text.group = "Light";
  return text;
}

const auto kCompareOptions = std::to_array<Option<CompareOptions>>({
    {{.name = "threshold", .value = "METRIC=VALUE", .help = kThresholdHelp}, kThresholds},
    {{.name = "json", .help = "print JSON"}, &CompareOptions::json},
    {{.name = "pixels-per-degree",
      .value = "N",
      .minimum = kMinPixelsPerDegree,
      .maximum = 1000,
      .help =
          "how many pixels a degree of FLIP's observer has; the default is a display of 3840 pixels over 0.7 m, seen "
          "from 0.7 m",
      .also = "ppd"},
     &CompareOptions::pixels_per_degree},
    {{.name = "repair", .help = "replace NaN and infinite texels by the mean of their neighbours"},
     &CompareOptions::repair},
    {{.name = "resize", .help = "bring A to the size of B first, by the mean of what each of its pixels covers"},
     &CompareOptions::resize},
    {layerText(), &CompareOptions::layer},
    {kMaxMemoryText, kMemoryLimitField<CompareOptions>},
    {{.name = "heat-map", .value = "FILE", .help = kHeatMapHelp, .group = "Pictures", .takes_path = true},
     &CompareOptions::heat_map},
    {{.name = "sheet", .value = "FILE", .help = kSheetHelp, .group = "Pictures", .takes_path = true},
     &CompareOptions::sheet},
    {{.name = "map",
      .choices = "signed|flip",
      .aliases = "difference=signed",
      .help = "the heat map: signed shows the channel that differs most, red where A is above B and blue where it is "
              "below; flip shows how strongly an observer sees the difference",
      .group = "Pictures"},
     choiceField<&CompareOptions::map>},
    {{.name = "scale",
      .value = "X",
      .minimum = 0,
      .help =
          "difference that has the full colour in the signed heat map; 0: 1, 2 or 5 times a power of ten, so that 99 "
          "% of the pixels that differ visibly are within it",
      .group = "Pictures"},
     &CompareOptions::scale},
    {ofLight(exposureText(), "exposure at which psnr, ssim and the sheet see light, applied before its tone map"),
     kCompareExposure},
    {ofLight(toneMapText(), "curve by which psnr, ssim and the sheet see light"), kCompareToneMap},
});

/// One of the two files.
struct ComparedSide {
  std::string name;
  std::string format;
  ImageKind kind;
  bool has_several_pictures;
  ComparedImage image;
};

/// The picture of a file, or the layer of it that is asked for: of two files that are compared one may have a single
/// picture, which is none of the other's layers.
Result<DecodedImage> decodeCompared(const std::string& path, std::span<const std::uint8_t> bytes,
                                    const std::string& layer) {
  ImageReadOptions how{.layer = layer, .progress = progressBar("reading " + shown(path))};
  auto decoded = decodeImage(bytes, how);
  if (decoded || decoded.error().code != ErrorCode::not_found) return decoded;
  how.layer.clear();
  auto single = decodeImage(bytes, how);
  return single && single->layers.empty() ? std::move(single) : std::move(decoded);
}

Result<ComparedSide> readComparedSide(const std::string& path, const CompareOptions& options) {
  MIRRORBALL_TRY(bytes, readImageFile(path));
  MIRRORBALL_TRY(decoded, withName(path, decodeCompared(path, bytes, options.layer)));
  remarkOnPicture(path, decoded);
  const bool is_picture = holdsCodes(bytes) && decoded.gain_map != GainMapUse::applied;
  const ImageKind kind = is_picture ? ImageKind::picture : ImageKind::light;
  if (const NonFinite bad = findNonFinite(decoded.image); options.repair && bad.count > 0) {
    MIRRORBALL_TRY_VOID(withName(path, repairNonFinite(decoded.image)));
    remark(path + ": " + textOf(bad) + "; compared as the mean of their neighbours");
  }
  MIRRORBALL_TRY(image, withName(path, comparedImage(std::move(decoded.image), kind)));
  return ComparedSide{path, decoded.format, kind, !decoded.layers.empty(), std::move(image)};
}

/// errors   bad_shape: one is a picture, the other light
Result<void> refuseDifferentKinds(const ComparedSide& test, const ComparedSide& reference) {
  if (test.kind == reference.kind) return {};
  const auto told = [](const ComparedSide& side) {
    return side.name + " is " + (side.kind == ImageKind::light ? "linear light" : "a picture for a display") + " (" +
           side.format + ")";
  };
  return fail(ErrorCode::bad_shape,
              told(test) + " and " + told(reference) + "; their numbers mean different things: compare two of a kind");
}

/// errors   not_found: a layer was asked for, and neither file has several pictures
Result<void> refuseIdleLayer(const ComparedSide& test, const ComparedSide& reference, const CompareOptions& options) {
  if (options.layer.empty() || test.has_several_pictures || reference.has_several_pictures) return {};
  return fail(ErrorCode::not_found, test.name + " and " + reference.name + ": have no layers; leave --layer out");
}

/// Brings one image to the size of the other.
///
/// errors   too_large
Result<void> resizeTo(const ComparedImage& reference, ComparedSide& side) {
  const glm::ivec2 size(reference.light.width(), reference.light.height());
  const glm::ivec2 own(side.image.light.width(), side.image.light.height());
  if (own == size) return {};
  constexpr std::uint64_t kBytesOfPixel = 4 * sizeof(float);
  // What it is made of, and between the two what has the new width alone.
  MIRRORBALL_TRY_VOID(withName(
      side.name, checkMemory(kBytesOfPixel * std::uint64_t(size.x) * (std::uint64_t(size.y) + std::uint64_t(own.y)))));
  side.image.light = resized(side.image.light, size);
  if (!side.image.alpha.empty()) side.image.alpha = resized(side.image.alpha, size);
  remark(side.name + ": resized from " + sizeText(own) + " to " + sizeText(size));
  return {};
}

/// errors   usage: an option has nothing to act on
Result<void> refuseIdleCompareOptions(const CompareOptions& options, const GivenOptions& given) {
  const bool has_picture = !options.heat_map.empty() || !options.sheet.empty();
  for (const std::string_view name : {"map", "scale"})
    if (given.contains(name) && !has_picture)
      return fail(ErrorCode::usage,
                  "--" + std::string(name) + " is of a heat map, and none is written; add --heat-map or --sheet");
  if (given.contains("scale") && options.map == HeatMapKind::flip)
    return fail(ErrorCode::usage, "--scale is of the signed heat map; FLIP's goes from 0 to 1");
  return {};
}

/// errors   usage: how light is shown is said of pictures
Result<void> refuseOptionsOfLight(const ComparedSide& test, const GivenOptions& given) {
  for (const std::string_view name : {"exposure", "tone-map"})
    if (given.contains(name) && test.kind == ImageKind::picture)
      return fail(ErrorCode::usage,
                  "--" + std::string(name) + " is for light; " + test.name + " is a picture for a display already");
  return {};
}

/// Refuses pictures that cannot be written before anything is computed.
///
/// errors   usage; io
Result<void> checkOutputs(const std::vector<std::string>& inputs, const CompareOptions& options) {
  for (const std::string& output : {options.heat_map, options.sheet}) {
    if (output.empty()) continue;
    if (output.starts_with("-."))
      return fail(ErrorCode::usage, output + ": standard output has the numbers; name a file");
    MIRRORBALL_TRY_VOID(formatToWrite(output, {Holds::picture}));
    MIRRORBALL_TRY_VOID(checkFolder(output));
    MIRRORBALL_TRY_VOID(refuseOverwriting(inputs, std::span(&output, 1)));
  }
  if (!options.sheet.empty() && options.sheet == options.heat_map)
    return fail(ErrorCode::usage, options.sheet + ": cannot be both the heat map and the sheet; name two files");
  return {};
}

Result<void> writePictures(const ToldComparison& told) {
  const CompareOptions& options = told.options;
  if (!options.heat_map.empty()) {
    MIRRORBALL_TRY_VOID(savePicture(options.heat_map, heatMapOf(told.comparison, options.map, told.scale)));
    announce(options.heat_map);
  }
  if (!options.sheet.empty()) {
    const std::string map = options.map == HeatMapKind::flip ? "FLIP" : "A - B";
    const SheetText text{told.test, told.reference, map, linesOf(told)};
    MIRRORBALL_TRY_VOID(savePicture(options.sheet, comparisonSheet(told.comparison, options.map, told.scale, text)));
    announce(options.sheet);
  }
  return {};
}

/// errors   out_of_range: a metric is worse than its threshold; bad_shape: it has no value
Result<void> holdToThresholds(const ToldComparison& told) {
  std::vector<std::string> worse;
  for (const Threshold& threshold : told.options.thresholds) {
    const MetricText& text = textOf(threshold.metric);
    const auto& value = told.comparison.value(threshold.metric);
    // Of two opaque images the coverage is the same.
    if (!value && threshold.metric == Metric::alpha) continue;
    if (!value)
      return fail(ErrorCode::bad_shape, "has no " + std::string(text.label) +
                                            ", whose window of 11x11 pixels does not "
                                            "fit; leave its threshold out");
    if (isWorse(threshold.metric, *value, threshold.value))
      worse.push_back(std::string(text.label) + " is " + valueText(threshold.metric, *value) +
                      (text.higher_is_better ? " (at least " : " (at most ") +
                      valueText(threshold.metric, threshold.value) + ")");
  }
  if (worse.empty()) return {};
  return fail(ErrorCode::out_of_range, join(std::span<const std::string>(worse)));
}

void printComparison(const ToldComparison& told) {
  if (told.options.json) {
    print(jsonOf(told));
    return;
  }
  std::string text = printable(told.test) + " against " + printable(told.reference) + "\n";
  for (const std::string& line : linesOf(told)) text += "  " + line + "\n";
  const bool has_picture = !told.options.heat_map.empty() || !told.options.sheet.empty();
  if (has_picture && told.options.map == HeatMapKind::difference)
    text += "  map       full colour at a difference of " + formatNumber(double(told.scale)) + "\n";
  print(text);
}

Result<void> compare(const std::string& test_name, const std::string& reference_name, const CompareOptions& options,
                     const GivenOptions& given) {
  MIRRORBALL_TRY_VOID(refuseIdleCompareOptions(options, given));
  MIRRORBALL_TRY_VOID(checkOutputs({test_name, reference_name}, options));
  MIRRORBALL_TRY(test, readComparedSide(test_name, options));
  MIRRORBALL_TRY(reference, readComparedSide(reference_name, options));
  MIRRORBALL_TRY_VOID(refuseIdleLayer(test, reference, options));
  MIRRORBALL_TRY_VOID(refuseDifferentKinds(test, reference));
  MIRRORBALL_TRY_VOID(refuseOptionsOfLight(test, given));
  if (options.resize) MIRRORBALL_TRY_VOID(resizeTo(reference.image, test));

  const std::string names = test_name + " against " + reference_name;
  const ComparisonSettings settings{.pixels_per_degree = options.pixels_per_degree,
                                    .exposure = options.display.exposure(),
                                    .tone_map = static_cast<int>(options.display.tone_map)};
  MIRRORBALL_TRY(comparison, withName(names, compareImages(std::move(test.image), std::move(reference.image), test.kind,
                                                           settings, progressBar("comparing"))));
  if (comparison.value(Metric::alpha))
    remark(names + ": colours count by their coverage, which is compared by itself as alpha");
  const float scale = options.scale > 0.0f ? options.scale : usualScale(comparison.difference);
  const ToldComparison told{shown(test_name), shown(reference_name), options, std::move(comparison), scale};
  printComparison(told);
  MIRRORBALL_TRY_VOID(writePictures(told));
  return withName(names, holdToThresholds(told));
}

}  // namespace

std::span<const Option<CompareOptions>> compareOptions() { return kCompareOptions; }

Command compareCommand() {
  struct Request {
    std::string test;
    std::string reference;
    CompareOptions options;
    GivenOptions given;
  };
  auto request = std::make_shared<Request>();
  Command command{
      .name = "compare",
      .help = "Compares two pictures, or two images of light: RMSE, relMSE, PSNR, SSIM, FLIP",
      .about =
          "B is the reference. A and B are both pictures or both linear light, of one size (or --resize brings "
          "A to that of B). One of them may be - for standard input.",
      .examples = {{"compare a.png b.png --sheet sheet.png", "the numbers, and both with their difference on a sheet"},
                   {"compare a.exr truth.exr --threshold flip=0.05 --threshold psnr=40 --json",
                    "numbers for a program; exit code 1 if one is worse"}}};
  static const std::string formats = "(" + std::string(readExtensions()) + "), or - for standard input";
  addArgument(command,
              {.name = "A",
               .help = "the image to judge " + formats,
               .missing = "name the image to judge and its reference",
               .takes_path = true},
              request->test);
  addArgument(
      command,
      {.name = "B", .help = "the reference " + formats, .missing = "name the reference too", .takes_path = true},
      request->reference);
  addOptions(command, compareOptions(), request->options, &request->given);
  command.action = [request]() -> Result<void> {
    MIRRORBALL_TRY_VOID(readStandardInput({&request->test, &request->reference}));
    return compare(request->test, request->reference, request->options, request->given);
  };
  return command;
}

}  // namespace mirrorball::cli
