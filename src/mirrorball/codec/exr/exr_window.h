#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <ImathBox.h>
#include <ImfHeader.h>

#include "mirrorball/base/result.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// Where the picture of a part lies, and which texels of it the file holds.
struct ExrWindow {
  Imath::Box2i picture;                    ///< the display window; the last texels are in it
  Imath::Box2i data;                       ///< the data window
  std::optional<PictureWindow> part = {};  ///< DecodedImage::window
  std::string oddity = {};                 ///< DecodedImage::oddities

  int width() const { return picture.max.x - picture.min.x + 1; }
  int height() const { return picture.max.y - picture.min.y + 1; }
  int dataWidth() const { return data.max.x - data.min.x + 1; }
  /// Whether all texels of the picture are in the file.
  bool isFull() const;
  /// Whether rows of the file have texels that the picture lacks.
  bool hasOverscan() const { return data.min.x < picture.min.x || data.max.x > picture.max.x; }
};

/// The picture is the display window: programs crop empty margins, and render more than is shown. It is the data window
/// in an environment map of OpenEXR's own kind, and where the two have no texel in common, which nobody can mean.
///
/// file_size  in bytes
/// errors     bad_file, too_large: a display window that no file of that size is for
/// from       OpenEXR, "Technical Introduction": Pixel Space, Display Window and Data Window; ImfEnvmap.h (directions
///            follow the data window)
Result<ExrWindow> exrWindow(const Imf::Header& header, std::uint64_t file_size);

}  // namespace mirrorball
