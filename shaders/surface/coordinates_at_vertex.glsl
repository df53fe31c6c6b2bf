// Part "coordinates" (coordinates_at_fragment.glsl). Here: computed at the vertices and interpolated between them, as
// the first hardware did it.
#include "sphere_map.glsl"
#include "texgen.glsl"

in vec4 vertex_look_up;
in vec4 vertex_picture;

vec4 lookUpCoordinates(SurfacePoint point, vec3 n) { return vertex_look_up; }

vec4 pictureCoordinates(SurfacePoint point) { return vertex_picture; }
