#include "mirrorball/trace/bsdf.h"

#include <algorithm>
#include <cmath>

#include "formula/bsdf.h"
#include "formula/surface.h"
#include "mirrorball/trace/microsurface.h"

namespace mirrorball {
namespace {

/// Below this a lobe is as narrow as a float's direction.
constexpr float kSmoothAlpha = 1e-4f;
/// A walk that has not ended by then carries next to nothing.
constexpr int kLongestWalk = 64;

float maxComponent(glm::vec3 v) { return std::max({v.x, v.y, v.z}); }

/// The index of the far side over that of the near side.
float etaFrom(bool is_outside, float ior) { return is_outside ? ior : 1.0f / ior; }

/// The normal of the facets that refract w (towards the eye) into l: upwards (Walter et al. 2007, eq. 16).
glm::vec3 refractingNormal(glm::vec3 w, glm::vec3 l, float eta) {
  const glm::vec3 h = glm::normalize(w + l * eta);
  return h.z < 0.0f ? -h : h;
}

/// The density [1/sr] of refraction into l at the facets that are met along w: without Fresnel's share (Walter et al.
/// 2007, eq. 17).
float densityOfRefraction(float alpha, glm::vec3 w, glm::vec3 l, float eta) {
  const glm::vec3 h = refractingNormal(w, l, eta);
  const float cosine = glm::dot(w, h);
  const float beyond = glm::dot(l, h);
  const float both = cosine + eta * beyond;
  if (cosine <= 0.0f || beyond >= 0.0f || both == 0.0f) return 0.0f;
  return densityOfMetFacets(alpha, w, h) * eta * eta * -beyond / (both * both);
}

/// The density of reflection into l at the facets that are met along w, without Fresnel's share.
float densityOfReflection(float alpha, glm::vec3 w, glm::vec3 l) {
  const glm::vec3 h = glm::normalize(w + l);
  const float cosine = glm::dot(w, h);
  if (h.z <= 0.0f || cosine <= 0.0f) return 0.0f;
  return densityOfMetFacets(alpha, w, h) / (4.0f * cosine);
}

}  // namespace

float balanced(float chosen_pdf, float other_pdf) { return chosen_pdf / std::max(chosen_pdf + other_pdf, 1e-30f); }

/// A ray between the facets. Inside of the body everything is as outside, turned upside down.
struct Bsdf::Walk {
  glm::vec3 ray;
  bool is_metal;
  bool is_outside;
  float height = kAboveAllFacets;  // above the facets as seen from the side where the ray is
  glm::vec3 weight{1.0f};
  float pdf = 0.0f;       // of the last choice
  bool has_left = false;  // for good: no facet is met any more

  float side() const { return is_outside ? 1.0f : -1.0f; }
  /// Towards where the ray comes from, as seen from its side.
  glm::vec3 back() const { return -side() * ray; }

  bool meetsFacet(float alpha, float u) {
    height = heightOfNextFacet(alpha, side() * ray, height, u);
    return height != kEscaped;
  }
};

Bsdf::Bsdf(const formula::Material& material) : material_(material) {
  const float alpha = formula::alphaFromPerceptualRoughness(material.perceptual_roughness);
  alpha_ = alpha < kSmoothAlpha ? 0.0f : alpha;
}

bool Bsdf::chooseMetal(SampleSequence& samples) const {
  if (material_.metallic <= 0.0f) return false;
  return material_.metallic >= 1.0f || samples.nextIndependent() < material_.metallic;
}

glm::vec3 Bsdf::facetReflectance(bool is_metal, bool is_outside, float cosine) const {
  const float bounded = std::clamp(cosine, 0.0f, 1.0f);
  formula::Surface surface;
  surface.material = material_;
  if (is_metal) return formula::metalReflectance(surface, bounded);
  if (is_outside) return formula::smoothDielectric(surface, bounded);
  const float inner = formula::fresnelDielectric(bounded, 1.0f / material_.ior);
  return glm::vec3(inner < 1.0f ? material_.specular * inner : 1.0f);  // nothing passes beyond the critical angle
}

/// What the facets that may be met here send straight into the light's direction, if no other facet catches it there.
glm::vec3 Bsdf::offeredByFacets(const Walk& walk, const OfferedLight& light) const {
  const glm::vec3 w = walk.back();
  const glm::vec3 l = walk.side() * light.direction;
  if (l.z > 0.0f) {
    const float density = densityOfReflection(alpha_, w, l) * shareOfFacets(walk);
    if (density <= 0.0f) return glm::vec3(0.0f);
    const glm::vec3 reflectance = facetReflectance(walk.is_metal, walk.is_outside, glm::dot(w, glm::normalize(w + l)));
    const float own = density * (walk.is_metal ? 1.0f : maxComponent(reflectance));
    return walk.weight * reflectance *
           (density * escapeProbability(alpha_, l, walk.height) * balanced(light.pdf, own) / light.pdf);
  }
  if (walk.is_metal || material_.transmission <= 0.0f) return glm::vec3(0.0f);
  const float eta = etaFrom(walk.is_outside, material_.ior);
  const float density = densityOfRefraction(alpha_, w, l, eta) * material_.transmission;
  if (density <= 0.0f) return glm::vec3(0.0f);
  const glm::vec3 reflectance = facetReflectance(false, walk.is_outside, glm::dot(w, refractingNormal(w, l, eta)));
  const float own = density * (1.0f - maxComponent(reflectance));
  return walk.weight * material_.base_color * (glm::vec3(1.0f) - reflectance) *
         (density * escapeProbability(alpha_, -l, -walk.height) * balanced(light.pdf, own) / light.pdf);
}

/// What the matter below a facet, or from inside before it, scatters back into the light's direction.
glm::vec3 Bsdf::offeredByMatter(const Walk& walk, const OfferedLight& light, glm::vec3 reflectance) const {
  const float scattered = 1.0f - material_.transmission;
  if (walk.is_metal || scattered <= 0.0f) return glm::vec3(0.0f);
  const glm::vec3 entered = walk.is_outside ? glm::vec3(1.0f) - reflectance : glm::vec3(1.0f);
  const float density = scattered * formula::pdfDiffuse(walk.side() * light.direction);
  const float own = density * (walk.is_outside ? 1.0f - maxComponent(reflectance) : 1.0f);
  return walk.weight * material_.base_color * entered * (density * balanced(light.pdf, own) / light.pdf);
}

/// The share of a ray that facets reflect or refract: from inside, matter scatters its share before they are met, so
/// that light does not circle in a ball that reflects it totally.
float Bsdf::shareOfFacets(const Walk& walk) const {
  return walk.is_outside || walk.is_metal ? 1.0f : material_.transmission;
}

/// Reflects, refracts or scatters a ray that has met a facet.
///
/// u        for the choice
void Bsdf::chooseNext(Walk& walk, glm::vec3 h, glm::vec3 reflectance, glm::vec2 u, SampleSequence& samples) const {
  const glm::vec3 w = walk.back();
  const float share = walk.is_metal ? 1.0f : maxComponent(reflectance);
  const float by_facets = shareOfFacets(walk);
  const bool is_reflected = u.x < share && (by_facets == 1.0f || u.y < by_facets);
  if (is_reflected) {
    const glm::vec3 l = glm::reflect(-w, h);
    walk.pdf = isSmooth() ? 0.0f : by_facets * share * densityOfReflection(alpha_, w, l);
    walk.weight *= reflectance / share;
    walk.ray = walk.side() * l;
    return;
  }
  const glm::vec3 entered = (glm::vec3(1.0f) - reflectance) / std::max(1.0f - share, 1e-30f);
  if (u.y < material_.transmission) {
    const float eta = etaFrom(walk.is_outside, material_.ior);
    const glm::vec3 l = formula::refractedDirection(-w, h, eta);
    walk.pdf = isSmooth() ? 0.0f : (1.0f - share) * material_.transmission * densityOfRefraction(alpha_, w, l, eta);
    walk.weight *= material_.base_color * entered;
    walk.ray = walk.side() * l;
    walk.is_outside = !walk.is_outside;
    walk.height = -walk.height;
    return;
  }
  const glm::vec3 l = formula::sampleDiffuse(samples.next());
  walk.weight *= material_.base_color * (walk.is_outside ? entered : glm::vec3(1.0f));
  walk.pdf = (1.0f - material_.transmission) * (walk.is_outside ? 1.0f - share : 1.0f) * formula::pdfDiffuse(l);
  walk.ray = walk.side() * l;
  walk.has_left = true;
}

Scattering Bsdf::scatter(glm::vec3 v, const OfferedLight& light, SampleSequence& samples) const {
  Walk walk{.ray = -v, .is_metal = chooseMetal(samples), .is_outside = v.z > 0.0f};
  Scattering result;
  // The first facet's numbers are spread well over the paths of a pixel.
  glm::vec2 for_facet = samples.next();
  glm::vec2 for_choice = samples.next();
  for (int step = 0; step < kLongestWalk; ++step) {
    const bool meets = !walk.has_left && (isSmooth() ? step == 0 : walk.meetsFacet(alpha_, samples.nextIndependent()));
    if (!meets) {
      if (step > 0) result.next = BsdfSample{walk.ray, walk.weight, walk.pdf};
      return result;
    }
    if (step > 0) {
      for_facet = {samples.nextIndependent(), samples.nextIndependent()};
      for_choice = {samples.nextIndependent(), samples.nextIndependent()};
    }
    const glm::vec3 w = walk.back();
    const glm::vec3 h = isSmooth() ? glm::vec3(0.0f, 0.0f, 1.0f) : formula::sampleVisibleNormal(alpha_, w, for_facet);
    const glm::vec3 reflectance = facetReflectance(walk.is_metal, walk.is_outside, glm::dot(w, h));
    if (light.pdf > 0.0f) {
      if (!isSmooth()) result.offered += offeredByFacets(walk, light);
      result.offered += offeredByMatter(walk, light, reflectance);
    }
    chooseNext(walk, h, reflectance, for_choice, samples);
  }
  return result;
}

}  // namespace mirrorball
