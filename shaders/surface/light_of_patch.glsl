// The light of a patch of directions of the environment, which a pixel sees. Where it is long, it may be read piece
// by piece (filter_kind.glsl).
#include "filter_kind.glsl"
#include "microfacet.glsl"

vec3 lookUpDirection(SurfacePoint point, vec3 n) {
  vec4 str = look_up_matrix * lookUpCoordinates(point, n);
  return normalize(str.xyz);
}

// The directions that a sample's cell of the pixel sees, about a direction.
struct Patch {
  vec3 middle;   // beside that direction
  vec3 across;   // from side to side
  vec3 up;
};

// Where a pixel's size chooses nothing, it is a point. Samples lie more evenly than the cells for which they stand, so
// that outlines have many steps; but the cells lie side by side, and between them nothing of the pixel is left out or
// seen twice.
//   across, up   how the direction changes to the next pixels
Patch patchOf(vec3 across, vec3 up) {
  if (!readsMipLevels(TEXTURE_FILTER)) return Patch(vec3(0.0), vec3(0.0), vec3(0.0));
  return Patch(pixel_cell.x * across + pixel_cell.y * up, pixel_cell.z * across, pixel_cell.w * up);
}

//   place   of its middle, (0, 0) being the patch's and (½, ½) a corner
//   size    over the patch's
Patch partOfPatch(Patch area, vec2 place, vec2 size) {
  return Patch(area.middle + place.x * area.across + place.y * area.up, size.x * area.across, size.y * area.up);
}

// [sr]
float footprintOfPatch(Patch area) { return sampleFootprint(area.across, area.up, 1.0); }

vec3 longerWay(Patch area) { return dot(area.across, area.across) > dot(area.up, area.up) ? area.across : area.up; }

// How many reads along its longer way cover it. One lobe covers about α [rad] by itself: what a patch as long as that
// adds to its variance is 3 % (of slopes whose median is α: roughnessOverPatch).
int readsOfPatch(Patch area, float perceptual_roughness) {
  float longer = length(longerWay(area));
  float shorter =
      max(footprintOfPatch(area) / max(longer, 1e-12), alphaFromPerceptualRoughness(perceptual_roughness));
  return readsAlong(longer * texels_per_radian, shorter * texels_per_radian);
}

vec3 lightOfPatch(SurfacePoint point, vec3 d, Patch area, float perceptual_roughness) {
  float footprint = footprintOfPatch(area);
  vec3 middle = d + area.middle;
  if (TEXTURE_FILTER != kFilterAnisotropic)
    return lightOfLobe(point.position, normalize(middle), perceptual_roughness, footprint);
  int reads = readsOfPatch(area, perceptual_roughness);
  vec3 along = longerWay(area);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < reads; ++i)
    sum += lightOfLobe(point.position, normalize(middle + placeOfRead(i, reads) * along), perceptual_roughness,
                       footprint / float(reads));
  return sum / float(reads);
}
