#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "mirrorball/bake/prefilter/lobe.h"

namespace mirrorball {

/// One read of a cube's mip levels (formula/prefilter/mip_taps.glsl).
struct LobeTap {
  glm::vec2 place;      ///< x and y of its direction in a frame whose third axis is the lobe's middle
  float footprint_rad;  ///< the width of the texels that it blurs like
  float weight;
};

/// Taps whose weighted sum is nearly the mean under a lobe.
///
/// They stand on rings that share the lobe's light evenly, but for the outer ones, which get more than their share; a
/// tap's footprint grows with its part of the ring. The weights are those with the least expected square error for
/// random light whose power is the same in each octave of bands, as in natural pictures: with the addition theorem of
/// spherical harmonics a linear system of one unknown a ring.
///
/// texel_rad  width of the map's own texels: no footprint is less
/// rings      at least 1, of `points` taps each
/// returns    weights of at least 0 and sum 1; ring after ring from the inside
/// cost       rings² · points · the lobe's bands, about 1 ms
/// from       docs/prefiltering_gpu.md; Bayesian quadrature (O'Hagan 1991)
std::vector<LobeTap> lobeTaps(const Lobe& lobe, float texel_rad, int rings, int points);

}  // namespace mirrorball
