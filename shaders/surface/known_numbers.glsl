// The material with the numbers that are constants of its shaders (render/surface/shader_constants.h).

Material withKnownNumbers(Material m) {
  m.fresnel = FRESNEL;
  if (!HAS_CONDUCTOR_INDEX) m.conductor_k = vec3(0.0);
  if (HAS_SMOOTH_COAT) m.clearcoat_roughness = 0.0;
  if (!HAS_SPECULAR_COLOR) m.specular_color = vec3(1.0);
  if (!DISPERSES) {
    m.dispersion = 0.0;
    m.sellmeier_b = vec4(0.0);
  }
  return m;
}
