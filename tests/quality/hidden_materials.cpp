#include <cmath>
#include <utility>
#include <vector>

#include "formula/constants.h"
#include "mirrorball/scene/shapes/revolution.h"
#include "quality/hidden_makers.h"
#include "quality/scene_parts.h"

namespace mirrorball::quality {
namespace {

Material clearGlass() {
  Material glass = *materialNamed("glass");
  glass.dispersion = 0.0f;
  return glass;
}

/// A beaker on the ground, whose wall and bottom have one thickness.
Mesh beaker(double radius, double height, double thickness) {
  const double inner = radius - thickness;
  const std::vector<ProfilePoint> profile{{{0.0, thickness}, profile::kUp},     {{inner, thickness}, profile::kUp},
                                          {{inner, thickness}, -profile::kOut}, {{inner, height}, -profile::kOut},
                                          {{inner, height}, profile::kUp},      {{radius, height}, profile::kUp},
                                          {{radius, height}, profile::kOut},    {{radius, 0.001}, profile::kOut},
                                          {{radius, 0.001}, profile::kDown},    {{0.0, 0.001}, profile::kDown}};
  return revolvedMesh(profile, 48);
}

/// A closed cylinder on the Y axis.
Mesh cylinder(double radius, double low, double high) {
  const std::vector<ProfilePoint> profile{{{0.0, high}, profile::kUp},     {{radius, high}, profile::kUp},
                                          {{radius, high}, profile::kOut}, {{radius, low}, profile::kOut},
                                          {{radius, low}, profile::kDown}, {{0.0, low}, profile::kDown}};
  return revolvedMesh(profile, 32);
}

void addCandle(Scene& scene) {
  add(scene, cylinder(0.18, 0.03, 0.7), matt({0.85f, 0.8f, 0.7f}, 0.6f));
  Mesh flame = ball({0, 0, 0}, 1.0f, 16);
  for (Vertex& vertex : flame.vertices) {
    const float narrower = 1.0f - 0.5f * std::max(vertex.position.y, 0.0f);
    vertex.position = vertex.position * glm::vec3(0.06f * narrower, 0.14f, 0.06f * narrower) + glm::vec3(0, 0.87f, 0);
  }
  computeNormals(flame);
  Material burning = matt(glm::vec3(0.0f));
  burning.emission = glm::vec3(12.0f, 7.0f, 2.5f);
  add(scene, std::move(flame), burning);
}

/// Normals of a surface that rises and falls along u, `waves` times.
Texture ripples(int waves, float slope) {
  constexpr int kMapSide = 256;
  Texture map{.image = Image8(kMapSide, kMapSide, 4)};
  for (int y = 0; y < kMapSide; ++y)
    for (int x = 0; x < kMapSide; ++x) {
      const float phase = 2.0f * formula::kPi * static_cast<float>(waves) * (static_cast<float>(x) + 0.5f) / kMapSide;
      const glm::vec3 normal = glm::normalize(glm::vec3(-slope * std::cos(phase), 0.0f, 1.0f));
      std::uint8_t* const texel = map.image.edit().texel(x, y);
      for (int channel = 0; channel < 3; ++channel)
        texel[channel] = static_cast<std::uint8_t>(std::lround(127.5f + 127.5f * normal[channel]));
      texel[3] = 255;
    }
  return map;
}

/// A triangle of side 1 that leans back a little.
Mesh triangle() {
  Mesh mesh;
  const glm::vec3 normal = glm::normalize(glm::vec3(0.0f, 0.2f, 1.0f));
  for (const glm::vec2 place : {glm::vec2(-0.5f, 0.0f), {0.5f, 0.0f}, {0.0f, 0.9f}}) {
    Vertex vertex{.position = {place.x, place.y, -0.2f * place.y}, .normal = normal};
    vertex.uv[0] = place;
    mesh.vertices.push_back(vertex);
  }
  mesh.indices = {0, 1, 2};
  return mesh;
}

Scene dielectricBall(float perceptual_roughness) {
  return meshScene(ball({0, 0, 0}, 1.0f, 64), matt({0.7f, 0.15f, 0.1f}, perceptual_roughness));
}

Material sheenOfCloth(glm::vec3 base_color, glm::vec3 sheen_color) {
  Material cloth = matt(base_color, 0.9f);
  cloth.sheen_color = sheen_color;
  cloth.sheen_roughness = 0.5f;
  cloth.double_sided = true;
  return cloth;
}

Material printed(Scene& scene) {
  scene.textures.push_back(smallText());
  Material material = matt(glm::vec3(1.0f), 0.6f);
  material.base_color_map.texture = static_cast<int>(scene.textures.size()) - 1;
  return material;
}

}  // namespace

Scene vesselWithFlame() {
  Scene scene;
  add(scene, ground(1.0f, 16), matt({0.6f, 0.55f, 0.5f}));
  add(scene, beaker(0.5, 1.4, 0.02), clearGlass());
  addCandle(scene);
  return scene;
}

Scene sheetVesselWithFlame() {
  Scene scene;
  add(scene, ground(1.0f, 16), matt({0.6f, 0.55f, 0.5f}));
  const std::vector<ProfilePoint> wall{{{0.5, 1.4}, profile::kOut}, {{0.5, 0.001}, profile::kOut}};
  Material sheet = clearGlass();
  sheet.thin_walled = true;
  sheet.double_sided = true;
  add(scene, revolvedMesh(wall, 48), sheet);
  addCandle(scene);
  return scene;
}

Scene vesselBeforeStripes() {
  Scene scene;
  add(scene, ground(1.4f, 16), matt({0.6f, 0.6f, 0.6f}));
  for (int stripe = 0; stripe < 7; ++stripe)
    add(scene, box({0.0f, 0.12f + 0.24f * static_cast<float>(stripe), -0.75f}, {1.4f, 0.12f, 0.04f}),
        stripe % 2 == 0 ? matt({0.75f, 0.2f, 0.1f}) : matt({0.85f, 0.85f, 0.8f}));
  Material glass = clearGlass();
  glass.attenuation_color = {0.6f, 0.9f, 0.75f};
  glass.attenuation_distance = 0.05f;
  add(scene, beaker(0.5, 1.3, 0.03), glass);
  add(scene, cylinder(0.05, 0.04, 1.6), matt({0.2f, 0.3f, 0.7f}));
  return scene;
}

Scene plainTriangle() { return meshScene(triangle(), roughMetal(glm::vec3(1.0f), 1.0f)); }

Scene dielectricTriangle() { return meshScene(triangle(), matt(glm::vec3(1.0f), 0.5f)); }

Scene dielectricBallSmooth() { return dielectricBall(0.0f); }

Scene dielectricBallGlossy() { return dielectricBall(0.3f); }

Scene dielectricBallRough() { return dielectricBall(0.6f); }

Scene dielectricBallRoughest() { return dielectricBall(1.0f); }

Scene rippledCoat() {
  Scene scene;
  scene.textures.push_back(ripples(12, 0.35f));
  Material table = matt({0.05f, 0.05f, 0.06f}, 0.6f);
  table.clearcoat = 1.0f;
  table.clearcoat_roughness = 0.1f;
  table.clearcoat_normal_map.texture = 0;
  add(scene, ground(1.5f), table);
  add(scene, ball({-0.4f, 0.45f, -0.1f}, 0.45f), matt({0.8f, 0.75f, 0.6f}));
  add(scene, box({0.6f, 0.5f, -0.3f}, {0.2f, 0.5f, 0.2f}), matt({0.75f, 0.2f, 0.15f}));
  return scene;
}

Scene rippledBall() {
  Scene scene;
  scene.textures.push_back(ripples(16, 0.3f));
  Material paint = *materialNamed("car-paint");
  paint.clearcoat_normal_map.texture = 0;
  paint.clearcoat_roughness = 0.05f;
  add(scene, ground(1.2f), matt({0.4f, 0.4f, 0.4f}));
  add(scene, ball({0, 0.8f, 0}, 0.8f, 48), paint);
  return scene;
}

Scene sheenFolds() {
  Scene scene;
  add(scene, ground(1.5f), matt({0.5f, 0.45f, 0.4f}));
  Mesh curtain = rectangle({0, 1, 0}, {1.3f, 0, 0}, {0, 1, 0}, 96);
  for (Vertex& vertex : curtain.vertices) {
    const float fold = 10.0f * vertex.position.x;
    vertex.position.z += 0.3f * std::sin(fold);
    vertex.position.x += 0.05f * std::sin(2.0f * fold);
  }
  computeNormals(curtain);
  add(scene, std::move(curtain), sheenOfCloth({0.15f, 0.15f, 0.35f}, {0.8f, 0.85f, 1.0f}));
  return scene;
}

Scene sheenWaves() {
  Scene scene;
  add(scene, ground(1.4f), matt({0.55f, 0.5f, 0.45f}));
  for (int layer = 0; layer < 3; ++layer) {
    Mesh cloth = rectangle({0, 0.3f + 0.28f * static_cast<float>(layer), 0}, {1.1f, 0, 0}, {0, 0, -0.9f}, 96);
    for (Vertex& vertex : cloth.vertices)
      vertex.position.y += 0.16f * std::sin(8.0f * vertex.position.x + 0.8f * static_cast<float>(layer) +
                                            std::sin(3.0f * vertex.position.z));
    computeNormals(cloth);
    add(scene, std::move(cloth), sheenOfCloth({0.12f, 0.03f, 0.03f}, {0.9f, 0.5f, 0.4f}));
  }
  return scene;
}

Scene print() {
  Scene scene;
  const Material label = printed(scene);
  add(scene, rectangle({0, 0, 0}, {0.5f, 0, 0}, {0, 0.375f, 0}), label);
  return scene;
}

Scene slantedPrint() {
  Scene scene;
  const Material label = printed(scene);
  add(scene, ground(0.8f), label);
  add(scene, ball({0.2f, 0.2f, -0.2f}, 0.2f), matt({0.7f, 0.3f, 0.2f}));
  return scene;
}

}  // namespace mirrorball::quality
