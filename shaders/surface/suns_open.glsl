// Part "suns" (suns_none.glsl). Here: nothing hides them but the relief of the surface.
float sunShare(int sun, vec3 place, vec3 up) { return 1.0; }
#include "light_of_suns.glsl"
