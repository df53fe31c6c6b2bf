#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "mirrorball/scene/shapes/revolution.h"
#include "quality/hidden_makers.h"
#include "quality/scene_parts.h"

namespace mirrorball::quality {
namespace {

const glm::vec3 kSteel(0.75f, 0.75f, 0.77f), kBrass(0.9f, 0.7f, 0.35f);

/// A body of plates: outer radius and upper height of each, from above down to the ground, with level steps between.
Mesh steppedBody(std::span<const glm::dvec2> steps, int segments) {
  std::vector<ProfilePoint> profile{{{0.0, steps.front().y}, profile::kUp},
                                    {{steps.front().x, steps.front().y}, profile::kUp}};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool is_last = i + 1 == steps.size();
    const double low = is_last ? 0.0 : steps[i + 1].y;
    profile.push_back({{steps[i].x, steps[i].y}, profile::kOut});
    profile.push_back({{steps[i].x, low}, profile::kOut});
    const double next = is_last ? 0.0 : steps[i + 1].x;
    const glm::dvec2 normal = next > steps[i].x ? profile::kUp : profile::kDown;
    profile.push_back({{steps[i].x, low}, normal});
    profile.push_back({{next, low}, normal});
  }
  return revolvedMesh(profile, segments);
}

}  // namespace

Scene neck() {
  Scene scene;
  add(scene, ground(1.2f), matt({0.5f, 0.5f, 0.5f}));
  constexpr std::array<glm::dvec2, 5> kSteps{{{0.7, 1.7}, {0.22, 1.55}, {0.75, 1.0}, {0.3, 0.75}, {0.8, 0.25}}};
  add(scene, steppedBody(kSteps, 48), roughMetal(kSteel, 0.4f));
  return scene;
}

Scene grooves() {
  Scene scene;
  add(scene, ground(1.1f), matt({0.45f, 0.45f, 0.5f}));
  std::vector<glm::dvec2> steps;
  for (int i = 0; i < 15; ++i) steps.emplace_back(i % 2 == 0 ? 0.7 : 0.5, 1.5 - 0.1 * i);
  add(scene, steppedBody(steps, 64), roughMetal(kBrass, 0.35f));
  return scene;
}

Scene roughCorner() {
  Scene scene;
  const Material steel = roughMetal(kSteel, 0.4f);
  add(scene, ground(1.0f), steel);
  add(scene, rectangle({0, 1, -1}, {1, 0, 0}, {0, 1, 0}), roughMetal(kBrass, 0.3f));
  add(scene, rectangle({-1, 1, 0}, {0, 0, -1}, {0, 1, 0}), steel);
  add(scene, box({-0.1f, 0.35f, -0.1f}, {0.35f, 0.35f, 0.35f}), matt({0.8f, 0.25f, 0.15f}, 0.4f));
  return scene;
}

Scene rowOfNeighbours() {
  Scene scene;
  add(scene, ground(1.5f), matt({0.6f, 0.55f, 0.5f}));
  constexpr std::array<glm::vec3, 3> kCovers{glm::vec3(0.75f, 0.2f, 0.15f), {0.2f, 0.35f, 0.65f}, {0.8f, 0.75f, 0.6f}};
  for (int i = 0; i < 9; ++i) {
    const float height = 0.55f + 0.05f * static_cast<float>((5 * i) % 4);
    add(scene, box({0.28f * static_cast<float>(i - 4), height, 0.0f}, {0.09f, height, 0.5f}),
        matt(kCovers[static_cast<std::size_t>(i) % kCovers.size()], 0.5f));
  }
  return scene;
}

Scene rowOfBars() {
  Scene scene;
  add(scene, ground(1.5f), matt({0.4f, 0.4f, 0.4f}));
  for (int i = 0; i < 7; ++i)
    add(scene, box({0.36f * static_cast<float>(i - 3), 0.6f, 0.0f}, {0.12f, 0.6f, 0.45f}), roughMetal(kSteel, 0.45f));
  return scene;
}

Scene housing() {
  Scene scene;
  add(scene, ground(1.2f), matt({0.6f, 0.6f, 0.6f}));
  const Material black = matt(glm::vec3(0.03f), 0.35f);
  add(scene, box({0, 0.05f, 0}, {0.9f, 0.05f, 0.5f}), black);
  add(scene, box({0, 1.15f, 0}, {0.9f, 0.05f, 0.5f}), black);
  add(scene, box({-0.85f, 0.6f, 0}, {0.05f, 0.5f, 0.5f}), black);
  add(scene, box({0.85f, 0.6f, 0}, {0.05f, 0.5f, 0.5f}), black);
  add(scene, box({0, 0.6f, -0.45f}, {0.8f, 0.5f, 0.05f}), black);
  add(scene, ball({-0.4f, 0.4f, 0.0f}, 0.3f), matt(glm::vec3(0.05f), 0.3f));
  add(scene, box({0.35f, 0.45f, -0.1f}, {0.15f, 0.35f, 0.2f}), roughMetal(kSteel, 0.35f));
  return scene;
}

Scene pipe() {
  Scene scene;
  // Down the outer wall and up the inner one, which closes at the upper rim.
  const std::vector<ProfilePoint> profile{{{0.6, 1.6}, profile::kUp},   {{0.7, 1.6}, profile::kUp},
                                          {{0.7, 1.6}, profile::kOut},  {{0.7, 0.0}, profile::kOut},
                                          {{0.7, 0.0}, profile::kDown}, {{0.6, 0.0}, profile::kDown},
                                          {{0.6, 0.0}, -profile::kOut}, {{0.6, 1.6}, -profile::kOut}};
  add(scene, revolvedMesh(profile, 48), roughMetal(kSteel, 0.35f));
  add(scene, ground(1.4f), matt({0.7f, 0.35f, 0.2f}));
  return scene;
}

Scene zigzag() {
  Scene scene;
  add(scene, ground(1.4f), matt({0.6f, 0.6f, 0.6f}));
  Material paper = matt({0.85f, 0.82f, 0.75f}, 0.8f);
  paper.double_sided = true;
  constexpr int kFolds = 14;
  constexpr float kHalfStep = 0.08f, kHalfDepth = 0.3f;
  for (int i = 0; i < kFolds; ++i) {
    const float side = i % 2 == 0 ? 1.0f : -1.0f;
    const glm::vec3 middle(2.0f * kHalfStep * (static_cast<float>(i) - 0.5f * (kFolds - 1)), 0.7f, 0.0f);
    add(scene, rectangle(middle, {kHalfStep, 0, side * kHalfDepth}, {0, 0.7f, 0}), paper);
  }
  return scene;
}

}  // namespace mirrorball::quality
