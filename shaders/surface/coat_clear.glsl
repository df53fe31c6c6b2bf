// Part "coat" (coat_none.glsl). Here: one that is smooth over bumps and normal maps.
vec3 coatNormal(SurfacePoint point) { return point.normal; }
#include "coat.glsl"
