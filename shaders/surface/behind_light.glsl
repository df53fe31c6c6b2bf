// Part "behind": what a ray meets that goes through a body.
//   bool meetsSurface(vec3 origin, vec3 d, float perceptual_roughness, bool is_inside, inout float way, out vec3 light)
//                          whether it meets something before it has gone a way, in the body or outside of bodies (where
//                          the way may be kEndless): how far, and its light
// Here: nothing.

bool meetsSurface(vec3 origin, vec3 d, float perceptual_roughness, bool is_inside, inout float way, out vec3 light) {
  light = vec3(0.0);
  return false;
}
