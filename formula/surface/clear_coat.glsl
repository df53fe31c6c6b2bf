// A coat of clear varnish over all that a surface is made of (KHR_materials_clearcoat). It is a surface of its own,
// black but for what it reflects; what it does not reflect goes straight to what is below, and comes back from there.
// Needs: material, shading.

const float kCoatIor = 1.5f;

FN Material coatMaterial(Material m) {
  m.base_color = vec3(0.0f);
  m.metallic = 0.0f;
  m.perceptual_roughness = m.clearcoat_roughness;
  m.specular = 1.0f;
  m.specular_color = vec3(1.0f);
  m.ior = kCoatIor;
  m.dispersion = 0.0f;
  m.sellmeier_b = vec4(0.0f);
  m.transmission = 0.0f;
  m.emission = vec3(0.0f);
  m.fresnel = kFresnelExact;
  m.clearcoat = 0.0f;
  m.sheen_color = vec3(0.0f);
  m.anisotropy = 0.0f;
  m.iridescence = 0.0f;
  return m;
}

// The coat of a surface, seen along the ray from the eye.
//   normal, tangent, environment_brdf   of the coat, as in Surface
FN Surface coatOf(Surface s, vec3 ray, vec3 normal, vec3 tangent, vec3 environment_brdf) {
  s.material = coatMaterial(s.material);
  s.own_roughness = s.material.perceptual_roughness;
  s.normal = normal;
  s.tangent = tangent;
  s.environment_brdf = environment_brdf;
  s.stretched_share = 1.0f;
  s.sheen_albedo = 0.0f;
  return seenAlong(s, ray);
}

// Light from below a coat, and the light that the coat itself shows.
//   share        of the surface that it covers
FN vec3 underCoat(Surface coat, float share, vec3 light, vec3 of_coat) {
  vec3 reflected = aroundMirror(coat.reflectance) + coat.reflectance.multiple_scattering;
  return light * (vec3(1.0f) - share * reflected) + share * of_coat;
}
