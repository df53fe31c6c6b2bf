#include "mirrorball/codec/tiff/tiff.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "mirrorball/base/bit_cast.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/codec/color/icc_profile.h"
#include "mirrorball/codec/format_signature.h"
#include "mirrorball/codec/missing_rows.h"
#include "mirrorball/codec/picture_window.h"
#include "mirrorball/codec/tiff/tiff_file.h"
#include "mirrorball/codec/tiff/tiff_layout.h"
#include "mirrorball/codec/within_memory.h"
#include "mirrorball/image/small_float.h"
#include "mirrorball/image/upright.h"

namespace mirrorball {
namespace {

using Span = std::span<const std::uint8_t>;
using Image16 = ImageOf<std::uint16_t>;

/// Hands out strips or tiles one after the other.
class Striles {
 public:
  Striles(const TiffFile& file, const TiffLayout& layout, const ProgressFunction& progress)
      : file_(file),
        layout_(layout),
        planes_(layout.is_by_planes ? layout.samples : 1),
        per_plane_(std::uint32_t(layout.strilesAcross()) * std::uint32_t(layout.strilesDown())),
        counter_(progress, std::size_t(planes_) * per_plane_),
        bytes_(bytesWithoutValues(layout.strileBytes())) {}

  /// Calls `take(plane, first texel, size, bytes)` for each of them that holds colours or alpha. Those at the right and
  /// lower edges may reach beyond the picture; `size` does not.
  template <typename Take>
  Result<void> forEach(const Take& take) {
    const int across = layout_.strilesAcross();
    for (int plane = 0; plane < planes_; ++plane) {
      if (layout_.is_by_planes && plane >= layout_.colors && plane != layout_.alpha) continue;
      for (std::uint32_t i = 0; i < per_plane_; ++i) {
        const std::uint32_t index = std::uint32_t(plane) * per_plane_ + i;
        const int rows = layout_.rows_there[index];
        MIRRORBALL_TRY_VOID(rows < layout_.rowsInStrile(index) ? takePlain(index, rows) : decode(index));
        const glm::ivec2 begin(int(i % std::uint32_t(across)) * layout_.strile_width,
                               int(i / std::uint32_t(across)) * layout_.strile_height);
        take(plane, begin,
             glm::ivec2(std::min(layout_.strile_width, layout_.width - begin.x),
                        std::min(rows, layout_.height - begin.y)),
             bytes_.get());
        counter_.advance();
        if (counter_.stopped()) return counter_.result();
      }
    }
    return {};
  }

 private:
  /// The rows of a strip or tile that the file ends within, which is not compressed.
  Result<void> takePlain(std::uint32_t index, int rows) {
    const std::size_t size = std::size_t(layout_.rowBytes()) * std::size_t(rows);
    if (size == 0) return {};
    std::memcpy(bytes_.get(), file_.bytes().data() + TIFFGetStrileOffset(file_.get(), index), size);
    if (TIFFIsByteSwapped(file_.get()) == 0) return {};
    if (layout_.bits == 16) TIFFSwabArrayOfShort(reinterpret_cast<std::uint16_t*>(bytes_.get()), tmsize_t(size / 2));
    if (layout_.bits == 32) TIFFSwabArrayOfLong(reinterpret_cast<std::uint32_t*>(bytes_.get()), tmsize_t(size / 4));
    if (layout_.bits == 64) TIFFSwabArrayOfLong8(reinterpret_cast<std::uint64_t*>(bytes_.get()), tmsize_t(size / 8));
    return {};
  }

  Result<void> decode(std::uint32_t index) {
    const auto size = tmsize_t(layout_.rowBytes() * std::uint64_t(layout_.rowsInStrile(index)));
    const int warnings = file_.warnings();
    const tmsize_t decoded = layout_.is_tiled ? TIFFReadEncodedTile(file_.get(), index, bytes_.get(), size)
                                              : TIFFReadEncodedStrip(file_.get(), index, bytes_.get(), size);
    // libjpeg only warns where its data end early, and goes on with grey.
    if (decoded != size || (layout_.is_jpeg && file_.warnings() > warnings)) return file_.damaged();
    return {};
  }

  const TiffFile& file_;
  const TiffLayout& layout_;
  int planes_;
  std::uint32_t per_plane_;
  ProgressCounter counter_;
  /// Without values at first, so that a size that lies costs no memory.
  std::unique_ptr<std::uint8_t[]> bytes_;
};

/// The code of any number of bits; below 8, and between 8 and 16, they lie side by side, the highest bits first.
std::uint32_t codeAt(const std::uint8_t* row, std::size_t sample, int bits) {
  switch (bits) {
    case 8:
      return row[sample];
    case 16: {
      std::uint16_t code = 0;
      std::memcpy(&code, row + 2 * sample, sizeof code);  // libtiff has brought it to the machine's byte order
      return code;
    }
    case 32: {
      std::uint32_t code = 0;
      std::memcpy(&code, row + 4 * sample, sizeof code);
      return code;
    }
    default: {
      const std::size_t first = sample * std::size_t(bits);
      std::uint32_t code = 0;
      for (std::size_t bit = first; bit < first + std::size_t(bits); ++bit)
        code = code << 1 | (row[bit / 8] >> (7 - bit % 8) & 1u);
      return code;
    }
  }
}

float floatAt(const std::uint8_t* row, std::size_t sample, int bits) {
  if (bits == 16) return floatFromHalf(static_cast<std::uint16_t>(codeAt(row, sample, 16)));
  if (bits == 32) return bitCast<float>(codeAt(row, sample, 32));
  double value = 0;
  std::memcpy(&value, row + 8 * sample, sizeof value);
  return static_cast<float>(value);
}

/// Fills an image, each sample by `read(row, sample, channel)`.
template <typename Sample, typename Read>
Result<ImageOf<Sample>> readTexels(const TiffFile& file, const TiffLayout& layout, const ProgressFunction& progress,
                                   const Read& read) {
  constexpr std::uint64_t kSampleBytes = sizeof(Sample) + (std::is_same_v<Sample, float> ? 0 : sizeof(float));
  const int channels = layout.channels();
  const std::uint64_t texels = std::uint64_t(layout.width) * std::uint64_t(layout.height);
  MIRRORBALL_TRY_VOID(checkMemory(texels * std::uint64_t(channels) * kSampleBytes + layout.strileBytes()));
  auto image = ImageOf<Sample>::withoutValues(layout.width, layout.height, channels);
  const auto stride = std::size_t(layout.samplesInPlane());
  Striles striles(file, layout, progress);
  MIRRORBALL_TRY_VOID(striles.forEach([&](int plane, glm::ivec2 begin, glm::ivec2 size, const std::uint8_t* bytes) {
    for (int c = 0; c < channels; ++c) {
      if (layout.is_by_planes && layout.sampleOf(c) != plane) continue;
      const std::size_t offset = layout.is_by_planes ? 0 : std::size_t(layout.sampleOf(c));
      for (int y = 0; y < size.y; ++y) {
        const std::uint8_t* row = bytes + std::size_t(y) * layout.rowBytes();
        Sample* to = image.texel(begin.x, begin.y + y) + c;
        for (int x = 0; x < size.x; ++x) to[x * channels] = read(row, std::size_t(x) * stride + offset, c);
      }
    }
  }));
  blackenRows(image, layout.missingRows());
  return image;
}

/// Codes that are `Sample`s already, or become the nearest of them.
template <typename Sample>
Result<CodedPicture> readCodes(const TiffFile& file, const TiffLayout& layout, const ProgressFunction& progress) {
  constexpr std::uint32_t kNewMax = std::numeric_limits<Sample>::max();
  const int bits = layout.bits;
  const auto max = static_cast<std::uint32_t>((std::uint64_t{1} << bits) - 1);
  const std::uint32_t turned = layout.is_white_zero ? max : 0;  // greatest − code are all its bits turned over
  const auto read = [&](const std::uint8_t* row, std::size_t sample, int channel) {
    const std::uint32_t code = codeAt(row, sample, bits) ^ (channel == 3 ? 0 : turned);
    return static_cast<Sample>(max == kNewMax ? code : rescaledCode(code, max, kNewMax));
  };
  MIRRORBALL_TRY(codes, readTexels<Sample>(file, layout, progress, read));
  return CodedPicture(std::move(codes));
}

Result<CodedPicture> readPalette(const TiffFile& file, const TiffLayout& layout, const ProgressFunction& progress) {
  const auto read = [&](const std::uint8_t* row, std::size_t sample, int channel) {
    const std::uint32_t code = codeAt(row, sample, layout.bits);
    if (channel < 3) return layout.palette[std::size_t(channel)][code];
    return static_cast<std::uint16_t>(rescaledCode(code, (1u << layout.bits) - 1, 65535));
  };
  MIRRORBALL_TRY(codes, readTexels<std::uint16_t>(file, layout, progress, read));
  return CodedPicture(std::move(codes));
}

/// Integers, their alpha straight.
Result<CodedPicture> readPicture(const TiffFile& file, const TiffLayout& layout, const ProgressFunction& progress) {
  const bool fits_8_bits = layout.bits == 8 || layout.bits == 4 || layout.bits == 2 || layout.bits == 1;
  MIRRORBALL_TRY(picture, layout.hasPalette() ? readPalette(file, layout, progress)
                          : fits_8_bits       ? readCodes<std::uint8_t>(file, layout, progress)
                                              : readCodes<std::uint16_t>(file, layout, progress));
  if (layout.is_premultiplied) makeStraight(picture);
  return picture;
}

/// Floats: light multiplied by its alpha, numbers as they are stored.
Result<Image> readFloats(const TiffFile& file, const TiffLayout& layout, const ImageReadOptions& options) {
  const auto read = [&](const std::uint8_t* row, std::size_t sample, int) { return floatAt(row, sample, layout.bits); };
  MIRRORBALL_TRY(floats, readTexels<float>(file, layout, options.progress, read));
  if (options.as == ReadAs::light && layout.alpha >= 0 && !layout.is_premultiplied)
    for (std::size_t i = 0; i < floats.samples().size(); i += 4)
      for (std::size_t c = 0; c < 3; ++c) floats.samples()[i + c] *= floats.samples()[i + 3];
  return floats;
}

/// "TIFF, 16 bit, LZW"
std::string formatText(const TiffLayout& layout) {
  std::string text = "TIFF, ";
  if (layout.is_log) {
    text += layout.colors == 3 ? "LogLuv" : "LogL";
  } else if (layout.is_float) {
    text += layout.bits == 16 ? "half" : layout.bits == 32 ? "float" : "double";
  } else {
    text += std::to_string(layout.bits) + (layout.hasPalette() ? " bit palette" : " bit");
  }
  return layout.compression.empty() ? text : text + ", " + layout.compression;
}

constexpr const char* kTiffOrientation = "tag";

/// An ICC profile counts before the tags of primaries.
CodedColor colorOfCodes(const TiffLayout& layout) {
  return layout.profile.description.empty() ? codedColor(kSrgbCurve, layout.primaries) : codedColor(layout.profile);
}

/// EXIF is the tags of a TIFF.
CodedFile makeCodedFile(CodedPicture codes, const TiffLayout& layout, Span bytes) {
  return {.codes = std::move(codes),
          .color = colorOfCodes(layout),
          .orientation = layout.orientation,
          .orientation_source = kTiffOrientation,
          .exif = readExif(bytes),
          .metadata = {},
          .format = formatText(layout)};
}

/// What `info` says of floats.
std::string colorText(const TiffLayout& layout) {
  if (layout.is_log && layout.colors == 3) return "CIE XYZ: converted";
  if (const std::string& name = layout.profile.description; !name.empty() && !layout.profile.is_understood)
    return "linear, Rec.709 assumed: its ICC profile (" + name + ") is not applied";
  return describeColor(kLinearLight, layout.primaries, layout.channels());
}

/// Of floats.
std::optional<Primaries> statedPrimaries(const TiffLayout& layout) {
  return layout.is_log ? std::optional(kCieXyz) : layout.primaries;
}

/// What floats that are read as numbers state of colours.
std::string spaceStatedBy(const TiffLayout& layout) {
  CodedColor color{.transfer = Transfer::linear, .primaries = statedPrimaries(layout)};
  if (!layout.profile.is_understood) color.unread_profile = layout.profile.description;
  return statedSpace(color, layout.channels());
}

/// What is unusual about floats.
std::vector<std::string> floatOddities(const TiffLayout& layout, ReadAs as) {
  std::vector<std::string> oddities;
  if (std::string remark = uprightRemark(layout.orientation, kTiffOrientation); !remark.empty())
    oddities.push_back(std::move(remark));
  if (as == ReadAs::numbers)
    tellUnapplied(spaceStatedBy(layout), oddities);
  else if (layout.profile.is_understood && layout.profile.curve.power != kLinearLight.power)
    oddities.push_back("has floats and an ICC profile (" + layout.profile.description +
                       ") with a curve: taken as linear light, of whose profile the primaries alone count");
  return oddities;
}

/// Where the page is to be put. One that is to be turned has no place in a larger picture that its writer can have
/// meant: of the programs that write places none turns.
std::optional<PictureWindow> placeIn(const TiffLayout& layout) {
  return uprightRemark(layout.orientation, kTiffOrientation).empty() ? layout.window.part : std::nullopt;
}

/// Puts codes or light into their place in the larger picture.
///
/// errors   too_large
template <typename Sample>
Result<ImageOf<Sample>> inItsPlace(ImageOf<Sample> page, const TiffLayout& layout) {
  const auto place = placeIn(layout);
  if (!place) return page;
  MIRRORBALL_TRY_VOID(checkImageMemory(place->whole.x, place->whole.y, page.channels()));
  return placedInWindow(page, *place);
}

Result<CodedPicture> inItsPlace(CodedPicture page, const TiffLayout& layout) {
  return std::visit(
      [&](auto& codes) -> Result<CodedPicture> {
        MIRRORBALL_TRY(placed, inItsPlace(std::move(codes), layout));
        return CodedPicture(std::move(placed));
      },
      page);
}

void tellPlace(const TiffLayout& layout, std::vector<std::string>& oddities) {
  if (std::string remark = missingRowsRemark(layout.missingRows()); !remark.empty())
    oddities.push_back(std::move(remark));
  if (layout.window.part && !placeIn(layout))
    oddities.emplace_back("is a part of a larger picture, and not stored upright: read without the rest");
  else if (!layout.window.oddity.empty())
    oddities.push_back(layout.window.oddity);
}

DecodedImage withPlace(DecodedImage image, const TiffLayout& layout) {
  image.window = placeIn(layout);
  tellPlace(layout, image.oddities);
  return image;
}

}  // namespace

Result<DecodedImage> decodeTiff(Span bytes, const ImageReadOptions& options) {
  const TiffFile file(bytes);
  MIRRORBALL_TRY(layout, readTiffLayout(file));
  if (!layout.is_float) {
    MIRRORBALL_TRY(page, readPicture(file, layout, options.progress));
    MIRRORBALL_TRY(codes, inItsPlace(std::move(page), layout));
    return withPlace(asImage(makeCodedFile(std::move(codes), layout, bytes)), layout);
  }
  MIRRORBALL_TRY(page, readFloats(file, layout, options));
  MIRRORBALL_TRY(stored, inItsPlace(std::move(page), layout));
  const bool is_light = options.as == ReadAs::light;
  DecodedImage image{upright(std::move(stored), layout.orientation), {}, formatText(layout)};
  image.color = is_light ? colorText(layout) : std::string(kAsStored);
  if (is_light) {
    image.is_converted = layout.alpha >= 0 && !layout.is_premultiplied;
    image.is_converted |= convertToRec709(image.image, statedPrimaries(layout));
  }
  image.oddities = floatOddities(layout, options.as);
  return withPlace(std::move(image), layout);
}

Result<CodedFile> decodeTiffCodes(Span bytes, CodeForm) {
  const TiffFile file(bytes);
  MIRRORBALL_TRY(layout, readTiffLayout(file));
  if (layout.is_float)
    return fail(ErrorCode::unsupported, "holds floats, and a texture has integers; save it with 8 or 16 bits");
  MIRRORBALL_TRY(page, readPicture(file, layout, {}));
  MIRRORBALL_TRY(codes, inItsPlace(std::move(page), layout));
  CodedFile coded = makeCodedFile(std::move(codes), layout, bytes);
  tellPlace(layout, coded.oddities);
  return coded;
}

bool isTiffOfIntegers(Span bytes) {
  if (!isTiff(bytes)) return false;
  const TiffFile file(bytes);
  const auto layout = readTiffLayout(file);
  return layout && !layout->is_float;
}

FormatCodec tiffCodec() {
  return {.decode = decodeTiff, .decode_codes = decodeTiffCodes, .holds_integers = isTiffOfIntegers};
}

}  // namespace mirrorball
