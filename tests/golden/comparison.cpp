#include "golden/comparison.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "mirrorball/base/text.h"
#include "mirrorball/metric/image_error.h"
#include "mirrorball/metric/picture/side_by_side.h"

namespace mirrorball::golden {
namespace {

constexpr int kGap_px = 4;
constexpr std::uint8_t kGrey = 128;
constexpr float kMagnification = 8.0f;

bool haveSameSize(const Image8& a, const Image8& b) { return a.width() == b.width() && a.height() == b.height(); }

/// Colour times coverage, and coverage, in codes.
glm::vec4 premultiplied(const std::uint8_t* texel) {
  const float alpha = texel[3];
  return glm::vec4(glm::vec3(texel[0], texel[1], texel[2]) * (alpha / 255.0f), alpha);
}

/// What is compared of a picture.
Image premultiplied(const Image8& picture) {
  Image codes = Image::withoutValues(picture.width(), picture.height(), 4);
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const glm::vec4 texel = premultiplied(picture.texel(x, y));
      std::copy_n(&texel.x, 4, codes.texel(x, y));
    }
  return codes;
}

void setTexel(Image8& picture, int x, int y, glm::vec3 codes) {
  const glm::vec3 rounded = glm::round(glm::clamp(codes, 0.0f, 255.0f));
  for (int channel = 0; channel < 3; ++channel)
    picture.texel(x, y)[channel] = static_cast<std::uint8_t>(rounded[channel]);
}

Image8 onGrey(const Image8& picture) {
  Image8 panel(picture.width(), picture.height(), 3);
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const glm::vec4 codes = premultiplied(picture.texel(x, y));
      setTexel(panel, x, y, glm::vec3(codes) + (1.0f - codes.w / 255.0f) * float(kGrey));
    }
  }
  return panel;
}

/// A difference of coverage shows in all three channels.
Image8 magnifiedDifference(const Image8& golden, const Image8& now) {
  Image8 panel(golden.width(), golden.height(), 3);
  for (int y = 0; y < golden.height(); ++y) {
    for (int x = 0; x < golden.width(); ++x) {
      const glm::vec4 codes = glm::abs(premultiplied(now.texel(x, y)) - premultiplied(golden.texel(x, y)));
      setTexel(panel, x, y, kMagnification * glm::max(glm::vec3(codes), glm::vec3(codes.w)));
    }
  }
  return panel;
}

}  // namespace

std::string textOf(const Difference& difference) {
  return formatNumber(difference.maximum) + " at (" + std::to_string(difference.worst.x) + ", " +
         std::to_string(difference.worst.y) + "), " + formatNumber(difference.mean) + " in the mean";
}

Difference differenceOf(const Image8& golden, const Image8& now) {
  assert(haveSameSize(golden, now) && golden.channels() == 4 && now.channels() == 4);
  const ImageError error = imageError(premultiplied(now), premultiplied(golden));
  return {.maximum = double(error.max), .mean = error.mean_of_worst, .worst = error.worst};
}

bool isWithin(const Difference& difference, const Tolerance& tolerance) {
  return difference.maximum <= tolerance.maximum && difference.mean <= tolerance.mean;
}

Image8 contactSheet(const Image8& golden, const Image8& now) {
  std::vector<Image8> panels{onGrey(golden), onGrey(now)};
  if (haveSameSize(golden, now)) panels.push_back(magnifiedDifference(golden, now));
  return sideBySide(panels, kGap_px, kGrey);
}

}  // namespace mirrorball::golden
