#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "mirrorball/environment/file/photo_sphere.h"

namespace mirrorball::testing {

/// A Photo Sphere's XMP packet with these attributes.
inline std::string packetWith(const std::string& attributes) {
  return "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF><rdf:Description "
         "xmlns:GPano=\"http://ns.google.com/photos/1.0/panorama/\" " +
         attributes + "/></rdf:RDF></x:xmpmeta>";
}

/// The attributes of the middle quarter of a panorama of 512 × 256: 180 × 90 degrees.
inline const std::string kHalfOfPanorama =
    "GPano:ProjectionType=\"equirectangular\" GPano:FullPanoWidthPixels=\"512\" GPano:FullPanoHeightPixels=\"256\" "
    "GPano:CroppedAreaImageWidthPixels=\"256\" GPano:CroppedAreaImageHeightPixels=\"128\" "
    "GPano:CroppedAreaLeftPixels=\"128\" GPano:CroppedAreaTopPixels=\"64\"";

/// What a file of that text says.
inline std::optional<PhotoSphere> sphereIn(const std::string& text) {
  return photoSphereIn({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace mirrorball::testing
