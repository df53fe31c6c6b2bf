// Part "transmission" (transmission_none.glsl). Here: a ray is followed through the bodies of the scene, which
// scene/bodies/body_tree.cpp has put into a texture. At each surface that it meets, light is reflected and refracted by
// Fresnel's equations. The stronger way is followed if it meets a surface again, else the weaker one if that does. The
// other takes the light that arrives along its direction, so that none is lost; so does all that is left after
// `inner_bounces` surfaces.
// Compilers copy each function to where it is called: what is large is called in one place.
#include "entering_beam.glsl"
#include "lies_in_air.glsl"
#include "light_from_afar.glsl"
#include "media.glsl"
#include "octahedral.glsl"
#include "triangle_tree.glsl"

uniform usampler2D bodies;
uniform Media eye_media;  // the bodies that the eye is inside of

// A ray in a body, or between bodies.
struct InnerRay {
  vec3 origin;
  vec3 direction;
  vec3 throughput;
  Beam beam;
  int leaves;  // the triangle from which it comes; −1: not known
  Media media;
};

// Past this many surfaces that are not there for a ray, the next one is.
const int kMostPassed = 16;

// The index of what is inside of the bodies, for one kind of light.
float iorInside(Media media, int kind) {
  int filling = fillingBody(media);
  if (filling < 0) return 1.0;
  return iorOfKind(bodyAt(bodies, filling).index, kind);
}

// What the body that a ray is in leaves of light over a distance.
vec3 transmittanceOver(Media media, float distance) {
  int filling = fillingBody(media);
  if (filling < 0) return vec3(1.0);
  Body body = bodyAt(bodies, filling);
  return bodyTransmittance(body.attenuation_color, body.attenuation_distance, distance);
}

// The first surface that is there for a ray, whose throughput and media are then those before it.
TriangleHit firstSurface(inout InnerRay ray) {
  float nearest = 0.0;
  float absorbed_to = 0.0;
  TriangleHit hit;
  for (int passed = 0; passed <= kMostPassed; ++passed) {
    // Inside of a body there is a surface ahead: who finds none has slipped through between two triangles.
    for (int attempt = 0; attempt < 2; ++attempt) {
      hit = nearestTriangle(bodies, ray.origin, ray.direction, nearest, ray.leaves,
                            attempt == 0 ? kNarrowMargin : kWideMargin);
      if (hit.triangle >= 0 || !isWithinBody(ray.media)) break;
    }
    if (hit.triangle < 0) return hit;
    ray.throughput *= transmittanceOver(ray.media, hit.distance - absorbed_to);
    absorbed_to = hit.distance;
    BodySurface surface = bodySurfaceAt(bodies, hit);
    bool is_entering = dot(ray.direction, surface.geometric_normal) < 0.0;
    int priority = bodyAt(bodies, surface.body).priority;
    if (passed == kMostPassed || hasSurface(ray.media, surface.body, priority, is_entering)) return hit;
    if (is_entering)
      ray.media = entered(ray.media, surface.body, priority);
    else
      ray.media = left(ray.media, surface.body);
    nearest = hit.distance * (1.0 + 1e-6);
  }
  return hit;
}

// A way on from a surface. It may go out where the other one is expected: smooth normals do so over flat triangles.
InnerRay wayOn(InnerRay arriving, TriangleHit hit, BodySurface surface, vec3 direction, vec3 throughput, Beam beam,
               Media beyond) {
  bool is_entering = dot(arriving.direction, surface.geometric_normal) < 0.0;
  bool crosses = (dot(direction, surface.geometric_normal) < 0.0) == is_entering;
  InnerRay way;
  way.origin = besideSurface(arriving.origin + hit.distance * arriving.direction, hit.distance,
                             crosses != is_entering ? surface.geometric_normal : -surface.geometric_normal);
  way.direction = direction;
  way.throughput = throughput;
  way.beam = beam;
  way.leaves = hit.triangle;
  way.media = arriving.media;
  if (crosses) way.media = beyond;
  return way;
}

// The two ways on from a surface.
//
// ray   becomes the stronger one
// other becomes the weaker one
void passSurface(inout InnerRay ray, TriangleHit hit, int kind, out InnerRay other) {
  BodySurface surface = bodySurfaceAt(bodies, hit);
  Body body = bodyAt(bodies, surface.body);
  bool is_entering = dot(ray.direction, surface.geometric_normal) < 0.0;
  Media beyond = ray.media;
  if (is_entering)
    beyond = entered(beyond, surface.body, body.priority);
  else
    beyond = left(beyond, surface.body);
  float eta = iorInside(beyond, kind) / iorInside(ray.media, kind);
  vec3 normal = facingNormal(is_entering ? surface.normal : -surface.normal, ray.direction);
  float cosine = min(-dot(ray.direction, normal), 1.0);
  float fresnel = fresnelDielectric(cosine, eta);
  float reflects = fresnel < 1.0 ? body.specular * fresnel : 1.0;
  float alpha = alphaFromPerceptualRoughness(body.perceptual_roughness);
  Beam arriving = beamAfter(ray.beam, hit.distance);
  float curvature = is_entering ? -surface.curvature : surface.curvature;
  InnerRay reflected = wayOn(ray, hit, surface, reflect(ray.direction, normal), ray.throughput * reflects,
                             beamBeyond(arriving, reflectionOfBeam(alpha, cosine, curvature)), beyond);
  InnerRay refracted = wayOn(ray, hit, surface, refractedDirection(ray.direction, normal, eta),
                             ray.throughput * body.base_color * (1.0 - reflects),
                             beamBeyond(arriving, refractionOfBeam(alpha, cosine, eta, curvature)), beyond);
  bool is_reflected = reflects > 0.5;
  other = reflected;
  ray = refracted;
  if (is_reflected) {
    other = refracted;
    ray = reflected;
  }
}

// The light that a ray of one kind of light brings from the bodies which it is in.
vec3 lightFromInside(InnerRay ray, int kind) {
  vec3 light = vec3(0.0);
  InnerRay other = ray;  // the weaker way from the last surface
  other.throughput = vec3(0.0);
  for (int surfaces = 0;;) {
    TriangleHit hit = TriangleHit(kBeyondAll, -1, vec2(0.0));
    if (surfaces < inner_bounces) hit = firstSurface(ray);
    bool goes_on = hit.triangle >= 0;
    InnerRay ended = ray;
    if (goes_on) ended = other;
    // Something else may be in the way to that surface, where it leads from one body to another; then in that of the
    // ray which has ended.
    for (int look = 0; look < 2; ++look) {
      bool is_between = look == 0;
      bool is_needed = is_between ? goes_on && fillingBody(ray.media) < 0 : ended.throughput != vec3(0.0);
      if (!is_needed) continue;
      vec3 origin = is_between ? ray.origin : ended.origin;
      vec3 direction = is_between ? ray.direction : ended.direction;
      vec3 throughput = is_between ? ray.throughput : ended.throughput;
      float roughness = is_between ? roughnessOfBeam(ray.beam) : roughnessOfBeam(ended.beam);
      float way = is_between ? hit.distance : kEndless;
      vec3 met;
      bool is_met = meetsSurface(origin, direction, roughness, false, way, met);
      if (is_between) {
        if (!is_met) continue;
        ended.throughput = vec3(0.0);
        goes_on = false;
      } else if (!is_met) {
        met = lightFromAfar(origin, direction, roughness, footprintOfBeam(ended.beam));
      }
      light += throughput * met;
    }
    if (goes_on) {
      passSurface(ray, hit, kind, other);
      ++surfaces;
      continue;
    }
    ray = other;
    other.throughput = vec3(0.0);
    if (ray.throughput == vec3(0.0)) break;
  }
  return light;
}

// The ray from an eye that is inside of bodies: what is drawn there only tells the direction.
InnerRay rayOfEye(SurfacePoint point) {
  InnerRay ray;
  ray.origin = camera_position;
  ray.direction = point.ray;
  ray.throughput = vec3(1.0);
  float angle = sqrt(sampleFootprint(dFdx(point.ray), dFdy(point.ray), samples_per_pixel));
  ray.beam = Beam(vec3(0.0), vec2(angle, 0.0));
  ray.leaves = -1;
  ray.media = eye_media;
  return ray;
}

// The ray into the surface that is drawn.
InnerRay enteringRay(Surface s, SurfacePoint point, int kind) {
  float eta = iorOfKind(refractiveIndexOf(s.material), kind);
  InnerRay ray;
  // A place that the rasteriser interpolates is as exact as the corners around it, however far away the eye is.
  vec3 size = floatsOf(fetchWords(bodies, 2));
  ray.origin = besideSurface(point.position, max(max(size.x, size.y), size.z), -s.normal);
  ray.direction = refractedDirection(point.ray, s.normal, eta);
  ray.throughput = vec3(1.0);
  ray.beam = enteringBeam(s, point, ray.direction, eta);
  ray.leaves = -1;
  ray.media = noMedia();
  if (seesFront()) ray.media = entered(ray.media, instance, bodyAt(bodies, instance).priority);
  return ray;
}

vec3 transmittedLight(Surface s, SurfacePoint point) {
  bool disperses = fetchWords(bodies, 0).w != 0u;
  bool is_eye_inside = isWithinBody(eye_media);
  vec3 light = vec3(0.0);
  for (int kind = 0; kind < lightKinds(disperses); ++kind) {
    InnerRay ray;
    if (is_eye_inside)
      ray = rayOfEye(point);
    else
      ray = enteringRay(s, point, kind);
    light += shareOfKind(kind, disperses) * lightFromInside(ray, kind);
  }
  return light;
}
