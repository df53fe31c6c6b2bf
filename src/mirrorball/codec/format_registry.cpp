#include "mirrorball/codec/format_registry.h"

#include <string>
#include <utility>

#include "mirrorball/base/left_out.h"
#include "mirrorball/codec/foreign_file.h"
#include "mirrorball/codec/format_signature.h"
#include "mirrorball/codec/hdr/hdr.h"
#include "mirrorball/codec/hdr/hdr_rows.h"
#include "mirrorball/codec/ldr/bmp.h"
#include "mirrorball/codec/ldr/pnm.h"
#include "mirrorball/codec/ldr/tga.h"
#include "mirrorball/codec/texture/dds.h"
#include "mirrorball/codec/texture/ktx1.h"
#include "mirrorball/codec/texture/ktx2.h"
#include "mirrorball/codec/texture/texture_file.h"

namespace mirrorball {
namespace {

using Span = std::span<const std::uint8_t>;

/// How each format is recognised by a file's first bytes, in the order of kImageFormats.
constexpr std::array<bool (*)(Span), kImageFormats.size()> kBegins{
    isHdr, isExr, isPng, isJpeg, isKtx2, isKtx1, isDds, isTiff, isWebp, isAvif, isJxl, isTga, isBmp, isPnm, isPfm};

/// The largest level of a texture of one face: its first picture, if it is an array.
Result<DecodedImage> decodeTexturePicture(Span bytes, const ImageReadOptions& options) {
  MIRRORBALL_TRY(texture, decodeImageSet(bytes, options.as));
  if (texture.images.faces() != 1)
    return fail(ErrorCode::bad_shape, "is the texture of a cube, where one picture is wanted");
  return DecodedImage{.image = std::move(texture.images.at(0, 0)),
                      .metadata = std::move(texture.metadata),
                      .format = std::move(texture.format),
                      .color = std::move(texture.color),
                      .oddities = std::move(texture.oddities),
                      .is_converted = texture.is_converted};
}

Result<Bytes> encodeHdrLight(const Image& light, const ImageWriteOptions& options) {
  return encodeHdr(light, options.metadata, options.primaries);
}

Result<std::unique_ptr<RowReader>> openHdrRowsOfPicture(FileReader file, const ImageReadOptions& options) {
  if (!options.layer.empty()) return nullptr;  // which readImage refuses
  return openHdrRows(std::move(file));
}

constexpr FormatCodec kTexture{.decode = decodeTexturePicture};

/// What needs no library.
constexpr auto kEveryBuilds = std::to_array<OptionalFormat>({
    {ImageFormatId::hdr, {.decode = decodeHdr, .open_rows = openHdrRowsOfPicture, .encode = encodeHdrLight}},
    {ImageFormatId::ktx2, kTexture},
    {ImageFormatId::ktx, kTexture},
    {ImageFormatId::dds, kTexture},
    {ImageFormatId::tga, {.decode_codes = decodeTga}},
    {ImageFormatId::bmp, {.decode_codes = decodeBmp}},
    {ImageFormatId::pnm, {.decode_codes = decodePnm}},
    {ImageFormatId::pfm, {.decode = withoutOptions<decodePfm>}},
});

}  // namespace

FormatRegistry::FormatRegistry(std::span<const OptionalFormat> optional) {
  for (const std::span<const OptionalFormat> formats : {std::span<const OptionalFormat>(kEveryBuilds), optional})
    for (const OptionalFormat& format : formats) codecs_[static_cast<std::size_t>(format.id)] = format.codec;
}

const FormatRegistry& FormatRegistry::ofThisBuild() {
  static const FormatRegistry registry(optionalFormats());
  return registry;
}

Result<const FormatCodec*> FormatRegistry::codecFor(Span bytes) const {
  const std::optional<ImageFormatId> id = formatBegunBy(bytes);
  if (!id) return nullptr;
  const ImageFormat& format = formatOf(*id);
  if (!has(*id)) return leftOut("reads no " + std::string(format.name), format.build_option);
  return &(*this)[*id];
}

std::optional<ImageFormatId> formatBegunBy(Span bytes) {
  // TGA has no first bytes of its own, and is asked for last.
  for (const ImageFormat& format : kImageFormats)
    if (format.id != ImageFormatId::tga && kBegins[static_cast<std::size_t>(format.id)](bytes)) return format.id;
  if (isTga(bytes)) return ImageFormatId::tga;
  // A JPEG may stand behind bytes that belong to nothing; but where these begin a file of another kind, such as an
  // archive with a JPEG in it, the file is not meant as that picture.
  const bool is_late_jpeg = beginOfJpeg(bytes) && !foreignFileError(FileUse::picture, bytes);
  return is_late_jpeg ? std::optional(ImageFormatId::jpeg) : std::nullopt;
}

Result<Bytes> encodePicture(ImageFormatId id, const Image8& picture, const Metadata& metadata) {
  const ImageFormat& format = formatOf(id);
  if (!isInThisBuild(format)) return leftOut("writes no " + std::string(format.name), format.build_option);
  return FormatRegistry::ofThisBuild()[id].encode_picture(picture, metadata, OutputPrimaries::rec709);
}

}  // namespace mirrorball
