#pragma once

#include <cmath>
#include <optional>

#include <glm/glm.hpp>

#include "formula/surface.h"
#include "mirrorball/bake/light_sampler.h"
#include "mirrorball/rays/sample_sequence.h"

namespace mirrorball {

/// A direction that a path goes on in.
struct BsdfSample {
  glm::vec3 direction{0.0f};  ///< unit, local
  glm::vec3 weight{0.0f};     ///< BSDF times cosine over the density: the share of light that it carries
  float pdf = 0.0f;           ///< density of this choice [1/sr]; 0: the only direction that a smooth surface has
  bool is_refracted = false;  ///< light of one wavelength, if Refraction has chosen one
};

/// How light passes a surface.
struct Refraction {
  float ior = 1.0f;        ///< of the inside over the outside; at the wavelength that light has once it is refracted
  glm::vec3 weight{1.0f};  ///< of what is refracted: that wavelength's in red, green and blue
  bool is_thin = false;    ///< it is a sheet, which has no inside and does not refract
  bool is_coat = false;    ///< what it does not reflect enters what lies below it, and ends the walk
};

/// What becomes of light at a surface.
struct Scattering {
  /// The share of the light sample that goes towards the eye, over its density, and weighed against `next`.
  glm::vec3 direct{0.0f};
  /// Where the path goes on; nothing where the walk had no end. Light that is found there counts by its weight against
  /// the density of a light sample there (balanceHeuristic).
  std::optional<BsdfSample> next = {};
  /// Where the path has entered what lies below a coat: the share that it still carries.
  std::optional<glm::vec3> enters = {};
};

/// The weight of a choice against another one that could have chosen the same (the balance heuristic: Veach & Guibas
/// 1995).
float balanceHeuristic(float chosen_pdf, float other_pdf);

/// The weight of a light sample against a surface's own choice.
float lightWeight(const LightSample& light, float own_pdf);

/// How a point of a surface scatters light: glTF's metallic-roughness material as a random walk between the facets of a
/// rough surface (microsurface.h). What a dielectric's facets do not reflect is scattered by the matter below them
/// (Lambert), or refracted, in the shares that Material::transmission says; a thin wall lets it go straight on instead,
/// widened as a reflection is (KHR_materials_transmission). The reflectance of facets, their distribution and their
/// sampling are those of formula/bsdf/.
///
/// Directions are unit, in the frame of the surface, whose normal is +Z on the outside; v is towards the eye. v.z < 0
/// is inside of a transmitting body. Radiance is carried divided by the square of the index, so that white light stays
/// white in glass.
class Bsdf {
 public:
  /// material  its numbers at the point; `ior` is relative to what is outside. Where it disperses, each channel is
  ///           reflected by its own index
  Bsdf(const formula::Material& material, const Refraction& refraction);

  /// Whether a light sample can be of use: a smooth mirror or glass has light from single directions alone.
  bool takesLightSamples() const { return !isSmooth() || (material_.metallic < 1.0f && material_.transmission < 1.0f); }

  /// Walks from the eye between the facets until the path leaves. At each facet the light sample has its share, weighed
  /// against the facet's own choice: the densities are exact at each facet, though nobody knows that of the whole walk,
  /// and so neither a sun nor a narrow lobe makes single paths bright. Whether a further facet is met is a matter of
  /// chance for the path, and of its probability for the light sample. Light by way of two facets is also looked for
  /// from the light's side, by the facets that it sees.
  ///
  /// light    local; a pdf of 0: there is none
  /// cost     0.2 µs where it is smooth, to 0.7 µs where it is rough; measured
  Scattering scatter(glm::vec3 v, const LightSample& light, SampleSequence& samples) const;

 private:
  struct Walk;
  struct Facet;
  bool chooseMetal(SampleSequence& samples) const;
  bool isSmooth() const { return is_smooth_; }
  /// Whether both sides have one index.
  bool goesStraightOn() const { return !refraction_.is_thin && std::abs(refraction_.ior - 1.0f) < 1e-4f; }
  bool isInMatter(const Walk& walk) const;
  float shareOfFacets(const Walk& walk) const;
  glm::vec3 reflectanceOfIndex(const formula::Material& material, const Walk& walk, float cosine) const;
  glm::vec3 facetReflectance(const formula::Material& material, const Walk& walk, float cosine) const;
  Facet facetAt(const Walk& walk, glm::vec3 normal) const;
  glm::vec3 facetTransmittance(const Walk& walk, const Facet& facet) const;
  glm::vec3 directFromTwoFacets(const Walk& walk, const LightSample& light, SampleSequence& samples) const;
  glm::vec3 directFromFacets(const Walk& walk, const LightSample& light, float part) const;
  glm::vec3 directThroughFacets(const Walk& walk, const LightSample& light) const;
  glm::vec3 directFromMatter(const Walk& walk, const LightSample& light, const Facet& facet) const;
  void chooseNext(Walk& walk, const Facet& facet, glm::vec2 u, SampleSequence& samples) const;
  void transmit(Walk& walk, const Facet& facet) const;

  formula::Material material_;
  Refraction refraction_;
  glm::vec2 alpha_;
  bool is_smooth_;
};

}  // namespace mirrorball
