#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/material/material.h"

namespace mirrorball {

/// The lecture's form of Fresnel's law, offset + scale (1 − cos θ)^power, and how far it is from a curve.
struct EmpiricalFit {
  float offset = 0.0f;
  float scale = 1.0f;
  float power = 5.0f;
  float greatest_error = 0.0f;  ///< over all angles
};

/// The empirical form whose greatest error over all angles is the least.
///
/// reflectance  of cos θ in [0, 1], in [0, 1]
/// returns      within the ranges of the material's parameters fresnel_offset, _scale and _power
/// cost         some 300 000 evaluations of the form, about 10 ms
/// from         Chebyshev's criterion: for one power the form is a line over (1 − cos θ)^power
EmpiricalFit fitEmpirical(const std::function<float(float cosine)>& reflectance);

/// A form of Fresnel's law.
enum class FresnelForm { exact, schlick, f82, empirical };
inline constexpr std::array<std::string_view, 4> kFresnelFormNames{"exact", "schlick", "f82", "empirical"};

/// One index of refraction n + ik, by each form: the three approximations with the parameters that suit it best.
struct FresnelCurves {
  std::string name;            ///< "red" of a metal; empty: a dielectric's, the same in all channels
  float n = 1.0f;              ///< of the inside over the outside
  float k = 0.0f;              ///< 0: a dielectric
  float f0 = 0.0f;             ///< the reflectance at normal incidence, of Schlick's form and F82
  float f82_tint = 1.0f;       ///< with which F82 meets the exact curve at cos θ = 1/7, or comes nearest
  EmpiricalFit empirical{};    ///< the best fit
  float schlick_error = 0.0f;  ///< greatest over all angles
  float f82_error = 0.0f;

  /// cosine   of the angle of incidence, in [0, 1]
  /// returns  in [0, 1]
  float reflectance(FresnelForm form, float cosine) const;

  /// The same of an angle of incidence in [0, 90] degrees.
  float reflectanceAtAngle(FresnelForm form, int degrees) const;
};

/// The curves of a dielectric's index at 588 nm, or of a metal's in each channel.
///
/// errors   usage: a metal that has only a colour, or a `material` that is partly metal
Result<std::vector<FresnelCurves>> fresnelCurves(const Material& material);

/// The curves as a file .svg: a plot for each index, reflectance over the angle of incidence.
///
/// title    of the plots, a text of any letters
std::string fresnelPlotOf(const std::vector<FresnelCurves>& curves, const std::string& title);

}  // namespace mirrorball
