#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/base/result.h"
#include "mirrorball/codec/ldr/xmp_properties.h"
#include "mirrorball/environment/file/panorama_part.h"

namespace mirrorball {

/// The fields that a Photo Sphere has in XMP, in the namespace GPano.
class PhotoSphereFields {
 public:
  /// Finds them in a file of any format that stores the packet as plain text, as JPEG (its extension of XMP too), WebP,
  /// TIFF and AVIF do, and compressed in PNG and JPEG XL (codec/compressed_xmp.h).
  ///
  /// bytes    of a file, of which the first and the last MiB are looked through, or readEnds'; must outlive this
  /// returns  nothing where no packet has fields of the namespace
  /// cost     a few passes over the bytes, whatever they are
  static std::optional<PhotoSphereFields> in(std::span<const std::uint8_t> bytes);

  /// What a field holds; nothing where it is absent.
  std::optional<std::string_view> text(std::string_view name) const;

  /// An angle up to `most` on either side [degrees]; nothing where it is absent.
  ///
  /// errors   bad_file: it is not such an angle; names the field
  Result<std::optional<double>> angle(std::string_view name, double most) const;

  /// A whole number of texels.
  ///
  /// errors   bad_file: it is none, or absent; names the field
  Result<int> texels(std::string_view name) const;

 private:
  PhotoSphereFields(XmpProperties properties, std::shared_ptr<const std::string> unpacked)
      : unpacked_(std::move(unpacked)), properties_(std::move(properties)) {}

  std::shared_ptr<const std::string> unpacked_;  ///< what the properties lie in, if the packet was compressed
  XmpProperties properties_;
};

/// What a Photo Sphere says of its picture.
struct PhotoSphere {
  std::string projection = {};            ///< "equirectangular"; empty: unsaid
  std::optional<PanoramaArea> area = {};  ///< of the panorama, that the picture shows, if not all of it
  std::string stereo = {};                ///< "top-bottom", "left-right": two eyes in one picture; empty: unsaid
  double pitch_deg = 0.0;                 ///< as in CompassHeading, and the next
  double roll_deg = 0.0;
  std::vector<std::string> mistakes = {};  ///< a line for each field that cannot be meant; above they are left out

  bool isEquirectangular() const;
  bool isTilted() const;
};

/// from     Google, Photo Sphere XMP Metadata (developers.google.com/streetview/spherical-metadata); the two eyes:
///          Google, Spherical Video RFC, StereoMode, which pictures have in either namespace
/// cost     as PhotoSphereFields::in
std::optional<PhotoSphere> photoSphereIn(std::span<const std::uint8_t> bytes);

/// The first and the last MiB of a file, in which formats have their metadata, one behind the other; all of a small
/// one.
///
/// errors   not_found; io
Result<Bytes> readEnds(const std::filesystem::path& path);

}  // namespace mirrorball
