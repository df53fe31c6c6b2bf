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
constexpr glm::vec3 kUp{0.0f, 0.0f, 1.0f};
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

/// The direction on the other side of a thin wall.
glm::vec3 mirrored(glm::vec3 l) { return {l.x, l.y, -l.z}; }

/// The density [1/sr] of refraction into l at the facets that are met along w: without Fresnel's share (Walter et al.
/// 2007, eq. 17).
float densityOfRefraction(glm::vec2 alpha, glm::vec3 w, glm::vec3 l, float eta) {
  const glm::vec3 h = refractingNormal(w, l, eta);
  const float cosine = glm::dot(w, h);
  const float beyond = glm::dot(l, h);
  const float both = cosine + eta * beyond;
  if (cosine <= 0.0f || beyond >= 0.0f || both == 0.0f) return 0.0f;
  return densityOfMetFacets(alpha, w, h) * eta * eta * -beyond / (both * both);
}

/// The density of reflection into l at the facets that are met along w, without Fresnel's share.
float densityOfReflection(glm::vec2 alpha, glm::vec3 w, glm::vec3 l) {
  const glm::vec3 h = glm::normalize(w + l);
  const float cosine = glm::dot(w, h);
  const bool is_met = h.z > 0.0f && cosine > 0.0f;
  return is_met ? densityOfMetFacets(alpha, w, h) / (4.0f * cosine) : 0.0f;
}

/// The density [1/sr] of the rays that a facet reflects into l, if facets are chosen by D(h) h.z, as they are seen
/// along the surface's normal: D(h) h.z / (4 l·h). It is great for facets that l grazes, where the walk finds too few.
float densityFromLight(glm::vec2 alpha, glm::vec3 ray, glm::vec3 l) {
  const glm::vec3 h = glm::normalize(l - ray);
  const float cosine = glm::dot(l, h);
  const bool is_met = h.z > 0.0f && cosine > 0.0f;  // not where the ray already goes there
  return is_met ? densityOfMetFacets(alpha, kUp, h) / (4.0f * cosine) : 0.0f;
}

}  // namespace

float balanceHeuristic(float chosen_pdf, float other_pdf) {
  return chosen_pdf / std::max(chosen_pdf + other_pdf, 1e-30f);
}

float lightWeight(const LightSample& light, float own_pdf) {
  return light.is_weighed ? balanceHeuristic(light.pdf, own_pdf) : 1.0f;
}

/// A ray between the facets. Inside of the body everything is as outside, turned upside down.
struct Bsdf::Walk {
  glm::vec3 ray;
  bool is_metal;
  bool is_outside;
  float height = kAboveAllFacets;  // above the facets as seen from the side where the ray is
  glm::vec3 weight{1.0f};
  float pdf = 0.0f;           // of the last choice, and of the facet that it was made at
  float meeting = 1.0f;       // probability with which the facet is met that is looked at
  float from_facet = 0.0f;    // density with which a facet has reflected it to where it is; 0: none has
  bool has_left = false;      // for good: no facet is met any more
  bool is_refracted = false;  // once at least
  bool has_entered = false;   // what lies below a coat

  float side() const { return is_outside ? 1.0f : -1.0f; }
  /// Towards where the ray comes from, as seen from its side.
  glm::vec3 back() const { return -side() * ray; }

  /// Of choosing this ray and then a facet that reflects it into l, against choosing that facet first
  /// (directFromTwoFacets): the part that the former has, by their densities.
  float partOfWalk(glm::vec2 alpha, glm::vec3 l) const {
    const bool has_other_way = from_facet > 0.0f && l.z > 0.0f;
    return has_other_way ? balanceHeuristic(from_facet, densityFromLight(alpha, -back(), l)) : 1.0f;
  }
};

/// One that a ray has met.
struct Bsdf::Facet {
  glm::vec3 normal;
  float cosine;
  glm::vec3 reflectance;
  glm::vec3 entering;  // the share that it does not reflect
};

Bsdf::Bsdf(const formula::Material& material, const Refraction& refraction)
    : material_(material), refraction_(refraction) {
  const glm::vec2 alpha = formula::stretchedAlpha(material.perceptual_roughness, material.anisotropy);
  is_smooth_ = std::max(alpha.x, alpha.y) < kSmoothAlpha;
  alpha_ = glm::max(alpha, kSmoothAlpha);
}

bool Bsdf::chooseMetal(SampleSequence& samples) const {
  if (material_.metallic <= 0.0f) return false;
  return material_.metallic >= 1.0f || samples.nextIndependent() < material_.metallic;
}

/// Whether the ray is inside of a body that facets enclose.
bool Bsdf::isInMatter(const Walk& walk) const { return !walk.is_outside && !refraction_.is_thin; }

/// What a dielectric's facet reflects by the one index that refracted light has.
glm::vec3 Bsdf::reflectanceOfIndex(const formula::Material& m, const Walk& walk, float cosine) const {
  const bool refracts = m.transmission > 0.0f && !refraction_.is_thin;
  const float exact = refracts ? formula::fresnelDielectric(cosine, etaFrom(walk.is_outside, refraction_.ior)) : 0.0f;
  if (exact >= 1.0f) return glm::vec3(1.0f);  // nothing passes beyond the critical angle
  const bool is_inside = refracts && !walk.is_outside;
  const glm::vec3 ior(refraction_.ior);
  // With a film, light that comes out is reflected as light that goes in by the same way.
  const float sine2 = refraction_.ior * refraction_.ior * (1.0f - cosine * cosine);
  const float outside = is_inside ? std::sqrt(std::max(1.0f - sine2, 0.0f)) : cosine;
  const glm::vec3 here =
      is_inside && m.iridescence <= 0.0f ? glm::vec3(exact) : formula::dielectricReflectance(m, outside, ior);
  if (m.specular_color == glm::vec3(1.0f)) return m.specular * here;
  const glm::vec3 f0 = is_inside ? glm::vec3(formula::fresnelDielectric(1.0f, refraction_.ior))
                                 : formula::dielectricReflectance(m, 1.0f, ior);
  return formula::tintedReflectance(m, here, f0);
}

/// material   material_, or that with another specular colour
glm::vec3 Bsdf::facetReflectance(const formula::Material& material, const Walk& walk, float cosine) const {
  const float bounded = std::clamp(cosine, 0.0f, 1.0f);
  if (walk.is_metal) return formula::metalReflectance(material, bounded);
  if (material.dispersion > 0.0f && !walk.is_refracted) return formula::smoothDielectric(material, bounded);
  return reflectanceOfIndex(material, walk, bounded);
}

Bsdf::Facet Bsdf::facetAt(const Walk& walk, glm::vec3 normal) const {
  const float cosine = glm::dot(walk.back(), normal);
  const glm::vec3 reflectance = facetReflectance(material_, walk, cosine);
  const glm::vec3 tint = material_.specular_color;
  const bool is_tinted = !walk.is_metal && tint != glm::vec3(maxComponent(tint));
  const glm::vec3 kept_out =
      is_tinted ? facetReflectance(formula::withGreySpecular(material_), walk, cosine) : reflectance;
  return {normal, cosine, reflectance, glm::vec3(1.0f) - kept_out};
}

/// What it lets through: all that enters, weighed for its wavelength when that is new.
glm::vec3 Bsdf::facetTransmittance(const Walk& walk, const Facet& facet) const {
  return material_.base_color * facet.entering * (walk.is_refracted ? glm::vec3(1.0f) : refraction_.weight);
}

/// What the facets that may be met here send straight into the light's direction, if no other facet catches it there.
/// The light sample is weighed against the walk alone: not against the other way to a second facet.
///
/// part     partOfWalk, for the light's direction
glm::vec3 Bsdf::directFromFacets(const Walk& walk, const LightSample& light, float part) const {
  const glm::vec3 w = walk.back();
  const glm::vec3 l = walk.side() * light.direction;
  if (l.z <= 0.0f) return directThroughFacets(walk, light);
  const float density = walk.meeting * densityOfReflection(alpha_, w, l) * shareOfFacets(walk);
  if (density <= 0.0f) return glm::vec3(0.0f);
  const glm::vec3 reflectance = facetReflectance(material_, walk, glm::dot(w, glm::normalize(w + l)));
  const float own = density * (walk.is_metal ? 1.0f : maxComponent(reflectance)) * part;
  return walk.weight * reflectance *
         (density * escapeProbability(alpha_, l, walk.height) * lightWeight(light, own) / light.pdf);
}

/// What two facets send there, the second one chosen before the ray to it: the first one seldom reflects a ray that a
/// second one then mirrors into a low sun, but such light is bright.
glm::vec3 Bsdf::directFromTwoFacets(const Walk& walk, const LightSample& light, SampleSequence& samples) const {
  const glm::vec3 w = walk.back();
  const glm::vec3 l = walk.side() * light.direction;
  if (l.z <= 0.0f) return glm::vec3(0.0f);
  const glm::vec2 u(samples.nextIndependent(), samples.nextIndependent());
  const glm::vec3 between = glm::reflect(l, formula::sampleVisibleNormal(alpha_, kUp, u));
  const float by_light = densityFromLight(alpha_, between, l);
  const float first = walk.meeting * shareOfFacets(walk) * densityOfReflection(alpha_, w, between);
  if (by_light <= 0.0f || first <= 0.0f) return glm::vec3(0.0f);
  const glm::vec3 reflectance = facetReflectance(material_, walk, glm::dot(w, glm::normalize(w + between)));
  const float by_first = first * (walk.is_metal ? 1.0f : maxComponent(reflectance));
  Walk second = walk;
  second.ray = walk.side() * between;
  second.meeting = 1.0f - escapeProbability(alpha_, between, walk.height);
  second.height = heightOfNextFacet(alpha_, between, walk.height, samples.nextIndependent());
  const float part = balanceHeuristic(by_first, by_light);
  second.weight *= reflectance * (first / by_light * (1.0f - part));
  return directFromFacets(second, light, part);
}

/// The same through the facets.
glm::vec3 Bsdf::directThroughFacets(const Walk& walk, const LightSample& light) const {
  if (walk.is_metal || material_.transmission <= 0.0f || goesStraightOn()) return glm::vec3(0.0f);
  const glm::vec3 w = walk.back();
  const glm::vec3 l = walk.side() * light.direction;
  const float eta = etaFrom(walk.is_outside, refraction_.ior);
  const glm::vec3 h = refraction_.is_thin ? glm::normalize(w + mirrored(l)) : refractingNormal(w, l, eta);
  const float through =
      refraction_.is_thin ? densityOfReflection(alpha_, w, mirrored(l)) : densityOfRefraction(alpha_, w, l, eta);
  const float density = walk.meeting * through * material_.transmission;
  if (density <= 0.0f) return glm::vec3(0.0f);
  const Facet facet = facetAt(walk, h);
  const float own = density * (1.0f - maxComponent(facet.reflectance));
  const float height = refraction_.is_thin ? walk.height : -walk.height;
  return walk.weight * facetTransmittance(walk, facet) *
         (density * escapeProbability(alpha_, -l, height) * lightWeight(light, own) / light.pdf);
}

/// What the matter below a facet, or from inside before it, scatters back into the light's direction.
glm::vec3 Bsdf::directFromMatter(const Walk& walk, const LightSample& light, const Facet& facet) const {
  const float scattered = 1.0f - material_.transmission;
  if (walk.is_metal || scattered <= 0.0f) return glm::vec3(0.0f);
  const bool is_inside = isInMatter(walk);
  const glm::vec3 entered = is_inside ? glm::vec3(1.0f) : facet.entering;
  const float density = walk.meeting * scattered * formula::pdfDiffuse(walk.side() * light.direction);
  const float own = density * (is_inside ? 1.0f : 1.0f - maxComponent(facet.reflectance));
  return walk.weight * material_.base_color * entered * (density * lightWeight(light, own) / light.pdf);
}

/// The share of a ray that facets reflect or refract: from inside, matter scatters its share before they are met, so
/// that light does not circle in a ball that reflects it totally.
float Bsdf::shareOfFacets(const Walk& walk) const {
  return isInMatter(walk) && !walk.is_metal ? material_.transmission : 1.0f;
}

/// Reflects, refracts or scatters a ray that has met a facet.
///
/// u        for the choice
void Bsdf::chooseNext(Walk& walk, const Facet& facet, glm::vec2 u, SampleSequence& samples) const {
  const glm::vec3 w = walk.back();
  const float share = walk.is_metal ? 1.0f : maxComponent(facet.reflectance);
  const float by_facets = shareOfFacets(walk);
  const bool is_reflected = u.x < share && (by_facets == 1.0f || u.y < by_facets);
  if (is_reflected) {
    const glm::vec3 l = glm::reflect(-w, facet.normal);
    const float density = isSmooth() ? 0.0f : walk.meeting * by_facets * share * densityOfReflection(alpha_, w, l);
    walk.pdf = density * walk.partOfWalk(alpha_, l);
    walk.from_facet = density;
    walk.weight *= facet.reflectance / share;
    walk.ray = walk.side() * l;
    return;
  }
  walk.from_facet = 0.0f;
  if (u.y < material_.transmission) return transmit(walk, facet);
  const bool is_inside = isInMatter(walk);
  const glm::vec3 entered = facet.entering / std::max(1.0f - share, 1e-30f);
  if (refraction_.is_coat) {
    walk.weight *= entered;
    walk.has_entered = true;
    return;
  }
  const glm::vec3 l = formula::sampleDiffuse(samples.next());
  walk.weight *= material_.base_color * (is_inside ? glm::vec3(1.0f) : entered);
  walk.pdf =
      walk.meeting * (1.0f - material_.transmission) * (is_inside ? 1.0f : 1.0f - share) * formula::pdfDiffuse(l);
  walk.ray = walk.side() * l;
  walk.has_left = true;
}

/// Refracts a ray through a facet, or lets it pass a thin wall.
void Bsdf::transmit(Walk& walk, const Facet& facet) const {
  const glm::vec3 w = walk.back();
  const float eta = etaFrom(walk.is_outside, refraction_.ior);
  const glm::vec3 l = refraction_.is_thin ? mirrored(glm::reflect(-w, facet.normal))
                                          : formula::refractedDirection(-w, facet.normal, eta);
  const float passes = std::max(1.0f - maxComponent(facet.reflectance), 1e-30f);  // the probability
  if (!isSmooth() && !goesStraightOn()) {
    const float density =
        refraction_.is_thin ? densityOfReflection(alpha_, w, mirrored(l)) : densityOfRefraction(alpha_, w, l, eta);
    walk.pdf = walk.meeting * passes * material_.transmission * density;
  } else {
    walk.pdf = 0.0f;
  }
  walk.weight *= facetTransmittance(walk, facet) / passes;
  walk.ray = walk.side() * l;
  walk.is_outside = !walk.is_outside;
  walk.is_refracted = true;
  if (!refraction_.is_thin) walk.height = -walk.height;
}

Scattering Bsdf::scatter(glm::vec3 v, const LightSample& light, SampleSequence& samples) const {
  Walk walk{.ray = -v, .is_metal = chooseMetal(samples), .is_outside = v.z > 0.0f};
  Scattering result;
  // The first facet's numbers are spread well over the paths of a pixel.
  glm::vec2 for_facet = samples.next();
  glm::vec2 for_choice = samples.next();
  for (int step = 0; step < kLongestWalk; ++step) {
    if (step > 0) {
      const float escapes =
          isSmooth() || walk.has_left ? 1.0f : escapeProbability(alpha_, walk.side() * walk.ray, walk.height);
      if (escapes >= 1.0f || samples.nextIndependent() < escapes)
        result.next = BsdfSample{walk.ray, walk.weight, walk.pdf, walk.is_refracted};
      if (escapes >= 1.0f || (result.next && light.pdf <= 0.0f)) return result;
      walk.meeting = 1.0f - escapes;
      for_facet = {samples.nextIndependent(), samples.nextIndependent()};
      for_choice = {samples.nextIndependent(), samples.nextIndependent()};
    }
    const glm::vec3 w = walk.back();
    if (!isSmooth()) walk.height = heightOfNextFacet(alpha_, -w, walk.height, samples.nextIndependent());
    const glm::vec3 normal = isSmooth() ? kUp : formula::sampleVisibleNormal(alpha_, w, for_facet);
    const Facet facet = facetAt(walk, normal);
    if (light.pdf > 0.0f) {
      if (!isSmooth()) {
        const float part = walk.partOfWalk(alpha_, walk.side() * light.direction);
        result.direct += part * directFromFacets(walk, light, part) + directFromTwoFacets(walk, light, samples);
      }
      result.direct += directFromMatter(walk, light, facet);
    }
    if (result.next) return result;
    chooseNext(walk, facet, for_choice, samples);
    if (walk.has_entered) {
      result.enters = walk.weight;
      return result;
    }
  }
  return result;
}

}  // namespace mirrorball
