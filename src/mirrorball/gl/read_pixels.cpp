#include "mirrorball/gl/read_pixels.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include "formula/color.h"
#include "mirrorball/gl/gl_api.h"

namespace mirrorball::gl {
namespace {

using DecodeTable = std::array<float, 256>;

DecodeTable makeTable(bool srgb) {
  DecodeTable table;
  for (std::size_t code = 0; code < table.size(); ++code) {
    const float encoded = static_cast<float>(code) / 255.0f;
    table[code] = srgb ? formula::linearFromSrgb1(encoded) : encoded;
  }
  return table;
}

}  // namespace

Image8 readPixelBytes(int width, int height) {
  Image8 image(width, height, 4);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.samples().data());
  return image;
}

Image readPixelFloats(Format format, int width, int height) {
  Image image(width, height, 4);
  if (format == Format::rgba16f || format == Format::rgba32f || format == Format::r32f || format == Format::rg32f) {
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, image.samples().data());
    return image;
  }
  // OpenGL ES gives 8-bit pixels as bytes only, and neither API decodes sRGB here.
  const Image8 bytes = readPixelBytes(width, height);
  const DecodeTable color = makeTable(format == Format::srgb8_alpha8);
  const DecodeTable alpha = makeTable(false);
  for (std::size_t i = 0; i < bytes.samples().size(); ++i) {
    image.samples()[i] = (i % 4 == 3 ? alpha : color)[bytes.samples()[i]];
  }
  return image;
}

}  // namespace mirrorball::gl
