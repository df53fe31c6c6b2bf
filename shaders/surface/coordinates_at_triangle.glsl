// Part "coordinates" (coordinates_at_fragment.glsl). Here: those of a triangle's last corner for all of it, as with
// OpenGL's flat shading: a mirror made of tiles.
#include "sphere_map.glsl"
#include "texgen.glsl"

flat in vec4 triangle_look_up;
flat in vec4 triangle_picture;

vec4 lookUpCoordinates(SurfacePoint point, vec3 n) { return triangle_look_up; }

vec4 pictureCoordinates(SurfacePoint point) { return triangle_picture; }
