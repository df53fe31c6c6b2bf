// How near surfaces are to the camera's place (formula/proxy/captured_sight.glsl).
#include "nearness_of_depth.glsl"

out vec4 fragment;

void main() {
  float nearness = nearnessOfDepth();
  if (nearness == 0.0) discard;
  fragment = vec4(nearness, 0.0, 0.0, 1.0);
}
