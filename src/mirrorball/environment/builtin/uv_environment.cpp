#include "mirrorball/environment/builtin/uv_environment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <glm/glm.hpp>

#include "formula/projection.h"

namespace mirrorball {
namespace {

/// A straight stroke of a letter, in a box from (−½, −½) to (½, ½), y up.
struct Stroke {
  glm::vec2 from;
  glm::vec2 to;
};

constexpr std::array<Stroke, 2> kPlus{{{{-0.4f, 0.0f}, {0.4f, 0.0f}}, {{0.0f, -0.4f}, {0.0f, 0.4f}}}};
constexpr std::array<Stroke, 1> kMinus{{{{-0.4f, 0.0f}, {0.4f, 0.0f}}}};
constexpr std::array<Stroke, 2> kX{{{{-0.4f, -0.5f}, {0.4f, 0.5f}}, {{-0.4f, 0.5f}, {0.4f, -0.5f}}}};
constexpr std::array<Stroke, 3> kY{
    {{{-0.4f, 0.5f}, {0.0f, 0.0f}}, {{0.4f, 0.5f}, {0.0f, 0.0f}}, {{0.0f, 0.0f}, {0.0f, -0.5f}}}};
constexpr std::array<Stroke, 3> kZ{
    {{{-0.4f, 0.5f}, {0.4f, 0.5f}}, {{0.4f, 0.5f}, {-0.4f, -0.5f}}, {{-0.4f, -0.5f}, {0.4f, -0.5f}}}};

/// A face: its axis, which way is up for the reader, its colour and its name.
struct LabelledFace {
  glm::vec3 axis;
  glm::vec3 up;
  glm::vec3 color;
  std::span<const Stroke> sign;
  std::span<const Stroke> letter;
};

// Up is +Y on the four walls. Looking along +Z, a reader who tilts the head back to +Y has −Z above, and forward to −Y
// has +Z above.
const std::array<LabelledFace, 6> kFaces{{
    {{1, 0, 0}, {0, 1, 0}, {0.80f, 0.10f, 0.08f}, kPlus, kX},
    {{-1, 0, 0}, {0, 1, 0}, {0.05f, 0.60f, 0.62f}, kMinus, kX},
    {{0, 1, 0}, {0, 0, -1}, {0.12f, 0.60f, 0.10f}, kPlus, kY},
    {{0, -1, 0}, {0, 0, 1}, {0.62f, 0.10f, 0.55f}, kMinus, kY},
    {{0, 0, 1}, {0, 1, 0}, {0.08f, 0.16f, 0.75f}, kPlus, kZ},
    {{0, 0, -1}, {0, 1, 0}, {0.75f, 0.58f, 0.05f}, kMinus, kZ},
}};

float distanceTo(const Stroke& stroke, glm::vec2 p) {
  const glm::vec2 along = stroke.to - stroke.from;
  const float share = glm::clamp(glm::dot(p - stroke.from, along) / glm::dot(along, along), 0.0f, 1.0f);
  return glm::length(p - stroke.from - share * along);
}

/// Whether p lies on a glyph of that height centred at `center`.
bool onGlyph(std::span<const Stroke> strokes, glm::vec2 center, float height, glm::vec2 p) {
  const glm::vec2 inside = (p - center) / height;
  return std::any_of(strokes.begin(), strokes.end(),
                     [&](const Stroke& stroke) { return distanceTo(stroke, inside) < 0.09f; });
}

/// A small triangle near the upper edge, its tip towards the edge.
bool onUpMark(glm::vec2 p) {
  const float below_tip = 0.88f - p.y;
  return below_tip > 0.0f && below_tip < 0.14f && std::abs(p.x) < below_tip * 0.6f;
}

bool onGrid(glm::vec2 p) {
  const glm::vec2 cell = glm::abs(glm::fract(p * 4.0f + 0.5f) - 0.5f);
  return std::min(cell.x, cell.y) < 0.02f || std::max(std::abs(p.x), std::abs(p.y)) > 0.98f;
}

}  // namespace

glm::vec3 uvRadiance(glm::vec3 direction) {
  const LabelledFace& face = kFaces[static_cast<std::size_t>(formula::cubeFace(direction))];
  const glm::vec3 right = glm::cross(face.axis, face.up);
  const float depth = glm::dot(direction, face.axis);
  const glm::vec2 p = glm::vec2(glm::dot(direction, right), glm::dot(direction, face.up)) / depth;
  if (onGlyph(face.sign, {-0.34f, 0.0f}, 0.62f, p) || onGlyph(face.letter, {0.30f, 0.0f}, 0.80f, p) || onUpMark(p))
    return glm::vec3(0.95f);
  return onGrid(p) ? face.color * 0.45f : face.color;
}

}  // namespace mirrorball
