// The BRDF table of the split sum (Karis 2013), looked up by n·v and roughness. Needs: microfacet.

// How far to the right, 0 to 1, a table with warped axes holds n·v = cosine. What happens near grazing angles depends
// on n·v / alpha and happens at ever smaller angles the smoother the surface is: on linear axes it all falls into one
// corner, where rows of 0 and of small roughness do not meet. So half of each row is given to n·v / alpha from 0 to
// infinity, and the other half to √(n·v), which the bias (1 − n·v)⁵ bends least in.
FN float brdfTableColumn(float perceptual_roughness, float cosine) {
  float bend = 0.5f * alphaFromPerceptualRoughness(perceptual_roughness);
  float grazing = cosine * (1.0f + bend) / max(cosine + bend, 1e-30f);
  return 0.5f * (grazing + sqrt(cosine));
}

// Texture coordinates in a table of warped axes with `size` texels a side, whose first and last texel centres are
// the ends of both axes.
FN vec2 brdfTableCoordinates(float perceptual_roughness, float cosine, float size) {
  vec2 place = vec2(brdfTableColumn(perceptual_roughness, cosine), perceptual_roughness);
  return (place * (size - 1.0f) + 0.5f) / size;
}

// A texel of such a table, which is the left square of a map.
FN vec4 brdfTexel(MAP_SAMPLER table, float perceptual_roughness, float cosine) {
  ivec2 size = mapSize(table, 0);
  vec2 place = brdfTableCoordinates(perceptual_roughness, cosine, float(size.y));
  return sampleMap(table, vec2(place.x * float(size.y) / float(size.x), place.y));
}

// What it holds of facets: Surface::environment_brdf of shading.glsl.
FN vec3 environmentBrdf(MAP_SAMPLER table, float perceptual_roughness, float cosine) {
  vec4 texel = brdfTexel(table, perceptual_roughness, cosine);
  return vec3(texel.x, texel.y, texel.w);
}

// And in its third channel: the albedo of white cloth (formula/bsdf/charlie.glsl).
FN float sheenAlbedo(MAP_SAMPLER table, float sheen_roughness, float cosine) {
  return brdfTexel(table, sheen_roughness, cosine).z;
}
