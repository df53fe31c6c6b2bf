#include "mirrorball/codec/color/display.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "formula/color.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/image_format.h"

namespace mirrorball {

float Display::exposure() const { return std::exp2(exposure_ev); }

OptionText exposureText() {
  static const std::string help =
      "exposure of a picture (" + writtenExtensions(Holds::picture) + "), applied before its tone map";
  return {.name = "exposure",
          .value = "EV",
          .unit = "stops",
          .minimum = -30,
          .maximum = 30,
          .help = help,
          .group = "Picture",
          .is_daily = true,
          .soft_minimum = -8,
          .soft_maximum = 8,
          .step = 0.1,
          .is_number = true};
}

OptionText toneMapText() {
  static const std::string help =
      "curve by which radiance becomes a picture (" + writtenExtensions(Holds::picture) + ")";
  return {.name = "tone-map",
          .choices = "agx|aces|neutral|reinhard|linear",
          .help = help,
          .group = "Picture",
          .is_daily = true,
          .soft_minimum = -8,
          .soft_maximum = 8,
          .step = 0.1,
          .is_number = true};
}

OptionText ditherText() {
  static const std::string help =
      "how a picture of 8 bits (" + writtenExtensions(Holds::picture) +
      ") shows light between two of its codes: pattern has a fixed pattern of both, so that a soft gradient has no "
      "visible steps; none takes the nearest. Alpha is never dithered";
  return {.name = "dither", .choices = "none|pattern", .help = help, .group = "Picture"};
}

OptionText gainMapText() {
  return {.name = "gain-map",
          .help =
              "write a .jpg with a gain map beside its picture (Ultra HDR, ISO 21496-1): readers that know of "
              "it, this program among them, have the light that is brighter than white",
          .group = "Picture"};
}

Image lightOnDisplay(const Display& display, const Image& image, glm::vec4 backdrop) {
  const float exposure = display.exposure();
  Image light = Image::withoutValues(image.width(), image.height(), 3);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const glm::vec4 texel = rgbaAt(image, x, y) * glm::vec4(exposure, exposure, exposure, 1.0f);
      const glm::vec4 whole = formula::laidOver(texel, backdrop);
      std::copy_n(&whole.x, 3, light.texel(x, y));
    }
  return light;
}

void showOn(const Display& display, Image& image) {
  constexpr std::size_t kRowsPerPiece = 16;
  const float exposure = display.exposure();
  const int curve = static_cast<int>(display.tone_map);
  const auto colors = std::min(image.channels(), 3);
  parallelFor(std::size_t(image.height()), kRowsPerPiece, [&](std::size_t begin, std::size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const glm::vec4 light = formula::displayLight(rgbaAt(image, x, y), exposure, curve);
        const glm::vec3 straight = light.w > 0.0f ? glm::vec3(light) / light.w : glm::vec3(0.0f);
        std::copy_n(&straight.x, colors, image.texel(x, y));
      }
  });
}

Image displayedLight(const Display& display, Image image, glm::vec4 backdrop) {
  showOn(display, image);
  for (int y = 0; backdrop.w > 0.0f && y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const glm::vec4 texel = rgbaAt(image, x, y);
      const glm::vec4 over(glm::mix(glm::vec3(backdrop), glm::vec3(texel), texel.w), 1.0f);
      std::copy_n(&over.x, 4, image.texel(x, y));
    }
  return image;
}

Image8 displayedPicture(const Display& display, Image image, glm::vec4 backdrop) {
  return pictureFromLinear(displayedLight(display, std::move(image), backdrop), 4, display.dither);
}

void layOver(Image& image, glm::vec4 backdrop) {
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const glm::vec4 texel = formula::laidOver(rgbaAt(image, x, y), backdrop);
      std::copy_n(&texel.x, 4, image.texel(x, y));
    }
}

}  // namespace mirrorball
