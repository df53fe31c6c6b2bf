// Part "transmission" (transmission_none.glsl). Here: the ray that the drawn front face refracts leaves by a back face,
// which is looked for in a picture of them (back_face.glsl). What that face reflects takes the light from far away
// along its direction, so that none is lost.
#include "back_face.glsl"
#include "entering_beam.glsl"
#include "light_from_afar.glsl"
#include "octahedral.glsl"

uniform sampler2D back_faces;

float iorAround() { return iorAroundVertices(); }

const int kSearchSteps = 14;
const int kNewtonSearchSteps = 5;  // then steps that do not become shorter halve what is left
const float kNearEnough = 2e-3;  // of the way; the last step brings it nearer by far

// Where the picture of back faces shows a place, in texels; beside it on its border. What is behind the eye is nowhere.
vec2 shownAt(vec3 place) {
  vec4 seen = back_faces_from_world * vec4(place, 1.0);
  return seen.w > 0.0 ? clamp(seen.xy / seen.w, vec2(0.0), vec2(textureSize(back_faces, 0))) : vec2(-1.0);
}

// The back face in the texel that a position in the picture lies in.
//
// returns  whether there is one
bool backFaceAt(vec2 position, out BackFace face) {
  face = BackFace(vec3(0.0), vec3(0.0), 0.0);
  if (position.x < 0.0) return false;
  vec2 texel = min(floor(position), vec2(textureSize(back_faces, 0) - 1));
  vec4 found = texelFetch(back_faces, ivec2(texel), 0);
  if (found.z >= kNoBackFace) return false;
  vec4 far = eye_from_back_faces * vec4(texel + 0.5, 1.0, 1.0);
  vec3 from_eye = far.xyz / far.w;
  float depth = dot(from_eye, camera_forward);
  from_eye = orthographic > 0.5 ? from_eye + (found.z - depth) * camera_forward : from_eye * (found.z / depth);
  face = BackFace(camera_position + from_eye, octahedralDirection(found.xy), found.w);
  return true;
}

// Where a ray leaves the body: Newton's method, kept between a place that is inside and one that is outside.
//
// face     becomes the back face there. Where the ray leaves by a face that is not in the picture, it is the last that
//          is behind the ray; if there is none, its normal is the ray's direction
// returns  the distance
float wayOut(vec3 origin, vec3 direction, out BackFace face) {
  float stride = 4.0 * length(dFdx(origin));
  face = BackFace(origin, direction, 0.0);
  float inside = 0.0;
  float outside = kNoBackFace;
  float at = 0.0;
  float step_before = 0.0;
  for (int i = 0; i < kSearchSteps; ++i) {
    BackFace seen;
    bool is_seen = backFaceAt(shownAt(origin + at * direction), seen);
    // How far to go where no face is in front: as far as the body is thick along the eye's ray, or some pixels.
    if (i == 0 && is_seen) stride = max(stride, distance(seen.place, origin));
    bool is_out = !is_seen || dot(origin + at * direction - seen.place, seen.normal) > 0.0;
    float next = is_seen ? wayToBackFace(seen, origin, direction) : kNoBackFace;
    if (is_out) {
      outside = min(at, outside);
    } else {
      inside = max(at, inside);
      if (next < kNoBackFace) face = seen;
    }
    if (abs(next - at) <= kNearEnough * at) {
      face = seen;
      return next;
    }
    // Where the picture jumps from one face to another, Newton's steps go to and fro (Brent 1973, "Algorithms for
    // minimization without derivatives", ch. 4).
    bool halves = outside < kNoBackFace && i >= kNewtonSearchSteps && abs(next - at) > 0.5 * step_before;
    if (halves || next < inside || next > outside || next == kNoBackFace) {
      next = outside < kNoBackFace ? 0.5 * (inside + outside) : at + stride;
      stride *= 2.0;
    }
    step_before = abs(next - at);
    at = next;
  }
  return inside;
}

// The normal of a back face at a place, between those of the texels around it that are of the same smooth surface: a
// texel's one curvature leaves out that a surface may bend more one way than the other.
vec3 normalAt(BackFace face, vec3 place) {
  const float kSame = 0.999;  // 2.6°: less than any edge that is meant to be one
  vec3 normal = normalBesideBackFace(face, place);
  vec2 middle = shownAt(place) - 0.5;
  vec2 share = fract(middle);
  vec3 sum = vec3(0.0);
  // A number of corners that the compiler knew would be four copies of what follows, a tenth of the program.
  int corners = textureSize(back_faces, 0).x > 0 ? 4 : 0;
  for (int corner = 0; corner < corners; ++corner) {
    vec2 step = vec2(corner & 1, corner >> 1);
    BackFace other;
    if (!backFaceAt(floor(middle) + step, other)) continue;
    vec3 found = normalBesideBackFace(other, place);
    vec2 weights = mix(1.0 - share, share, step);
    if (dot(found, normal) > kSame) sum += weights.x * weights.y * found;
  }
  return sum == vec3(0.0) ? normal : normalize(sum);
}

vec3 lightThrough(Surface s, SurfacePoint point, float ior) {
  vec3 d = refractedDirection(point.ray, s.normal, ior);
  BackFace face;
  float way = wayOut(point.position, d, face);
  vec3 place = point.position + way * d;
  vec3 normal = facingNormal(-normalAt(face, place), d);
  float cosine = min(-dot(d, normal), 1.0);
  float eta = 1.0 / ior;
  float fresnel = fresnelDielectric(cosine, eta);
  float reflects = fresnel < 1.0 ? s.material.specular * fresnel : 1.0;
  float alpha = alphaFromPerceptualRoughness(s.material.perceptual_roughness);
  Beam arriving = beamAfter(enteringBeam(s, point, d, ior), way);
  vec3 light = vec3(0.0);
  // What the ray meets inside; else what it does when it leaves, and what the back face reflects of it, which is still
  // inside: it is taken to leave there as it goes.
  for (int look = 0; look < 3; ++look) {
    bool is_inside = look == 0;
    bool is_reflected = look == 2;
    vec3 share = is_inside ? vec3(1.0) : (is_reflected ? vec3(reflects) : s.material.base_color * (1.0 - reflects));
    if (share == vec3(0.0)) continue;
    vec3 from = is_inside ? point.position : place;
    vec3 to = is_inside ? d : (is_reflected ? reflect(d, normal) : refractedDirection(d, normal, eta));
    Beam beam = beamBeyond(arriving, is_reflected ? reflectionOfBeam(alpha, cosine, face.curvature)
                                                  : refractionOfBeam(alpha, cosine, eta, face.curvature));
    float roughness = is_inside ? s.material.perceptual_roughness : roughnessOfBeam(beam);
    float way_to_surface = is_inside ? way : kEndless;
    vec3 found;
    bool is_met = meetsSurface(from, to, roughness, is_inside, way_to_surface, found);
    if (is_inside && !is_met) continue;
    if (!is_met) found = lightFromAfar(from, to, roughness, footprintOfBeam(beam));
    light += share * found;
    if (is_inside) {
      way = way_to_surface;
      break;
    }
  }
  return light * bodyTransmittance(s.material.attenuation_color, s.material.attenuation_distance, way);
}

#include "each_kind_of_light.glsl"
