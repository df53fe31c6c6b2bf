#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace mirrorball {

/// The most bytes that are unpacked of all the compressed texts of a file: more than any real packet has.
inline constexpr std::size_t kLongestCompressedXmp = std::size_t{1} << 20;

/// What is still to be unpacked of a file. It is taken in steps, so that neither one text that is large nor many that
/// are small take more than that.
class UnpackingBudget {
 public:
  static constexpr std::size_t kStep = std::size_t{1} << 14;

  /// Whether there is so much left, which is taken then.
  bool take(std::size_t bytes) {
    if (bytes > left_) return false;
    left_ -= bytes;
    return true;
  }
  bool isSpent() const { return left_ < kStep; }

 private:
  std::size_t left_ = kLongestCompressedXmp;
};

/// Whether some text, which may be any profile, has an XMP packet in it.
inline bool holdsXmp(std::string_view text) {
  return text.find("<x:xmpmeta") != std::string_view::npos || text.find("<rdf:RDF") != std::string_view::npos;
}

/// The XMP that a file holds compressed or written as digits, where a search of its bytes does not find it: in a PNG's
/// iTXt, zTXt and ImageMagick's "Raw profile type", and in a JPEG XL's `brob` boxes.
///
/// bytes    of a file, or of its beginning
/// returns  text with the first packet in it; empty where there is none, where it is damaged or behind more than
///          kLongestCompressedXmp of other texts, and of all other formats
/// cost     a pass over the file's chunks; at most kLongestCompressedXmp of memory
std::string compressedXmp(std::span<const std::uint8_t> bytes);

}  // namespace mirrorball
