#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/option.h"
#include "mirrorball/base/result.h"
#include "mirrorball/codec/color/output_primaries.h"

namespace mirrorball {

/// What the files of a format hold.
enum class Holds {
  light,    ///< linear radiance, in floats
  picture,  ///< integers, encoded as sRGB unless the file says otherwise
  either,   ///< integers as pictures have them, or floats that are light
  texture,  ///< images as a GPU has them: mip levels, cubes, arrays
};

/// The formats that are read, some of which are written; a format's number is its place in kImageFormats.
enum class ImageFormatId { hdr, exr, png, jpeg, ktx2, ktx, dds, tiff, webp, avif, jxl, tga, bmp, pnm, pfm };

/// Which primaries files that are written may state.
enum class StatedPrimaries {
  none,         ///< that is Rec.709's
  of_displays,  ///< all but ACEScg, which is for linear light
  all,
};

struct ImageFormat {
  ImageFormatId id;
  std::string_view name;        ///< "Radiance HDR"
  std::string_view extensions;  ///< "jpg jpeg": in names of files, the usual one first
  Holds holds;
  bool is_written;
  std::string_view what;               ///< what is read of it, for the documentation
  std::string_view build_option = {};  ///< of a format that a build may leave out: "MIRRORBALL_TIFF"
  StatedPrimaries states = StatedPrimaries::none;
};

/// The one list of formats: every message, help text and page that names some is made from it, in its order, and names
/// those that the build has (isInThisBuild).
inline constexpr std::array<ImageFormat, 15> kImageFormats{{
    {ImageFormatId::hdr, "Radiance HDR", "hdr", Holds::light, true,
     "RGBE and XYZE; run-length coded, old and new, or flat; any orientation", "", StatedPrimaries::all},
    {ImageFormatId::exr, "OpenEXR", "exr", Holds::light, true,
     "half, float and integers; scan lines and tiles; every compression of OpenEXR 3; luminance and chroma",
     "MIRRORBALL_EXR", StatedPrimaries::all},
    {ImageFormatId::png, "PNG", "png", Holds::picture, true,
     "every kind and depth; `cICP`, `sRGB`, `iCCP`, `gAMA`, `cHRM`", "MIRRORBALL_PNG", StatedPrimaries::of_displays},
    {ImageFormatId::jpeg, "JPEG", "jpg jpeg", Holds::picture, true,
     "grey, RGB and CMYK, baseline and progressive; gain maps (Ultra HDR, ISO 21496-1)", "MIRRORBALL_JPEG"},
    {ImageFormatId::ktx2, "KTX2", "ktx2", Holds::texture, true,
     "8- and 16-bit unorm, sRGB, half, float, b10g11r11, e5b9g9r9, BC6H, UASTC HDR 4x4; Zstandard", "",
     StatedPrimaries::all},
    {ImageFormatId::ktx, "KTX", "ktx", Holds::texture, true, "the same formats, in either byte order"},
    {ImageFormatId::dds, "DDS", "dds", Holds::texture, true,
     "the same formats, and masks of older files: 5:6:5, 10:10:10:2"},
    {ImageFormatId::tiff, "TIFF", "tif tiff", Holds::either, false,
     "integers of up to 16 bits and of 32, floats of 16, 32 and 64; grey, RGB, palette, LogLuv; plain, LZW, deflate, "
     "PackBits, Zstandard, JPEG; strips and tiles, BigTIFF",
     "MIRRORBALL_TIFF"},
    {ImageFormatId::webp, "WebP", "webp", Holds::picture, false, "lossy and lossless, alpha; no animations",
     "MIRRORBALL_WEBP"},
    {ImageFormatId::avif, "AVIF", "avif", Holds::picture, false,
     "8, 10 and 12 bits, alpha; PQ and HLG, primaries; no animations", "MIRRORBALL_AVIF"},
    {ImageFormatId::jxl, "JPEG XL", "jxl", Holds::either, false,
     "integers of up to 16 bits and floats, lossy and lossless, alpha; PQ and HLG, primaries; no animations",
     "MIRRORBALL_JXL"},
    {ImageFormatId::tga, "TGA", "tga", Holds::picture, false,
     "grey, palette, 15, 16, 24 and 32 bits; run-length coded or not"},
    {ImageFormatId::bmp, "BMP", "bmp", Holds::picture, false, "palettes, RLE4, RLE8, 16, 24 and 32 bits, masks, alpha"},
    {ImageFormatId::pnm, "PNM", "pnm ppm pgm pbm pam", Holds::picture, false, "P1 to P7, text or bytes, up to 16 bits"},
    {ImageFormatId::pfm, "PFM", "pfm", Holds::light, false, "grey, RGB and RGBA, either byte order"},
}};

constexpr const ImageFormat& formatOf(ImageFormatId id) { return kImageFormats[static_cast<std::size_t>(id)]; }

/// Whether this build reads the format, and writes it if it is written.
bool isInThisBuild(const ImageFormat& format);

/// Whether the format has files that hold that: TIFF has pictures and light.
constexpr bool mayHold(const ImageFormat& format, Holds what) {
  return format.holds == what || (format.holds == Holds::either && (what == Holds::light || what == Holds::picture));
}

/// "jpg"
constexpr std::string_view usualExtension(const ImageFormat& format) {
  return format.extensions.substr(0, format.extensions.find(' '));
}

/// The usual extensions of all formats that are read: ".hdr .exr .png".
std::string_view readExtensions();

/// The same of those that may hold one thing.
std::string readExtensions(Holds what);

/// The usual extensions of all formats that are written: ".hdr .exr .png"; ".hdr, .exr or .png".
std::string writtenExtensions(std::string_view before_last = " ");

/// The same of those that hold one thing.
std::string writtenExtensions(Holds what, std::string_view before_last = " ");

/// The usual extensions of all formats that are written, without their dots.
std::vector<std::string_view> writtenExtensionNames();

/// The same of those that hold one thing.
std::vector<std::string_view> writtenExtensionNames(Holds what);

/// "Radiance HDR, OpenEXR, PNG or JPEG": the formats that are read.
std::string readFormatNames();

/// The same of those that may hold one thing.
std::string readFormatNames(Holds what);

/// --primaries, of every command that writes light or pictures of it: the names of OutputPrimaries.
///
/// help     primariesHelp(); must outlive it
OptionText primariesText(std::string_view help);
/// What it says.
///
/// written  what the command writes
std::string primariesHelp(std::initializer_list<Holds> written);

/// Refuses primaries that a file of that name cannot state: what it holds would be taken for other colours.
///
/// wanted   what the format may hold
/// errors   usage: lists the extensions that can; formatToWrite's
Result<void> checkStatesPrimaries(const std::filesystem::path& path, OutputPrimaries primaries,
                                  std::initializer_list<Holds> wanted);

/// The format that is written under a name with that extension.
///
/// wanted   what the format may hold; the message lists them in this order
/// errors   usage: it is none of those; unsupported: the build lacks it
Result<ImageFormatId> formatToWrite(const std::filesystem::path& path, std::initializer_list<Holds> wanted);

class FormatRegistry;

/// The same of another build's formats.
Result<ImageFormatId> formatToWrite(const std::filesystem::path& path, std::initializer_list<Holds> wanted,
                                    const FormatRegistry& formats);

}  // namespace mirrorball
