#pragma once

#include <cstdint>
#include <string>

#include "mirrorball/codec/ldr/gain_map_metadata.h"
#include "mirrorball/codec/ldr/jpeg_segments.h"

namespace mirrorball::testing {

/// A Photo Sphere's XMP packet with these attributes.
inline std::string photoSpherePacket(const std::string& attributes) {
  return "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF><rdf:Description "
         "xmlns:GPano=\"http://ns.google.com/photos/1.0/panorama/\" " +
         attributes + "/></rdf:RDF></x:xmpmeta>";
}

/// The attributes of a part of a panorama [texels].
inline std::string croppedAreaOf(const std::string& left, const std::string& top, const std::string& width,
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
  const std::string packet = std::string(kXmpName) + photoSpherePacket(attributes);
  const Bytes segment = jpegSegment(kApp1, {reinterpret_cast<const std::uint8_t*>(packet.data()), packet.size()});
  jpeg.insert(jpeg.begin() + static_cast<std::ptrdiff_t>(behindJfif(jpeg)), segment.begin(), segment.end());
  return jpeg;
}

}  // namespace mirrorball::testing
