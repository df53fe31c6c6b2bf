// Part "coordinates": what addresses pictures of light and of colour, before a matrix.
//   vec4 lookUpCoordinates(SurfacePoint point, vec3 n)   of the light that is reflected; n on the viewer's side
//   vec4 pictureCoordinates(SurfacePoint point)          of base_color_map, where they are generated
// LOOK_UP_COORDINATES and PICTURE_COORDINATES name the formulas of texgen.glsl.
// Here: computed at the fragment.
#include "sphere_map.glsl"
#include "texgen.glsl"

vec4 lookUpCoordinates(SurfacePoint point, vec3 n) {
  return LOOK_UP_COORDINATES(TexgenPoint(point.object_position, point.position, n, point.ray, eye_from_world));
}

vec4 pictureCoordinates(SurfacePoint point) {
  return PICTURE_COORDINATES(
      TexgenPoint(point.object_position, point.position, point.normal, point.ray, eye_from_world));
}
