// Part "transmission" (transmission_none.glsl). Here: the light from where the ray goes after this one surface, for
// each channel its own where the glass disperses.

vec3 lightThrough(Surface s, SurfacePoint point, float ior) {
  vec3 d = refractedDirection(point.ray, s.normal, ior);
  return incomingLight(point.position, d, s.material.perceptual_roughness, 0.0);
}

vec3 transmittedLight(Surface s, SurfacePoint point) {
  vec3 ior = iorOfChannels(s.material.ior, s.material.dispersion);
  vec3 green = lightThrough(s, point, ior.y);
  if (s.material.dispersion == 0.0) return green;
  return vec3(lightThrough(s, point, ior.x).x, green.y, lightThrough(s, point, ior.z).z);
}
