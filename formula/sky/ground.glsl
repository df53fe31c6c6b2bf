// The ground under the built-in sky: dry soil with patches of stubble, seen from the height of an eye. Made to be
// believed, not measured; what is physical in it is said. Needs: constants, grid_random.

// Where a ray that goes down meets the ground, in heights of the eye.
FN vec2 groundPlace(vec3 d) { return vec2(d.x, d.z) / max(-d.y, 1e-4f); }

// A smooth random function of mean ½, between 0 and 1, whose cells are 1 wide: values at the corners, blended by
// 3 t² − 2 t³ (Perlin 1985).
FN float groundNoise(vec2 place) {
  vec2 corner = floor(place);
  vec2 t = place - corner;
  vec2 fade = t * t * (3.0f - 2.0f * t);
  ivec3 cell = ivec3(int(corner.x), int(corner.y), 0);
  float low = mix(gridRandom(cell).x, gridRandom(cell + ivec3(1, 0, 0)).x, fade.x);
  float high = mix(gridRandom(cell + ivec3(0, 1, 0)).x, gridRandom(cell + ivec3(1, 1, 0)).x, fade.x);
  return mix(low, high, fade.y);
}

// How much of a pattern of cells `width` heights wide is left at a ray, whose downward component is `sine`: seen at
// that angle a cell is width · sine² high [rad], and goes as it falls from five to two texels.
FN float groundDetail(float width, float sine, float texel_rad) {
  return smoothstep(2.0f, 5.0f, width * sine * sine / texel_rad);
}

// One octave about 0, of cells `width` heights wide. `octave` gives each another part of the noise.
FN float groundOctave(vec2 place, float width, float octave, float sine, float texel_rad) {
  float detail = groundDetail(width, sine, texel_rad);
  if (detail <= 0.0f) return 0.0f;
  return (groundNoise(place / width + 17.0f * octave) - 0.5f) * detail;
}

// Patches of 5 and 4/3 heights, grains of 1/3 and 1/12. Those too far away to be seen are 0, their mean.
FN vec2 groundPattern(vec2 place, float sine, float texel_rad) {
  float patches = 0.65f * groundOctave(place, 5.0f, 0.0f, sine, texel_rad) +
                  0.35f * groundOctave(place, 1.333333f, 1.0f, sine, texel_rad);
  float grains = 0.6f * groundOctave(place, 0.333333f, 2.0f, sine, texel_rad) +
                 0.4f * groundOctave(place, 0.083333f, 3.0f, sine, texel_rad);
  return vec2(patches, grains);
}

// Albedo: soil and stubble, of 0.2 on average.
FN vec3 groundAlbedo(vec2 pattern) {
  vec3 soil = vec3(0.285f, 0.240f, 0.190f);
  vec3 stubble = vec3(0.150f, 0.150f, 0.095f);
  return mix(soil, stubble, smoothstep(-0.22f, 0.22f, pattern.x)) * (1.0f + 1.1f * pattern.y);
}

// The radiance of the ground along d (d.y < 0).
//   sun              direction towards it
//   sun_irradiance   of a level surface, by the sun; sky_irradiance by the rest of the sky
//   horizon          the sky's radiance above the horizon there, into which the air fades what is far away
// In the sun, rough and dark ground is brighter the lower the sun and the eye are, since both then meet its upright
// sides: by the law of Lommel and Seeliger as 1 / (μ₀ + μ), their sines (Hapke 2012, "Theory of Reflectance and
// Emittance Spectroscopy", 8.4). With the sun behind the eye its lit sides are seen: half as bright again, and as much
// less against the sun. What stands at the centre keeps the sky from the ground under it.
FN vec3 groundRadiance(vec3 d, vec3 sun, vec3 sun_irradiance, vec3 sky_irradiance, vec3 horizon, float texel_rad) {
  vec2 place = groundPlace(d);
  vec3 albedo = groundAlbedo(groundPattern(place, -d.y, texel_rad));
  float sunlit = (1.0f - 0.5f * (d.x * sun.x + d.z * sun.z)) / max(sun.y - d.y, 0.1f);
  float under_sky = 1.0f - 0.6f * exp(-1.2f * dot(place, place));
  vec3 ground = albedo * (sun_irradiance * sunlit + sky_irradiance * under_sky) / kPi;
  float air = exp(-length(place) / 2000.0f) * smoothstep(0.0f, 3.0f * texel_rad, -d.y);
  return mix(horizon, ground, air);
}
