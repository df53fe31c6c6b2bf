#pragma once

#include <cstdlib>

#include <libexif/exif-data.h>

#include "mirrorball/base/file.h"
#include "mirrorball/photo/exif.h"

namespace mirrorball::testing {

/// A JPEG with an EXIF segment that libexif's own writer makes of what `exif` holds.
inline Bytes withExif(const Bytes& jpeg, const Exif& exif) {
  ExifData* data = exif_data_new();
  exif_data_set_byte_order(data, EXIF_BYTE_ORDER_INTEL);
  const auto add = [&](ExifIfd directory, ExifTag tag, ExifFormat format, unsigned size) {
    ExifEntry* entry = exif_entry_new();
    exif_content_add_entry(data->ifd[directory], entry);
    entry->tag = tag;
    entry->format = format;
    entry->components = format == EXIF_FORMAT_ASCII ? size : 1;
    entry->size = size;
    entry->data = static_cast<unsigned char*>(std::calloc(1, size));
    exif_entry_unref(entry);
    return entry->data;
  };
  const auto addShort = [&](ExifIfd directory, ExifTag tag, double value) {
    exif_set_short(add(directory, tag, EXIF_FORMAT_SHORT, 2), EXIF_BYTE_ORDER_INTEL, static_cast<ExifShort>(value));
  };
  const auto addRational = [&](ExifTag tag, double value) {
    const ExifRational ratio{static_cast<ExifLong>(value * 1e5 + 0.5), 100000};
    exif_set_rational(add(EXIF_IFD_EXIF, tag, EXIF_FORMAT_RATIONAL, 8), EXIF_BYTE_ORDER_INTEL, ratio);
  };
  addShort(EXIF_IFD_0, EXIF_TAG_ORIENTATION, exif.orientation);
  if (exif.exposure_time_s) addRational(EXIF_TAG_EXPOSURE_TIME, *exif.exposure_time_s);
  if (exif.f_number) addRational(EXIF_TAG_FNUMBER, *exif.f_number);
  if (exif.iso) addShort(EXIF_IFD_EXIF, EXIF_TAG_ISO_SPEED_RATINGS, *exif.iso);
  if (exif.focal_length_35mm) addShort(EXIF_IFD_EXIF, EXIF_TAG_FOCAL_LENGTH_IN_35MM_FILM, *exif.focal_length_35mm);
  if (exif.image_direction_deg) {
    constexpr auto kReference = static_cast<ExifTag>(16), kDirection = static_cast<ExifTag>(17);
    add(EXIF_IFD_GPS, kReference, EXIF_FORMAT_ASCII, 2)[0] = exif.is_direction_magnetic ? 'M' : 'T';
    exif_set_rational(add(EXIF_IFD_GPS, kDirection, EXIF_FORMAT_RATIONAL, 8), EXIF_BYTE_ORDER_INTEL,
                      {static_cast<ExifLong>(*exif.image_direction_deg * 1e5 + 0.5), 100000});
  }
  unsigned char* segment = nullptr;
  unsigned size = 0;
  exif_data_save_data(data, &segment, &size);
  exif_data_unref(data);

  // SOI, then APP1 with its length, which counts its own two bytes, then the rest of the file.
  Bytes bytes(jpeg.begin(), jpeg.begin() + 2);
  const unsigned length = size + 2;
  for (const unsigned byte : {0xffu, 0xe1u, length >> 8, length & 0xffu})
    bytes.push_back(static_cast<std::uint8_t>(byte));
  bytes.insert(bytes.end(), segment, segment + size);
  bytes.insert(bytes.end(), jpeg.begin() + 2, jpeg.end());
  std::free(segment);
  return bytes;
}

}  // namespace mirrorball::testing
