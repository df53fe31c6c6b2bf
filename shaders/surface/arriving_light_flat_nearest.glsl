// Part "arriving light" (arriving_light_distant.glsl). Here: the same from pictures of six faces side by side, whose
// texels the shader finds by itself: the nearest texel.
#define FLAT_LOOK_UP flatNearestLod
#include "flat_light.glsl"
