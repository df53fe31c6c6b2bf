// Part "coat" (coat_none.glsl). Here: one that is smooth over bumps and normal maps.
vec3 coatNormal(SurfacePoint point) { return point.normal; }
float hiddenInCoat(SurfacePoint point) { return 0.0; }
#include "coat.glsl"
