// Part "sky" (sky_open.glsl). Here: the relief around the point does, as far as its horizons say, and shows its own
// light instead.
#include "heights.glsl"
#include "occlusion.glsl"
#include "horizon.glsl"

uniform highp sampler2DArray horizons;

Horizons horizonsAt(SurfacePoint point) {
  float tiles = material.height_frequency;
  float part = tiles / sqrt(samples_per_pixel);
  vec2 uv = point.uv_0 * tiles;
  vec2 across = point.uv_across * part;
  vec2 down = point.uv_down * part;
  return Horizons(textureGrad(horizons, vec3(uv, 0.0), across, down),
                  textureGrad(horizons, vec3(uv, 1.0), across, down));
}

ReliefGround groundAt(SurfacePoint point) {
  SurfaceChange change = surfaceChange();
  vec2 size = heightMapSize();
  return ReliefGround(change.along_u / material.height_frequency,
                      change.along_v * (size.x / (size.y * material.height_frequency)), point.normal,
                      dot(reliefUp(point), point.normal));
}

const float kSliceRoughness = 0.6;  // a lobe about as wide as a slice

// The light of the sky over the horizons, as shares of what there would be without them.
struct SkyShare {
  vec3 light;        // of this sky
  float irradiance;  // of an even one
};

SkyShare skyShare(ReliefGround ground, Horizons h, SurfacePoint point, vec3 normal) {
  vec3 visible = vec3(0.0);
  vec3 open = vec3(0.0);
  float share = 0.0;
  float whole = 0.0;
  for (int azimuth = 0; azimuth < 8; ++azimuth) {
    SkySlices s = slicesOfSky(ground, h, normal, azimuth);
    visible += s.visible.share * lightOfWideLobe(point.position, s.visible.direction, kSliceRoughness);
    open += s.open.share * lightOfWideLobe(point.position, s.open.direction, kSliceRoughness);
    share += s.visible.share;
    whole += s.open.share;
  }
  return SkyShare(visible / max(open, vec3(1e-12)), clamp(share / max(whole, 1e-6), 0.0, 1.0));
}

vec3 litByEnvironment(Surface s, SurfacePoint point, vec3 transmitted, vec3 on_cloth) {
  ReliefGround ground = groundAt(point);
  vec3 irradiance = arrivingIrradiance(point.position, s.normal);
  vec3 reflected = reflectedLight(s, point);
  bool is_flat = ground.along_u == vec3(0.0) || ground.along_v == vec3(0.0);
  // Of a surface that is seen from behind nothing is known.
  if (is_flat || dot(s.normal, ground.up) <= 0.0)
    return shadedByEnvironment(s, reflected, transmitted, irradiance, on_cloth);
  Horizons h = horizonsAt(point);
  SkyShare sky = skyShare(ground, h, point, s.normal);
  float lobe = lobeOverHorizons(ground, h, s.normal, reflect(point.ray, s.normal),
                                alphaFromPerceptualRoughness(s.material.perceptual_roughness));
  vec3 on_relief = irradiance * sky.light / max(sky.irradiance, 1e-3) + irradianceOfSuns(point.normal, suns_on_mesh);
  vec3 relief = lightOfRelief(s, sky.irradiance, on_relief);
  vec3 hidden = (1.0 - sky.irradiance) * relief;
  return shadedByEnvironment(s, mix(relief, reflected, lobe), transmitted, irradiance * sky.light + hidden,
                             on_cloth * sky.light + hidden);
}
