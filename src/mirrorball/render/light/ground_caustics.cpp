#include "mirrorball/render/light/ground_caustics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "formula/bsdf.h"
#include "formula/color.h"
#include "formula/tangent.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/rays/path_vertex.h"
#include "mirrorball/rays/sample_sequence.h"
#include "mirrorball/rays/surface_finder.h"
#include "mirrorball/rays/surface_shares.h"
#include "mirrorball/render/light/count_smoothing.h"

namespace mirrorball {
namespace {

constexpr std::uint32_t kRays = 1u << 17;
constexpr int kMostSurfaces = 16;     // of a path
constexpr float kLeastAlpha = 1e-3f;  // of facets that are not taken as one plane

/// Where a ray brings light to the ground.
struct Landing {
  glm::vec2 place{0.0f};  // x and z in the world
  glm::vec3 share{0.0f};  // of the light that it began with
};

/// A ball around all bodies; its radius is 0 if there are none.
BoundingSphere aroundBodies(const Scene& scene, std::span<const Box> boxes) {
  Box box;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (isBody(materialOf(scene, i))) box.include(boxes[i]);
  if (box.isEmpty()) return {.radius = 0.0f};
  return {box.center(), glm::distance(box.low, box.high) / 2.0f};
}

class GlassFollower {
 public:
  GlassFollower(const Scene& scene, const Geometry& geometry, float ground)
      : scene_(scene), geometry_(geometry), ground_(ground), world_from_normal_(normalMatrices(scene)) {}

  /// Follows one ray of a light. Nothing: it meets no body, or is lost.
  std::optional<Landing> follow(Ray ray, SampleSequence& random) const {
    SurfaceFinder finder(scene_, geometry_, ReliefKind::bump, [&] { return random.nextIndependent(); });
    Landing landing{.share = glm::vec3(1.0f)};
    bool meets_body = false;
    for (int i = 0; i < kMostSurfaces; ++i) {
      const bool goes_down = ray.direction.y < 0.0f;
      const float to_ground = goes_down ? std::max((ground_ - ray.origin.y) / ray.direction.y, 0.0f) : INFINITY;
      const auto hit = finder.first(ray, to_ground, false, landing.share);
      if (!hit) {
        if (!goes_down || !meets_body) return std::nullopt;
        const glm::vec3 place = ray.origin + to_ground * ray.direction;
        landing.place = {place.x, place.z};
        return landing;
      }
      const PathVertex vertex = pathVertexAt(scene_, world_from_normal_, *hit, ray, ReliefKind::bump);
      meets_body = meets_body || vertex.is_body;
      const auto next = leave(vertex, landing.share, random);
      if (!next) return std::nullopt;
      ray = *next;
    }
    return std::nullopt;
  }

 private:
  /// Goes on by one of the two ways, chosen by the light that they take.
  static std::optional<Ray> leave(const PathVertex& vertex, glm::vec3& share, SampleSequence& random) {
    const glm::vec3 n = facetAt(vertex, frameOnRaysSide(vertex), random);
    const SurfaceShares shares = sharesAt(vertex, n);
    // What sends none on refracted is solid, unless all is reflected.
    if (shares.refracted == glm::vec3(0.0f) && !shares.is_total) return std::nullopt;
    const float refracted = formula::luminance(shares.refracted);
    const float sum = refracted + formula::luminance(shares.reflected);
    const bool is_refracted = random.nextIndependent() * sum < refracted;
    share *=
        (is_refracted ? shares.refracted : shares.reflected) * (sum / (is_refracted ? refracted : sum - refracted));
    const glm::vec3 direction = is_refracted ? refractedDirection(vertex, n) : reflectedDirection(vertex, n);
    // A facet that lies at a steep angle may send it back into its own side, where other facets are in its way.
    const bool goes_out = glm::dot(direction, vertex.hit.geometric_normal) >= 0.0f;
    if (is_refracted && goes_out == vertex.is_outside) return std::nullopt;
    return leavingRay(vertex, direction);
  }

  /// The normal of a facet that the ray meets.
  static glm::vec3 facetAt(const PathVertex& vertex, const Frame& frame, SampleSequence& random) {
    const formula::Material& material = vertex.point.material;
    const glm::vec2 alpha = formula::stretchedAlpha(material.perceptual_roughness, material.anisotropy);
    if (std::max(alpha.x, alpha.y) < kLeastAlpha) return frame.n;
    const glm::vec3 v = frame.toLocal(-vertex.arriving.direction);
    return frame.toWorld(formula::sampleVisibleNormal(glm::max(alpha, kLeastAlpha), v, random.next()));
  }

  const Scene& scene_;
  const Geometry& geometry_;
  float ground_;
  std::vector<glm::mat3> world_from_normal_;
};

/// Adds light to the texels that a tent about a place covers.
///
/// at   in texels; a ray along the ground lands far beyond the picture
void addLight(Image& picture, glm::vec2 at, glm::vec3 light) {
  const glm::vec2 beyond(picture.width() + 1, picture.height() + 1);
  if (!glm::all(glm::greaterThan(at, glm::vec2(-1.0f))) || !glm::all(glm::lessThan(at, beyond))) return;
  const glm::ivec2 first(glm::floor(at - 0.5f));
  const glm::vec2 part = at - 0.5f - glm::vec2(first);
  for (int i = 0; i < 4; ++i) {
    const glm::ivec2 place = first + glm::ivec2(i % 2, i / 2);
    if (std::min(place.x, place.y) < 0 || place.x >= picture.width() || place.y >= picture.height()) continue;
    const float weight = (i % 2 == 1 ? part.x : 1.0f - part.x) * (i / 2 == 1 ? part.y : 1.0f - part.y);
    const glm::vec4 added = weight * glm::vec4(light, 1.0f);
    for (int channel = 0; channel < 4; ++channel) picture.texel(place.x, place.y)[channel] += added[channel];
  }
}

/// Where a ray of a light begins that may meet the bodies: on a disc across it.
Ray rayTowards(const BoundingSphere& bodies, glm::vec3 light, float beyond, glm::vec2 u) {
  const glm::vec3 across = formula::anyTangent(light);
  const glm::vec2 beside = bodies.radius * glm::vec2(formula::sampleDiffuse(u));  // even over a disc
  return {.origin = bodies.center + beyond * light + beside.x * across + beside.y * glm::cross(light, across),
          .direction = -light};
}

/// What some of the rays bring.
struct Brought {
  std::vector<Landing> landings;
  glm::dvec3 light{0.0};  ///< of all that were begun, whether they land or not
};

}  // namespace

bool hasCaustics(const Scene& scene) {
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    if (isBody(materialOf(scene, i))) return true;
  return false;
}

Image groundCaustics(const CausticsScene& caught, const GroundSky& sky, float ground, glm::vec3 area, int size) {
  Image picture(size, size, 4);
  const BoundingSphere bodies = aroundBodies(caught.scene, caught.boxes);
  if (bodies.radius <= 0.0f) return picture;
  const float beyond = glm::distance(glm::vec2(area), glm::vec2(bodies.center.x, bodies.center.z)) + area.z;
  const GlassFollower follower(caught.scene, caught.geometry, ground);
  constexpr std::uint32_t kPiece = 1u << 12;
  std::vector<Brought> pieces(kRays / kPiece);
  parallelFor(pieces.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t piece = begin; piece < end; ++piece) {
      for (std::uint32_t i = 0; i < kPiece; ++i) {
        SampleSequence random(0, std::uint32_t(piece) * kPiece + i);
        const auto light = groundLightAt(sky.environment, sky.sampler, sky.environment_from_world, random.next());
        if (!light) continue;
        pieces[piece].light += light->share;
        auto landing = follower.follow(rayTowards(bodies, light->direction, beyond, random.next()), random);
        if (!landing) continue;
        landing->share *= light->share / light->direction.y;
        pieces[piece].landings.push_back(*landing);
      }
    }
  });
  glm::dvec3 all(0.0);
  for (const Brought& piece : pieces) all += piece.light;
  const float texel = 2.0f * area.z / float(size);
  const float disc = formula::kPi * bodies.radius * bodies.radius / (texel * texel);  // of the level ground, in texels
  const glm::vec3 share = disc / glm::max(glm::vec3(all), glm::vec3(1e-20f));
  for (const Brought& piece : pieces)
    for (const Landing& landing : piece.landings)
      addLight(picture, (landing.place - glm::vec2(area) + area.z) / texel, share * landing.share);
  smoothByCount(picture);
  return picture;
}

}  // namespace mirrorball
