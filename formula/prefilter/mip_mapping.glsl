// Which level of a prefiltered chain holds which perceptual roughness, `last` being the level of roughness 1.

// lod = M r (2 − r), as Filament has it: half of the levels for the sharpest quarter of the roughnesses, whose lobes
// differ most.
FN float lodOfRoughness(float perceptual_roughness, float last) {
  return last * perceptual_roughness * (2.0f - perceptual_roughness);
}

FN float roughnessOfLod(float lod, float last) { return 1.0f - sqrt(max(1.0f - lod / last, 0.0f)); }
