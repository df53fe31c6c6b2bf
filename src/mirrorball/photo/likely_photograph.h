#pragma once

#include <filesystem>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// Whether a picture is more likely a photograph of something than a map of all directions: its shape is that of no map
/// (recognize), or its EXIF names a camera's exposure or focal length and it is no panorama of 2:1. What says of itself
/// which map it is, is none.
///
/// errors   as readImageFile's and decodeImage's
/// cost     that of reading the file, or its header alone (.exr, .hdr); pixels are decoded where the file is none of
///          these, .jpg or .png, or has the shape of no map
Result<bool> isLikelyPhotograph(const std::filesystem::path& path);

}  // namespace mirrorball
