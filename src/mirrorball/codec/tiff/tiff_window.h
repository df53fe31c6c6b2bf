#pragma once

#include <optional>
#include <string>

#include <glm/vec2.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/tiff/tiff_file.h"

namespace mirrorball {

/// Where a page lies in the larger picture that it is cut out of.
struct TiffWindow {
  std::optional<PictureWindow> part = {};  ///< DecodedImage::window
  std::string oddity = {};                 ///< DecodedImage::oddities
};

/// Hugin, PTmender and OpenImageIO write the size of the larger picture in the tags 33300 and 33301, which are Pixar's,
/// and the page's place in it by its position on a sheet: XPosition × XResolution texels from the left.
///
/// size     of the page [texels]
/// errors   bad_file, too_large: a larger picture that no file of that size is for
/// from     TIFF 6.0, XPosition; libtiff's tiff.h; https://hugin.sourceforge.io/docs/manual/Cropped_TIFF.html
Result<TiffWindow> readTiffWindow(const TiffFile& file, glm::ivec2 size);

}  // namespace mirrorball
