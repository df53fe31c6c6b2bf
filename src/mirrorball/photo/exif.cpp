#include "mirrorball/photo/exif.h"

#include <cmath>
#include <memory>

#include <libexif/exif-data.h>

namespace mirrorball {
namespace {

struct Release {
  void operator()(ExifData* data) const { exif_data_unref(data); }
};
using Data = std::unique_ptr<ExifData, Release>;

/// The first value of an entry, which may be absent.
std::optional<double> numberIn(const Data& data, const ExifEntry* entry) {
  if (!entry || !entry->data || entry->components < 1) return {};
  if (entry->size < exif_format_get_size(entry->format)) return {};
  const ExifByteOrder order = exif_data_get_byte_order(data.get());
  switch (entry->format) {
    case EXIF_FORMAT_SHORT:
      return exif_get_short(entry->data, order);
    case EXIF_FORMAT_LONG:
      return exif_get_long(entry->data, order);
    case EXIF_FORMAT_RATIONAL: {
      const ExifRational ratio = exif_get_rational(entry->data, order);
      return double(ratio.numerator) / double(ratio.denominator);
    }
    case EXIF_FORMAT_SRATIONAL: {
      const ExifSRational ratio = exif_get_srational(entry->data, order);
      return double(ratio.numerator) / double(ratio.denominator);
    }
    default:
      return {};
  }
}

/// The first value of a tag, wherever it stands: writers disagree about the directories.
std::optional<double> numberOf(const Data& data, ExifTag tag) {
  return numberIn(data, exif_data_get_entry(data.get(), tag));
}

/// An entry of the GPS directory, whose tags have the numbers of other directories' tags.
const ExifEntry* gpsEntry(const Data& data, unsigned tag) {
  return exif_content_get_entry(data->ifd[EXIF_IFD_GPS], static_cast<ExifTag>(tag));
}

/// Where the camera looked, in EXIF's numbers for GPSImgDirectionRef (a letter, 'T' or 'M') and GPSImgDirection.
void readDirection(const Data& data, Exif& exif) {
  constexpr unsigned kImageDirectionRef = 16, kImageDirection = 17;
  const auto direction = numberIn(data, gpsEntry(data, kImageDirection));
  if (!direction || !(*direction >= 0.0 && *direction <= 360.0)) return;
  exif.image_direction_deg = direction;
  const ExifEntry* reference = gpsEntry(data, kImageDirectionRef);
  exif.is_direction_magnetic =
      reference != nullptr && reference->data != nullptr && reference->size > 0 && reference->data[0] == 'M';
}

std::optional<double> positive(std::optional<double> number) {
  return number && std::isfinite(*number) && *number > 0.0 ? number : std::nullopt;
}

/// The time itself, else from APEX: shutter speed value = −log₂(time).
std::optional<double> exposureTime(const Data& data) {
  if (const auto time = positive(numberOf(data, EXIF_TAG_EXPOSURE_TIME))) return time;
  const auto speed = numberOf(data, EXIF_TAG_SHUTTER_SPEED_VALUE);
  return speed ? positive(std::exp2(-*speed)) : std::nullopt;
}

/// The f-number itself, else from APEX: aperture value = 2 log₂(f-number).
std::optional<double> fNumber(const Data& data) {
  if (const auto number = positive(numberOf(data, EXIF_TAG_FNUMBER))) return number;
  const auto aperture = numberOf(data, EXIF_TAG_APERTURE_VALUE);
  return aperture ? positive(std::exp2(*aperture / 2.0)) : std::nullopt;
}

}  // namespace

Exif readExif(std::span<const std::uint8_t> jpeg) {
  const Data data(exif_data_new_from_data(jpeg.data(), static_cast<unsigned>(jpeg.size())));
  if (!data) return {};
  Exif exif;
  exif.exposure_time_s = exposureTime(data);
  exif.f_number = fNumber(data);
  exif.iso = positive(numberOf(data, EXIF_TAG_ISO_SPEED_RATINGS));
  exif.focal_length_35mm = positive(numberOf(data, EXIF_TAG_FOCAL_LENGTH_IN_35MM_FILM));
  readDirection(data, exif);
  const auto orientation = numberOf(data, EXIF_TAG_ORIENTATION);
  if (orientation && *orientation >= 1.0 && *orientation <= 8.0) exif.orientation = static_cast<int>(*orientation);
  return exif;
}

}  // namespace mirrorball
