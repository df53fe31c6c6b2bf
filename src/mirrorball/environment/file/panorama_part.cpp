#include "mirrorball/environment/file/panorama_part.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "mirrorball/base/parallel.h"
#include "mirrorball/base/size_text.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/picture_window.h"
#include "mirrorball/environment/environment_map.h"
#include "mirrorball/environment/fill.h"
#include "mirrorball/image/filter.h"

namespace mirrorball {
namespace {

constexpr std::size_t kPanoramaRowsPerPiece = 16;

/// Both numbers of "512x256".
std::optional<glm::dvec2> twoNumbers(std::string_view text) {
  const std::vector<std::string> parts = split(text, 'x');
  if (parts.size() != 2) return std::nullopt;
  const auto first = parseNumber(parts[0]), second = parseNumber(parts[1]);
  if (!first || !second) return std::nullopt;
  return glm::dvec2(*first, *second);
}

/// A number of texels: whole, and no larger than sizes may be.
std::optional<int> texelsIn(double number) {
  constexpr double kMost = 1 << 24;
  if (number != std::floor(number) || std::abs(number) > kMost) return std::nullopt;
  return static_cast<int>(number);
}

std::optional<glm::ivec2> texelsIn(const std::optional<glm::dvec2>& numbers) {
  if (!numbers) return std::nullopt;
  const auto x = texelsIn(numbers->x), y = texelsIn(numbers->y);
  if (!x || !y) return std::nullopt;
  return glm::ivec2(*x, *y);
}

/// The area in "X,Y,W,H/FULLWxFULLH".
std::optional<PanoramaArea> areaIn(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  std::vector<int> numbers;
  for (const std::string& word : split(text.substr(0, slash), ',')) {
    const auto number = parseNumber(word);
    const auto texels = number ? texelsIn(*number) : std::nullopt;
    if (!texels) return std::nullopt;
    numbers.push_back(*texels);
  }
  const auto whole = texelsIn(twoNumbers(text.substr(slash + 1)));
  if (numbers.size() != 4 || !whole) return std::nullopt;
  return PanoramaArea{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}, *whole};
}

Result<PanoramaPart> partAroundMiddle(std::string_view word, const std::optional<glm::dvec2>& degrees) {
  if (!degrees || degrees->x <= 0.0 || degrees->x > 360.0 || degrees->y <= 0.0 || degrees->y > 180.0)
    return fail(
        ErrorCode::usage,
        "'" + excerpt(word) + "' should be a field of view: fov=HxV in degrees, at most 360x180, as in fov=360x90");
  const glm::dvec2 half = 0.5 * *degrees / glm::dvec2(360.0, 180.0);
  return PanoramaPart{0.5 - half, 0.5 + half};
}

/// Whether a number of texels is whole but for rounding.
bool isWholeNumber(double texels) { return std::abs(texels - std::round(texels)) < 1e-3; }

/// The panorama that has the picture's own texels, or nothing where they lie between those of every panorama.
std::optional<glm::ivec2> cornerOnTexels(glm::ivec2 picture, const PanoramaPart& part, int height) {
  const glm::dvec2 whole(2 * height, height);
  const glm::dvec2 begin = part.begin * whole, extent = (part.end - part.begin) * whole;
  if (!isWholeNumber(begin.x) || !isWholeNumber(begin.y)) return std::nullopt;
  if (std::abs(extent.x - picture.x) > 1e-3 || std::abs(extent.y - picture.y) > 1e-3) return std::nullopt;
  return glm::ivec2(glm::round(begin));
}

/// Interpolates a picture's light at the centres of those of a panorama's texels that lie in its part.
void resampleInto(const Image& picture, const PanoramaPart& part, Image& panorama) {
  const bool goes_round = part.goesRound();
  const glm::dvec2 whole(panorama.width(), panorama.height());
  const glm::dvec2 size(picture.width(), picture.height());
  const auto around = [&](int x, int y) {
    const int column = goes_round ? (x + picture.width()) % picture.width() : std::clamp(x, 0, picture.width() - 1);
    return glm::vec4(rgbAt(picture, column, std::clamp(y, 0, picture.height() - 1)), 1.0f);
  };
  parallelFor(std::size_t(panorama.height()), kPanoramaRowsPerPiece, [&](std::size_t begin, std::size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      for (int x = 0; x < panorama.width(); ++x) {
        const glm::dvec2 share = (glm::dvec2(x, y) + 0.5) / whole;
        glm::dvec2 place = (share - part.begin) / (part.end - part.begin) * size;
        if (goes_round && place.x < 0.0) place.x += size.x;
        if (place.x < 0.0 || place.y < 0.0 || place.x > size.x || place.y > size.y) continue;
        const glm::vec4 light = bicubic(glm::vec2(place), around);
        std::copy_n(&light.x, 3, panorama.texel(x, y));
      }
  });
}

/// What of a window lies within the whole: its first texel, and the one behind its last.
std::pair<glm::ivec2, glm::ivec2> knownTexels(const PictureWindow& window) {
  const glm::ivec2 size = window.size == glm::ivec2(0) ? window.whole : window.size;
  return {glm::max(window.corner, glm::ivec2(0)), glm::min(window.corner + size, window.whole)};
}

std::string notTwoToOneText(const PanoramaArea& area) {
  return sizeText(area.size) + " of a panorama of " + sizeText(area.whole) + ", and a whole panorama is 2:1";
}

}  // namespace

bool isNearlyWholePanorama(glm::ivec2 size) {
  // Two rows off are four columns off. Of small pictures that may be another form.
  constexpr int kMostColumns = 4, kSmallest = 128;
  const int off = std::abs(size.x - 2 * size.y);
  return off == 0 || (off <= kMostColumns && size.x >= kSmallest);
}

Result<PanoramaPart> panoramaPart(const PanoramaArea& area) {
  if (isStrip(area)) return fail(ErrorCode::bad_shape, notTwoToOneText(area));
  return panoramaPartOfStrip(area);
}

bool isStrip(const PanoramaArea& area) {
  return area.whole.x - 2 * std::int64_t{area.whole.y} > area.whole.x / 100 + 2;
}

Result<PanoramaPart> panoramaPartOfStrip(const PanoramaArea& area) {
  const auto [corner, size, whole] = area;
  const bool is_too_high = 2 * std::int64_t{whole.y} - whole.x > whole.x / 100 + 2;
  if (size.x < 1 || size.y < 1 || whole.x < 2 || whole.y < 1 || is_too_high)
    return fail(ErrorCode::bad_shape, notTwoToOneText(area));
  if (corner.x < 0 || corner.x >= whole.x || corner.y < 0 || size.x > whole.x || size.y > whole.y - corner.y)
    return fail(ErrorCode::bad_shape, sizeText(size) + " at (" + std::to_string(corner.x) + ", " +
                                          std::to_string(corner.y) + "), which reaches beyond a panorama of " +
                                          sizeText(whole));
  if (!isStrip(area))
    return PanoramaPart{glm::dvec2(corner) / glm::dvec2(whole), glm::dvec2(corner + size) / glm::dvec2(whole)};
  const glm::dvec2 sphere(whole.x, 0.5 * whole.x);
  const glm::dvec2 first = glm::dvec2(corner) + glm::dvec2(0.0, 0.5 * (sphere.y - whole.y));
  return PanoramaPart{first / sphere, (first + glm::dvec2(size)) / sphere};
}

Result<PanoramaPart> panoramaPartNamed(std::string_view word) {
  const std::string_view value = word.substr(std::min(word.find('=') + 1, word.size()));
  if (word.starts_with("fov=")) return partAroundMiddle(word, twoNumbers(value));
  const auto area = areaIn(value);
  if (!area)
    return fail(ErrorCode::usage, "'" + excerpt(word) +
                                      "' should be a part of a panorama: crop=X,Y,W,H/FULLWxFULLH in texels, as in "
                                      "crop=0,1024,8192,2048/8192x4096, or crop=none");
  auto part = panoramaPart(*area);
  if (part) return part;
  return fail(ErrorCode::usage, "'" + excerpt(word) + "' is " + part.error().message);
}

std::optional<int> heightOfWhole(glm::ivec2 picture, const PanoramaPart& part) {
  constexpr double kMostOff = 0.03, kMostHeight = 1 << 29;
  const glm::dvec2 whole = glm::dvec2(picture) / (part.end - part.begin);
  const double by_width = 0.5 * whole.x;
  if (std::abs(by_width - whole.y) > kMostOff * whole.y || std::max(by_width, whole.y) > kMostHeight)
    return std::nullopt;
  return std::max(static_cast<int>(std::ceil(std::max(by_width, whole.y) - 1e-3)), 1);
}

std::string textOf(const PanoramaPart& part) {
  const glm::dvec2 degrees = (part.end - part.begin) * glm::dvec2(360.0, 180.0);
  const auto rounded = [](double angle) { return formatNumber(std::round(10.0 * angle) / 10.0); };
  return rounded(degrees.x) + " x " + rounded(degrees.y) + " degrees";
}

double shareOfSphere(const PictureWindow& window, bool goes_round) {
  auto [begin, end] = knownTexels(window);
  if (goes_round) end.x = begin.x + std::min(window.size.x, window.whole.x);
  if (begin.x >= end.x || begin.y >= end.y) return 0.0;
  const double row = std::numbers::pi / window.whole.y;
  return double(end.x - begin.x) / window.whole.x * 0.5 * (std::cos(begin.y * row) - std::cos(end.y * row));
}

PictureWindow windowInPanorama(const PictureWindow& window, const PanoramaPart& part, glm::ivec2 whole) {
  const auto [first, last] = knownTexels(window);
  const auto texelAt = [&, part](glm::ivec2 corner) {
    const glm::dvec2 share = glm::dvec2(corner) / glm::dvec2(window.whole);
    return glm::ivec2(glm::round((part.begin + share * (part.end - part.begin)) * glm::dvec2(whole)));
  };
  PictureWindow placed{.whole = whole, .corner = texelAt(first), .source = window.source};
  placed.size = glm::max(texelAt(glm::max(first, last)) - placed.corner, glm::ivec2(1));
  return placed;
}

void turnColumns(Image& panorama, int columns) {
  const std::ptrdiff_t kept = std::ptrdiff_t{panorama.width() - columns} * panorama.channels();
  for (int y = 0; y < panorama.height(); ++y)
    std::rotate(panorama.row(y).begin(), panorama.row(y).begin() + kept, panorama.row(y).end());
}

Result<Image> placedInPanorama(Image picture, const PanoramaPart& part, PictureWindow& window) {
  const glm::ivec2 size(picture.width(), picture.height());
  const auto height = heightOfWhole(size, part);
  if (!height) return fail(ErrorCode::bad_shape, "has not the proportion of its part of a panorama");
  window.whole = {2 * *height, *height};
  MIRRORBALL_TRY_VOID(checkDimensions(window.whole.x, window.whole.y));
  const auto corner = cornerOnTexels(size, part, *height);
  const int channels = corner ? picture.channels() : 3;
  MIRRORBALL_TRY_VOID(checkImageMemory(window.whole.x, window.whole.y, channels));
  if (corner) {
    window.corner = *corner;
    window.size = size;
    return placedInWindow(picture, window);
  }
  window.corner = glm::ivec2(glm::round(part.begin * glm::dvec2(window.whole)));
  window.size = glm::ivec2(glm::round(part.end * glm::dvec2(window.whole))) - window.corner;
  Image panorama(window.whole.x, window.whole.y, channels);
  resampleInto(picture, part, panorama);
  return panorama;
}

Result<void> fillAround(const PictureWindow& known, Image& panorama) {
  constexpr int kFaceTexels = 64;
  const auto [begin, end] = knownTexels(known);
  const glm::ivec2 extent(panorama.width(), panorama.height());
  const bool goes_round = end.x - begin.x == extent.x;
  // Interpolation takes nothing from beyond the edge where it keeps half a texel away from it.
  const auto lightTowards = [&, first = begin, last = end](glm::vec3 direction) -> std::optional<glm::vec3> {
    const glm::vec2 at = positionOf(Projection::equirect, direction).uv * glm::vec2(extent);
    const glm::vec2 margin(goes_round ? 0.0f : 0.5f, 0.5f);
    const glm::vec2 low = glm::vec2(first) + margin, high = glm::vec2(last) - margin;
    const bool is_known =
        at.x >= low.x && at.x <= high.x && (at.y >= low.y || first.y == 0) && (at.y <= high.y || last.y == extent.y);
    if (!is_known) return std::nullopt;
    return glm::vec3(bilinear(at, [&](int x, int y) {
      return glm::vec4(rgbAt(panorama, (x + extent.x) % extent.x, std::clamp(y, first.y, last.y - 1)), 1.0f);
    }));
  };
  auto continued = continueSmoothly(lightTowards, kFaceTexels);
  if (!continued) return fail(ErrorCode::bad_shape, "shows too little of the sphere to be continued into the rest");
  parallelFor(std::size_t(extent.y), kPanoramaRowsPerPiece,
              [&, first = begin, last = end](std::size_t y, std::size_t end_y) {
                for (; y < end_y; ++y)
                  for (int x = 0; x < extent.x; ++x) {
                    const glm::ivec2 texel(x, static_cast<int>(y));
                    if (glm::all(glm::greaterThanEqual(texel, first)) && glm::all(glm::lessThan(texel, last))) continue;
                    const glm::vec2 uv = (glm::vec2(texel) + 0.5f) / glm::vec2(extent);
                    const glm::vec3 light = continued->radiance(directionAt(Projection::equirect, {0, uv}));
                    for (int c = 0; c < panorama.channels(); ++c)
                      panorama.texel(x, texel.y)[c] = c < 3 ? light[c] : 1.0f;
                  }
              });
  return {};
}

}  // namespace mirrorball
