#include "mirrorball/gl/texture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "formula/color.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/half.h"
#include "mirrorball/gl/read_pixels.h"
#include "mirrorball/gl/sampling_parameters.h"

namespace mirrorball::gl {
namespace {

constexpr int kWorkUnit = Texture::kUnits;  // the last one that OpenGL ES 3.0 promises
constexpr std::uint16_t kHalfOne = 0x3c00;

GLenum internalFormat(Format format) {
  switch (format) {
    case Format::rgba8:
      return GL_RGBA8;
    case Format::srgb8_alpha8:
      return GL_SRGB8_ALPHA8;
    case Format::rgba16f:
      return GL_RGBA16F;
    case Format::rgba32f:
      return GL_RGBA32F;
    case Format::r32f:
      return GL_R32F;
    case Format::rg32f:
      return GL_RG32F;
    case Format::depth24:
      return GL_DEPTH_COMPONENT24;
    case Format::depth24_stencil8:
      return GL_DEPTH24_STENCIL8;
    case Format::rgba32ui:
      return GL_RGBA32UI;
  }
  assert(false && "no such format");
  return GL_RGBA8;
}

bool isDepth(Format format) { return format == Format::depth24 || format == Format::depth24_stencil8; }

int channelsOf(Format format) {
  return format == Format::r32f || isDepth(format) ? 1 : format == Format::rg32f ? 2 : 4;
}

/// Whether OpenGL ES cannot filter it.
bool isUnfiltered(Format format) {
  return format == Format::rgba32f || format == Format::r32f || format == Format::rg32f || isDepth(format) ||
         format == Format::rgba32ui;
}

bool isEightBit(Format format) { return format == Format::rgba8 || format == Format::srgb8_alpha8; }

/// The type of one component as it is handed to OpenGL.
template <typename Component>
constexpr GLenum kComponentType = GL_UNSIGNED_BYTE;
template <>
constexpr GLenum kComponentType<std::uint16_t> = GL_HALF_FLOAT;
template <>
constexpr GLenum kComponentType<float> = GL_FLOAT;

/// Spreads texels of 1, 3 or 4 channels to four.
template <typename Sample>
void expandRow(std::span<const Sample> row, int channels, Sample opaque, std::span<Sample> rgba) {
  assert(channels == 1 || channels == 3 || channels == 4);
  const std::size_t step = static_cast<std::size_t>(channels);
  const std::size_t green = channels == 1 ? 0 : 1;
  const std::size_t blue = channels == 1 ? 0 : 2;
  for (std::size_t from = 0, to = 0; from < row.size(); from += step, to += 4) {
    rgba[to] = row[from];
    rgba[to + 1] = row[from + green];
    rgba[to + 2] = row[from + blue];
    rgba[to + 3] = channels == 4 ? row[from + 3] : opaque;
  }
}

std::uint8_t byteFromUnit(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

void encodeRow(std::span<const float> rgba, bool srgb, std::span<std::uint8_t> bytes) {
  for (std::size_t i = 0; i < rgba.size(); ++i) {
    const bool curved = srgb && i % 4 != 3;
    bytes[i] = byteFromUnit(curved ? formula::srgbFromLinear1(rgba[i]) : rgba[i]);
  }
}

}  // namespace

Result<Texture> Texture::make2d(Format format, int width, int height, int levels) {
  return make(format, Shape::plane, width, height, 1, levels);
}

Result<Texture> Texture::makeCube(Format format, int size, int levels) {
  return make(format, Shape::cube, size, size, 1, levels);
}

Result<Texture> Texture::makeArray(Format format, int width, int height, int layers, int levels) {
  assert(layers >= 1 && layers <= 256);
  return make(format, Shape::array, width, height, layers, levels);
}

Result<Texture> Texture::make(Format format, Shape shape, int width, int height, int layers, int levels) {
  assert(width >= 1 && height >= 1 && levels >= 0);
  GLint largest = 0;
  glGetIntegerv(shape == Shape::cube ? GL_MAX_CUBE_MAP_TEXTURE_SIZE : GL_MAX_TEXTURE_SIZE, &largest);
  const std::string what = "a texture of " + std::to_string(width) + " × " + std::to_string(height);
  if (width > largest || height > largest) {
    return fail(ErrorCode::too_large, what + " texels is larger than the " + std::to_string(largest) +
                                          " texels a side that the graphics driver takes");
  }
  const int max = levelCount(std::max(width, height));
  Texture texture(format, shape, width, height, layers, levels == kAllLevels ? max : std::min(levels, max));
  if (glGetError() == GL_OUT_OF_MEMORY) {
    return fail(ErrorCode::too_large, what + " texels does not fit into the graphics memory");
  }
  return texture;
}

Result<Texture> Texture::fromImages(Format format, const ImageSet& images) {
  assert(!images.empty() && (images.faces() == 1 || images.faces() == 6));
  const Image& first = images.at(0, 0);
  MIRRORBALL_TRY(texture, make(format, images.faces() == 6 ? Shape::cube : Shape::plane, first.width(), first.height(),
                               1, images.levels()));
  texture.upload(images);
  return texture;
}

Result<Texture> Texture::fromWords(std::span<const glm::uvec4> words) {
  const auto count = static_cast<int>(words.size());
  assert(count >= 1);
  const int rows = (count - 1) / kWordTexels + 1;
  MIRRORBALL_TRY(texture, make(Format::rgba32ui, Shape::plane, kWordTexels, rows, 1, 1));
  const auto upload = [](int first_row, int width, int height, const glm::uvec4* texels) {
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, first_row, width, height, GL_RGBA_INTEGER, GL_UNSIGNED_INT, texels);
  };
  texture.bindForWork();
  const int whole_rows = count / kWordTexels;
  if (whole_rows > 0) upload(0, kWordTexels, whole_rows, words.data());
  const auto uploaded = static_cast<std::size_t>(whole_rows) * kWordTexels;
  if (uploaded < words.size()) upload(whole_rows, count % kWordTexels, 1, words.data() + uploaded);
  return Result<Texture>(std::move(texture));
}

Texture::Texture(Format format, Shape shape, int width, int height, int layers, int levels)
    : format_(format),
      shape_(shape),
      width_(width),
      height_(height),
      layers_(shape == Shape::cube ? 6 : layers),
      levels_(levels) {
  GLuint name = 0;
  glGenTextures(1, &name);
  handle_ = Handle<destroy>(name);
  bindForWork();
  if (shape == Shape::array)
    glTexStorage3D(target(), levels, internalFormat(format), width, height, layers);
  else
    glTexStorage2D(target(), levels, internalFormat(format), width, height);
  Sampling sampling;
  if (isUnfiltered(format)) sampling.filter = Sampling::Filter::nearest;
  setSampling(sampling);
}

std::size_t Texture::bytes() const {
  const std::size_t of_component = isEightBit(format_) ? 1 : format_ == Format::rgba16f ? 2 : 4;
  std::size_t texels = 0;
  for (int level = 0; level < levels_; ++level)
    texels += std::size_t(std::max(width_ >> level, 1)) * std::size_t(std::max(height_ >> level, 1));
  return texels * std::size_t(layers_) * std::size_t(channelsOf(format_)) * of_component;
}

void Texture::makeLevels() {
  bindForWork();
  glGenerateMipmap(target());
}

void Texture::destroy(unsigned name) { glDeleteTextures(1, &name); }

unsigned Texture::target() const {
  switch (shape_) {
    case Shape::plane:
      return GL_TEXTURE_2D;
    case Shape::array:
      return GL_TEXTURE_2D_ARRAY;
    case Shape::cube:
      return GL_TEXTURE_CUBE_MAP;
  }
  assert(false && "no such shape");
  return GL_TEXTURE_2D;
}

void Texture::bindForWork() const {
  glActiveTexture(GL_TEXTURE0 + kWorkUnit);
  glBindTexture(target(), handle_.name());
}

void Texture::bind(int unit, const Sampler* sampler) const {
  assert(unit >= 0 && unit < kWorkUnit);
  glBindSampler(static_cast<GLuint>(unit), sampler ? sampler->name() : 0);
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(target(), handle_.name());
}

/// What names one image of it in uploads and framebuffers.
unsigned Texture::imageTarget(int face) const {
  assert(face >= 0 && face < (isCube() ? 6 : 1));
  return isCube() ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face) : GLenum{GL_TEXTURE_2D};
}

/// Whether that is the size of an image of the level.
bool Texture::takes(int level, int width, int height) const {
  if (level < 0 || level >= levels_) return false;
  const int level_width = levelSide(width_, level);
  const int level_height = levelSide(height_, level);
  if (shape_ == Shape::array) return width <= level_width && height <= level_height;
  return width == level_width && height == level_height;
}

template <typename Component, typename Fill>
void Texture::uploadRows(int level, int face, int width, int height, Fill&& fill, int channels) {
  // Rows go over in bands, so that a large image is not in memory twice and a band is still in the
  // cache when the driver copies it.
  constexpr std::size_t kBandBytes = std::size_t{2} << 20;
  constexpr std::size_t kGrainBytes = std::size_t{64} << 10;
  const std::size_t row_length = static_cast<std::size_t>(channels) * static_cast<std::size_t>(width);
  const GLenum form = channels == 1 ? GL_RED : channels == 2 ? GL_RG : GL_RGBA;
  const std::size_t row_bytes = row_length * sizeof(Component);
  const auto all_rows = static_cast<std::size_t>(height);
  const std::size_t band_rows = std::clamp<std::size_t>(kBandBytes / row_bytes, 1, all_rows);
  std::vector<Component> band(band_rows * row_length);
  bindForWork();
  for (std::size_t top = 0; top < all_rows; top += band_rows) {
    const std::size_t rows = std::min(band_rows, all_rows - top);
    parallelFor(rows, kGrainBytes / row_bytes, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row) {
        fill(static_cast<int>(top + row), std::span(band).subspan(row * row_length, row_length));
      }
    });
    const auto y = static_cast<GLint>(top);
    const auto row_count = static_cast<GLsizei>(rows);
    constexpr GLenum kType = kComponentType<Component>;
    if (shape_ == Shape::array)
      glTexSubImage3D(target(), level, 0, y, face, width, row_count, 1, form, kType, band.data());
    else
      glTexSubImage2D(imageTarget(face), level, 0, y, width, row_count, form, kType, band.data());
  }
}

void Texture::upload(int level, int face, const Image& image) {
  assert(takes(level, image.width(), image.height()));
  const int channels = channelsOf(format_);
  const auto first = [&](int y, std::span<float> row) {
    for (int x = 0; x < image.width(); ++x)
      std::copy_n(image.texel(x, y), channels, &row[std::size_t(x) * std::size_t(channels)]);
  };
  const auto expanded = [&](int y, std::span<float> rgba) { expandRow(image.row(y), image.channels(), 1.0f, rgba); };
  if (channels < 4) {
    assert(image.channels() >= channels);
    uploadRows<float>(level, face, image.width(), image.height(), first, channels);
  } else if (format_ == Format::rgba32f) {
    uploadRows<float>(level, face, image.width(), image.height(), expanded);
  } else if (format_ == Format::rgba16f) {
    uploadRows<std::uint16_t>(level, face, image.width(), image.height(), [&](int y, std::span<std::uint16_t> rgba) {
      std::vector<std::uint16_t> halves(image.row(y).size());
      halvesFromFloats(image.row(y), halves);
      expandRow<std::uint16_t>(halves, image.channels(), kHalfOne, rgba);
    });
  } else {
    uploadRows<std::uint8_t>(level, face, image.width(), image.height(), [&](int y, std::span<std::uint8_t> bytes) {
      std::vector<float> rgba(bytes.size());
      expanded(y, rgba);
      encodeRow(rgba, format_ == Format::srgb8_alpha8, bytes);
    });
  }
}

void Texture::upload(const ImageSet& images) {
  for (int level = 0; level < images.levels(); ++level)
    for (int face = 0; face < images.faces(); ++face) upload(level, face, images.at(level, face));
}

void Texture::upload(int level, int face, const Image8& image) {
  assert(isEightBit(format_) && takes(level, image.width(), image.height()));
  uploadRows<std::uint8_t>(level, face, image.width(), image.height(), [&](int y, std::span<std::uint8_t> bytes) {
    expandRow<std::uint8_t>(image.row(y), image.channels(), 255, bytes);
  });
}

void Texture::setSampling(const Sampling& sampling) {
  bindForWork();
  Sampling of_shape = sampling;
  if (isCube()) of_shape.wrap_s = of_shape.wrap_t = Sampling::Wrap::clamp_to_edge;
  forEachParameter(of_shape, [this](GLenum name, GLint value) { glTexParameteri(target(), name, value); });
  // Drivers without the extension know no such parameter.
  if (sampling.anisotropy == anisotropy_) return;
  glTexParameterf(target(), GL_TEXTURE_MAX_ANISOTROPY_EXT, sampling.anisotropy);
  anisotropy_ = sampling.anisotropy;
}

void Texture::setLevels(int first, int last) {
  assert(first >= 0 && first <= last && last < levels_);
  bindForWork();
  glTexParameteri(target(), GL_TEXTURE_BASE_LEVEL, first);
  glTexParameteri(target(), GL_TEXTURE_MAX_LEVEL, last);
}

Image Texture::read(int level, int face) const {
  assert(level >= 0 && level < levels_);
  GLint previous = 0;
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &previous);
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  if (shape_ == Shape::array)
    glFramebufferTextureLayer(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, handle_.name(), level, face);
  else
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, imageTarget(face), handle_.name(), level);
  Image image = readPixelFloats(format_, levelSide(width_, level), levelSide(height_, level));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(previous));
  glDeleteFramebuffers(1, &framebuffer);
  return image;
}

}  // namespace mirrorball::gl
