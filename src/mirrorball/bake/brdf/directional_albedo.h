#pragma once

#include "mirrorball/bake/prefilter/lobe.h"

namespace mirrorball {

/// How much of a white environment's light a rough surface reflects towards an eye, by single scattering and with
/// Schlick's Fresnel: f0 · scale + bias, f0 being the reflectance at normal incidence.
struct DirectionalAlbedo {
  float scale = 0.0f;
  float bias = 0.0f;
  float tilt = 0.0f;  ///< the same with 1 − cosine in place of Schlick's term, the cosine being that of a facet

  /// Of a surface whose facets reflect all.
  float total() const { return scale + bias; }
  /// 1 − the cosine at which Schlick's term (1 − cosine)⁵ is its mean over the facets; in [0, 1].
  float grazing() const;
  /// The mean of 1 − cosine over the facets; in [0, 1].
  float meanTilt() const;
};

/// The two integrals of the split sum, ∫ D V (1 − Fc) n·l dl and ∫ D V Fc n·l dl with Fc = (1 − v·h)⁵, and a third with
/// 1 − v·h in place of Fc.
///
/// distribution         ggx with Smith's masking and shadowing correlated by height (Heitz 2014, eq. 99), V = G2 / (4
///                      n·v n·l); blinn with Walter's fit of Smith's for its exponent, correlated alike; phong is taken
///                      for the blinn lobe as wide; charlie with V = 1 / (4 (n·l + n·v − n·l n·v)) and no Fresnel, so
///                      that all is scale and a cloth of sheen colour f0 reflects f0 · scale
/// perceptual_roughness in [0, 1]
/// cosine               n·v in [0, 1]
/// returns              all exact to 5e-5. charlie's is no share of energy: near grazing it passes 1 and grows as
///                      0.4 / perceptual_roughness, since V ignores shadowing
/// cost                 about 1 µs for ggx with AVX2, 10 to 20 µs for the others
/// from                 Karis 2013, "Real shading in Unreal Engine 4"; Walter et al. 2007, eq. 27 and p. 8; Estevez &
///                      Kulla 2017, eq. 2; Neubelt & Pettineo 2013 (V). How it is integrated: directional_albedo.cpp
DirectionalAlbedo directionalAlbedo(Distribution distribution, float perceptual_roughness, float cosine);

/// The mean over all directions of the eye, 2 ∫ total(μ) μ dμ: the albedo of such a surface under white light that
/// Kulla & Conty 2017 need for multiple scattering.
///
/// cost     24 directionalAlbedo
float averageAlbedo(Distribution distribution, float perceptual_roughness);

}  // namespace mirrorball
