#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/image/texel_allocator.h"

namespace mirrorball {

/// A rectangle of texels: `channels` interleaved samples a texel, rows from the top, no padding.
///
/// Sample   float (linear light unless said otherwise) or std::uint8_t (encoded as the owner says)
template <typename Sample>
class ImageOf {
 public:
  ImageOf() = default;
  /// Takes width · height · channels samples of memory, all set to `fill`.
  ImageOf(int width, int height, int channels, Sample fill = Sample{})
      : width_(width), height_(height), channels_(channels) {
    assert(width >= 0 && height >= 0 && channels >= 1 && channels <= 4);
    samples_.assign(std::size_t(width) * std::size_t(height) * std::size_t(channels), fill);
  }

  /// The same with undefined samples, for callers that set them all.
  static ImageOf withoutValues(int width, int height, int channels) {
    ImageOf image;
    image.width_ = width;
    image.height_ = height;
    image.channels_ = channels;
    image.samples_.resize(std::size_t(width) * std::size_t(height) * std::size_t(channels));
    return image;
  }

  int width() const { return width_; }
  int height() const { return height_; }
  int channels() const { return channels_; }
  bool empty() const { return samples_.empty(); }
  std::size_t texelCount() const { return std::size_t(width_) * std::size_t(height_); }

  std::span<Sample> samples() { return samples_; }
  std::span<const Sample> samples() const { return samples_; }

  std::span<Sample> row(int y) { return samples().subspan(offset(0, y), rowLength()); }
  std::span<const Sample> row(int y) const { return samples().subspan(offset(0, y), rowLength()); }

  /// The samples of one texel, x to the right and y down from the top left one.
  Sample* texel(int x, int y) { return samples_.data() + offset(x, y); }
  const Sample* texel(int x, int y) const { return samples_.data() + offset(x, y); }

 private:
  std::size_t rowLength() const { return std::size_t(width_) * std::size_t(channels_); }
  std::size_t offset(int x, int y) const {
    assert(x >= 0 && x < width_ && y >= 0 && y < height_);
    return std::size_t(y) * rowLength() + std::size_t(x) * std::size_t(channels_);
  }

  int width_ = 0;
  int height_ = 0;
  int channels_ = 1;
  std::vector<Sample, TexelAllocator<Sample>> samples_;
};

using Image = ImageOf<float>;          ///< linear light
using Image8 = ImageOf<std::uint8_t>;  ///< a picture or a texture, encoded

/// What a texture holds: codes of 8 bits, or floats where 8 bits would not do.
using Texels = std::variant<Image8, Image>;

/// The first three channels of a texel; a grey image's one channel three times.
inline glm::vec3 rgbAt(const Image& image, int x, int y) {
  const float* texel = image.texel(x, y);
  return image.channels() >= 3 ? glm::vec3(texel[0], texel[1], texel[2]) : glm::vec3(texel[0]);
}

/// Codes as fractions of the greatest one.
template <typename Code>
Image fractionsFromCodes(const ImageOf<Code>& codes) {
  Image fractions = Image::withoutValues(codes.width(), codes.height(), codes.channels());
  constexpr auto kGreatest = static_cast<float>(std::numeric_limits<Code>::max());
  std::transform(codes.samples().begin(), codes.samples().end(), fractions.samples().begin(),
                 [](Code code) { return static_cast<float>(code) / kGreatest; });
  return fractions;
}

/// A texel as (r, g, b, a); alpha is 1 where the image has none.
glm::vec4 rgbaAt(const Image& image, int x, int y);

/// The light of an image alone: a grey one's channel three times, alpha left out.
Image rgbOf(const Image& image);

/// The largest sample of all channels, and at least 0; NaN is none.
float largestSample(const Image& image);

/// How many samples are NaN or infinite, and the first texel that has one.
struct NonFinite {
  std::size_t count = 0;  ///< texels, not samples
  glm::ivec2 first{0};
};
NonFinite findNonFinite(const Image& image);

/// "2 texels are NaN or infinite, the first at (3, 1)"
std::string textOf(const NonFinite& bad);

/// Replaces every texel that holds NaN or infinity by the mean of its nearest finite neighbours, ring by ring.
///
/// errors   non_finite when no texel is finite
Result<void> repairNonFinite(Image& image);

/// Refuses sizes that no image may have: a side of 0, or more than `kLargestTexelCount` texels.
///
/// errors   bad_file (a side is 0 or negative); too_large
Result<void> checkDimensions(long long width, long long height);

/// Refuses an image of that size in linear light if it would take more memory than is allowed (base/memory.h).
///
/// errors   too_large
Result<void> checkImageMemory(int width, int height, int channels);

/// 2³⁰ texels: 32768 × 32768, or 16 GiB as float RGBA.
inline constexpr long long kLargestTexelCount = 1LL << 30;

}  // namespace mirrorball
