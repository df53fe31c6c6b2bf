// What a polished ground shows of the scene, laid over the background: the picture of the camera's mirror image, in the
// directions that the ground's facets mirror.
#include "box.glsl"
#include "constants.glsl"
#include "sampling.glsl"
#include "optics.glsl"
#include "ggx.glsl"
#include "eye_ray.glsl"
#include "proxy_block.glsl"
#include "proxy_shape.glsl"
#include "glossy_ground.glsl"

uniform mat4 picture_from_world;  // of the mirror image: texels and depth, 0 to 1
uniform highp sampler2D mirror_picture;
uniform highp sampler2D mirror_depths;
uniform vec3 scene_low;
uniform vec3 scene_high;
uniform float alpha;
uniform int taps;
uniform int first_tap;          // of the sample
uniform float taps_of_pixel;    // of all its samples
uniform float pixels_per_slope;  // of the picture, for a slope of 1 against the camera's axis, or a world unit

out vec4 fragment;

// With what is divided by.
vec4 texelOf(vec3 place) {
  vec4 texel = picture_from_world * vec4(place, 1.0);
  return vec4(texel.xyz / texel.w, texel.w);
}

void main() {
  vec3 d = eyeDirection();
  vec3 origin = eyeOrigin();
  ProxyHit ground = hitOfGround(captured_at, proxy_radius, proxy_ground, origin, d);
  fragment = vec4(0.0);
  if (!ground.is_ground) return;
  for (int i = 0; i < taps; ++i) {
    vec3 mirrored = mirroredByGround(d, alpha, evenPoint(vec2(0.5), float(first_tap + i)));
    float share = shareMirroredByGround(d, mirrored, alpha);
    vec2 way = wayThroughBox(scene_low, scene_high, ground.place, mirrored);
    way.x = max(way.x, 0.0);
    if (share <= 0.0 || way.x >= way.y) continue;
    vec4 from = texelOf(ground.place + way.x * mirrored);
    vec4 to = texelOf(ground.place + way.y * mirrored);
    // A ray that comes back towards the eye is followed until it is beside the picture's camera.
    float least = 1e-3 * abs(from.w);
    if (from.w <= 0.0) continue;
    if (to.w < least) {
      way.y = mix(way.x, way.y, (from.w - least) / (from.w - to.w));
      to = texelOf(ground.place + way.y * mirrored);
    }
    vec3 met = hitInMirrorPicture(mirror_depths, from.xyz, to.xyz);
    if (met.z < 0.0) continue;
    // What lies between the rays is seen by them through mip levels (Křivánek & Colbert 2008).
    float along = mix(way.x, way.y, met.z * from.w / mix(to.w, from.w, met.z));
    float size = along * sqrt(solidAngleMirroredByGround(d, mirrored, alpha, taps_of_pixel));
    float away = orthographic > 0.5 ? 1.0 : distance(origin, ground.place) + along;
    float level = log2(max(size / away * pixels_per_slope, 1.0));
    fragment += share * textureLod(mirror_picture, met.xy / vec2(textureSize(mirror_picture, 0)), level);
  }
  fragment /= float(taps);
}
