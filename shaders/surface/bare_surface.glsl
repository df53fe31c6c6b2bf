// A surface that answers to no light of its own accord: no rough facets, no layers.
Surface bareSurface(SurfacePoint point, Material m, vec3 n) {
  Surface s;
  s.material = m;
  s.normal = n;
  s.own_roughness = m.perceptual_roughness;
  s.occlusion = 1.0;
  s.environment_brdf = vec3(0.0);
  stretchRoughness(s, point);
  layCloth(s, point);
  return s;
}
