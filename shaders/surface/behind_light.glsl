// Part "behind": what a ray meets that goes through a body.
//   vec3 lightBehind(vec3 origin, vec3 d, float perceptual_roughness, float footprint)      as incomingLight's: when it
//                                                                                           has left the body
//   bool meetsInside(vec3 origin, vec3 d, float perceptual_roughness, inout float way, out vec3 light)
//                          whether it meets something before it has gone a way in the body: how far, and its light
//   bool meetsBefore(vec3 origin, vec3 d, float perceptual_roughness, float way, out vec3 light)
//                          the same of a way outside of bodies, from one to the next
// Here: what reflected rays see, too; nothing inside.

vec3 lightBehind(vec3 origin, vec3 d, float perceptual_roughness, float footprint) {
  return incomingLight(origin, d, perceptual_roughness, footprint) +
         sunsAlong(origin, d, perceptual_roughness, footprint);
}

bool meetsInside(vec3 origin, vec3 d, float perceptual_roughness, inout float way, out vec3 light) {
  light = vec3(0.0);
  return false;
}

bool meetsBefore(vec3 origin, vec3 d, float perceptual_roughness, float way, out vec3 light) {
  light = vec3(0.0);
  return false;
}
