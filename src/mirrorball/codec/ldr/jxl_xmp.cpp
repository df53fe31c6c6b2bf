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

/// Reads the contents of that box.
///
/// returns  where the decoder has got to: the next box, or the file's end; anything else where this one is damaged, or
///          too long
JxlDecoderStatus readBox(JxlDecoder* decoder, UnpackingBudget& budget, std::string& text) {
  constexpr std::size_t kStep = UnpackingBudget::kStep;
  JxlDecoderStatus status = JXL_DEC_BOX_NEED_MORE_OUTPUT;
  while (status == JXL_DEC_BOX_NEED_MORE_OUTPUT) {
    if (!budget.take(kStep)) return JXL_DEC_ERROR;
    const std::size_t filled = text.size();
    text.resize(filled + kStep);
    if (JxlDecoderSetBoxBuffer(decoder, reinterpret_cast<std::uint8_t*>(text.data()) + filled, kStep) !=
        JXL_DEC_SUCCESS)
      return JXL_DEC_ERROR;
    status = JxlDecoderProcessInput(decoder);
    text.resize(filled + kStep - JxlDecoderReleaseBoxBuffer(decoder));
  }
  return status;
}

}  // namespace

std::string compressedXmpInJxl(std::span<const std::uint8_t> bytes) {
  const Decoder decoder(JxlDecoderCreate(nullptr), JxlDecoderDestroy);
  if (!decoder || JxlDecoderSubscribeEvents(decoder.get(), JXL_DEC_BOX) != JXL_DEC_SUCCESS ||
      JxlDecoderSetDecompressBoxes(decoder.get(), JXL_TRUE) != JXL_DEC_SUCCESS)
    return {};
  JxlDecoderSetInput(decoder.get(), bytes.data(), bytes.size());
  JxlDecoderCloseInput(decoder.get());
  UnpackingBudget budget;
  for (JxlDecoderStatus status = JxlDecoderProcessInput(decoder.get()); status == JXL_DEC_BOX;) {
    if (!isCompressedXml(decoder.get())) {
      status = JxlDecoderProcessInput(decoder.get());
      continue;
    }
    std::string text;
    status = readBox(decoder.get(), budget, text);
    if ((status == JXL_DEC_BOX || status == JXL_DEC_SUCCESS) && holdsXmp(text)) return text;
  }
  return {};
}

}  // namespace mirrorball
