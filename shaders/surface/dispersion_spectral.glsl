// Part "dispersion" (dispersion_channels.glsl). Here: some wavelengths, other ones in pixels side by side, chosen by
// render/surface/wavelength_sets.cpp.
#include "color.glsl"
#include "wavelength.glsl"

vec4 lightOfKind(int kind) {
  int set = wavelengthSetOfPixel(int(gl_FragCoord.x), int(gl_FragCoord.y));
  return wavelengths[set * wavelength_count + kind];
}

int lightKinds(bool disperses) { return disperses ? wavelength_count : 1; }

vec3 shareOfKind(int kind, bool disperses) { return disperses ? lightOfKind(kind).xyz : vec3(1.0); }

float iorOfKind(RefractiveIndex index, int kind) { return iorAtWavelength(index, lightOfKind(kind).w); }
