#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "mirrorball/codec/image_format.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball::cli {

/// A map as its numbers are.
struct MadeMap {
  ImageSet images;                  ///< levels only of a pyramid; 1 or 3 channels
  bool is_signed = false;           ///< of a picture, ½ + ½ n stands for it
  std::optional<float> scale = {};  ///< with which heights are right that were given the range 0 to 1
};

/// The format of a file for a map of numbers.
///
/// errors   usage: that name's changes them, or there is none; io: its folder
Result<ImageFormatId> numberFormat(const std::string& output);

/// Turns the second of each texel's three numbers upside down.
void flipGreen(Image& normals);

/// Reads the normals of a picture, as signed numbers of 3 channels; what is odd about it is a remark.
///
/// input    its name, for remarks
/// bytes    of its file
/// layer    of it that is asked for, if any
/// errors   bad_shape: grey; as decodeDataTexture's
Result<Image> readNormals(const std::string& input, std::span<const std::uint8_t> bytes, const std::string& layer);

/// The codes of 8 bits nearest to a map's numbers; says where some do not fit.
Image8 pictureOf(const MadeMap& map, const std::string& output);

/// Writes a map as the format can hold it, and says so.
///
/// errors   io; interrupted
Result<void> writeNumbers(const MadeMap& map, const std::string& output);

}  // namespace mirrorball::cli
