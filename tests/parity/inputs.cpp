#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "parity/parity_case.h"

namespace mirrorball::parity {
namespace {

constexpr int kRandomCount = 400;

/// Number `index` of the 3⁴ vectors whose components are of the three values.
glm::vec4 combination(int index, std::array<float, 3> values) {
  glm::vec4 result;
  for (int component = 0; component < 4; ++component) {
    result[component] = values[static_cast<std::size_t>(index % 3)];
    index /= 3;
  }
  return result;
}

class Random {
 public:
  float unit() { return static_cast<float>(generator_() >> 12) / 1048576.0f; }
  glm::vec4 unit4() {
    glm::vec4 result;
    for (int component = 0; component < 4; ++component) result[component] = unit();
    return result;
  }

 private:
  std::mt19937 generator_{20240229};  // the standard fixes its sequence
};

/// A point of [−1, 1]³ as a direction, with a fourth number beside it.
glm::vec4 directionFrom(glm::vec4 cube) {
  const glm::vec3 point(cube);
  const float length = glm::length(point);
  const glm::vec3 d = length == 0.0f ? glm::vec3(0.0f, 0.0f, 1.0f) : point / length;
  return glm::vec4(d, cube.w);
}

float lightFrom(float unit) { return unit == 0.0f ? 0.0f : std::exp2(28.0f * unit - 14.0f); }

/// Takes a vector of [0, 1]⁴ into a domain.
glm::vec4 toDomain(Domain domain, glm::vec4 unit) {
  switch (domain) {
    case Domain::unit:
      return unit;
    case Domain::direction:
      return directionFrom(glm::vec4(2.0f * glm::vec3(unit) - 1.0f, unit.w));
    case Domain::light:
      return glm::vec4(lightFrom(unit.x), lightFrom(unit.y), lightFrom(unit.z), lightFrom(unit.w));
  }
  return unit;
}

}  // namespace

std::vector<Input> inputsOf(Domain domain) {
  std::vector<Input> inputs;
  const auto add = [&](glm::vec4 p, glm::vec4 q, glm::vec4 r) {
    inputs.push_back({toDomain(domain, p), toDomain(domain, q), r});
  };
  constexpr std::array<float, 3> kEdges = {0.0f, 0.5f, 1.0f};
  for (int i = 0; i < 81; ++i) {
    // 7 and 5 have no factor in common with 81: q and r go through all combinations too, but not
    // beside the same ones of p.
    add(combination(i, kEdges), combination((7 * i + 40) % 81, kEdges), combination((5 * i + 13) % 81, kEdges));
  }
  Random random;
  for (int i = 0; i < kRandomCount; ++i) {
    const glm::vec4 p = random.unit4();
    const glm::vec4 q = random.unit4();
    add(p, q, random.unit4());
  }
  return inputs;
}

}  // namespace mirrorball::parity
