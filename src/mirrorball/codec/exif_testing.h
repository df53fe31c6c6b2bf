#pragma once

#include <cstdlib>

#include <libexif/exif-data.h>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/exif.h"
#include "mirrorball/codec/ldr/jpeg_segments.h"

namespace mirrorball::testing {

/// EXIF as libexif's own writer makes it of what `exif` holds, behind "Exif\0\0".
inline Bytes exifBlock(const Exif& exif, ExifByteOrder order = EXIF_BYTE_ORDER_INTEL) {
  ExifData* data = exif_data_new();
  exif_data_set_byte_order(data, order);
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
    exif_set_short(add(directory, tag, EXIF_FORMAT_SHORT, 2), order, static_cast<ExifShort>(value));
  };
  const auto addRational = [&](ExifIfd directory, ExifTag tag, double value) {
    const ExifRational ratio{static_cast<ExifLong>(value * 1e5 + 0.5), 100000};
    exif_set_rational(add(directory, tag, EXIF_FORMAT_RATIONAL, 8), order, ratio);
  };
  addShort(EXIF_IFD_0, EXIF_TAG_ORIENTATION, exif.orientation);
  if (exif.exposure_time_s) addRational(EXIF_IFD_EXIF, EXIF_TAG_EXPOSURE_TIME, *exif.exposure_time_s);
  if (exif.f_number) addRational(EXIF_IFD_EXIF, EXIF_TAG_FNUMBER, *exif.f_number);
  if (exif.iso) addShort(EXIF_IFD_EXIF, EXIF_TAG_ISO_SPEED_RATINGS, *exif.iso);
  if (exif.focal_length_35mm) addShort(EXIF_IFD_EXIF, EXIF_TAG_FOCAL_LENGTH_IN_35MM_FILM, *exif.focal_length_35mm);
  if (exif.image_direction_deg) {
    constexpr auto kReference = static_cast<ExifTag>(16), kDirection = static_cast<ExifTag>(17);
    add(EXIF_IFD_GPS, kReference, EXIF_FORMAT_ASCII, 2)[0] = exif.is_direction_magnetic ? 'M' : 'T';
    addRational(EXIF_IFD_GPS, kDirection, *exif.image_direction_deg);
  }
  unsigned char* block = nullptr;
  unsigned size = 0;
  exif_data_save_data(data, &block, &size);
  exif_data_unref(data);
  const Bytes bytes(block, block + size);
  std::free(block);
  return bytes;
}

/// A JPEG with that in its first segment.
inline Bytes withExif(const Bytes& jpeg, const Exif& exif) {
  const Bytes segment = jpegSegment(kApp1, exifBlock(exif));
  Bytes bytes = jpeg;
  bytes.insert(bytes.begin() + 2, segment.begin(), segment.end());
  return bytes;
}

}  // namespace mirrorball::testing
