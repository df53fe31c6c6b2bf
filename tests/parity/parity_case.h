#pragma once

#include <span>
#include <string_view>
#include <vector>

#include <glm/vec4.hpp>

namespace mirrorball::parity {

/// What a formula is evaluated at. The third vector is always in [0, 1]⁴.
struct Input {
  glm::vec4 p;
  glm::vec4 q;
  glm::vec4 r;
};

enum class Domain {
  unit,       ///< p and q in [0, 1]⁴
  direction,  ///< p.xyz and q.xyz unit vectors, p.w and q.w in [0, 1]
  light,      ///< p and q radiances from 0 and 2⁻¹⁴ to 2¹⁴
};

/// The inputs of a domain: its corners and middles first, then pseudo-random ones, always the same.
/// Numbers have at most 20 bits, so that a scaling by a power of two and a shift are exact.
std::vector<Input> inputsOf(Domain domain);

/// One formula as it is called on both sides.
struct Case {
  std::string_view function;
  Domain domain;
  float tolerance;        ///< of |C++ − GLSL| ≤ tolerance · max(1, |C++|), for each component
  std::string_view glsl;  ///< an expression over p, q and r of type vec4
  glm::vec4 (*cpp)(glm::vec4 p, glm::vec4 q, glm::vec4 r);  ///< the same one
};

std::span<const Case> allCases();

/// Those of them that are of surfaces and bodies.
std::span<const Case> surfaceCases();

/// Those of them that are of built-in heights.
std::span<const Case> reliefCases();

}  // namespace mirrorball::parity
