#pragma once

namespace mirrorball {

/// The least weight of a texel beside a brighter one (in its block), and of the square of a channel's share in a texel.
/// Beside a sun leaves count less, but not so little that they would shine.
inline constexpr float kMinWeight = 1.0f / 64.0f;
inline constexpr float kMinShare = 1.0f / 16.0f;

/// Below any difference that counts, and above where a division would overflow.
inline constexpr float kTiny = 1e-20f;

}  // namespace mirrorball
