// Part "behind": the light of a ray that has left a body.
//   vec3 lightBehind(vec3 origin, vec3 d, float perceptual_roughness, float footprint)      as incomingLight's
// Here: what reflected rays see, too.

vec3 lightBehind(vec3 origin, vec3 d, float perceptual_roughness, float footprint) {
  return incomingLight(origin, d, perceptual_roughness, footprint);
}
