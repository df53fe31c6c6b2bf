#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/codec/color/output_primaries.h"
#include "mirrorball/codec/color/primaries.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// How codes of pictures and videos stand for light.
enum class Transfer { srgb, rec709, linear, gamma, pq, hlg };

/// What a file says of its codes.
struct CodedColor {
  Transfer transfer = Transfer::srgb;
  double gamma = 1.0;                       ///< of Transfer::gamma: light is the code to this power
  std::optional<Primaries> primaries = {};  ///< nothing: Rec.709's
  /// What an ICC profile calls itself that is not understood and so not applied, in whose place sRGB is assumed.
  std::string unread_profile = {};
};

/// The radiance of white, by which PQ and HLG, which state absolute light, become relative [cd/m²].
///
/// source   ITU-R BT.2408-7 (2023), 2.2: graphics white
inline constexpr float kGraphicsWhite = 203.0f;

/// By the numbers of ITU-T H.273 (2021), tables 2 and 3, as AVIF, HEIF and PNG's cICP have them. Numbers that say
/// nothing, or that are not known, mean sRGB.
CodedColor codedColor(int primaries, int transfer);

/// Of a curve and primaries that a file states by themselves.
CodedColor codedColor(const TransferCurve& curve, const std::optional<Primaries>& primaries);

/// Whether codes with 1, 3 or 4 channels are sRGB's as they are, as far as is known.
bool isSrgb(const CodedColor& color);

/// What a file says of its colours that counts for nothing where its samples are read as numbers: "sRGB, Display P3".
/// Empty of sRGB's codes and of linear light with Rec.709's primaries, which are what formats mean without a word.
std::string statedSpace(const CodedColor& color, int channels);

/// Adds the remark on such a colour space; none where it is empty.
void tellUnapplied(const std::string& space, std::vector<std::string>& oddities);

/// What `info` says of the colours of samples that are read as numbers.
inline constexpr std::string_view kAsStored = "none: numbers as they are stored";

/// The curve that gives the light of each code by itself, relative to white; nothing: PQ's, HLG's and Rec.709's.
std::optional<TransferCurve> curveOf(const CodedColor& color);

/// The number of primaries there, of any but ACEScg's, which has none.
int codePointOf(OutputPrimaries primaries);

/// Turns codes from 0 to 1 into linear light of Rec.709's primaries; a fourth channel is alpha and stays. PQ's light is
/// in kGraphicsWhite, up to 49; HLG's as on a display of 1000 cd/m², up to 4.9.
///
/// returns  whether that changed them
/// source   PQ: SMPTE ST 2084 (2014), equation 4.1; HLG: ITU-R BT.2100-2 (2018), table 5; Rec.709: ITU-R BT.709-6,
///          item 1.2
bool decodeColor(Image& codes, const CodedColor& color);

/// What `info` says of it: of a profile that is not understood, that it is not applied, but for one that is sRGB's by
/// its name.
std::string describeColor(const CodedColor& color, int channels);

}  // namespace mirrorball
