#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/ldr/gain_map.h"

namespace mirrorball {

/// The two ways in which a JPEG says how its gain map is meant. Writers of today write both.

/// The names that the segments begin with, with their 0: XMP's in APP1, ISO 21496-1's in APP2.
inline constexpr std::string_view kXmpName("http://ns.adobe.com/xap/1.0/\0", 29);
inline constexpr std::string_view kIsoGainMapName("urn:iso:std:iso:ts:21496:-1\0", 28);

/// Whether an XMP packet speaks of a gain map: a picture's says that there is one, the map's own how it is meant.
bool speaksOfGainMap(std::string_view xmp);

/// Reads the numbers of a gain map from its own XMP packet: attributes, or elements that hold one number or a list of
/// three. It is no reader of XML; comments and entities are not what writers put there.
///
/// errors   bad_file (a number is missing or is none; or as checkGainMap's); unsupported (another version, a picture
///          that is the HDR rendition itself)
/// from     Adobe, Gain Map Specification 1.0, "XMP metadata"
Result<GainMap> readGainMapXmp(std::string_view xmp);

/// The same from ISO 21496-1's numbers, which are fractions.
///
/// data     behind kIsoGainMapName
/// errors   as readGainMapXmp's
/// from     ISO 21496-1:2025, annex C.2: gain map metadata
Result<GainMap> readGainMapIso(std::span<const std::uint8_t> data);

/// A packet for the map's own JPEG. It has attributes alone, for three.js' loader reads no lists.
///
/// gain_map of numbers that are the same in all channels
std::string gainMapXmp(const GainMap& gain_map);

/// A packet for the picture's: it says that a gain map follows, of so many bytes.
///
/// from     Android, Ultra HDR Image Format v1.1, "GContainer"
std::string gainMapContainerXmp(std::size_t gain_map_bytes);

/// What stands behind kIsoGainMapName in the map's JPEG.
Bytes gainMapIso(const GainMap& gain_map);

/// And in the picture's: the version alone.
Bytes gainMapIsoVersion();

}  // namespace mirrorball
