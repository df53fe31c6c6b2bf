// Part "suns" (suns_none.glsl). Here: the scene hides them, as pictures of its depths say that are drawn from each sun
// (render/surface/sun_shadows.h).
#include "sun_list.glsl"
#include "sun_shadow.glsl"

uniform highp sampler2D sun_shadows;  // of all suns side by side, each as wide as it is high

// Of each sun, from the world: across, up and away from it, so that the scene lies from 0 to 1.
uniform vec4 sun_shadow_rows[3 * SUN_COUNT];

const int kShadowTaps = 8;

const float kFarthest = 0.99999;  // where there is nothing it is 1

// The nearest of the scene to the sun.
//   at   from (0, 0) to (1, 1)
float nearestToSun(int sun, vec2 at) {
  int side = textureSize(sun_shadows, 0).y;
  ivec2 texel = clamp(ivec2(floor(at * float(side))), ivec2(0), ivec2(side - 1));
  return texelFetch(sun_shadows, texel + ivec2(sun * side, 0), 0).x;
}

// The share of a sun that is seen from a place (Fernando 2005, "Percentage-closer soft shadows"): what hides it is
// looked for as far around as its disc may be hidden from, and how blurred its edge is follows from how far away it is.
//   up   unit, of the surface there
float sunShare(int sun, vec3 place, vec3 up) {
  float texel = 1.0 / float(textureSize(sun_shadows, 0).y);
  mat3 axes = mat3(sun_shadow_rows[3 * sun].xyz, sun_shadow_rows[3 * sun + 1].xyz, sun_shadow_rows[3 * sun + 2].xyz);
  vec3 origin = vec3(sun_shadow_rows[3 * sun].w, sun_shadow_rows[3 * sun + 1].w, sun_shadow_rows[3 * sun + 2].w);
  float scale = length(axes[0]);
  // So far above the surface that its own texels, which are flat, do not hide it.
  vec3 at = (place + up * (kAboveShadow * texel / scale)) * axes + origin;
  if (min(min(at.x, at.y), at.z) <= 0.0 || max(at.x, at.y) >= 1.0) return 1.0;
  vec2 slope = slopeInShadow(up * axes / scale);
  float spread = sun_rows[2 * sun].w;
  float turn = sample_phase;
  float hiders = 0.0;
  float depths = 0.0;
  float reach = max(spread * at.z, texel);
  for (int i = 0; i < kShadowTaps; ++i) {
    vec2 beside = reach * shadowTap(i, kShadowTaps, turn);
    float depth = nearestToSun(sun, at.xy + beside);
    if (depth >= min(at.z + dot(slope, beside), kFarthest)) continue;
    hiders += 1.0;
    depths += depth;
  }
  if (hiders == 0.0) return 1.0;
  float width = max(spread * (at.z - depths / hiders), kLeastShadowEdge * texel);
  float lit = 0.0;
  for (int i = 0; i < kShadowTaps; ++i) {
    vec2 beside = width * shadowTap(i, kShadowTaps, turn);
    lit += nearestToSun(sun, at.xy + beside) >= min(at.z + dot(slope, beside), kFarthest) ? 1.0 : 0.0;
  }
  return lit / float(kShadowTaps);
}

#include "light_of_suns.glsl"
