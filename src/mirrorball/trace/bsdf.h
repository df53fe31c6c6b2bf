#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "formula/material.h"
#include "mirrorball/trace/sample_sequence.h"

namespace mirrorball {

/// A direction in which light is looked for, chosen by the light.
struct OfferedLight {
  glm::vec3 direction{0.0f, 0.0f, 1.0f};  ///< unit, local
  float pdf = 0.0f;                       ///< density with which it was chosen [1/sr]; 0: none is offered
};

/// A direction that a path goes on in.
struct BsdfSample {
  glm::vec3 direction{0.0f};  ///< unit, local
  glm::vec3 weight{0.0f};     ///< BSDF times cosine over the density: the share of light that it carries
  float pdf = 0.0f;           ///< density of this last choice [1/sr]; 0: the only direction that a smooth surface has
};

/// What becomes of light at a surface.
struct Scattering {
  /// The share of the offered light that goes towards the eye, over its density, and weighed against `next`.
  glm::vec3 offered{0.0f};
  /// Where the path goes on; nothing where the walk had no end. Light that is found there counts by its weight against
  /// the density with which it would have been offered (balanced).
  std::optional<BsdfSample> next = {};
};

/// The weight of a choice against another one that could have chosen the same (the balance heuristic: Veach & Guibas
/// 1995).
float balanced(float chosen_pdf, float other_pdf);

/// How a point of a surface scatters light: glTF's metallic-roughness material as a random walk between the facets of a
/// rough surface (microsurface.h). What a dielectric's facets do not reflect is scattered by the matter below them
/// (Lambert), or refracted, in the shares that Material::transmission says. The reflectance of facets, their
/// distribution and their sampling are those of formula/bsdf/.
///
/// Directions are unit, in the frame of the surface, whose normal is +Z on the outside; v is towards the eye. v.z < 0
/// is inside of a transmitting body. Radiance is carried divided by the square of the index, so that white light stays
/// white in glass.
class Bsdf {
 public:
  /// material  its numbers at the point
  explicit Bsdf(const formula::Material& material);

  /// Walks from the eye between the facets until the path leaves. At each facet the offered light has its share,
  /// weighed against the facet's own choice: the densities are exact at each facet, though nobody knows that of the
  /// whole walk, and so neither a sun nor a narrow lobe makes single paths bright.
  ///
  /// cost     0.2 µs where it is smooth, to 0.7 µs where it is rough; measured
  Scattering scatter(glm::vec3 v, const OfferedLight& light, SampleSequence& samples) const;

 private:
  struct Walk;
  bool chooseMetal(SampleSequence& samples) const;
  bool isSmooth() const { return alpha_ == 0.0f; }
  float shareOfFacets(const Walk& walk) const;
  glm::vec3 facetReflectance(bool is_metal, bool is_outside, float cosine) const;
  glm::vec3 offeredByFacets(const Walk& walk, const OfferedLight& light) const;
  glm::vec3 offeredByMatter(const Walk& walk, const OfferedLight& light, glm::vec3 reflectance) const;
  void chooseNext(Walk& walk, glm::vec3 h, glm::vec3 reflectance, glm::vec2 u, SampleSequence& samples) const;

  formula::Material material_;
  float alpha_;  // 0: smooth
};

}  // namespace mirrorball
