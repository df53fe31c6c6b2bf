#include "mirrorball/trace/layered_bsdf.h"

#include <algorithm>

#include "formula/bsdf.h"
#include "formula/surface.h"
#include "mirrorball/bake/brdf/sheen_albedo.h"

namespace mirrorball {
namespace {

LightSample local(const LightSample& light, const Frame& frame) {
  return {frame.toLocal(light.direction), light.pdf, light.is_weighed};
}

/// What has been scattered below with a share of the path.
Scattering inWorld(Scattering scattering, const Frame& frame, glm::vec3 share) {
  scattering.direct *= share;
  if (scattering.next) {
    scattering.next->weight *= share;
    scattering.next->direction = frame.toWorld(scattering.next->direction);
  }
  return scattering;
}

}  // namespace

void LayeredBsdf::addSheen(const formula::Material& material) {
  if (material.sheen_color != glm::vec3(0.0f)) sheen_ = Sheen{material.sheen_color, material.sheen_roughness};
}

void LayeredBsdf::addCoat(const formula::Material& material, const Frame& frame) {
  if (material.clearcoat <= 0.0f) return;
  const formula::Material coat = formula::coatMaterial(material);
  coat_ = Coat{material.clearcoat, Bsdf(coat, {.ior = coat.ior, .is_coat = true}), frame};
}

bool LayeredBsdf::takesLightSamples() const {
  return surface_.takesLightSamples() || sheen_ || (coat_ && coat_->bsdf.takesLightSamples());
}

/// Of a path to be reflected by the cloth: what its brightest channel reflects of white light.
float LayeredBsdf::sheenProbability(glm::vec3 v) const {
  if (!sheen_ || v.z <= 0.0f) return 0.0f;
  const glm::vec3 color = sheen_->color;
  return std::max({color.x, color.y, color.z}) * sheenAlbedo(sheen_->roughness, std::min(v.z, 1.0f));
}

/// The light sample's share, weighed against the walk's choice.
///
/// probability   sheenProbability(v)
glm::vec3 LayeredBsdf::directFromSheen(glm::vec3 v, float probability, const LightSample& light) const {
  if (probability <= 0.0f || light.pdf <= 0.0f || light.direction.z <= 0.0f) return glm::vec3(0.0f);
  const float value =
      formula::evalCharlie(formula::alphaOfSheen(sheen_->roughness), v, light.direction) * light.direction.z;
  const float own = probability * formula::pdfDiffuse(light.direction);
  return sheen_->color * (value * lightWeight(light, own) / light.pdf);
}

BsdfSample LayeredBsdf::sampleSheen(glm::vec3 v, float probability, SampleSequence& samples) const {
  const glm::vec3 l = formula::sampleDiffuse(samples.next());
  const float pdf = std::max(probability * formula::pdfDiffuse(l), 1e-30f);
  const float value = formula::evalCharlie(formula::alphaOfSheen(sheen_->roughness), v, l) * l.z;
  return {l, sheen_->color * (value / pdf), pdf};
}

LayeredScattering LayeredBsdf::scatter(glm::vec3 v, const LightSample& light, SampleSequence& samples) const {
  LayeredScattering result;
  glm::vec3 share(1.0f);
  glm::vec3 of_layers(0.0f);
  if (coat_ && samples.nextIndependent() < coat_->share && coat_->frame.toLocal(v).z > 0.0f) {
    const Frame& frame = coat_->frame;
    const Scattering scattering = coat_->bsdf.scatter(frame.toLocal(v), local(light, frame), samples);
    if (!scattering.enters) return {inWorld(scattering, frame, glm::vec3(1.0f)), glm::vec3(0.0f)};
    of_layers = scattering.direct;
    share = *scattering.enters;
  }
  const glm::vec3 w = frame_.toLocal(v);
  const LightSample in_frame = local(light, frame_);
  const float of_cloth = sheenProbability(w);
  of_layers += share * directFromSheen(w, of_cloth, in_frame);
  if (sheen_ && samples.nextIndependent() < of_cloth) {
    result.scattering = inWorld({.next = sampleSheen(w, of_cloth, samples)}, frame_, share);
  } else {
    result.scattering = inWorld(surface_.scatter(w, in_frame, samples), frame_, share);
    result.share_below = share;
  }
  result.scattering.direct += of_layers;
  return result;
}

}  // namespace mirrorball
