#include "mirrorball/codec/foreign_file.h"

#include <algorithm>
#include <array>
#include <string>

#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

using namespace std::string_view_literals;

/// Where the bytes stand that tell a kind.
enum class Mark {
  at_begin,
  in_box,     ///< behind the size of a first box of MPEG-4 or JPEG 2000: at byte 4
  in_markup,  ///< anywhere in the beginning of a text that begins with '<', in small letters here and in any there
};

/// A kind of file that this program does not read.
struct ForeignFormat {
  std::string_view extensions;  ///< "usd usda"; empty where they are not asked
  std::string_view name;        ///< with its article
  Mark mark;
  std::string_view bytes;  ///< empty where they do not tell
  FileUse use;
  std::string_view advice;  ///< to who wants it as what it is
};

constexpr std::string_view kUnpack = "unpack it";
constexpr std::string_view kToPng = "save it as PNG";
constexpr std::string_view kToLight = "save it as OpenEXR, or as PNG";
constexpr std::string_view kFrame = "save one of its frames as PNG";
constexpr std::string_view kDevelop = "develop it to OpenEXR, or to a TIFF of 16 bits";
constexpr std::string_view kBlender = "open it in Blender and export it as glTF 2.0 (.glb)";
constexpr std::string_view kFreeCad = "open it in FreeCAD and export it as glTF 2.0 (.glb)";
constexpr std::string_view kMaya = "open it in Maya and export it as glTF 2.0 (.glb)";
constexpr std::string_view kDownload = "it came in the file's place: download the file itself";

/// The first that fits counts. From the specifications of the formats and, for the many that have none at hand, the
/// table of file(1) (https://github.com/file/file/tree/master/magic/Magdir).
constexpr auto kForeignFormats = std::to_array<ForeignFormat>({
    {"", "a Git LFS pointer", Mark::at_begin, "version https://git-lfs.github.com/spec/", FileUse::any,
     "run `git lfs pull`, which fetches the file that it stands for"},
    {"", "a web page", Mark::in_markup, "<!doctype html", FileUse::any, kDownload},
    {"", "a web page", Mark::in_markup, "<html", FileUse::any, kDownload},
    {"", "a server's message", Mark::in_markup, "<error>", FileUse::any, kDownload},
    {"", "compressed by gzip", Mark::at_begin, "\x1f\x8b\x08", FileUse::any, "unpack it: `gunzip` does"},
    {"", "compressed by bzip2", Mark::at_begin, "BZh", FileUse::any, "unpack it: `bunzip2` does"},
    {"usdz", "a USD", Mark::at_begin, "", FileUse::model, kBlender},  // a zip archive
    {"", "a zip archive", Mark::at_begin, "PK\x03\x04", FileUse::any, kUnpack},
    {"", "a 7-Zip archive", Mark::at_begin, "7z\xbc\xaf\x27\x1c", FileUse::any, kUnpack},
    {"", "a RAR archive", Mark::at_begin, "Rar!\x1a\x07", FileUse::any, kUnpack},
    {"", "an xz archive", Mark::at_begin, "\xfd\x37zXZ\0"sv, FileUse::any, kUnpack},
    {"", "a Zstandard archive", Mark::at_begin, "\x28\xb5\x2f\xfd", FileUse::any, kUnpack},

    {"", "a Photoshop document", Mark::at_begin, "8BPS", FileUse::picture, kToLight},
    {"", "a GIF", Mark::at_begin, "GIF8", FileUse::picture, kToPng},
    {"", "an SVG", Mark::in_markup, "<svg", FileUse::picture, kToPng},
    {"", "a PDF", Mark::at_begin, "%PDF-", FileUse::picture, kToPng},
    {"", "a GIMP document", Mark::at_begin, "gimp xcf", FileUse::picture, kToLight},
    {"", "a QOI", Mark::at_begin, "qoif", FileUse::picture, kToPng},
    {"", "a JPEG XR", Mark::at_begin, "II\xbc\x01", FileUse::picture, kToLight},
    {"", "a JPEG 2000", Mark::in_box, "jP  \r\n\x87\n", FileUse::picture, kToPng},
    {"", "a JPEG 2000", Mark::at_begin, "\xff\x4f\xff\x51", FileUse::picture, kToPng},
    {"", "a DPX", Mark::at_begin, "SDPX", FileUse::picture, kToLight},
    {"", "a DPX", Mark::at_begin, "XPDS", FileUse::picture, kToLight},
    {"", "a Source texture (VTF)", Mark::at_begin, "VTF\0"sv, FileUse::picture, kToLight},
    {"", "a PVR texture", Mark::at_begin, "PVR\x03", FileUse::picture, "save it as KTX2"},
    {"", "an ASTC texture", Mark::at_begin, "\x13\xab\xa1\x5c", FileUse::picture, kToPng},
    {"", "a Babylon.js environment (.env)", Mark::at_begin, "\x86\x16\x87\x96\xf6\xd6\x96\x36", FileUse::picture,
     "use the .hdr or .dds that it was made from"},
    {"", "a HEIC", Mark::in_box, "ftyphei", FileUse::picture, kToPng},
    {"", "a HEIC", Mark::in_box, "ftyphev", FileUse::picture, kToPng},
    {"", "a HEIF", Mark::in_box, "ftypmif1", FileUse::picture, kToPng},
    {"", "a HEIF", Mark::in_box, "ftypmsf1", FileUse::picture, kToPng},
    {"", "a camera's raw picture", Mark::in_box, "ftypcrx ", FileUse::picture, kDevelop},
    {"", "a camera's raw picture", Mark::at_begin, "FUJIFILMCCD-RAW", FileUse::picture, kDevelop},
    {"", "a video", Mark::in_box, "ftyp", FileUse::picture, kFrame},
    {"", "a video", Mark::in_box, "moov", FileUse::picture, kFrame},
    {"", "a video", Mark::at_begin, "\x1a\x45\xdf\xa3", FileUse::picture, kFrame},

    {"blend", "a Blender file", Mark::at_begin, "BLENDER", FileUse::model, kBlender},
    {"fbx", "an FBX", Mark::at_begin, "Kaydara FBX Binary", FileUse::model, kBlender},
    {"usd usdc", "a USD", Mark::at_begin, "PXR-USDC", FileUse::model, kBlender},
    {"usda", "a USD", Mark::at_begin, "#usda", FileUse::model, kBlender},
    {"dae", "a COLLADA", Mark::in_markup, "<collada", FileUse::model, kBlender},
    {"abc", "an Alembic", Mark::at_begin, "Ogawa", FileUse::model, kBlender},
    {"3ds", "a 3DS", Mark::at_begin, "", FileUse::model, kBlender},
    {"wrl x3d", "a VRML or X3D", Mark::at_begin, "#VRML", FileUse::model, kBlender},
    {"step stp", "a STEP", Mark::at_begin, "ISO-10303-21", FileUse::model, kFreeCad},
    {"iges igs", "an IGES", Mark::at_begin, "", FileUse::model, kFreeCad},
    {"3dm", "a Rhino model", Mark::at_begin, "3D Geometry File Format", FileUse::model,
     "open it in Rhino and export it as glTF 2.0 (.glb)"},
    {"skp", "a SketchUp model", Mark::at_begin, "", FileUse::model,
     "open it in SketchUp and export it as glTF 2.0 (.glb)"},
    {"max", "a 3ds Max scene", Mark::at_begin, "", FileUse::model,
     "open it in 3ds Max and export it as glTF 2.0 (.glb)"},
    {"ma", "a Maya scene", Mark::at_begin, "//Maya ASCII", FileUse::model, kMaya},
    {"mb", "a Maya scene", Mark::at_begin, "", FileUse::model, kMaya},
    {"c4d", "a Cinema 4D scene", Mark::at_begin, "", FileUse::model,
     "open it in Cinema 4D and export it as glTF 2.0 (.glb)"},
    {"b3dm", "a tile of 3D Tiles", Mark::at_begin, "b3dm", FileUse::model,
     "take the .glb out of it by `npx 3d-tiles-tools b3dmToGlb`"},
    {"i3dm", "a tile of 3D Tiles", Mark::at_begin, "i3dm", FileUse::model,
     "take the .glb out of it by `npx 3d-tiles-tools i3dmToGlb`"},
});

/// The beginning in small letters where it begins as a text of markup does; else nothing.
std::string markupIn(std::string_view begin) {
  begin = withoutByteOrderMark(begin);
  const std::size_t first = begin.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || begin[first] != '<') return {};
  return lowerCase(begin.substr(first));
}

bool fits(const ForeignFormat& format, std::string_view begin, std::string_view markup) {
  constexpr std::size_t kBoxSize = 4;
  if (format.bytes.empty()) return false;
  switch (format.mark) {
    case Mark::at_begin:
      return begin.starts_with(format.bytes);
    case Mark::in_box:
      return begin.size() > kBoxSize && begin.substr(kBoxSize).starts_with(format.bytes);
    case Mark::in_markup:
      return markup.find(format.bytes) != std::string_view::npos;
  }
  return false;
}

}  // namespace

std::optional<Error> foreignFileError(FileUse wanted, std::span<const std::uint8_t> begin, std::string_view extension) {
  const std::string_view text(reinterpret_cast<const char*>(begin.data()), std::min(begin.size(), kForeignFileBytes));
  const std::string markup = markupIn(text);
  const auto* const format =
      std::find_if(kForeignFormats.begin(), kForeignFormats.end(), [&](const ForeignFormat& known) {
        if (wanted == FileUse::any && known.use != FileUse::any) return false;
        return fits(known, text, markup) || (!extension.empty() && contains(split(known.extensions, ' '), extension));
      });
  if (format == kForeignFormats.end()) return std::nullopt;
  const std::string is = "is " + std::string(format->name);
  if (format->use != FileUse::any && format->use != wanted)
    return Error{ErrorCode::unsupported,
                 is + (wanted == FileUse::model ? ", a picture and no model" : ", a model and no picture")};
  return Error{ErrorCode::unsupported, is + ", which is not read; " + std::string(format->advice)};
}

}  // namespace mirrorball
