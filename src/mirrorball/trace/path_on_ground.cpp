#include "mirrorball/trace/path_on_ground.h"

#include <cstdint>
#include <utility>

#include "formula/bsdf.h"
#include "formula/proxy.h"
#include "formula/surface.h"
#include "mirrorball/trace/bsdf.h"

namespace mirrorball {
namespace {

/// The share of paths that go on from a polished ground as its mirror image.
constexpr float kMirroredPaths = 0.5f;
/// In place of an instance: the ground of the environment.
constexpr std::uint32_t kGround = ~std::uint32_t{0};

}  // namespace

Ray PathOnGround::scatter(const Ray& ray, float distance, glm::vec3 photographed, const ShareThatArrives& arrives,
                          CarriedLight& light) {
  const glm::vec3 up(0.0f, 1.0f, 0.0f);
  const glm::vec3 place = ray.origin + distance * ray.direction;
  // From below the ground it meets also what lies flat on it.
  const Ray next{
      .origin = formula::besideSurface(place, distance, -up), .from = Hit{.instance = kGround}, .media = ray.media};
  if (surroundings_.groundRoughness() < 1.0f) {
    if (samples_.nextIndependent() < kMirroredPaths) {
      photographed_ = photographed;
      return mirrored_ = mirror(ray, next, light);
    }
    light.throughput /= 1.0f - kMirroredPaths;
  }
  return scatterMatt(next, photographed, arrives, light);
}

Ray PathOnGround::scatterMatt(Ray next, glm::vec3 photographed, const ShareThatArrives& arrives, CarriedLight& light) {
  light.throughput *= surroundings_.albedoOfGround(photographed);
  if (strategy_ != LightStrategy::surface)
    light.sum -= light.throughput * hidden(next, strategy_ == LightStrategy::light, arrives);
  const glm::vec3 scattered = formula::sampleDiffuse(samples_.next());
  light.pdf = formula::pdfDiffuse(scattered);
  light.emitter_share = 0.0f;
  next.direction = formula::aboveGround(scattered);
  left_ = Left::scattered;
  return next;
}

/// A ray to what a polished ground may show of the scene, in place of a share of what is there.
Ray PathOnGround::mirror(const Ray& ray, Ray next, CarriedLight& light) {
  const float alpha = formula::alphaFromPerceptualRoughness(surroundings_.groundRoughness());
  next.direction = formula::mirroredByGround(ray.direction, alpha, samples_.next());
  light.throughput *= formula::shareMirroredByGround(ray.direction, next.direction, alpha) / kMirroredPaths;
  light.pdf = 0.0f;
  light.emitter_share = 0.0f;
  left_ = Left::mirrored;
  return next;
}

/// The light of the environment that the scene hides from a matt white ground, as one light sample tells it.
///
/// is_alone   no other strategy looks for it
glm::vec3 PathOnGround::hidden(Ray next, bool is_alone, const ShareThatArrives& arrives) {
  const LightSample light = surroundings_.sampleFarAway(samples_.next());
  if (light.pdf <= 0.0f || light.direction.y <= 0.0f) return glm::vec3(0.0f);
  next.direction = light.direction;
  const float cosine = light.direction.y / formula::kPi;
  const float weight = is_alone ? 1.0f : balanceHeuristic(light.pdf, cosine);
  const glm::vec3 hidden = 1.0f - arrives(next);
  if (hidden == glm::vec3(0.0f)) return hidden;  // as from most of the ground
  return hidden * surroundings_.radianceFarAway(light.direction) * (weight * cosine / light.pdf);
}

bool PathOnGround::goesOn(const Ray& ray, bool meets_surface, const ShareThatArrives& arrives, CarriedLight& light) {
  const Left left = std::exchange(left_, Left::no);
  if (!meets_surface) return left == Left::no;
  if (left == Left::scattered)
    light.sum -= light.throughput * light.weightBeside(surroundings_.pdfFarAway(ray.direction), strategy_) *
                 surroundings_.radianceFarAway(ray.direction);
  if (left == Left::mirrored)
    light.sum -= light.throughput *
                 (photographed_ - surroundings_.albedoOfGround(photographed_) * hidden(mirrored_, true, arrives));
  return true;
}

}  // namespace mirrorball
