#include "mirrorball/metric/comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "formula/color.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/base/size_text.h"
#include "mirrorball/metric/image_error.h"
#include "mirrorball/metric/ssim.h"

namespace mirrorball {
namespace {

constexpr std::size_t kRowsPerConversion = 16;

static_assert([] {
  for (std::size_t i = 0; i < kMetrics.size(); ++i)
    if (static_cast<std::size_t>(kMetrics[i].metric) != i) return false;
  return true;
}());

/// Calls `change(texel)` for the three channels of every texel.
template <typename Change>
void changeColors(Image& image, const Change& change) {
  parallelFor(std::size_t(image.height()), kRowsPerConversion, [&](std::size_t begin, std::size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const glm::vec3 changed = change(rgbAt(image, x, y));
        std::copy_n(&changed.x, 3, image.texel(x, y));
      }
  });
}

/// Brings light to what a display shows of it, encoded.
void showOnDisplay(Image& light, ImageKind kind, const ComparisonSettings& settings) {
  if (kind == ImageKind::picture)
    changeColors(light, [](glm::vec3 c) { return formula::srgbFromLinear(glm::clamp(c, 0.0f, 1.0f)); });
  else
    changeColors(light, [&](glm::vec3 c) {
      return glm::vec3(formula::displayed(glm::vec4(c, 1.0f), settings.exposure, settings.tone_map));
    });
}

/// The coverage of an image, 1 where it is opaque; empty if it is so everywhere.
Image coverageOf(const Image& image) {
  if (image.channels() != 4) return {};
  Image alpha = Image::withoutValues(image.width(), image.height(), 1);
  bool is_opaque = true;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      *alpha.texel(x, y) = image.texel(x, y)[3];
      is_opaque = is_opaque && image.texel(x, y)[3] == 1.0f;
    }
  return is_opaque ? Image() : alpha;
}

std::optional<double> errorOfAlpha(Image test, Image reference) {
  if (test.empty() && reference.empty()) return {};
  if (test.empty()) test = Image(reference.width(), reference.height(), 1, 1.0f);
  if (reference.empty()) reference = Image(test.width(), test.height(), 1, 1.0f);
  return std::sqrt(imageError(test, reference).mean_square);
}

double meanOf(const Image& map) {
  double sum = 0.0;
  for (const float sample : map.samples()) sum += double(sample);
  return sum / static_cast<double>(map.texelCount());
}

/// RMSE with the pixel that is farthest apart, of what the images hold now.
void measure(Comparison& comparison, const ImageError& error, const Image& test, const Image& reference) {
  comparison.values[static_cast<std::size_t>(Metric::rmse)] = std::sqrt(error.mean_square);
  comparison.worst = error.worst;
  comparison.test_at_worst = rgbAt(test, error.worst.x, error.worst.y);
  comparison.reference_at_worst = rgbAt(reference, error.worst.x, error.worst.y);
  comparison.difference = signedDifference(test, reference);
}

Result<void> measureFlip(Comparison& comparison, const Image& test, const Image& reference, float pixels_per_degree,
                         const ProgressFunction& progress) {
  if (comparison.kind == ImageKind::picture) {
    MIRRORBALL_TRY(flip, ldrFlip(test, reference, pixels_per_degree, progress));
    comparison.flip = std::move(flip);
  } else {
    comparison.exposures = exposureRangeOf(reference);
    MIRRORBALL_TRY(flip, hdrFlip(test, reference, comparison.exposures, pixels_per_degree, progress));
    comparison.flip = std::move(flip);
  }
  const auto errors = comparison.flip.samples();
  const auto worst = std::size_t(std::max_element(errors.begin(), errors.end()) - errors.begin());
  const auto width = std::size_t(test.width());
  comparison.max_flip = errors[worst];
  comparison.worst_flip = {static_cast<int>(worst % width), static_cast<int>(worst / width)};
  comparison.values[static_cast<std::size_t>(Metric::flip)] = meanOf(comparison.flip);
  return {};
}

}  // namespace

std::string valueText(Metric metric, double value) {
  if (std::isinf(value)) return "infinite";
  char text[32];
  std::snprintf(text, sizeof(text), metric == Metric::psnr ? "%.2f" : "%.5g", value);
  const std::string_view unit = textOf(metric).unit;
  return text + (unit.empty() ? "" : " " + std::string(unit));
}

Result<ComparedImage> comparedImage(Image image, ImageKind kind) {
  if (const NonFinite bad = findNonFinite(image); bad.count > 0)
    return fail(ErrorCode::non_finite, textOf(bad), FixHint::repair);
  ComparedImage compared{{}, coverageOf(image)};
  compared.light = rgbOf(image);
  if (kind == ImageKind::picture && !compared.alpha.empty())
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        for (int channel = 0; channel < 3; ++channel)
          compared.light.texel(x, y)[channel] *= *compared.alpha.texel(x, y);
  return compared;
}

Result<Comparison> compareImages(ComparedImage test, ComparedImage reference, ImageKind kind,
                                 const ComparisonSettings& settings, const ProgressFunction& progress) {
  const glm::ivec2 size(test.light.width(), test.light.height());
  const glm::ivec2 size_of_reference(reference.light.width(), reference.light.height());
  if (size != size_of_reference)
    return fail(ErrorCode::bad_shape,
                "their sizes differ, " + sizeText(size) + " and " + sizeText(size_of_reference) +
                    "; bring them to one size first",
                FixHint::resize);
  Comparison comparison;
  comparison.kind = kind;
  const auto set = [&](Metric metric, std::optional<double> value) {
    comparison.values[static_cast<std::size_t>(metric)] = value;
  };
  set(Metric::alpha, errorOfAlpha(std::move(test.alpha), std::move(reference.alpha)));

  // Of light first, since then it is brought to the display in its place.
  const ImageError of_light = imageError(test.light, reference.light);
  set(Metric::relmse, of_light.relative_mean_square);
  if (kind == ImageKind::light) measure(comparison, of_light, test.light, reference.light);
  constexpr std::size_t kSteps = 100;  // of which FLIP takes nearly all
  MIRRORBALL_TRY_VOID(measureFlip(comparison, test.light, reference.light, settings.pixels_per_degree,
                                  partOf(progress, 0, kSteps - 5, kSteps)));

  showOnDisplay(test.light, kind, settings);
  showOnDisplay(reference.light, kind, settings);
  const ImageError as_shown = imageError(test.light, reference.light);
  if (kind == ImageKind::picture) measure(comparison, as_shown, test.light, reference.light);
  set(Metric::psnr, peakSignalToNoise_db(as_shown.mean_square));
  MIRRORBALL_TRY(ssim, structuralSimilarity(test.light, reference.light, partOf(progress, kSteps - 5, 5, kSteps)));
  set(Metric::ssim, ssim);
  comparison.shown_test = std::move(test.light);
  comparison.shown_reference = std::move(reference.light);
  return comparison;
}

}  // namespace mirrorball
