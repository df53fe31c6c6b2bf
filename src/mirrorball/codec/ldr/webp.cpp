#include "mirrorball/codec/ldr/webp.h"

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <webp/decode.h>
#include <webp/demux.h>

#include "mirrorball/codec/color/icc_profile.h"
#include "mirrorball/codec/ldr/coded_file.h"
#include "mirrorball/codec/missing_rows.h"

namespace mirrorball {
namespace {

using Span = std::span<const std::uint8_t>;

tl::unexpected<Error> webpFailure(VP8StatusCode status, std::size_t size) {
  switch (status) {
    case VP8_STATUS_OUT_OF_MEMORY:
      return fail(ErrorCode::too_large, "not enough memory to decode it");
    case VP8_STATUS_NOT_ENOUGH_DATA:
    case VP8_STATUS_SUSPENDED:
      return endsInFirstRow(size);
    default:
      return fail(ErrorCode::bad_file, "is a damaged WebP");
  }
}

/// Decodes what there is of a file that ends early.
///
/// returns  how many rows that is, from the top
int decodeRowsThere(Span bytes, WebPDecoderConfig& config) {
  const std::unique_ptr<WebPIDecoder, decltype(&WebPIDelete)> decoder(WebPIDecode(nullptr, 0, &config), &WebPIDelete);
  if (!decoder) return 0;
  const VP8StatusCode status = WebPIUpdate(decoder.get(), bytes.data(), bytes.size());
  int rows = 0;
  const bool has_begun = WebPIDecGetRGB(decoder.get(), &rows, nullptr, nullptr, nullptr) != nullptr;
  return has_begun && (status == VP8_STATUS_OK || status == VP8_STATUS_SUSPENDED) ? rows : 0;
}

/// features become the file's
///
/// oddities   receives the remark on rows that are missing
Result<Image8> readWebpPicture(Span bytes, CodeForm form, WebPBitstreamFeatures& features,
                               std::vector<std::string>& oddities) {
  const VP8StatusCode known = WebPGetFeatures(bytes.data(), bytes.size(), &features);
  if (known != VP8_STATUS_OK) return webpFailure(known, bytes.size());
  if (features.has_animation != 0)
    return fail(ErrorCode::unsupported, "is an animated WebP; save one of its pictures by itself");
  MIRRORBALL_TRY_VOID(checkDimensions(features.width, features.height));
  constexpr int kSampleBytes = 2;  // libwebp's own picture, and ours
  MIRRORBALL_TRY_VOID(checkPictureMemory(features.width, features.height, 4, kSampleBytes));

  const int channels = form == CodeForm::rgba || features.has_alpha != 0 ? 4 : 3;
  // Without values, so that a size that lies costs no memory: only rows that are decoded are touched.
  Image8 picture = Image8::withoutValues(features.width, features.height, channels);
  WebPDecoderConfig config;
  if (WebPInitDecoderConfig(&config) == 0)
    return fail(ErrorCode::unsupported, "libwebp is another version than the program was built with");
  config.output.colorspace = channels == 4 ? MODE_RGBA : MODE_RGB;
  config.output.is_external_memory = 1;
  config.output.u.RGBA = {picture.samples().data(), features.width * channels, picture.samples().size()};
  const VP8StatusCode decoded = WebPDecode(bytes.data(), bytes.size(), &config);
  if (decoded == VP8_STATUS_OK) return picture;
  const bool is_cut = decoded == VP8_STATUS_NOT_ENOUGH_DATA || decoded == VP8_STATUS_SUSPENDED;
  const int rows = is_cut ? decodeRowsThere(bytes, config) : 0;
  if (rows == 0) return webpFailure(decoded, bytes.size());
  blackenMissingRows(picture, rows, /*from_top=*/true, oddities);
  if (rows == picture.height()) oddities.emplace_back("lacks its end; all of its rows are there");
  return picture;
}

/// The chunks beside the picture; of a file that ends early, those before its end.
class WebpChunks {
 public:
  explicit WebpChunks(Span bytes)
      : data_{bytes.data(), bytes.size()}, demuxer_(WebPDemuxPartial(&data_, nullptr), &WebPDemuxDelete) {}

  /// The first chunk of a name, in the file's bytes; empty where there is none.
  Span operator[](const char* name) const {
    WebPChunkIterator chunk;
    if (!demuxer_ || WebPDemuxGetChunk(demuxer_.get(), name, 1, &chunk) == 0) return {};
    const Span bytes(chunk.chunk.bytes, chunk.chunk.size);
    WebPDemuxReleaseChunkIterator(&chunk);
    return bytes;
  }

 private:
  WebPData data_;
  std::unique_ptr<WebPDemuxer, decltype(&WebPDemuxDelete)> demuxer_;
};

}  // namespace

Result<CodedFile> decodeWebp(Span bytes, CodeForm form) {
  WebPBitstreamFeatures features;
  std::vector<std::string> oddities;
  MIRRORBALL_TRY(picture, readWebpPicture(bytes, form, features, oddities));
  constexpr std::string_view kForms[]{"", ", lossy", ", lossless"};
  const WebpChunks chunks(bytes);
  const Span profile = chunks["ICCP"];
  const Exif exif = readExif(chunks["EXIF"]);
  return CodedFile{.codes = std::move(picture),
                   .color = profile.empty() ? CodedColor{} : codedColor(readIccProfile(profile)),
                   .orientation = exif.orientation,
                   .exif = exif,
                   .format = "WebP" + std::string(kForms[std::clamp(features.format, 0, 2)]),
                   .oddities = std::move(oddities)};
}

FormatCodec webpCodec() { return {.decode_codes = decodeWebp}; }

}  // namespace mirrorball
