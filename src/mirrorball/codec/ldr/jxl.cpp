#include "mirrorball/codec/ldr/jxl.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <jxl/color_encoding.h>
#include <jxl/decode.h>
#include <jxl/encode.h>
#include <jxl/parallel_runner.h>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/codec/color/icc_profile.h"
#include "mirrorball/codec/ldr/coded_file.h"
#include "mirrorball/codec/ldr/jxl_xmp.h"
#include "mirrorball/image/upright.h"

namespace mirrorball {
namespace {

using Span = std::span<const std::uint8_t>;

/// libjxl's loops as ours.
JxlParallelRetCode runInParallel(void*, void* work, JxlParallelRunInit begin_work, JxlParallelRunFunction step,
                                 std::uint32_t start, std::uint32_t end) {
  if (start >= end) return 0;
  const std::size_t count = end - start;
  const std::size_t grain = (count - 1) / (2 * std::size_t(threadLimit())) + 1;
  if (const JxlParallelRetCode failed = begin_work(work, (count - 1) / grain + 1); failed != 0) return failed;
  parallelFor(count, grain, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) step(work, start + static_cast<std::uint32_t>(i), first / grain);
  });
  return 0;
}

constexpr const char* kJxlOrientation = "header";

/// Asks for the colour of the samples that are decoded. Versions of libjxl before 0.8 take a format that they do not
/// use.
template <typename Ask, typename... Answer>
bool askOfSamples(Ask ask, const JxlDecoder* decoder, Answer... answer) {
  if constexpr (std::is_invocable_v<Ask, const JxlDecoder*, JxlColorProfileTarget, Answer...>)
    return ask(decoder, JXL_COLOR_PROFILE_TARGET_DATA, answer...) == JXL_DEC_SUCCESS;
  else
    return ask(decoder, nullptr, JXL_COLOR_PROFILE_TARGET_DATA, answer...) == JXL_DEC_SUCCESS;
}

/// Nothing: it cannot be said without a profile.
std::optional<JxlColorEncoding> encodingOf(const JxlDecoder* decoder) {
  JxlColorEncoding color{};
  color.primaries = JXL_PRIMARIES_SRGB;  // of grey pictures they are not written
  return askOfSamples(JxlDecoderGetColorAsEncodedProfile, decoder, &color) ? std::optional(color) : std::nullopt;
}

/// What the ICC profile of the samples says of them.
CodedColor colorByProfile(const JxlDecoder* decoder) {
  std::size_t size = 0;
  if (!askOfSamples(JxlDecoderGetICCProfileSize, decoder, &size)) return {};
  std::vector<std::uint8_t> profile(size);
  if (!askOfSamples(JxlDecoderGetColorAsICCProfile, decoder, profile.data(), profile.size())) return {};
  return codedColor(readIccProfile(profile));
}

CodedColor colorOf(const JxlColorEncoding& encoding) {
  CodedColor color = codedColor(encoding.primaries, encoding.transfer_function);
  if (encoding.transfer_function == JXL_TRANSFER_FUNCTION_GAMMA)
    color = {Transfer::gamma, encoding.gamma > 0.0 ? 1.0 / encoding.gamma : 1.0, color.primaries};
  if (encoding.transfer_function == JXL_TRANSFER_FUNCTION_DCI) color = {Transfer::gamma, 2.6, color.primaries};
  const auto place = [](const double* xy) { return glm::dvec2(xy[0], xy[1]); };
  if (encoding.primaries == JXL_PRIMARIES_CUSTOM)
    color.primaries = Primaries{place(encoding.primaries_red_xy), place(encoding.primaries_green_xy),
                                place(encoding.primaries_blue_xy), place(encoding.white_point_xy)};
  // The number of P3 goes with either white.
  if (encoding.primaries == JXL_PRIMARIES_P3 && encoding.white_point == JXL_WHITE_POINT_D65)
    color.primaries = kDisplayP3;
  return color;
}

/// A file whose picture is decoded step by step.
class JxlFile {
 public:
  explicit JxlFile(Span bytes) : bytes_(bytes), decoder_(JxlDecoderCreate(nullptr), JxlDecoderDestroy) {}

  /// Reads what the file says of its picture.
  Result<void> open() {
    if (!decoder_) return fail(ErrorCode::too_large, "not enough memory to decode it");
    JxlDecoderSetParallelRunner(decoder_.get(), runInParallel, nullptr);
    JxlDecoderSetUnpremultiplyAlpha(decoder_.get(), JXL_TRUE);
    JxlDecoderSetKeepOrientation(decoder_.get(), JXL_TRUE);  // turned by us, with a remark, as all formats are
    JxlDecoderSubscribeEvents(decoder_.get(), JXL_DEC_BASIC_INFO | JXL_DEC_COLOR_ENCODING | JXL_DEC_FULL_IMAGE);
    JxlDecoderSetInput(decoder_.get(), bytes_.data(), bytes_.size());
    JxlDecoderCloseInput(decoder_.get());
    MIRRORBALL_TRY_VOID(goOnTo(JXL_DEC_BASIC_INFO));
    if (JxlDecoderGetBasicInfo(decoder_.get(), &info_) != JXL_DEC_SUCCESS) return damaged();
    if (info_.have_animation != 0)
      return fail(ErrorCode::unsupported, "is an animated JPEG XL; save one of its pictures by itself");
    MIRRORBALL_TRY_VOID(checkDimensions(info_.xsize, info_.ysize));
    MIRRORBALL_TRY_VOID(checkDecoderMemory());
    MIRRORBALL_TRY_VOID(goOnTo(JXL_DEC_COLOR_ENCODING));
    if (const auto encoding = encodingOf(decoder_.get())) {
      color_ = colorOf(*encoding);
    } else if (info_.uses_original_profile == 0) {
      JxlColorEncoding linear;
      JxlColorEncodingSetToLinearSRGB(&linear, JXL_FALSE);
      if (JxlDecoderSetPreferredColorProfile(decoder_.get(), &linear) == JXL_DEC_SUCCESS)
        color_ = {.transfer = Transfer::linear};
    } else {
      color_ = colorByProfile(decoder_.get());
    }
    return {};
  }

  bool isOfFloats() const { return info_.exponent_bits_per_sample > 0; }
  int channels() const { return info_.alpha_bits > 0 ? 4 : 3; }
  const JxlBasicInfo& info() const { return info_; }

  template <typename Sample>
  Result<ImageOf<Sample>> decode(int channels, JxlDataType type) {
    const JxlPixelFormat format{static_cast<std::uint32_t>(channels), type, JXL_NATIVE_ENDIAN, 0};
    MIRRORBALL_TRY_VOID(goOnTo(JXL_DEC_NEED_IMAGE_OUT_BUFFER));
    ImageOf<Sample> image = ImageOf<Sample>::withoutValues(int(info_.xsize), int(info_.ysize), channels);
    const std::span<Sample> samples = image.samples();
    if (JxlDecoderSetImageOutBuffer(decoder_.get(), &format, samples.data(), samples.size_bytes()) != JXL_DEC_SUCCESS)
      return damaged();
    MIRRORBALL_TRY_VOID(goOnTo(JXL_DEC_FULL_IMAGE));
    return image;
  }

  const CodedColor& color() const { return color_; }
  int orientation() const { return static_cast<int>(info_.orientation); }

  std::string format() const {
    return "JPEG XL, " + std::to_string(info_.bits_per_sample) + (isOfFloats() ? "-bit floats" : " bits");
  }

 private:
  tl::unexpected<Error> damaged() const { return fail(ErrorCode::bad_file, "is a damaged JPEG XL"); }

  /// Refuses a picture that would take more memory than may be used: ours, and what libjxl holds of it. That decodes
  /// every extra channel, whether it is asked for or not.
  Result<void> checkDecoderMemory() const {
    // Measured with libjxl 0.7, with and without loss: 17 bytes a texel, and up to 20 for each extra channel; 20 more
    // where there is one.
    constexpr std::uint64_t kOfColors = 48, kOfExtraChannel = 24;
    const std::uint64_t of_texel = 4 * sizeof(float) + kOfColors + kOfExtraChannel * info_.num_extra_channels;
    return checkMemory(std::uint64_t{info_.xsize} * info_.ysize * of_texel);
  }

  Result<void> goOnTo(JxlDecoderStatus event) {
    const JxlDecoderStatus status = JxlDecoderProcessInput(decoder_.get());
    if (status == event) return {};
    if (status == JXL_DEC_NEED_MORE_INPUT)
      return fail(ErrorCode::bad_file, "ends at byte " + std::to_string(bytes_.size()) +
                                           ", before its last texel; the file is truncated or damaged");
    return damaged();
  }

  Span bytes_;
  std::unique_ptr<JxlDecoder, decltype(&JxlDecoderDestroy)> decoder_;
  JxlBasicInfo info_{};
  CodedColor color_ = {};
};

bool jxlHoldsIntegers(Span bytes) {
  JxlFile file(bytes);
  return file.open() && !file.isOfFloats();
}

}  // namespace

Result<DecodedImage> decodeJxl(Span bytes, const ImageReadOptions& options) {
  JxlFile file(bytes);
  MIRRORBALL_TRY_VOID(file.open());
  MIRRORBALL_TRY(stored, file.decode<float>(file.channels(), JXL_TYPE_FLOAT));
  DecodedImage decoded{upright(std::move(stored), file.orientation()), {}, file.format()};
  if (std::string remark = uprightRemark(file.orientation(), kJxlOrientation); !remark.empty())
    decoded.oddities.push_back(std::move(remark));
  const int channels = decoded.image.channels();
  if (options.as == ReadAs::numbers) {
    tellUnapplied(statedSpace(file.color(), channels), decoded.oddities);
    decoded.color = kAsStored;
    return decoded;
  }
  decoded.is_converted = decodeColor(decoded.image, file.color());
  decoded.color = describeColor(file.color(), channels);
  if (std::string remark = unreadProfileRemark(file.color()); !remark.empty())
    decoded.oddities.push_back(std::move(remark));
  return decoded;
}

Result<CodedFile> decodeJxlCodes(Span bytes, CodeForm form) {
  JxlFile file(bytes);
  MIRRORBALL_TRY_VOID(file.open());
  CodedFile coded{.codes = {},
                  .color = file.color(),
                  .orientation = file.orientation(),
                  .orientation_source = kJxlOrientation,
                  .format = file.format()};
  const int channels = form == CodeForm::rgba ? 4 : file.channels();
  if (file.info().bits_per_sample <= 8) {
    MIRRORBALL_TRY(codes, file.decode<std::uint8_t>(channels, JXL_TYPE_UINT8));
    coded.codes = std::move(codes);
  } else {
    MIRRORBALL_TRY(codes, file.decode<std::uint16_t>(channels, JXL_TYPE_UINT16));
    coded.codes = std::move(codes);
  }
  return coded;
}

FormatCodec jxlCodec() {
  return {.decode = decodeJxl,
          .decode_codes = decodeJxlCodes,
          .holds_integers = jxlHoldsIntegers,
          .compressed_xmp = compressedXmpInJxl};
}

}  // namespace mirrorball
