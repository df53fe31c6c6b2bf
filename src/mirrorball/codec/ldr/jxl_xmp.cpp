#include "mirrorball/codec/ldr/jxl_xmp.h"

#include <algorithm>
#include <memory>
#include <string_view>

#include <jxl/decode.h>

#include "mirrorball/codec/compressed_xmp.h"

namespace mirrorball {
namespace {

using Decoder = std::unique_ptr<JxlDecoder, decltype(&JxlDecoderDestroy)>;

/// Whether the box that the decoder has come to is XML that is compressed.
bool isCompressedXml(JxlDecoder* decoder) {
  JxlBoxType stored{}, unpacked{};
  return JxlDecoderGetBoxType(decoder, stored, JXL_FALSE) == JXL_DEC_SUCCESS &&
         JxlDecoderGetBoxType(decoder, unpacked, JXL_TRUE) == JXL_DEC_SUCCESS &&
         std::string_view(stored, 4) == "brob" && std::string_view(unpacked, 4) == "xml ";
}

/// The contents of that box.
std::string readBox(JxlDecoder* decoder) {
  constexpr std::size_t kStep = std::size_t{1} << 14;
  std::string text;
  for (std::size_t filled = 0; filled < kLongestCompressedXmp;) {
    text.resize(filled + kStep);
    if (JxlDecoderSetBoxBuffer(decoder, reinterpret_cast<std::uint8_t*>(text.data()) + filled, kStep) !=
        JXL_DEC_SUCCESS)
      return {};
    const JxlDecoderStatus status = JxlDecoderProcessInput(decoder);
    filled += kStep - JxlDecoderReleaseBoxBuffer(decoder);
    if (status == JXL_DEC_BOX_NEED_MORE_OUTPUT) continue;
    // The next box, or the file's end, ends this one.
    if (status != JXL_DEC_BOX && status != JXL_DEC_SUCCESS) return {};
    text.resize(filled);
    return text;
  }
  return {};
}

}  // namespace

std::string compressedXmpInJxl(std::span<const std::uint8_t> bytes) {
  const Decoder decoder(JxlDecoderCreate(nullptr), JxlDecoderDestroy);
  if (!decoder || JxlDecoderSubscribeEvents(decoder.get(), JXL_DEC_BOX) != JXL_DEC_SUCCESS ||
      JxlDecoderSetDecompressBoxes(decoder.get(), JXL_TRUE) != JXL_DEC_SUCCESS)
    return {};
  JxlDecoderSetInput(decoder.get(), bytes.data(), bytes.size());
  JxlDecoderCloseInput(decoder.get());
  while (JxlDecoderProcessInput(decoder.get()) == JXL_DEC_BOX)
    if (isCompressedXml(decoder.get())) return readBox(decoder.get());
  return {};
}

}  // namespace mirrorball
