// Part "behind" (behind_light.glsl). Here: the surfaces that are in the picture, which have been drawn before; where
// the ray meets none there, the arriving light. So it is only right where the picture shows what the ray meets.
//
// The ray is followed in the picture (McGuire & Mara 2014, "Efficient GPU screen-space ray tracing"), in even steps of
// a share s of it; where it has an end, place = mix(origin, end, s), and where it has none, its distance is
// screen_unit · s / (1 − s). Times 1 − s, that is linear in s, too, and so is what the camera makes of it. Rough glass
// reads a coarser mip level, as wide as its lobe is there (Filament and three.js do so for KHR_materials_transmission).
#include "box.glsl"

uniform highp sampler2D opaque_picture;  // light, and how near the surface is to the eye, in 1 / screen_unit; 0: none

const float kScreenSteps = 32.0;  // of a ray without an end
const float kStepsInside = 6.0;   // of one with an end
const int kScreenRefinements = 5;
// What is farther behind the surface than these shares of the distance, passes behind its edge: of a ray without an
// end, and of one with an end, beside some of its last steps: the picture holds half floats.
const float kMet = 0.05;
const float kMetInside = 3e-3;

struct ScreenRay {
  vec4 shown_from;   // clip space's coordinates of s = 0 and s = 1
  vec4 shown_to;
  vec4 from_camera;  // places as seen from it, in units of screen_unit, and what they are multiplied by
  vec4 to;
};

// For the share of a ray without an end that lies within a distance.
float shareOfWay(float way) { return way / (screen_unit + way); }

// A ray without an end, or with one after a way.
ScreenRay screenRay(vec3 origin, vec3 d, bool has_end, float way) {
  vec3 end = origin + way * d;
  return ScreenRay(clip_from_world * vec4(origin, 1.0),
                   clip_from_world * (has_end ? vec4(end, 1.0) : vec4(screen_unit * d, 0.0)),
                   vec4((origin - camera_position) / screen_unit, 1.0),
                   has_end ? vec4((end - camera_position) / screen_unit, 1.0) : vec4(d, 0.0));
}

// Where the picture shows a place of the ray, from (0, 0) to (1, 1); beside it, outside of these.
vec2 shownPlace(ScreenRay ray, float share) {
  vec4 seen = mix(ray.shown_from, ray.shown_to, share);
  return seen.w > 0.0 ? 0.5 + 0.5 * seen.xy / seen.w : vec2(-1.0);
}

// How much farther away a place of the ray is than what the picture shows there, as a share of that; −1 where it shows
// nothing.
float behindShown(ScreenRay ray, float share, vec2 shown) {
  vec2 size = vec2(textureSize(opaque_picture, 0));
  float nearness = texelFetch(opaque_picture, ivec2(min(shown * size, size - 1.0)), 0).w;
  vec4 place = mix(ray.from_camera, ray.to, share);
  return length(place.xyz) * nearness / place.w - 1.0;
}

// The share of the ray at which it meets a surface of the picture.
//
// first, last  where on the ray there may be one
// most         behindShown of it
// returns      −1: there is none
float shareMet(ScreenRay ray, float first, float last, float stride, float most) {
  float before = first;
  bool was_before = false;
  for (float next = first; before < last; next += stride) {
    float behind = min(next, last);
    vec2 shown = shownPlace(ray, behind);
    if (min(shown.x, shown.y) < 0.0 || max(shown.x, shown.y) >= 1.0) break;
    bool is_behind = behindShown(ray, behind, shown) >= 0.0;
    if (is_behind && was_before) {
      float low = before;
      float high = behind;
      for (int i = 0; i < kScreenRefinements; ++i) {
        float middle = 0.5 * (low + high);
        if (behindShown(ray, middle, shownPlace(ray, middle)) >= 0.0)
          high = middle;
        else
          low = middle;
      }
      if (behindShown(ray, high, shownPlace(ray, high)) < most) return high;
    }
    was_before = !is_behind;
    before = behind;
    if (next >= last) break;
  }
  return -1.0;
}

// The mip level whose texels are as wide as a lobe at the end of a way.
float screenLevel(float perceptual_roughness, float way, vec3 place) {
  float depth = (clip_from_world * vec4(place, 1.0)).w;
  vec3 upwards = vec3(clip_from_world[0].y, clip_from_world[1].y, clip_from_world[2].y);
  float texels_per_length = 0.5 * length(upwards) * float(textureSize(opaque_picture, 0).y) / depth;
  float width = alphaFromPerceptualRoughness(perceptual_roughness) * way * texels_per_length;
  return max(log2(max(width, 1.0)), 0.0);
}

vec3 lightMet(ScreenRay ray, float share, vec3 origin, vec3 d, float way, float perceptual_roughness) {
  return textureLod(opaque_picture, shownPlace(ray, share), screenLevel(perceptual_roughness, way, origin + way * d))
      .xyz;
}

bool meetsSurface(vec3 origin, vec3 d, float perceptual_roughness, bool is_inside, inout float way, out vec3 light) {
  light = vec3(0.0);
  // Nothing is met beside the box around all that is shown.
  vec2 ways = wayThroughBox(shown_low, shown_high, origin, d);
  float first = max(ways.x, 0.0);
  float last = min(ways.y, way);
  if (last <= first) return false;
  ScreenRay ray = screenRay(origin, d, is_inside, way);
  float last_step = way / (kStepsInside * exp2(float(kScreenRefinements)));
  float most = is_inside ? kMetInside + 4.0 * last_step / distance(origin, camera_position) : kMet;
  float share = shareMet(ray, is_inside ? 0.0 : shareOfWay(first), is_inside ? 1.0 : shareOfWay(last),
                         1.0 / (is_inside ? kStepsInside : kScreenSteps), most);
  if (share < 0.0) return false;
  way = is_inside ? way * share : screen_unit * share / (1.0 - share);
  light = lightMet(ray, share, origin, d, way, perceptual_roughness);
  return true;
}
