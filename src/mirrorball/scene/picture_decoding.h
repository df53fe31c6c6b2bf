#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// A picture as it lies in a model's file or beside it.
struct EncodedPicture {
  std::span<const std::uint8_t> bytes;
  ReadAs as = ReadAs::numbers;  ///< light: what a material reads in it is a colour
};

/// Receives what is odd about a picture's file and how it was read: a line without its name.
using PictureRemark = std::function<void(std::size_t picture, const std::string& oddity)>;

/// Decodes pictures (codec/image_file.h: decodeColorTexture, decodeDataTexture), several at the same time: with large
/// textures this is where a model's loading time goes.
///
/// budget    from which the images' memory is taken, and that of decoding each while it lasts
/// progress  counts bytes of pictures; may stop the rest
/// remark    called at the end, in the order of the pictures
/// returns   for each picture its image of 4 channels, without the remarks, or why it cannot be read: interrupted, if
///           it was not
std::vector<Result<Decoded<Texels>>> decodePictures(std::span<const EncodedPicture> pictures, MemoryBudget& budget,
                                                    const ProgressFunction& progress = {},
                                                    const PictureRemark& remark = {});

}  // namespace mirrorball
