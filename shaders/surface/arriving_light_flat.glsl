// Part "arriving light" (arriving_light_distant.glsl). Here: the same from pictures of six faces side by side, whose
// texels the shader finds by itself: bilinearly, and between mip levels.
#define FLAT_LOOK_UP flatTrilinear
#include "flat_light.glsl"
