#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {

/// How texels are stored in a texture file that is written. All formats hold linear light.
enum class TexelFormat {
  half,        ///< r16g16b16a16 sfloat, 8 bytes: ±65504
  float32,     ///< r32g32b32a32 sfloat, 16 bytes
  b10g11r11,   ///< b10g11r11 ufloat, 4 bytes: 6 bits of mantissa (blue 5), 0 to 65024 (blue 64512), no alpha
  e5b9g9r9,    ///< e5b9g9r9 ufloat, 4 bytes: 9 bits of mantissa under a common exponent, 0 to 65408, no alpha
  bc6h,        ///< bc6h ufloat, 16 bytes for 4 x 4 texels: 0 to 65504 with an error (conventions/files.md), no alpha
  uastc_hdr,   ///< astc 4x4 sfloat, likewise: UASTC HDR 4x4, which becomes BC6H for GPUs without ASTC HDR; KTX2 only
  rg_half,     ///< r16g16 sfloat, 4 bytes: red and green only
  rg_float32,  ///< r32g32 sfloat, 8 bytes
};

/// The name by which a format is requested. Formats of two channels have no name: they are chosen for images of two
/// channels.
struct TexelFormatName {
  TexelFormat format;
  std::string_view name;
  std::string_view also;  ///< other names, with spaces between
  bool is_in_exr;         ///< as a picture's samples
  bool is_only_in_ktx2 = false;
};

/// The one list of them, in the order of TexelFormat.
inline constexpr std::array<TexelFormatName, 6> kTexelFormatNames{{
    {TexelFormat::half, "half", "float16 fp16 f16", true},
    {TexelFormat::float32, "float32", "float fp32 f32", true},
    {TexelFormat::b10g11r11, "b10g11r11", "r11g11b10 r11g11b10f", false},
    {TexelFormat::e5b9g9r9, "e5b9g9r9", "rgb9e5 r9g9b9e5", false},
    {TexelFormat::bc6h, "bc6h", "bc6 bc6hu", false},
    {TexelFormat::uastc_hdr, "uastc_hdr", "uastc_hdr_4x4 uastc", false, true},
}};

/// Whether a texture, or a picture in .exr, can have texels of a format.
///
/// extension of the file: "exr", "ktx2"
bool holdsFormat(std::string_view extension, TexelFormat format);

/// Their names: of all, or of those that a file of this extension can have.
std::vector<std::string_view> texelFormatNames(std::string_view extension = {});

struct TextureWriteOptions {
  TexelFormat format = TexelFormat::half;
  int zstandard_level = 0;  ///< KTX2: 0 stores texels as they are, 1 (fast) to 22 (small) compresses each level
  Metadata metadata = {};   ///< KTX2 and KTX keep it, DDS has no place for it
  OutputPrimaries primaries = OutputPrimaries::rec709;  ///< that the images have, and a KTX2 states
  /// Told while writeImageSet compresses and writes, which takes seconds for large maps.
  ProgressFunction progress = {};
};

/// The images of a texture as they come from a file.
struct DecodedImageSet {
  ImageSet images;  ///< linear light, Rec.709, or numbers; 1, 3 or 4 channels; row 0 on top
  Metadata metadata;
  std::string format;                      ///< as `info` shows it: "KTX2, r16g16b16a16 sfloat, Zstandard"
  std::string color = {};                  ///< as DecodedImage's
  std::vector<std::string> oddities = {};  ///< likewise
  bool is_converted = false;               ///< likewise
  std::string channel_guess = {};  ///< the one of `oddities` that says that red and blue may be exchanged; empty: none
};

/// Reads .ktx2 .ktx .dds by their first bytes: two-dimensional textures and cubes, their mip levels and arrays, in
/// 8- and 16-bit unorm, sRGB, half, float, b10g11r11, e5b9g9r9, BC6H and UASTC HDR 4x4. One channel stays one (grey),
/// two become red and green.
/// sRGB formats, and 8-bit DDS files from before DX10, are decoded to linear light; unorm is taken as it stands.
/// A picture stored bottom up or right to left (KTXorientation) is turned; the faces of a cube are left as a GPU
/// would see them. Primaries that a KTX2 file names are converted to Rec.709.
///
/// errors   not_found; io; bad_file (what is wrong and at which byte); too_large; unsupported (other block
///          compressions: the format is named, and of ASTC the first block that is none of UASTC HDR; one- and
///          three-dimensional textures)
Result<DecodedImageSet> readImageSet(const std::filesystem::path& path);

/// The same from memory; numbers without sRGB's decoding and other primaries.
Result<DecodedImageSet> decodeImageSet(std::span<const std::uint8_t> bytes, ReadAs as = ReadAs::light);

/// Whether the bytes begin as one of the files that decodeImageSet takes.
bool isImageSet(std::span<const std::uint8_t> bytes);

/// Writes a texture by the name's extension, .ktx2, .ktx or .dds. Values are rounded to the nearest that the format
/// has, or compressed with some error, never clipped.
///
/// images   1, 3 or 4 channels, the same in all, or 2 for the formats that have two; each level half the size of the
///          one before, rounded down; 1 face, or 6 square ones
/// errors   usage (an unknown extension, a format, primaries or a Zstandard level that only KTX2 has, metadata that
///          cannot be stored); bad_shape; io; out_of_range (the first texel that does not fit the format is named;
///          where levels are compressed, the first of the smallest level that has one); too_large; interrupted (when
///          `progress` says so)
/// cost     what writing the bytes costs: texels are converted on all cores on their way into the file; bc6h some
///          13 million texels a second and core, uastc_hdr 3
Result<void> writeImageSet(const std::filesystem::path& path, const ImageSet& images,
                           const TextureWriteOptions& options = {});

/// The same into a file that is open, and stays so.
Result<void> writeImageSet(const FileWriter& file, const ImageSet& images, const TextureWriteOptions& options = {});

/// A texture file of one level that is written strip by strip, for images that are never in memory as a whole. Without
/// commit() the file is removed.
class TextureWriter {
 public:
  /// size     of each image
  /// faces    1 or 6
  /// channels of the texels that will be written
  /// options  without Zstandard, which needs a level as a whole
  /// errors   usage (an unknown extension); io; bad_file, too_large (no texture has that size)
  static Result<TextureWriter> create(const std::filesystem::path& path, glm::ivec2 size, int faces, int channels,
                                      const TextureWriteOptions& options);

  /// Writes a rectangle of an image's texels; called from several threads at a time.
  ///
  /// begin    where its first texel is in the image; for compressed formats both numbers are multiples of 4, and so are
  ///          the rectangle's width and height, except at the image's edges
  /// errors   io; out_of_range (the first texel that does not fit the format is named)
  Result<void> write(int face, glm::ivec2 begin, const Image& texels) const {
    return withName(file_.name(), writeTexels(face, begin, texels));
  }

  /// Gives the file its name.
  Result<void> commit() { return withName(file_.name(), file_.commit()); }

 private:
  TextureWriter(FileWriter file, glm::ivec2 size, TexelFormat format)
      : file_(std::move(file)), size_(size), format_(format) {}
  Result<void> writeTexels(int face, glm::ivec2 begin, const Image& texels) const;

  FileWriter file_;
  glm::ivec2 size_;
  TexelFormat format_;
  std::vector<std::uint64_t> offsets_ = {};  // of each face
};

/// Whether the extension names a texture file that writeImageSet takes.
bool isTexturePath(const std::filesystem::path& path);

}  // namespace mirrorball
