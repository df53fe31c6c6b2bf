#pragma once

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <gtest/gtest.h>
#include <tiffio.h>

#include "mirrorball/base/file.h"

namespace mirrorball::testing {

/// What a TIFF is to say, as libtiff writes it.
struct TiffForm {
  std::uint32_t width = 5;
  std::uint32_t height = 3;
  std::uint16_t samples = 3;
  std::uint16_t bits = 8;
  std::uint16_t kind = SAMPLEFORMAT_UINT;
  std::uint16_t photometric = PHOTOMETRIC_RGB;
  std::uint16_t compression = COMPRESSION_NONE;
  std::uint16_t predictor = PREDICTOR_NONE;
  std::uint16_t orientation = ORIENTATION_TOPLEFT;
  std::uint32_t tile = 0;  ///< the side of a tile; 0: strips
  std::uint32_t rows_per_strip = 2;
  bool is_by_planes = false;
  std::string mode = "w";                   ///< "wb" big-endian, "w8" BigTIFF
  std::vector<std::uint16_t> extras = {};   ///< EXTRASAMPLE_…
  std::vector<std::uint16_t> palette = {};  ///< red of all codes, green of all, blue of all
  Bytes profile = {};                       ///< ICC
  std::vector<float> primaries = {};        ///< white's x and y, then red's, green's and blue's
  std::uint32_t subfile = 0;                ///< FILETYPE_…
  bool is_dng = false;
  std::string xmp = {};
  std::optional<glm::uvec2> whole = {};  ///< Pixar's size of the full image
  glm::vec2 position{0.0f};              ///< in inches, if `whole` is there
  float resolution = 150.0f;             ///< texels an inch, likewise; 0: none is named
};

/// A file in memory that libtiff writes to.
struct TiffMemory {
  Bytes bytes;
  std::size_t at = 0;

  static tmsize_t read(thandle_t self, void* to, tmsize_t count) {
    auto* file = static_cast<TiffMemory*>(self);
    const std::size_t size = std::min(std::size_t(count), file->bytes.size() - std::min(file->at, file->bytes.size()));
    std::memcpy(to, file->bytes.data() + file->at, size);
    file->at += size;
    return tmsize_t(size);
  }
  static tmsize_t write(thandle_t self, void* from, tmsize_t count) {
    auto* file = static_cast<TiffMemory*>(self);
    file->bytes.resize(std::max(file->bytes.size(), file->at + std::size_t(count)));
    std::memcpy(file->bytes.data() + file->at, from, std::size_t(count));
    file->at += std::size_t(count);
    return count;
  }
  static toff_t seek(thandle_t self, toff_t offset, int from) {
    auto* file = static_cast<TiffMemory*>(self);
    file->at = offset + (from == SEEK_CUR ? file->at : from == SEEK_END ? file->bytes.size() : 0);
    return file->at;
  }
  static toff_t size(thandle_t self) { return static_cast<TiffMemory*>(self)->bytes.size(); }
};

inline void setTiffFields(TIFF* tiff, const TiffForm& form) {
  TIFFSetField(tiff, TIFFTAG_SUBFILETYPE, form.subfile);
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, form.width);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, form.height);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, form.samples);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, form.bits);
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, form.kind);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, form.photometric);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, form.compression);
  TIFFSetField(tiff, TIFFTAG_ORIENTATION, form.orientation);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, form.is_by_planes ? PLANARCONFIG_SEPARATE : PLANARCONFIG_CONTIG);
  if (form.predictor != PREDICTOR_NONE) TIFFSetField(tiff, TIFFTAG_PREDICTOR, form.predictor);
  if (form.compression == COMPRESSION_SGILOG || form.compression == COMPRESSION_SGILOG24)
    TIFFSetField(tiff, TIFFTAG_SGILOGDATAFMT, SGILOGDATAFMT_FLOAT);
  if (form.tile > 0) {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, form.tile);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, form.tile);
  } else {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, form.rows_per_strip);
  }
  if (!form.extras.empty())
    TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, static_cast<std::uint16_t>(form.extras.size()), form.extras.data());
  if (!form.palette.empty()) {
    const std::size_t codes = form.palette.size() / 3;
    TIFFSetField(tiff, TIFFTAG_COLORMAP, form.palette.data(), form.palette.data() + codes,
                 form.palette.data() + 2 * codes);
  }
  if (!form.profile.empty())
    TIFFSetField(tiff, TIFFTAG_ICCPROFILE, static_cast<std::uint32_t>(form.profile.size()), form.profile.data());
  if (!form.xmp.empty())
    TIFFSetField(tiff, TIFFTAG_XMLPACKET, static_cast<std::uint32_t>(form.xmp.size()), form.xmp.data());
  if (form.whole) {
    TIFFSetField(tiff, TIFFTAG_PIXAR_IMAGEFULLWIDTH, form.whole->x);
    TIFFSetField(tiff, TIFFTAG_PIXAR_IMAGEFULLLENGTH, form.whole->y);
    TIFFSetField(tiff, TIFFTAG_XPOSITION, double(form.position.x));
    TIFFSetField(tiff, TIFFTAG_YPOSITION, double(form.position.y));
    if (form.resolution != 0.0f) {
      TIFFSetField(tiff, TIFFTAG_XRESOLUTION, double(form.resolution));
      TIFFSetField(tiff, TIFFTAG_YRESOLUTION, double(form.resolution));
    }
  }
  constexpr std::uint8_t kVersion[]{1, 4, 0, 0};
  if (form.is_dng) TIFFSetField(tiff, TIFFTAG_DNGVERSION, kVersion);
  if (!form.primaries.empty()) {
    TIFFSetField(tiff, TIFFTAG_WHITEPOINT, form.primaries.data());
    TIFFSetField(tiff, TIFFTAG_PRIMARYCHROMATICITIES, form.primaries.data() + 2);
  }
}

/// Writes strips, or tiles each of whose sides is a multiple of 16; `samples` has rows of whole bytes, as `form` says.
inline void writeTiffPage(TIFF* tiff, const TiffForm& form, const Bytes& samples) {
  setTiffFields(tiff, form);
  const std::size_t row = (std::size_t(form.width) * form.samples * form.bits + 7) / 8;
  const std::size_t texel = std::size_t(form.samples) * form.bits / 8;
  const std::size_t sample = form.bits / 8u;
  const std::uint16_t planes = form.is_by_planes ? form.samples : 1;
  const std::uint32_t side = form.tile > 0 ? form.tile : form.width;
  for (std::uint16_t plane = 0; plane < planes; ++plane)
    for (std::uint32_t y0 = 0; y0<form.height; y0 += form.tile> 0 ? side : form.rows_per_strip)
      for (std::uint32_t x0 = 0; x0 < form.width; x0 += side) {
        Bytes bytes;
        for (std::uint32_t y = y0; y < y0 + (form.tile > 0 ? side : form.rows_per_strip); ++y) {
          if (form.tile == 0 && y >= form.height) break;
          if (form.tile == 0 && planes == 1) {
            bytes.insert(bytes.end(), samples.begin() + std::ptrdiff_t(y * row),
                         samples.begin() + std::ptrdiff_t((y + 1) * row));
            continue;
          }
          for (std::uint32_t x = x0; x < x0 + side; ++x) {
            const std::uint8_t* from = samples.data() + std::min(y, form.height - 1) * row +
                                       std::min(x, form.width - 1) * texel + (planes > 1 ? plane * sample : 0);
            bytes.insert(bytes.end(), from, from + (planes > 1 ? sample : texel));
          }
        }
        if (form.tile > 0)
          TIFFWriteEncodedTile(tiff, TIFFComputeTile(tiff, x0, y0, 0, plane), bytes.data(), tmsize_t(bytes.size()));
        else
          TIFFWriteEncodedStrip(tiff, TIFFComputeStrip(tiff, y0, plane), bytes.data(), tmsize_t(bytes.size()));
      }
}

/// A TIFF of one page or of several.
inline Bytes tiffFile(const std::vector<std::pair<TiffForm, Bytes>>& pages) {
  TiffMemory memory;
  TIFF* tiff = TIFFClientOpen(
      "memory", pages.front().first.mode.c_str(), &memory, TiffMemory::read, TiffMemory::write, TiffMemory::seek,
      [](thandle_t) { return 0; }, TiffMemory::size, nullptr, nullptr);
  EXPECT_NE(tiff, nullptr);
  for (const auto& [form, samples] : pages) {
    writeTiffPage(tiff, form, samples);
    TIFFWriteDirectory(tiff);
  }
  TIFFClose(tiff);
  return memory.bytes;
}
inline Bytes tiffFile(const TiffForm& form, const Bytes& samples) { return tiffFile({{form, samples}}); }

/// How a file is laid out whose page stands before its samples, as programs write them that do not know libtiff.
struct PageFirst {
  std::uint32_t width = 5;
  std::uint32_t height = 6;
  std::uint32_t rows = 6;  ///< of a strip
  std::uint32_t tile = 0;  ///< the side of a tile, which divides those of the page; 0: strips
  bool is_packed = false;  ///< by PackBits
  bool is_big_endian = false;
};

/// Grey of 16 bits, whose codes are 257, 514, 771 and so on.
inline Bytes tiffWithPageFirst(const PageFirst& form) {
  const auto number = [&](Bytes& bytes, std::uint32_t value, int size) {
    for (int i = 0; i < size; ++i)
      bytes.push_back(static_cast<std::uint8_t>(value >> 8 * (form.is_big_endian ? size - 1 - i : i)));
  };
  const std::uint32_t across = form.tile > 0 ? form.width / form.tile : 1;
  const std::uint32_t side = form.tile > 0 ? form.tile : form.width, rows = form.tile > 0 ? form.tile : form.rows;
  std::vector<Bytes> striles;
  for (std::uint32_t y0 = 0; y0 < form.height; y0 += rows)
    for (std::uint32_t x0 = 0; x0 < across * side; x0 += side) {
      Bytes& bytes = striles.emplace_back();
      for (std::uint32_t y = y0; y < std::min(y0 + rows, form.height); ++y) {
        if (form.is_packed) bytes.push_back(static_cast<std::uint8_t>(2 * side - 1));
        for (std::uint32_t x = x0; x < x0 + side; ++x) number(bytes, 257 * (1 + (y * form.width + x) % 250), 2);
      }
    }
  const auto count = static_cast<std::uint32_t>(striles.size());
  struct Field {
    std::uint32_t tag, type, count, value;
  };
  const std::uint32_t arrays = 8 + 2 + 12 * 10 + 4, samples = arrays + 8 * count;
  std::vector<Field> fields{{256, 4, 1, form.width},
                            {257, 4, 1, form.height},
                            {258, 3, 1, 16},
                            {259, 3, 1, form.is_packed ? 32773u : 1u},
                            {262, 3, 1, 1}};
  const Field offsets{form.tile > 0 ? 324u : 273u, 4, count, count == 1 ? samples : arrays};
  const Field sizes{form.tile > 0 ? 325u : 279u, 4, count,
                    count == 1 ? static_cast<std::uint32_t>(striles[0].size()) : arrays + 4 * count};
  if (form.tile > 0)
    fields.insert(fields.end(), {{277, 3, 1, 1}, {322, 4, 1, side}, {323, 4, 1, side}, offsets, sizes});
  else
    fields.insert(fields.end(), {offsets, {277, 3, 1, 1}, {278, 4, 1, rows}, sizes, {296, 3, 1, 1}});
  Bytes file(2, static_cast<std::uint8_t>(form.is_big_endian ? 'M' : 'I'));
  number(file, 42, 2);
  number(file, 8, 4);
  number(file, static_cast<std::uint32_t>(fields.size()), 2);
  for (const Field& field : fields) {
    number(file, field.tag, 2);
    number(file, field.type, 2);
    number(file, field.count, 4);
    number(file, field.value, field.type == 3 ? 2 : 4);
    if (field.type == 3) number(file, 0, 2);
  }
  number(file, 0, 4);
  std::uint32_t at = samples;
  for (const Bytes& strile : striles) {
    number(file, at, 4);
    at += static_cast<std::uint32_t>(strile.size());
  }
  for (const Bytes& strile : striles) number(file, static_cast<std::uint32_t>(strile.size()), 4);
  for (const Bytes& strile : striles) file.insert(file.end(), strile.begin(), strile.end());
  return file;
}

/// Bytes for the samples of a picture, each other than its neighbours.
inline Bytes tiffSamples(const TiffForm& form) {
  const std::size_t row = (std::size_t(form.width) * form.samples * form.bits + 7) / 8;
  Bytes bytes(row * form.height);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * 37 + 11);
  return bytes;
}

/// The same of floats, from 1/16 on.
inline std::vector<float> tiffFloats(const TiffForm& form) {
  std::vector<float> floats(std::size_t(form.width) * form.height * form.samples);
  for (std::size_t i = 0; i < floats.size(); ++i) floats[i] = static_cast<float>(1 + i * 7 % 41) / 16.0f;
  return floats;
}

/// The bytes of numbers as this machine has them, which is how libtiff takes samples.
template <typename Number>
Bytes bytesOfNumbers(const std::vector<Number>& numbers) {
  Bytes bytes(numbers.size() * sizeof(Number));
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

}  // namespace mirrorball::testing
