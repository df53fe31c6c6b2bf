// Where a ray that enters a relief from above meets its surface, by searches that may miss some of it: from the cheap
// guess to many steps. All return the depth that the ray has reached: 0 at the top, 1 at the bottom.
// Needs: height_map.

struct ReliefRay {
  vec2 from;  // where it enters, in texels
  vec2 run;   // texels that it passes until the bottom
};

FN float depthAt(MAP_SAMPLER heights, HeightMap map, ReliefRay ray, float depth) {
  return 1.0f - heightAt(heights, map, ray.from + depth * ray.run);
}

// Parallax mapping: as if the whole surface were as deep as it is below the place of entry (Kaneko et al. 2001). The
// offset is limited: without the factor `cosine` the texture swims at grazing angles (Welsh 2004).
//   cosine   of the ray to the normal
FN float parallaxDepth(MAP_SAMPLER heights, HeightMap map, ReliefRay ray, float cosine) {
  return cosine * depthAt(heights, map, ray, 0.0f);
}

// A piece of a ray that begins above the surface and ends below it, and how far above and below.
struct ReliefBracket {
  float above;
  float below;
  float height_above;
  float depth_below;
};

// The first of equal steps that is below the surface.
FN ReliefBracket firstStepBelow(MAP_SAMPLER heights, HeightMap map, ReliefRay ray, int steps) {
  ReliefBracket b = MAKE(ReliefBracket)(0.0f, 0.0f, depthAt(heights, map, ray, 0.0f), 0.0f);
  for (int i = 1; i <= steps; ++i) {
    float depth = float(i) / float(steps);
    float clearance = depthAt(heights, map, ray, depth) - depth;
    if (clearance <= 0.0f) return MAKE(ReliefBracket)(b.above, depth, b.height_above, -clearance);
    b.above = depth;
    b.height_above = clearance;
  }
  return MAKE(ReliefBracket)(b.above, 1.0f, b.height_above, 0.0f);
}

// Steep parallax mapping: the step itself (McGuire & McGuire 2005).
FN float steepDepth(MAP_SAMPLER heights, HeightMap map, ReliefRay ray, int steps) {
  return firstStepBelow(heights, map, ray, steps).below;
}

// Parallax occlusion mapping: where a straight surface between the two last steps would be met (Tatarchuk 2006).
FN float occlusionDepth(MAP_SAMPLER heights, HeightMap map, ReliefRay ray, int steps) {
  ReliefBracket b = firstStepBelow(heights, map, ray, steps);
  return mix(b.above, b.below, b.height_above / max(b.height_above + b.depth_below, 1e-6f));
}

const int kBinarySteps = 8;

// Relief mapping: the last step is halved again and again (Policarpo, Oliveira & Comba 2005).
FN float binaryDepth(MAP_SAMPLER heights, HeightMap map, ReliefRay ray, int steps) {
  ReliefBracket b = firstStepBelow(heights, map, ray, steps);
  for (int i = 0; i < kBinarySteps; ++i) {
    float middle = 0.5f * (b.above + b.below);
    bool is_above = depthAt(heights, map, ray, middle) > middle;
    b.above = is_above ? middle : b.above;
    b.below = is_above ? b.below : middle;
  }
  return 0.5f * (b.above + b.below);
}

// What stands on the surface at a place: its height, and a cone that is as narrow as the narrowest of the four texels
// around it. The cones are those of texels; the nearest one's, moved to the place, is cut by what rises beyond it.
//   returns   height and √ratio (heightTexel)
FN vec2 heightAndCone(MAP_SAMPLER heights, HeightMap map, vec2 place) {
  vec2 first = floor(place);
  vec2 near = heightTexel(heights, map, first);
  vec2 right = heightTexel(heights, map, first + vec2(1.0f, 0.0f));
  vec2 below = heightTexel(heights, map, first + vec2(0.0f, 1.0f));
  vec2 far = heightTexel(heights, map, first + vec2(1.0f, 1.0f));
  return vec2(heightOfPatch(vec4(near.x, right.x, below.x, far.x), place - first),
              min(min(near.y, right.y), min(below.y, far.y)));
}

// Cone stepping: each step goes as far as the empty cone above the surface allows (Dummer 2006).
//   steps   the most
FN float coneDepth(MAP_SAMPLER heights, HeightMap map, ReliefRay ray, int steps) {
  // Cones are stored as the root of radius over height, with the radius in map widths.
  float run = length(ray.run) / map.size.x;
  float depth = 0.0f;
  for (int i = 0; i < steps; ++i) {
    vec2 tip = heightAndCone(heights, map, ray.from + depth * ray.run);
    float clearance = 1.0f - tip.x - depth;
    if (clearance <= 1e-4f) break;
    float ratio = tip.y * tip.y;
    // After a step of d the ray is (clearance − d) above the cone's tip and run · d beside it.
    depth += clearance * max(ratio / max(run + ratio, 1e-20f), 1e-3f);
  }
  return min(depth, 1.0f);
}
