#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/ldr/gain_map.h"

namespace mirrorball {

/// The container of an Ultra HDR picture: a JPEG, behind whose end stands a second one, the gain map.

/// The second of the two.
struct GainMapPart {
  std::span<const std::uint8_t> jpeg;  ///< from its beginning to the file's end; empty: the file has lost it
  GainMap map = {};
};

/// Finds the gain map of a JPEG that says it has one. It is the first JPEG behind the end that says how it is meant as
/// a gain map; where the container's tables say that it stands is not asked, for programs that change a picture
/// leave wrong numbers there. ISO's metadata come before XMP's.
///
/// returns  nothing where the JPEG speaks of none
/// errors   as readGainMapXmp's
/// cost     O(bytes)
Result<std::optional<GainMapPart>> findGainMap(std::span<const std::uint8_t> bytes);

/// Joins a picture and its gain map, with XMP, ISO 21496-1 and the tables of both containers (MPF, GContainer).
///
/// picture  a JPEG as encodeJpeg writes it
/// map      likewise; 1 or 3 channels
/// from     Android, Ultra HDR Image Format v1.1; CIPA DC-007-2009 (MPF); ISO 21496-1:2025, annex C.4
Bytes joinedUltraHdr(const Bytes& picture, const Bytes& map, const GainMap& gain_map);

}  // namespace mirrorball
