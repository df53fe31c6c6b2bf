#include "mirrorball/codec/ldr/coded_picture.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "mirrorball/base/memory.h"
#include "mirrorball/codec/color/srgb.h"

namespace mirrorball {
namespace {

template <typename Sample>
constexpr std::uint32_t kMax = std::numeric_limits<Sample>::max();

template <typename Sample>
void divideByAlpha(ImageOf<Sample>& image) {
  for (std::size_t i = 0; i + 3 < image.samples().size(); i += 4) {
    Sample* texel = image.samples().data() + i;
    const std::uint32_t alpha = texel[3];
    if (alpha == 0 || alpha == kMax<Sample>) continue;
    for (int c = 0; c < 3; ++c)
      texel[c] = static_cast<Sample>(rescaledCode(std::min<std::uint32_t>(texel[c], alpha), alpha, kMax<Sample>));
  }
}

template <typename Sample>
Image8 rgba8Of(const ImageOf<Sample>& image) {
  Image8 texture = Image8::withoutValues(image.width(), image.height(), 4);
  const int channels = image.channels();
  const Sample* from = image.samples().data();
  for (std::uint8_t *to = texture.samples().data(), *end = to + texture.samples().size(); to < end; to += 4) {
    for (int c = 0; c < 4; ++c) {
      const Sample code = c < 3 ? from[channels == 1 ? 0 : c] : channels == 4 ? from[3] : Sample(kMax<Sample>);
      to[c] = static_cast<std::uint8_t>(rescaledCode(code, kMax<Sample>, 255));
    }
    from += channels;
  }
  return texture;
}

Image lightByTable(const Image8& codes, const TransferCurve& curve) { return linearFromPicture(codes, curve); }

Image lightByTable(const ImageOf<std::uint16_t>& codes, const TransferCurve& curve) {
  return linearFromSamples16(codes.samples(), codes.width(), codes.height(), codes.channels(), curve);
}

}  // namespace

Result<void> checkPictureMemory(int width, int height, int channels, int sample_bytes) {
  const std::uint64_t samples = std::uint64_t(width) * std::uint64_t(height) * std::uint64_t(channels);
  return checkMemory(samples * (sizeof(float) + std::uint64_t(sample_bytes)));
}

tl::unexpected<Error> cannotHold(long long width, long long height, std::size_t bytes) {
  return fail(ErrorCode::bad_file, "says its size is " + std::to_string(width) + "x" + std::to_string(height) +
                                       ", which its " + std::to_string(bytes) +
                                       " bytes cannot hold; the file is truncated or damaged");
}

Image lightOf(const CodedPicture& picture, const CodedColor& color) {
  const std::optional<TransferCurve> curve = curveOf(color);
  if (!curve) {
    Image light = sharesOf(picture);
    decodeColor(light, color);
    return light;
  }
  Image light = std::visit([&](const auto& codes) { return lightByTable(codes, *curve); }, picture);
  convertToRec709(light, color.primaries);
  return light;
}

Image sharesOf(const CodedPicture& picture) {
  return std::visit([](const auto& codes) { return fractionsFromCodes(codes); }, picture);
}

Image8 textureOf(CodedPicture picture) {
  if (auto* codes = std::get_if<Image8>(&picture); codes && codes->channels() == 4) return std::move(*codes);
  return std::visit([](const auto& codes) { return rgba8Of(codes); }, picture);
}

void makeStraight(CodedPicture& picture) {
  std::visit(
      [](auto& codes) {
        if (codes.channels() == 4) divideByAlpha(codes);
      },
      picture);
}

}  // namespace mirrorball
