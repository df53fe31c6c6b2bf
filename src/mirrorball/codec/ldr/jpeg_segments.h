#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/base/result.h"

namespace mirrorball {

/// A part of a JPEG between two markers.
struct JpegSegment {
  std::uint8_t marker;                 ///< its second byte: 0xe1 is APP1
  std::span<const std::uint8_t> data;  ///< without the length

  /// What stands behind a name, as those that APP1 and APP2 begin with.
  ///
  /// name     with its 0
  /// returns  nothing where the segment has another marker or name
  std::span<const std::uint8_t> behind(std::uint8_t its_marker, std::string_view name) const;
};

inline constexpr std::uint8_t kApp1 = 0xe1;
inline constexpr std::uint8_t kApp2 = 0xe2;

/// What a JPEG has before its first scan.
struct JpegHeader {
  std::vector<JpegSegment> segments;
  std::size_t end = 0;  ///< where the scan begins, or what is no segment
};

/// Reads the segments of the JPEG that the bytes begin as, up to its first scan. Whatever the bytes are, those that are
/// read lie within them.
///
/// from     ITU-T T.81, B.1.1 (markers, fill bytes) and B.2 (what has a length)
JpegHeader jpegHeader(std::span<const std::uint8_t> jpeg);

/// The data of the first frame header that holds a picture's size, which is at the places below; of no bytes where
/// there is none.
///
/// from     ITU-T T.81, B.2.2
std::span<const std::uint8_t> frameHeader(const JpegHeader& header);

inline constexpr std::size_t kJpegFrameHeight = 1;  // behind the bits of a sample
inline constexpr std::size_t kJpegFrameWidth = 3;

/// Where that JPEG ends: behind its end marker.
///
/// returns  the number of bytes where there is none
std::size_t endOfJpeg(std::span<const std::uint8_t> jpeg);

/// Where the last segment begins that begins before a place of that JPEG and behind its first scan's header: what an
/// error there is about. None of the scans before it needs it.
///
/// returns  nothing where there is none
std::optional<std::size_t> segmentBetweenScans(std::span<const std::uint8_t> jpeg, std::size_t before);

/// A JPEG whose frame header leaves its height open, with the height that a DNL segment states behind its first scan;
/// nothing where the header states one.
///
/// errors   bad_file: there is no such segment
/// from     ITU-T T.81, B.2.2 and B.2.5
Result<std::optional<Bytes>> withHeightInHeader(std::span<const std::uint8_t> jpeg);

/// A segment as it stands in a file.
///
/// data     at most 65533 bytes
Bytes jpegSegment(std::uint8_t marker, std::span<const std::uint8_t> data);

/// The place in a JPEG that libjpeg wrote where further segments may stand: behind JFIF's, which comes first.
std::size_t behindJfif(std::span<const std::uint8_t> jpeg);

}  // namespace mirrorball
