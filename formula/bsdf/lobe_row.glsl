// What a rough surface reflects at any angle: a row of a few of the round lobes that a prefiltered map holds
// (reflection_lobe.glsl), all in the plane of incidence.
//
// Facets of GGX turn the light by twice the angle that they are tilted by within the plane of incidence, but across it
// only by 2 n·v as much. Seen at an angle, the lobe is stretched towards the normal and the horizon, and masking draws
// it away from the mirror direction. A single round lobe, as from above, is too wide across. Narrower ones beside each
// other can be as long as it is and as narrow. Which ones, bake/lobe_row/ has fitted; docs/lobe_rows.md tells of it.
// Needs: microfacet.

// One of the row.
struct RoundLobe {
  vec3 direction;              // unit
  float perceptual_roughness;  // of the prefiltered level
  float weight;                // of what facets reflect at normal incidence; of the whole row nearly 1
  float grazing_weight;        // of what they reflect more at grazing angles, by Schlick's term; likewise
};

// The table of rows: `kLobeRowSize` columns a lobe, lobes beside each other, those of rows of 2, of 4 and of 6.
const int kLobeRowSize = 24;

// No lobe's roughness is less than this, times the surface's.
const float kNarrowestInRow = 0.33f;

// The first lobe of a row of 2, 4 or 6 in the table.
FN int firstOfRow(int lobes) { return (lobes / 2) * (lobes / 2 - 1); }

// The place of a lobe in the table [texels]: √(n·v) to the right, the roughness downwards, the first and the last of a
// lobe's texels being the ends of both axes.
FN vec2 placeInLobeRows(int lobe, float perceptual_roughness, float cosine) {
  float steps = float(kLobeRowSize - 1);
  return vec2(float(lobe * kLobeRowSize) + 0.5f + sqrt(cosine) * steps, 0.5f + perceptual_roughness * steps);
}

// What the table says of a lobe.
//   texel   how far it lies from the mirror direction towards the normal, in α times the normal's part across that
//           direction (so that it does not jump where they meet); its roughness over the surface's; its two weights
//   r       the mirror direction; n·r at least 0
FN RoundLobe lobeOfRow(vec4 texel, float perceptual_roughness, vec3 n, vec3 r) {
  float alpha = alphaFromPerceptualRoughness(perceptual_roughness);
  vec3 towards_normal = n - dot(n, r) * r;
  return MAKE(RoundLobe)(normalize(r + alpha * texel.x * towards_normal), min(perceptual_roughness * texel.y, 1.0f),
                         texel.z, texel.w);
}
