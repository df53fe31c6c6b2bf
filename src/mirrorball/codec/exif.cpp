#include "mirrorball/codec/exif.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/format_signature.h"
#include "mirrorball/codec/ldr/jpeg_segments.h"

namespace mirrorball {
namespace {

using Span = std::span<const std::uint8_t>;

constexpr std::string_view kExifName("Exif\0\0", 6);

enum ExifTag : std::uint16_t {
  kOrientation = 0x0112,
  kExposureTime = 0x829a,
  kFNumber = 0x829d,
  kExifDirectory = 0x8769,
  kIsoSpeedRatings = 0x8827,
  kGpsDirectory = 0x8825,
  kShutterSpeedValue = 0x9201,
  kApertureValue = 0x9202,
  kFocalLengthIn35mm = 0xa405,
};

/// Tags of the GPS directory, whose numbers mean something else in others.
enum GpsTag : std::uint16_t { kImageDirectionRef = 16, kImageDirection = 17 };

/// The directories of a TIFF.
class ExifBlock {
 public:
  explicit ExifBlock(Span bytes) {
    if (bytes.size() < kHeader) return;
    const std::string_view order(reinterpret_cast<const char*>(bytes.data()), 2);
    is_big_ = order == "MM";
    bytes_ = bytes;
    if ((order != "II" && !is_big_) || u16(2) != kVersion) return;
    main_ = u32(4);
    exif_ = directoryAt(kExifDirectory);
    gps_ = directoryAt(kGpsDirectory);
  }

  /// The first value of a tag in the picture's own directory or EXIF's: writers disagree about which.
  std::optional<double> number(std::uint16_t tag) const {
    const auto value = numberIn(main_, tag);
    return value ? value : numberIn(exif_, tag);
  }

  std::optional<double> gpsNumber(std::uint16_t tag) const { return numberIn(gps_, tag); }

  /// The first letter of a text in the GPS directory; 0 where there is none.
  char gpsLetter(std::uint16_t tag) const {
    const std::size_t entry = findEntry(gps_, tag);
    return entry != 0 && u16(entry + 2) == kAscii ? static_cast<char>(bytes_[entry + 8]) : '\0';
  }

 private:
  static constexpr std::size_t kHeader = 8;
  static constexpr std::uint16_t kVersion = 42;
  static constexpr std::size_t kEntry = 12;  // tag, type, count, value or where it stands
  enum Type : std::uint16_t { kAscii = 2, kShort = 3, kLong = 4, kRational = 5, kSignedRational = 10 };

  bool has(std::size_t at, std::size_t size) const { return at <= bytes_.size() && bytes_.size() - at >= size; }
  std::uint16_t u16(std::size_t at) const { return is_big_ ? bigU16(&bytes_[at]) : littleU16(&bytes_[at]); }
  std::uint32_t u32(std::size_t at) const { return is_big_ ? bigU32(&bytes_[at]) : littleU32(&bytes_[at]); }

  /// Where a directory begins that the picture's own one names; 0 where it names none.
  std::size_t directoryAt(std::uint16_t tag) const {
    const std::size_t entry = findEntry(main_, tag);
    return entry != 0 && u16(entry + 2) == kLong ? u32(entry + 8) : 0;
  }

  /// Where the entry of a tag begins; 0 where there is none, or not as a whole.
  std::size_t findEntry(std::size_t directory, std::uint16_t tag) const {
    if (directory < kHeader || !has(directory, 2)) return 0;
    const std::size_t first = directory + 2;
    const std::size_t count = std::min<std::size_t>(u16(directory), (bytes_.size() - first) / kEntry);
    for (std::size_t entry = first; entry < first + count * kEntry; entry += kEntry)
      if (u16(entry) == tag) return u32(entry + 4) > 0 ? entry : 0;
    return 0;
  }

  std::optional<double> numberIn(std::size_t directory, std::uint16_t tag) const {
    const std::size_t entry = findEntry(directory, tag);
    if (entry == 0) return {};
    switch (u16(entry + 2)) {
      case kShort:
        return u16(entry + 8);
      case kLong:
        return u32(entry + 8);
      case kRational:
      case kSignedRational: {
        const std::size_t at = u32(entry + 8);
        if (!has(at, 8)) return {};
        const auto term = [&](std::size_t place) {
          const std::uint32_t bits = u32(place);
          return u16(entry + 2) == kRational ? double(bits) : double(static_cast<std::int32_t>(bits));
        };
        return term(at) / term(at + 4);
      }
      default:
        return {};
    }
  }

  Span bytes_;
  bool is_big_ = false;
  std::size_t main_ = 0, exif_ = 0, gps_ = 0;  ///< where the directories begin; 0: there is none
};

std::optional<double> positive(std::optional<double> number) {
  return number && std::isfinite(*number) && *number > 0.0 ? number : std::nullopt;
}

/// The time itself, else from APEX: shutter speed value = −log₂(time).
std::optional<double> exposureTime(const ExifBlock& block) {
  if (const auto time = positive(block.number(kExposureTime))) return time;
  const auto speed = block.number(kShutterSpeedValue);
  return speed ? positive(std::exp2(-*speed)) : std::nullopt;
}

/// The f-number itself, else from APEX: aperture value = 2 log₂(f-number).
std::optional<double> fNumber(const ExifBlock& block) {
  if (const auto number = positive(block.number(kFNumber))) return number;
  const auto aperture = block.number(kApertureValue);
  return aperture ? positive(std::exp2(*aperture / 2.0)) : std::nullopt;
}

}  // namespace

Exif readExif(Span bytes) {
  const std::size_t name = kExifName.size();
  const bool is_named = bytes.size() >= name && std::equal(kExifName.begin(), kExifName.end(), bytes.begin());
  const ExifBlock block(is_named ? bytes.subspan(name) : bytes);
  Exif exif{.exposure_time_s = exposureTime(block),
            .f_number = fNumber(block),
            .iso = positive(block.number(kIsoSpeedRatings)),
            .focal_length_35mm = positive(block.number(kFocalLengthIn35mm))};
  const auto direction = block.gpsNumber(kImageDirection);
  if (direction && *direction >= 0.0 && *direction <= 360.0) {
    exif.image_direction_deg = direction;
    exif.is_direction_magnetic = block.gpsLetter(kImageDirectionRef) == 'M';
  }
  const auto orientation = block.number(kOrientation);
  if (orientation && *orientation >= 1.0 && *orientation <= 8.0) exif.orientation = static_cast<int>(*orientation);
  return exif;
}

Exif readJpegExif(Span jpeg) {
  if (!beginOfJpeg(jpeg)) return {};
  for (const JpegSegment& segment : jpegHeader(jpeg).segments)
    if (const Span exif = segment.behind(kApp1, kExifName); !exif.empty()) return readExif(exif);
  return {};
}

}  // namespace mirrorball
