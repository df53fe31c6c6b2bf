#pragma once

#include <compare>
#include <string>
#include <vector>

#include "formula/prefilter.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/scene/material/material.h"

namespace mirrorball {

/// What a frame and a material decide by numbers, as constants of their shaders: of a branch that the compiler can
/// decide nothing is left. A software driver follows both sides of every other one for each pixel, whatever it reads
/// there; a GPU keeps registers for both.
///
/// What a slider moves stays a uniform. These change where it comes to a value that a formula leaves out, as no
/// dispersion; then other shaders are made.
struct ShaderConstants {
  int texture_filter = 0;  ///< of formula/surface/filter_kind.glsl
  int blur_kind = 0;       ///< of formula/prefilter/blur.glsl
  int lobe_taps = 1;       ///< 1, or of formula/bsdf/lobe_row.glsl
  int fresnel = 0;         ///< of formula/material.glsl
  bool has_conductor_index = false;
  bool disperses = false;
  bool has_specular_color = false;  ///< other than white, at some place
  bool has_smooth_coat = false;     ///< whose reflection is sharp everywhere
  bool has_wide_lobes = false;      ///< of which none needs the environment beside its prefiltered chain

  auto operator<=>(const ShaderConstants&) const = default;
};

ShaderConstants shaderConstants(const Material& material, const FrameSettings& settings);

/// Of a surface that the eye's ray meets from inside of bodies, whose own numbers are not read
/// (shaders/surface/material_from_inside.glsl).
ShaderConstants seenFromInside(const ShaderConstants& constants);

/// Whether all lobes of a material's reflection, and of its coat's, are at least as wide as those of the chain's first
/// level. Of maps of roughness, which may be dark, it is not known; bumps make lobes only wider.
///
/// blur   of the light that it reads
bool hasWideLobes(const Material& material, const ShaderConstants& constants, const formula::Blur& blur);

/// Whether a material has a clear coat of roughness 0, also where a pixel averages bumps of the coat away.
bool hasSmoothCoat(const Material& material);

/// For the shaders' preprocessor: "NAME value".
std::vector<std::string> definitionsOf(const ShaderConstants& constants);

}  // namespace mirrorball
