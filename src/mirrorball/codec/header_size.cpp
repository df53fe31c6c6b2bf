#include "mirrorball/codec/header_size.h"

#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/format_signature.h"
#include "mirrorball/codec/ldr/jpeg_segments.h"
#include "mirrorball/codec/ldr/png_chunks.h"
#include "mirrorball/image/image.h"

namespace mirrorball {
namespace {

std::optional<glm::ivec2> checkedSize(std::uint32_t width, std::uint32_t height) {
  if (!checkDimensions(width, height)) return std::nullopt;
  return glm::ivec2(width, height);
}

std::optional<glm::ivec2> sizeInPng(std::span<const std::uint8_t> png) {
  constexpr std::size_t kWidth = kPngSignature + kPngChunkHead;
  constexpr std::size_t kHeight = kWidth + 4;
  if (png.size() < kHeight + 4) return std::nullopt;
  return checkedSize(bigU32(&png[kWidth]), bigU32(&png[kHeight]));
}

std::optional<glm::ivec2> sizeInJpeg(std::span<const std::uint8_t> jpeg) {
  const std::span<const std::uint8_t> frame = frameHeader(jpegHeader(jpeg));
  if (frame.empty()) return std::nullopt;
  return checkedSize(bigU16(&frame[kJpegFrameWidth]), bigU16(&frame[kJpegFrameHeight]));
}

}  // namespace

std::optional<glm::ivec2> sizeInHeader(std::span<const std::uint8_t> bytes) {
  if (isPng(bytes)) return sizeInPng(bytes);
  return isJpeg(bytes) ? sizeInJpeg(bytes) : std::nullopt;
}

}  // namespace mirrorball
