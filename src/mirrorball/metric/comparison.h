#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"
#include "mirrorball/metric/flip/flip.h"

namespace mirrorball {

/// What there is to know of how far two images are apart; a metric's number is its place in kMetrics.
enum class Metric { rmse, relmse, psnr, ssim, flip, alpha };

struct MetricText {
  Metric metric;
  std::string_view name;         ///< "psnr": in options and JSON
  std::string_view label;        ///< "PSNR"
  std::string_view unit;         ///< "dB"; empty for a pure number
  bool higher_is_better;         ///< else lower is
  std::string_view of_pictures;  ///< what it compares of two pictures
  std::string_view of_light;     ///< what of two images of light
};

/// The one table of metrics.
inline constexpr std::array<MetricText, 6> kMetrics{{
    {Metric::rmse, "rmse", "RMSE", "", false, "of encoded values, 0 to 1", "of radiance"},
    {Metric::relmse, "relmse", "relMSE", "", false, "of linear light", "of radiance"},
    {Metric::psnr, "psnr", "PSNR", "dB", true, "of encoded values", "as tone mapped"},
    {Metric::ssim, "ssim", "SSIM", "", true, "of luma, at most 1", "of luma as tone mapped, at most 1"},
    {Metric::flip, "flip", "FLIP", "", false, "LDR-FLIP, 0 to 1", "HDR-FLIP, 0 to 1"},
    {Metric::alpha, "alpha", "alpha", "", false, "RMSE of coverage", "RMSE of coverage"},
}};

constexpr const MetricText& textOf(Metric metric) { return kMetrics[static_cast<std::size_t>(metric)]; }

/// Whether one value of a metric is worse than another.
constexpr bool isWorse(Metric metric, double value, double than) {
  return textOf(metric).higher_is_better ? value < than : value > than;
}

/// "31.4 dB", "0.00215", "infinite"
std::string valueText(Metric metric, double value);

/// What the samples of an image stand for.
enum class ImageKind {
  picture,  ///< what a display shows: linear light in [0, 1], decoded from codes
  light,    ///< radiance of any size
};

/// One of two images to compare.
struct ComparedImage {
  Image light;  ///< 3 channels of linear light, over black where the image is transparent
  Image alpha;  ///< its coverage, one channel; empty where the image is opaque
};

/// Takes an image apart.
///
/// image    as readImage gives it: alpha straight in a picture, premultiplied in light
/// errors   non_finite (how many texels, and the first)
Result<ComparedImage> comparedImage(Image image, ImageKind kind);

struct ComparisonSettings {
  float pixels_per_degree = kUsualPixelsPerDegree;  ///< for FLIP, at least kMinPixelsPerDegree
  // How PSNR and SSIM see light: as formula::displayLight shows it.
  float exposure = 1.0f;  ///< factor on the radiance
  int tone_map = 2;       ///< formula::toneMap's number; the neutral one
};

/// Two images compared.
struct Comparison {
  ImageKind kind = ImageKind::picture;
  std::array<std::optional<double>, kMetrics.size()>
      values;                  ///< nothing: SSIM of what is smaller than its window, alpha
                               ///< of opaque images
  glm::ivec2 worst{0};         ///< the pixel with the greatest difference of a channel
  glm::vec3 test_at_worst{0};  ///< encoded values of pictures, radiance of light
  glm::vec3 reference_at_worst{0};
  glm::ivec2 worst_flip{0};  ///< the pixel with the greatest FLIP
  float max_flip = 0.0f;
  ExposureRange exposures;  ///< of HDR-FLIP
  Image flip;               ///< FLIP of each pixel, one channel
  Image difference;         ///< signedDifference of the values that RMSE compares
  Image shown_test;         ///< both as a display shows them, encoded, in [0, 1]
  Image shown_reference;

  const std::optional<double>& value(Metric metric) const { return values[static_cast<std::size_t>(metric)]; }
};

/// Compares a test with its reference by every metric. docs/metrics.md defines them.
///
/// errors   bad_shape (both sizes); interrupted
/// cost     0.6 µs a pixel on one core for pictures; for light FLIP's part (0.5 µs) for each exposure. Memory for eight
///          floats a pixel besides the images; bit-identical for any number of threads
Result<Comparison> compareImages(ComparedImage test, ComparedImage reference, ImageKind kind,
                                 const ComparisonSettings& settings = {}, const ProgressFunction& progress = {});

}  // namespace mirrorball
