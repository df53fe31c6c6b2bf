// What a ray sees that has left all bodies and meets nothing of the scene.

const float kEndless = 1e30;  // longer than any way in a scene

vec3 lightFromAfar(vec3 origin, vec3 d, float perceptual_roughness, float footprint) {
  return incomingLight(origin, d, perceptual_roughness, footprint) +
         sunsAlong(origin, d, perceptual_roughness, footprint);
}
