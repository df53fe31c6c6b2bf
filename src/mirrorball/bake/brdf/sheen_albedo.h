#pragma once

namespace mirrorball {

/// How much of a white environment's light white cloth reflects towards an eye: formula/bsdf/charlie.glsl integrated
/// over the hemisphere.
///
/// sheen_roughness   perceptual, in [0, 1]
/// cosine            n·v in [0, 1]
/// returns           in [0, 1], within 2e-3: interpolated in a table that is made when it is first asked for
/// cost              20 ns; the table once 60 ms on 2 cores
float sheenAlbedo(float sheen_roughness, float cosine);

}  // namespace mirrorball
