// Part "sky" (sky_open.glsl). Here: as in sky_occluded.glsl, and what a surface reflects of the scene is found by a
// ray into its lobe, and lit by the environment as it is drawn.
#include "brdf_look_up.glsl"
#include "ggx.glsl"
#include "grid_random.glsl"
#include "octahedral.glsl"
#include "triangle_tree.glsl"
#include "scene_surface.glsl"
#include "occluded_light.glsl"
#include "sampling.glsl"

in vec4 vertex_occluded;
in vec3 vertex_interreflected;
in vec3 vertex_lit_from;
in vec3 vertex_emitted;

uniform highp usampler2D scene_triangles;
uniform int unseen_by_itself;  // a child of the tree that the surface sees nothing of, from its outside

// The light of what a ray meets.
//   direction   of the ray
vec3 lightOfScene(vec3 place, vec3 direction, SceneSurface met) {
  Surface s;
  s.material = coreMaterial(material, met.base_color, met.metallic, met.perceptual_roughness, met.emission);
  s.own_roughness = met.perceptual_roughness;
  bool sees_front = dot(direction, met.geometric_normal) < 0.0;
  s.normal = facingNormal(sees_front ? met.normal : -met.normal, direction);
  s.tangent = anyTangent(s.normal);
  s.occlusion = 1.0;
  s.environment_brdf =
      environmentBrdf(brdf_table, met.perceptual_roughness, clamp(-dot(direction, s.normal), 0.0, 1.0));
  s.stretched_share = 1.0;
  s.sheen_albedo = 0.0;
  s = seenAlong(s, direction);
  SunsSeen suns = sunsSeen(place, s.normal);
  OccludedLight light =
      occludedLight(place, s.normal, PlaceInScene(met.occluded, met.interreflected, met.lit_from, met.emitted), suns);
  vec3 mirrored = reflect(direction, s.normal);
  vec3 reflected = occludedReflection(light, s, mirrored,
                                      incomingLight(place, mirrored, met.perceptual_roughness, 0.0));
  return shadedOccluded(light, s, reflected, vec3(0.0), vec3(0.0)) + litBySuns(s, direction, suns, 0.0);
}

// A direction that facets of the surface reflect towards the eye, another one for each sample of a pixel.
vec3 sampledReflection(Surface s, SurfacePoint point) {
  vec2 random = evenPoint(gridRandom(ivec3(ivec2(gl_FragCoord.xy), 0)).xy, floor(sample_phase * samples_per_pixel));
  vec2 alpha = stretchedAlpha(s.material.perceptual_roughness, s.material.anisotropy);
  vec3 facet = sampleVisibleNormal(alpha, eyeInFrame(s, point.ray), random);
  return reflect(point.ray, facet.x * s.tangent + facet.y * cross(s.normal, s.tangent) + facet.z * s.normal);
}

// Past this many triangles that let it through, a ray meets the next one.
const int kMostTrianglesPassed = 8;

// What the ray from the surface meets of the scene in a direction.
//   across   along the flat triangle's normal, of any length
//   found    becomes that light; stays as it is where nothing is met
void reflectScene(SurfacePoint point, vec3 across, vec3 direction, inout vec3 found) {
  vec3 up = normalize(dot(across, point.ray) > 0.0 ? -across : across);
  // What a smooth normal reflects below its flat triangle, no ray from there meets.
  direction -= 2.0 * min(dot(direction, up), 0.0) * up;
  vec3 size = floatsOf(fetchWords(scene_triangles, 2));
  vec3 origin = besideSurface(point.position, max(max(size.x, size.y), size.z), up);
  TriangleHit hit;
  float nearest = 0.0;
  for (int passed = 0; passed <= kMostTrianglesPassed; ++passed) {
    hit = nearestTriangleBeside(scene_triangles, origin, direction, nearest, -1, seesFront() ? unseen_by_itself : 0,
                                kNarrowMargin);
    if (hit.triangle < 0 || !passesTriangle(scene_triangles, hit, direction)) break;
    nearest = hit.distance * (1.0 + 1e-6);
  }
  if (hit.triangle >= 0)
    found = lightOfScene(origin + hit.distance * direction, direction, sceneSurfaceAt(scene_triangles, hit, direction));
}

// From so many samples on, the rays of rough surfaces make no speckles.
const float kSamplesOfRough = 16.0;

// How much the rays count beside what the vertices know.
float shareOfRays(Surface s) {
  if (samples_per_pixel >= kSamplesOfRough) return 1.0;
  return 1.0 - smoothstep(0.15, 0.3, s.material.perceptual_roughness);
}

float largestComponent(vec3 v) { return max(max(abs(v.x), abs(v.y)), abs(v.z)); }

// Along the normal of the flat triangle below the pixel; 0 where that is seen as a line. Squares of a pixel's area in a
// model of 1e-9 or 1e12 are no floats, so the edges are brought to about 1 first, by a power of two.
vec3 acrossTriangle(vec3 position) {
  vec3 along_x = dFdx(position);
  vec3 along_y = dFdy(position);
  float size = max(largestComponent(along_x), largestComponent(along_y));
  if (size == 0.0) return vec3(0.0);
  float scale = exp2(-floor(log2(size)));
  return cross(scale * along_x, scale * along_y);
}

vec3 litByEnvironment(Surface s, SurfacePoint point, vec3 transmitted, vec3 on_cloth) {
  vec3 across = acrossTriangle(point.position);
  OccludedLight light = lightAtPoint(
      s, point, PlaceInScene(vertex_occluded, vertex_interreflected, vertex_lit_from, vertex_emitted));
  vec3 of_environment = reflectedLight(s, point);
  vec3 found = of_environment;
  float share = dot(across, across) > 0.0 ? shareOfRays(s) : 0.0;
  if (share > 0.0) reflectScene(point, across, sampledReflection(s, point), found);
  vec3 reflected = occludedReflection(light, s, reflect(point.ray, s.normal), of_environment);
  return shadedOccluded(light, s, mix(reflected, found, share), transmitted, on_cloth);
}
