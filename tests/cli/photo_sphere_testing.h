#pragma once

#include <cstdint>
#include <string>

#include "mirrorball/codec/ldr/gain_map_metadata.h"
#include "mirrorball/codec/ldr/jpeg_segments.h"
#include "mirrorball/environment/file/photo_sphere_testing.h"

namespace mirrorball::testing {

/// The attributes of a part of a panorama [texels].
inline std::string croppedArea(const std::string& left, const std::string& top, const std::string& width,
                               const std::string& height, const std::string& full_width,
                               const std::string& full_height) {
  const auto field = [](const std::string& name, const std::string& number) {
    return " GPano:" + name + "Pixels=\"" + number + "\"";
  };
  return "GPano:ProjectionType=\"equirectangular\"" + field("CroppedAreaLeft", left) + field("CroppedAreaTop", top) +
         field("CroppedAreaImageWidth", width) + field("CroppedAreaImageHeight", height) +
         field("FullPanoWidth", full_width) + field("FullPanoHeight", full_height);
}

/// A JPEG as a camera writes a Photo Sphere.
inline Bytes asPhotoSphere(Bytes jpeg, const std::string& attributes) {
  const std::string packet = std::string(kXmpName) + packetWith(attributes);
  const Bytes segment = jpegSegment(kApp1, {reinterpret_cast<const std::uint8_t*>(packet.data()), packet.size()});
  jpeg.insert(jpeg.begin() + static_cast<std::ptrdiff_t>(behindJfif(jpeg)), segment.begin(), segment.end());
  return jpeg;
}

}  // namespace mirrorball::testing
