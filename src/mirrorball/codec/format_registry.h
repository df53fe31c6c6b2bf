#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/codec/ldr/coded_file.h"
#include "mirrorball/codec/row_reader.h"

namespace mirrorball {

/// How the files of one format are read and written. What is nullptr is not done with it.
struct FormatCodec {
  /// To light; nothing where a file's integers are all there is of it, of which asImage makes it.
  Result<DecodedImage> (*decode)(std::span<const std::uint8_t> bytes, const ImageReadOptions& options) = nullptr;
  /// To integers as stored; nothing where the format has none, or is none of pictures.
  Result<CodedFile> (*decode_codes)(std::span<const std::uint8_t> bytes, CodeForm form) = nullptr;
  /// Whether a file holds integers, of a format whose files may also hold floats.
  bool (*holds_integers)(std::span<const std::uint8_t> bytes) = nullptr;
  /// For reading some rows at a time; see openRows.
  Result<std::unique_ptr<RowReader>> (*open_rows)(FileReader file, const ImageReadOptions& options) = nullptr;
  /// Linear light as it is.
  Result<Bytes> (*encode)(const Image& light, const ImageWriteOptions& options) = nullptr;
  /// Encoded pictures, of which the format keeps so many channels; primaries are some that it can state.
  Result<Bytes> (*encode_picture)(const Image8& picture, const Metadata& metadata, OutputPrimaries primaries) = nullptr;
  /// The same with a gain map beside them, by which they hold linear light.
  Result<Bytes> (*encode_with_gain_map)(const Image8& picture, const Image& light, const Metadata& metadata) = nullptr;
  /// XMP that a search of the file's bytes does not find: compressed_xmp.h.
  std::string (*compressed_xmp)(std::span<const std::uint8_t> bytes) = nullptr;
  int picture_channels = 4;
};

/// A decode() of files with one picture, that is done before a progress could be told.
template <Result<DecodedImage> (*decode)(std::span<const std::uint8_t> bytes)>
Result<DecodedImage> withoutOptions(std::span<const std::uint8_t> bytes, const ImageReadOptions&) {
  return decode(bytes);
}

/// A format that a build may leave out, and has.
struct OptionalFormat {
  ImageFormatId id;
  FormatCodec codec;
};

/// Those of this build. CMake writes the function, from the targets that there are (codec/CMakeLists.txt).
std::span<const OptionalFormat> optionalFormats();

/// The formats that a build reads.
class FormatRegistry {
 public:
  /// Those that every build has, and these.
  explicit FormatRegistry(std::span<const OptionalFormat> optional);

  static const FormatRegistry& ofThisBuild();

  bool has(ImageFormatId format) const { return codecs_[static_cast<std::size_t>(format)].has_value(); }

  /// The codec of a format that this has.
  const FormatCodec& operator[](ImageFormatId format) const { return *codecs_[static_cast<std::size_t>(format)]; }

  /// The codec of the format that the bytes begin as; nullptr where they begin as none.
  ///
  /// errors   unsupported: this lacks the format
  Result<const FormatCodec*> codecFor(std::span<const std::uint8_t> bytes) const;

 private:
  std::array<std::optional<FormatCodec>, kImageFormats.size()> codecs_;
};

/// The format that a file's first bytes tell, whether a build has it or not.
std::optional<ImageFormatId> formatBegunBy(std::span<const std::uint8_t> bytes);

/// The bytes of a picture's file.
///
/// format   one that holds pictures and is written
/// errors   unsupported: the build lacks the format; else as the format's own encoder
Result<Bytes> encodePicture(ImageFormatId format, const Image8& picture, const Metadata& metadata);

}  // namespace mirrorball
