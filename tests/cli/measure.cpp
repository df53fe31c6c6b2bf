#include "cli/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "formula/color.h"
#include "mirrorball/render/settings/frame_settings.h"

namespace mirrorball::testing {
namespace {

glm::vec3 onDisplay(glm::vec3 light) {
  return glm::vec3(
      formula::displayed(glm::vec4(light, 1.0f), 1.0f, static_cast<int>(FrameSettings{}.display.tone_map)));
}

/// Calls visit(|a − b|) for every pair of samples; false when the images are not of one size and kind.
template <typename Visit>
bool forEachDifference(const Image& a, const Image& b, Visit&& visit) {
  if (a.width() != b.width() || a.height() != b.height() || a.channels() != b.channels()) return false;
  for (std::size_t i = 0; i < a.samples().size(); ++i) visit(std::abs(double(a.samples()[i]) - double(b.samples()[i])));
  return true;
}

}  // namespace

std::string uvFace(glm::vec3 light) {
  const float half = std::max({light.x, light.y, light.z}) / 2.0f;
  if (half <= 0.0f) return "black";
  constexpr std::array<const char*, 8> kNames{"black", "+X", "+Y", "-Z", "+Z", "-Y", "-X", "name"};
  return kNames[std::size_t(light.x > half) + 2 * std::size_t(light.y > half) + 4 * std::size_t(light.z > half)];
}

std::string uvFaceAt(const Image& image, glm::vec2 place) {
  const glm::ivec2 size(image.width(), image.height());
  const glm::ivec2 texel = glm::clamp(glm::ivec2(place * glm::vec2(size)), glm::ivec2(0), size - 1);
  return uvFace(rgbAt(image, texel.x, texel.y));
}

// A name's sign reaches from 0.59 to 0.09 left of a face's middle (an edge is 1 away), where no letter has a stroke on
// the right; its triangle from 0.74 to 0.88 above the middle, with nothing below. The places hit both also where a map
// shows equal angles at equal distances: there 0.55 of the way to an edge is 0.46 on the face, and 0.83 is 0.76.
std::string orientationOfName(const Image& image, glm::vec2 upper_left, glm::vec2 size) {
  const auto isWhite = [&](float right, float up) {
    return uvFaceAt(image, upper_left + size * glm::vec2(0.5f + right / 2.0f, 0.5f - up / 2.0f)) == "name";
  };
  const bool sign_left = isWhite(-0.55f, 0.0f);
  const bool sign_right = isWhite(0.55f, 0.0f);
  const bool mark_above = isWhite(0.0f, 0.83f);
  const bool mark_below = isWhite(0.0f, -0.83f);
  if (sign_left == sign_right || mark_above == mark_below) return "";
  if (mark_above) return sign_left ? "upright" : "mirrored";
  return sign_right ? "turned" : "mirrored and turned";
}

Environment displayed(const Environment& environment) {
  return Environment([environment](glm::vec3 d) { return onDisplay(environment.radiance(d)); },
                     environment.naturalSize(Projection::equirect));
}

double psnrOnDisplay(const Image& a, const Image& b, const std::function<bool(int, int)>& counts) {
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      if (!counts(x, y)) continue;
      const glm::vec3 difference = onDisplay(rgbAt(a, x, y)) - onDisplay(rgbAt(b, x, y));
      sum += double(glm::dot(difference, difference)) / 3.0;
      ++count;
    }
  return -10.0 * std::log10(sum / count);
}

Contents contentsOf(const Image& picture) {
  Contents contents;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const glm::vec4 texel = rgbaAt(picture, x, y);
      if (texel.w < 1.0f) continue;
      ++contents.texels;
      contents.mean += double(texel.x + texel.y + texel.z) / 3.0;
    }
  contents.mean /= std::max(contents.texels, 1);
  return contents;
}

double meanDifference(const Image& a, const Image& b) {
  double sum = 0.0;
  if (!forEachDifference(a, b, [&](double difference) { sum += difference; }))
    return std::numeric_limits<double>::infinity();
  return sum / static_cast<double>(a.samples().size());
}

double maxDifference(const Image& a, const Image& b) {
  double max = 0.0;
  if (!forEachDifference(a, b, [&](double difference) { max = std::max(max, difference); }))
    return std::numeric_limits<double>::infinity();
  return max;
}

}  // namespace mirrorball::testing
