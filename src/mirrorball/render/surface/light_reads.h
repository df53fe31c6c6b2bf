#pragma once

#include "formula/surface.h"
#include "mirrorball/render/light/environment_light.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/surface/frame_uniforms.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Blur::kind of formula/prefilter/blur.glsl: both chains are looked up alike.
int blurKindOfFormula(BlurKind blur);

/// How a frame blurs light, for formula/prefilter/blur.glsl.
///
/// cube    the light itself
/// chain   made of it
formula::Blur blurOf(const FrameSettings& settings, const gl::Texture& cube, const PrefilteredChain& chain);

/// How often a surface reads each texture of light for one sample of a pixel.
struct LightReads {
  int environment = 0;
  int prefiltered = 0;
  int irradiance = 0;
  int sphere_map = 0;

  int sum() const { return environment + prefiltered + irradiance + sphere_map; }
};

/// Counted: the formula that the shaders read light by (blurredLight) is evaluated with samplers that count. What each
/// part of shaders/surface/ adds to that is written down here.
///
/// scene    of its materials, for each texture the one that reads it most often; where a map makes a surface smoother
///          than its material's number, it may read less
LightReads lightReads(const Scene& scene, const formula::Blur& blur, const FrameSettings& settings);

}  // namespace mirrorball
