#pragma once

#include "mirrorball/base/result.h"
#include "mirrorball/gl/texture.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// The BRDF table as shaders/surface/ looks it up, on warped axes: in its channels 0, 1 and 3 Surface::environment_brdf
/// of formula/surface/shading.glsl, in channel 2 zeros. Needs no GL context.
///
/// cost     about 20 ms on 2 cores; made once
Result<Image> surfaceBrdfTable();

/// The same with the albedo of white cloth in channel 2.
///
/// cost     about 60 ms more; made once
Result<Image> surfaceBrdfTableWithCloth();

/// A table of those two and, on its right, the rows of lobes: shaders are short of textures. OpenGL ES filters no more
/// than half floats, which keep each share to 5e-4 of itself.
///
/// errors   too_large (for this driver)
Result<gl::Texture> brdfTexture(const Image& table);

}  // namespace mirrorball
