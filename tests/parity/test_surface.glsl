// A surface from three vectors of inputs: q.xyz its normal, turned to the side that the ray p.xyz comes from; the rest
// its parameters, each over its whole range.
FN Surface testSurface(vec4 p, vec4 q, vec4 r) {
  Surface s;
  vec3 n = vec3(q);
  s.normal = dot(vec3(p), n) > 0.0f ? -n : n;
  s.material.base_color = vec3(p.w, 0.5f, 1.0f - p.w);
  s.material.metallic = q.w;
  s.material.perceptual_roughness = r.x;
  s.own_roughness = r.x;
  s.material.specular = 1.0f - 0.5f * r.y;
  s.material.specular_color = vec3(1.0f, 30.0f * r.w, 0.25f);
  s.material.ior = 1.0f + 1.5f * r.z;
  s.material.dispersion = r.w;
  s.material.sellmeier_b = r.w < 0.5f ? vec4(0.0f) : r;
  s.material.sellmeier_c = vec4(0.0f, 0.015625f, 0.03125f, 64.0f);
  s.material.transmission = r.y;
  s.material.attenuation_color = vec3(1.0f, 1.0f, 1.0f);
  s.material.attenuation_distance = 0.0f;
  s.material.conductor_n = vec3(0.2f, 0.9f, 1.5f);
  s.material.conductor_k = r.w < 0.5f ? vec3(0.0f, 0.0f, 0.0f) : vec3(3.0f, 2.5f, 2.0f);
  s.occlusion = 1.0f - p.w;
  s.material.emission = vec3(0.0f, 0.25f, r.w);
  s.material.fresnel = int(3.9375f * r.z);
  s.material.fresnel_offset = 0.05f;
  s.material.fresnel_scale = 0.9f;
  s.material.fresnel_power = 4.0f;
  s.material.f82_tint = vec3(0.25f, 0.75f, r.x);
  s.tangent = normalize(cross(s.normal, vec3(0.6f, 0.48f, 0.64f)));
  s.sheen_albedo = 0.5f * r.y;
  s.stretched_share = 1.0f - 0.5f * r.w;
  s.material.clearcoat = r.x;
  s.material.clearcoat_roughness = 0.5f * r.y;
  s.material.sheen_color = vec3(0.25f, r.y, 0.75f);
  s.material.sheen_roughness = 0.5f + 0.5f * r.z;
  s.material.anisotropy = 0.5f * r.w;
  s.material.iridescence = r.y < 0.5f ? 0.0f : r.z;
  s.material.iridescence_ior = 1.25f + r.x;
  s.material.iridescence_thickness = 800.0f * r.w;
  s.environment_brdf = vec3(0.25f + 0.5f * r.w, 0.25f * r.x, 0.125f * r.x + 0.0625f * r.y);
  return s;
}
