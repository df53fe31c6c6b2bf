// The light that passes a surface by `vec3 lightThrough(Surface, SurfacePoint, float ior)`, for each kind of light its
// own where the body disperses.

vec3 transmittedLight(Surface s, SurfacePoint point) {
  RefractiveIndex index = refractiveIndexOf(s.material);
  bool disperses = s.material.dispersion != 0.0;
  vec3 light = vec3(0.0);
  for (int kind = 0; kind < lightKinds(disperses); ++kind)
    light += shareOfKind(kind, disperses) * lightThrough(s, point, iorOfKind(index, kind));
  return light;
}
