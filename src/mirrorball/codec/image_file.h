#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>

#include "mirrorball/base/file.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/codec/color/coded_color.h"
#include "mirrorball/codec/color/dither.h"
#include "mirrorball/codec/color/output_primaries.h"
#include "mirrorball/codec/exif.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// Texts that travel with an image: key → value. The keys that this program writes and reads:
///   "mirrorball:projection"     equirect | sphere | angular | cube | …: environment/projection/projection.h
///   "mirrorball:layout"         the layout of a cube's faces
///   "mirrorball:ball_distance"  of a photographed ball: ball radii from its centre to the camera
///   "mirrorball:arrangement"    how the images of a cube lie: environment/cube/cube_arrangement.h
///   "mirrorball:centre"         what is in the middle of a panorama: "+x", "-x" or "-z"
///   "mirrorball:texels"         "on-edges" for OpenEXR's registration
///   "mirrorball:sheet"          "mip levels" for a sheet of mip levels, which is not a map
///   "mirrorball:table"          "brdf" for a BRDF table; its parameters: "mirrorball:brdf_…", output/baked/brdf_file.h
///   "envmap"                    OpenEXR's own attribute, read as "latlong" or "cube"
///   "sh"                        Filament's, in KTX: harmonics of irradiance, bake/harmonics/filament_harmonics.h
using Metadata = std::map<std::string, std::string>;

/// What became of a gain map, by which a JPEG holds light brighter than white (Ultra HDR, ISO 21496-1).
enum class GainMapUse {
  none,     ///< the file speaks of none, or of one that is damaged, as a remark says
  applied,  ///< the image is the light that picture and gain map hold
  lost,     ///< the file says that it has one, and has lost it: the image is the picture alone
};

/// The part of a larger picture that a file holds: OpenEXR's data window in its display window, or a cropped panorama.
/// An image of the larger picture's size has been placed in it: black outside of the part, cut where it reaches beyond.
struct PictureWindow {
  glm::ivec2 whole{0};   ///< size of the larger picture [texels]
  glm::ivec2 corner{0};  ///< of the part's upper left texel in it; negative where the part reaches beyond it (overscan)
  std::string source = {};  ///< what says so: "its display window", "GPano"
  glm::ivec2 size{0};       ///< of the part in the file [texels]; 0: as the image
};

/// One of the pictures in a file of several: a layer of OpenEXR.
struct PictureLayer {
  std::string name;      ///< for ImageReadOptions::layer; no two of a file are the same
  std::string channels;  ///< as the file names them, without the layer: "R G B A", "X Y Z", "Z"
};

/// An image as it comes from a file.
struct DecodedImage {
  Image image;  ///< linear light, Rec.709, or numbers (ImageReadOptions::as); 1, 3 or 4 channels
  Metadata metadata;
  std::string format;      ///< as `info` shows it: "Radiance HDR, RLE", "OpenEXR, half, DWAB", "PNG, 8 bit"
  std::string color = {};  ///< the file's, and what was done about it: describeColor in codec/color/primaries.h
  GainMapUse gain_map = GainMapUse::none;
  std::optional<PictureWindow> window = {};  ///< where the file holds a part of a larger picture, or more than it;
                                             ///< one of `oddities` says so: windowText
  std::vector<PictureLayer> layers = {};     ///< to choose from (ImageReadOptions::layer), if there are several
  std::string layer = {};                    ///< the one that was read, of a format that has layers
  std::string layer_guess = {};              ///< the one of `oddities` that says that it was chosen among several,
                                             ///< since none was asked for; empty: there was no choice
  std::vector<std::string> oddities = {};  ///< what is unusual in the file and how it was read; lines without its name
  bool is_converted = false;               ///< the samples are light, not what ReadAs::numbers gives
};

/// What the samples of an image's file are.
enum class ReadAs {
  light,    ///< colours: brought to linear light with Rec.709's primaries by what the file states
  numbers,  ///< not colours, as normals, roughness and heights: as the file holds them, integers as fractions of their
            ///< greatest; a colour space that the file states is not applied, with a remark
};

/// How to read an image's file.
struct ImageReadOptions {
  std::string layer = {};          ///< of a file of several pictures (DecodedImage::layers); empty: the picture
  ProgressFunction progress = {};  ///< told by OpenEXR and TIFF, which take seconds for large compressed pictures
  ReadAs as = ReadAs::light;
};

/// What is read of a picture's file, upright, with remarks on the file.
template <typename Picture>
struct Decoded {
  Picture picture;
  std::vector<std::string> oddities = {};  ///< DecodedImage's
  std::string layer_guess = {};            ///< DecodedImage's
  bool is_converted = false;               ///< DecodedImage's
};

/// A picture as a camera or a program encoded it.
template <typename Codes>
struct EncodedPictureOf {
  Codes codes;                             ///< alpha straight, upright
  CodedColor color = {};                   ///< what they stand for, as far as the file says
  Exif exif = {};                          ///< its orientation is that of the file, not of the codes
  std::vector<std::string> oddities = {};  ///< DecodedImage's
};
using PictureCodes = EncodedPictureOf<Image8>;     ///< codes of 8 bits, 4 channels
using PictureFractions = EncodedPictureOf<Image>;  ///< fractions of the greatest code, the file's channels

/// What travels in an OpenEXR file beside its image: "albedo.R", "normal.X".
struct ImageLayer {
  std::string name;      ///< "albedo"
  std::string channels;  ///< a letter for each: "RGB", "XYZ"
  Image image;           ///< of the main image's size
};

/// How writeImage stores floats.
struct ImageWriteOptions {
  bool half = false;  ///< OpenEXR: 16-bit floats instead of 32-bit ones
  Metadata metadata;
  std::vector<ImageLayer> layers = {};  ///< OpenEXR alone
  /// That the image has, and the file states; what is in memory is brought to them by convertFromRec709.
  OutputPrimaries primaries = OutputPrimaries::rec709;
  Dither dither = Dither::none;  ///< of formats of 8 bits
};

/// Reads a file that is to be decoded, as a whole. A large one that holds no image is refused by what it begins and
/// ends with, before its memory is taken.
///
/// errors   as readFile's; bad_file, unsupported: it is none of image_format.h
Result<Bytes> readImageFile(const std::filesystem::path& path);

/// Reads every format of image_format.h by its first bytes, not by its name. Integers are decoded to linear light, from
/// sRGB unless a PNG states another curve; floats are linear light, and so is a JPEG with a gain map. Of a texture with
/// one face, the largest level is read. NaN and infinity are kept: callers that need light check with findNonFinite.
///
/// errors   not_found (also no layer of that name; lists them); io; bad_file (what is wrong and at which byte);
///          too_large; unsupported (also a format that the build lacks); interrupted, when the progress says so
Result<DecodedImage> readImage(const std::filesystem::path& path, const ImageReadOptions& options = {});

/// The same from memory.
Result<DecodedImage> decodeImage(std::span<const std::uint8_t> bytes, const ImageReadOptions& options = {});

/// Whether the bytes begin as one of the files that decodeImage takes, or names where the build lacks their format.
bool isImage(std::span<const std::uint8_t> bytes);

/// Writes linear light by the name's extension: .exr .hdr as it is, .png .jpg encoded to sRGB and
/// clipped to [0, 1]. PNG keeps straight alpha, EXR premultiplied (the caller's samples are taken
/// as the format wants them), HDR and JPEG drop it.
///
/// errors   usage (not an extension that can be written; lists those that can; layers in another file than .exr;
///          primaries that the format cannot state); io; bad_shape (a number of channels that the format cannot hold)
Result<void> writeImage(const std::filesystem::path& path, const Image& image, const ImageWriteOptions& options = {});

/// Decodes a picture of integers (PNG, JPEG, TIFF, WebP, AVIF, JPEG XL, TGA, BMP, PNM) to its 8-bit codes, upright and
/// otherwise as stored: no colour conversion, no gain map; more bits are rounded. Alpha is 255 where the file has none.
///
/// errors   as decodeImage's; unsupported: the file holds no integers
Result<PictureCodes> decodeCodes(std::span<const std::uint8_t> bytes);

/// Decodes it to its codes, as decodeCodes does, or where they are proportional to light to their fractions of the
/// greatest one, with all bits.
Result<std::variant<PictureCodes, PictureFractions>> decodeCodesOrFractions(std::span<const std::uint8_t> bytes);

/// The codes alone, for files that need no remark.
Result<Image8> decodeTexture(std::span<const std::uint8_t> bytes);

/// Decodes a picture as ReadAs::numbers.
///
/// options  of which `as` does not count
/// returns  1, 3 or 4 channels
/// errors   as decodeImage's
Result<Decoded<Image>> decodeNumbers(std::span<const std::uint8_t> bytes, const ImageReadOptions& options = {});

/// Decodes a texture that shows colours: codes of sRGB with 8 bits, into which other colours of a file of integers are
/// converted as far as they fit; else linear light with Rec.709's primaries.
///
/// returns  4 channels
/// errors   as decodeImage's
Result<Decoded<Texels>> decodeColorTexture(std::span<const std::uint8_t> bytes);

/// Decodes a texture as ReadAs::numbers: codes of 8 bits as they are stored; finer ones, and floats, as decodeNumbers
/// does.
///
/// options  of which `as` does not count
/// returns  4 channels, alpha 1 where the file has none
/// errors   as decodeImage's
Result<Decoded<Texels>> decodeDataTexture(std::span<const std::uint8_t> bytes, const ImageReadOptions& options = {});

/// Whether the bytes begin like a format of integers that decodeCodes takes. A TIFF must also hold integers.
bool holdsCodes(std::span<const std::uint8_t> bytes);

/// Writes an encoded picture of 3 or 4 channels (straight alpha; JPEG drops it) as .png or .jpg.
Result<void> savePicture(const std::filesystem::path& path, const Image8& picture, const Metadata& metadata = {});

/// Writes an encoded picture as .jpg, with a gain map beside it: every reader shows the picture, and those that know of
/// gain maps (Ultra HDR, ISO 21496-1), readImage among them, have the light.
///
/// light    linear, of the picture's size, white at 1
/// errors   as savePicture's; usage: checkHoldsGainMap's
Result<void> savePictureWithGainMap(const std::filesystem::path& path, const Image8& picture, const Image& light,
                                    const Metadata& metadata = {});

/// Whether the extension of `path` is one of files that are written with a gain map; the error names it.
Result<void> checkHoldsGainMap(const std::filesystem::path& path);

/// Whether the extension of `path` is one that writeImage takes; the error lists the right ones.
Result<void> checkWritable(const std::filesystem::path& path);

/// Whether the extension names a format of linear light (.exr .hdr).
bool storesLinearLight(const std::filesystem::path& path);

}  // namespace mirrorball
