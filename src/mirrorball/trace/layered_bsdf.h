#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "mirrorball/rays/frame.h"
#include "mirrorball/trace/bsdf.h"

namespace mirrorball {

/// What becomes of light at a surface and at what lies on it.
struct LayeredScattering {
  Scattering scattering = {};   ///< its direction in the world's frame
  glm::vec3 share_below{0.0f};  ///< of the path that has come to the surface below: 0, where a layer has reflected it
};

/// A surface and what lies on it: the fibres of cloth (KHR_materials_sheen), and over all a clear coat
/// (KHR_materials_clearcoat). A path is reflected by a layer or goes on to the one below, by chance and with its
/// direction: neither bends it. From inside of a body the layers are not there.
///
/// Directions are unit, in the world's frame; v is towards the eye.
class LayeredBsdf {
 public:
  /// The surface alone.
  LayeredBsdf(const formula::Material& material, const Refraction& refraction, const Frame& frame)
      : surface_(material, refraction), frame_(frame) {}

  /// Lays cloth on the surface: sheen_color and sheen_roughness of a material.
  void addSheen(const formula::Material& material);
  /// Lays a clear coat over all: clearcoat and clearcoat_roughness of a material.
  void addCoat(const formula::Material& material, const Frame& frame);

  /// Bsdf::takesLightSamples.
  bool takesLightSamples() const;

  /// Bsdf::scatter.
  LayeredScattering scatter(glm::vec3 v, const LightSample& light, SampleSequence& samples) const;

 private:
  struct Coat {
    float share;
    Bsdf bsdf;
    Frame frame;
  };
  struct Sheen {
    glm::vec3 color;
    float roughness;
  };

  float sheenProbability(glm::vec3 v) const;
  glm::vec3 directFromSheen(glm::vec3 v, float probability, const LightSample& light) const;
  BsdfSample sampleSheen(glm::vec3 v, float probability, SampleSequence& samples) const;

  Bsdf surface_;
  Frame frame_;
  std::optional<Sheen> sheen_;
  std::optional<Coat> coat_;
};

}  // namespace mirrorball
