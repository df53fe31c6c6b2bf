// Where the mip levels of a cube are read, to take a mean under a lobe with few reads. A trilinear read is a blurred
// mean itself. Halving with the weights 1 3 3 1 (shaders/prefilter_halve.frag) adds ¾ of the finer texel's width
// squared to the variance on each axis, so texels of width t made from ones of width t₀ have
// Σ ¾ t₀² 4^k = (t² − t₀²) / 4; linear interpolation adds t² / 6 on average. A read thus blurs as much as texels of a
// certain width, its footprint, do.

// The mip level for a footprint in a direction (unit). Texels are narrower away from a face's middle: their solid angle
// goes with the cube of the direction's longest component. Between two levels it is the variance that the hardware
// mixes linearly, not its logarithm.
//
// log_texels   log₂ of the footprint in texels of level 0 in the middle of a face
FN float lodOfFootprint(float log_texels, vec3 direction) {
  float longest = max(abs(direction.x), max(abs(direction.y), abs(direction.z)));
  float lod = log_texels - 1.5f * log2(longest);
  float whole = floor(lod);
  return max(whole + (exp2(2.0f * (lod - whole)) - 1.0f) / 3.0f, 0.0f);
}

// The direction of a tap (x, y) in the frame of tangent, bitangent and normal; taps lie on the side of the normal.
FN vec3 tapDirection(vec3 tangent, vec3 bitangent, vec3 normal, vec2 tap) {
  return tap.x * tangent + tap.y * bitangent + sqrt(max(1.0f - tap.x * tap.x - tap.y * tap.y, 0.0f)) * normal;
}
