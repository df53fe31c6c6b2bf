// A texel of the picture of back faces (formula/bodies/back_face.glsl).
#include "constants.glsl"
#include "octahedral.glsl"
#include "back_face.glsl"

uniform vec3 camera_position;
uniform vec3 camera_forward;

in vec3 world_position;
in vec3 world_normal;

out vec4 texel;

void main() {
  vec3 normal = normalize(world_normal);
  float curvature = curvatureOfPixels(dFdx(world_position), dFdx(normal), dFdy(world_position), dFdy(normal));
  texel = vec4(octahedralPosition(normal), dot(world_position - camera_position, camera_forward), curvature);
}
