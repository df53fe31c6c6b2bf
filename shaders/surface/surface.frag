// A surface lit by its environment. Each line "part: …" is a question; which file answers it, SurfaceVariant says
// (render/surface/surface_variant.h). What each part defines stands at the top of its files; docs/architecture.md tells
// how a part is added.
#include "frame_block.glsl"
#include "light_block.glsl"
#include "instance_block.glsl"
#include "material_block.glsl"

#include "color.glsl"
#include "constants.glsl"
#include "microfacet.glsl"
#include "optics.glsl"
#include "reflection_lobe.glsl"
#include "thin_film.glsl"
#include "part: film"
#include "shading.glsl"

#include "part: point"
#include "part: coordinates"
#include "part: maps"
#include "part: normal"
#include "part: detail"
#include "part: proxy"
#include "part: arriving light"
#include "part: suns"
#include "part: anisotropy"
#include "part: sheen"
#include "part: material"
#include "part: look-up"
#include "part: dispersion"
#include "part: behind"
#include "part: transmission"
#include "part: sky"
#include "part: lamps"
#include "part: coat"
#include "part: alpha"

out vec4 fragment;

void main() {
  SurfacePoint point = surfacePoint();
  vec4 color = colorAt(point);
  if (isCutAway(color.w)) discard;
  vec3 normal = detailedNormal(point, smoothNormal(point));
  normal = facingNormal(seesFront() ? normal : -normal, point.ray);
  Surface s = seenWithin(surfaceAt(point, normal, color.xyz), point.ray, iorAround());
  meetSuns(point);
  vec3 light = litByEnvironment(s, point, transmittedLight(s, point), lightOnCloth(s, point));
  setDepth(point);
  light += lightOfLamps(s, point) + reflectedSuns(s, point);
  fragment = shownAs(coated(s, point, light), color.w);
}
