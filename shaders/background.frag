// The environment behind everything; or of its ground the scene's shadow alone.
#include "color.glsl"
#include "filter_kind.glsl"
#include "constants.glsl"
#include "microfacet.glsl"
#include "reflection_lobe.glsl"
#include "sampling.glsl"
#include "eye_ray.glsl"
#include "part: proxy"
#include "sun_list.glsl"

uniform samplerCube environment;
uniform mat3 environment_from_world;
uniform float environment_intensity;
uniform float texels_per_radian;
uniform float samples_per_pixel;
uniform int texture_filter;    // of filter_kind.glsl
uniform float min_level;
uniform float lobe_roughness;  // blurs by the mip levels; 0: not
uniform int sun_count;         // of the suns, those that are shown
uniform float sun_roughness;   // blurs them
uniform bool is_shadow_alone;  // on a page, of which it takes as much away as of the ground's light
uniform vec4 page;             // its radiance and 1; or 0: black that covers as much of what it is laid over

out vec4 fragment;

void main() {
  vec3 d = eyeDirection();
  ProxySight sight = sightFrom(originOfEye(eyeOrigin(), d), d);
  // Of what is seen from pixel to pixel: of an eye outside of the proxy each ray begins elsewhere.
  float footprint = sampleFootprint(dFdx(sight.direction), dFdy(sight.direction), samples_per_pixel);
  float minified = readsMipLevels(texture_filter) ? footprintLod(footprint, texels_per_radian) : 0.0;
  vec3 seen = environment_from_world * sight.direction;
  float blurred = lobe_roughness > 0.0 ? lodOfLobe(lobe_roughness, texels_per_radian, seen) : min_level;
  vec3 light = sampleLod(environment, seen, max(blurred, minified)).xyz;
  vec3 shown = lightOfProxy(sight, light);
  vec3 suns = vec3(0.0);
  for (int i = 0; i < sun_count; ++i)
    if (!sight.is_ground) suns += sunInLobe(sunAt(i), sight.direction, sun_roughness, footprint);
  fragment = vec4(shown * environment_intensity + suns, 1.0);
  if (!is_shadow_alone) return;
  // Where the ground sends no light, none is missing.
  float lit = luminance(light);
  float missing = lit > 0.0 ? clamp(1.0 - luminance(shown) / lit, 0.0, 1.0) : 0.0;
  fragment = vec4(page.xyz * (1.0 - missing), max(page.w, missing));
}
