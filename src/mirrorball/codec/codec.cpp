#include "mirrorball/codec/codec.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "mirrorball/codec/exr.h"
#include "mirrorball/codec/hdr.h"
#include "mirrorball/codec/jpeg.h"
#include "mirrorball/codec/metadata.h"
#include "mirrorball/codec/png.h"
#include "mirrorball/codec/srgb.h"
#include "mirrorball/codec/within_memory.h"

namespace mirrorball {
namespace {

using Span = std::span<const std::uint8_t>;

enum class Format { exr, hdr, png, jpeg };

struct Extension {
  std::string_view text;
  Format format;
};
constexpr std::array<Extension, 5> kExtensions{
    {{"exr", Format::exr}, {"hdr", Format::hdr}, {"png", Format::png}, {"jpg", Format::jpeg}, {"jpeg", Format::jpeg}}};

/// The format that the name asks for.
Result<Format> formatOf(const std::filesystem::path& path) {
  const std::string extension = extensionOf(path);
  for (const Extension& known : kExtensions)
    if (extension == known.text) return known.format;
  return fail(ErrorCode::usage, path.string() +
                                    ": its extension names no format that is written; use .exr or .hdr "
                                    "for linear light, .png or .jpg for pictures");
}

/// The error for bytes that no codec takes.
tl::unexpected<Error> unknownFormat(Span bytes, const std::string& name, std::string_view known) {
  if (bytes.empty()) return fail(ErrorCode::bad_file, name + ": is empty");
  constexpr char kDigits[] = "0123456789abcdef";
  std::string begins;
  for (const std::uint8_t byte : bytes.first(std::min<std::size_t>(bytes.size(), 4))) {
    begins += ' ';
    begins += kDigits[byte >> 4];
    begins += kDigits[byte & 15];
  }
  return fail(ErrorCode::bad_file, name +
                                       ": is not an image that can be read (it begins with the "
                                       "bytes" +
                                       begins + "); use " + std::string(known));
}

Result<DecodedImage> decodeByMagic(Span bytes, const std::string& name, const ProgressFunction& progress) {
  if (isHdr(bytes)) return decodeHdr(bytes, name);
  if (isExr(bytes)) return decodeExr(bytes, name, progress);
  if (isPng(bytes)) return decodePng(bytes, name);
  if (isJpeg(bytes)) return decodeJpeg(bytes, name);
  return unknownFormat(bytes, name, "Radiance HDR, OpenEXR, PNG or JPEG");
}

Result<Image8> decodeTextureByMagic(Span bytes, const std::string& name) {
  if (isPng(bytes)) return decodePngTexture(bytes, name);
  if (isJpeg(bytes)) return decodeJpegTexture(bytes, name);
  return unknownFormat(bytes, name, "PNG or JPEG for textures");
}

Result<Bytes> encodePicture(Format format, const Image8& picture, const Metadata& metadata, const std::string& name) {
  if (format == Format::png) return encodePng(picture, metadata, name);
  return encodeJpeg(picture, metadata, name);
}

Result<Bytes> encodeImage(Format format, const Image& image, const ImageWriteOptions& options,
                          const std::string& name) {
  if (format == Format::exr) return encodeExr(image, options, name);
  if (format == Format::hdr) return encodeHdr(image, options.metadata);
  const int channels = format == Format::jpeg ? std::min(image.channels(), 3) : image.channels();
  return encodePicture(format, pictureFromLinear(image, channels), options.metadata, name);
}

template <typename Sample>
Result<void> checkShape(const ImageOf<Sample>& image, const std::string& name) {
  if (image.empty()) return fail(ErrorCode::bad_shape, name + ": an image of no texels cannot be written");
  if (image.channels() == 2)
    return fail(ErrorCode::bad_shape, name + ": an image of 2 channels cannot be written; give it 1, 3 or 4");
  return {};
}

}  // namespace

Result<DecodedImage> readImage(const std::filesystem::path& path) {
  const std::string name = path.string();
  return withinMemory<DecodedImage>(name, [&]() -> Result<DecodedImage> {
    MIRRORBALL_TRY(bytes, readFile(path));
    return decodeByMagic(bytes, name, {});
  });
}

Result<DecodedImage> decodeImage(Span bytes, const std::string& name, const ProgressFunction& progress) {
  return withinMemory<DecodedImage>(name, [&] { return decodeByMagic(bytes, name, progress); });
}

Result<void> writeImage(const std::filesystem::path& path, const Image& image, const ImageWriteOptions& options) {
  const std::string name = path.string();
  MIRRORBALL_TRY(format, formatOf(path));
  MIRRORBALL_TRY_VOID(checkShape(image, name));
  MIRRORBALL_TRY_VOID(checkMetadata(options.metadata));
  MIRRORBALL_TRY(bytes, withinMemory<Bytes>(name, [&] { return encodeImage(format, image, options, name); }));
  return writeFile(path, bytes);
}

Result<Image8> decodeTexture(Span bytes, const std::string& name) {
  return withinMemory<Image8>(name, [&] { return decodeTextureByMagic(bytes, name); });
}

Result<void> writePicture(const std::filesystem::path& path, const Image8& picture, const Metadata& metadata) {
  const std::string name = path.string();
  MIRRORBALL_TRY(format, formatOf(path));
  if (format != Format::png && format != Format::jpeg)
    return fail(ErrorCode::usage, name + ": holds linear light, not a picture; use .png or .jpg");
  MIRRORBALL_TRY_VOID(checkShape(picture, name));
  MIRRORBALL_TRY_VOID(checkMetadata(metadata));
  MIRRORBALL_TRY(bytes, withinMemory<Bytes>(name, [&] { return encodePicture(format, picture, metadata, name); }));
  return writeFile(path, bytes);
}

Result<void> checkWritable(const std::filesystem::path& path) {
  MIRRORBALL_TRY_VOID(formatOf(path));
  return {};
}

bool storesLinearLight(const std::filesystem::path& path) {
  const auto format = formatOf(path);
  return format && (*format == Format::exr || *format == Format::hdr);
}

}  // namespace mirrorball
