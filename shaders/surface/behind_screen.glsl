// Part "behind" (behind_light.glsl). Here: the opaque surfaces that are in the picture, which have been drawn before; what
// the ray does not meet there is the arriving light. So it is only right where the picture shows what the ray meets.
//
// The ray is followed in the picture (McGuire & Mara 2014, "Efficient GPU screen-space ray tracing", in even steps of
// the share s of t = reach · s / (1 − s)); rough glass reads a coarser mip level, as wide as its lobe is there
// (Filament and three.js do so for KHR_materials_transmission).

uniform highp sampler2D opaque_picture;  // light, and how near the surface is to the eye, in 1 / screen_unit; 0: none

const int kScreenSteps = 32;
const int kScreenRefinements = 5;

// Where the picture shows a place, from (0, 0) to (1, 1); beside it, outside of these.
vec2 shownPlace(vec3 place) {
  vec4 seen = clip_from_world * vec4(place, 1.0);
  return seen.w > 0.0 ? 0.5 + 0.5 * seen.xy / seen.w : vec2(-1.0);
}

// How much farther away a place is than what the picture shows there, as a share of that; −1 where it shows nothing.
float behindShown(vec3 place, vec2 shown) {
  vec2 size = vec2(textureSize(opaque_picture, 0));
  float nearness = texelFetch(opaque_picture, ivec2(min(shown * size, size - 1.0)), 0).w;
  return distance(place, camera_position) * nearness / screen_unit - 1.0;
}

float wayOfShare(float share) { return screen_unit * share / (1.0 - share); }

// The mip level whose texels are as wide as a lobe at the end of a way.
float screenLevel(float perceptual_roughness, float way, vec3 place) {
  float depth = (clip_from_world * vec4(place, 1.0)).w;
  vec3 upwards = vec3(clip_from_world[0].y, clip_from_world[1].y, clip_from_world[2].y);
  float texels_per_length = 0.5 * length(upwards) * float(textureSize(opaque_picture, 0).y) / depth;
  float width = alphaFromPerceptualRoughness(perceptual_roughness) * way * texels_per_length;
  return max(log2(max(width, 1.0)), 0.0);
}

vec3 lightBehind(vec3 origin, vec3 d, float perceptual_roughness, float footprint) {
  float before = 0.0;
  bool was_before = false;
  for (int i = 0; i < kScreenSteps; ++i) {
    float behind = (float(i) + 0.5) / float(kScreenSteps);
    vec3 place = origin + wayOfShare(behind) * d;
    vec2 shown = shownPlace(place);
    if (min(shown.x, shown.y) < 0.0 || max(shown.x, shown.y) >= 1.0) break;
    bool is_behind = behindShown(place, shown) >= 0.0;
    if (is_behind && was_before) {
      float low = before;
      for (int j = 0; j < kScreenRefinements; ++j) {
        float middle = 0.5 * (low + behind);
        place = origin + wayOfShare(middle) * d;
        if (behindShown(place, shownPlace(place)) >= 0.0)
          behind = middle;
        else
          low = middle;
      }
      float way = wayOfShare(behind);
      place = origin + way * d;
      shown = shownPlace(place);
      // Else it goes on behind the edge of something that is nearer.
      const float kThick = 0.05;
      if (behindShown(place, shown) < kThick)
        return textureLod(opaque_picture, shown, screenLevel(perceptual_roughness, way, place)).xyz;
      was_before = false;
      continue;
    }
    was_before = !is_behind;
    before = behind;
  }
  return incomingLight(origin, d, perceptual_roughness, footprint);
}
