#include "quality/scenes.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "mirrorball/scene/shapes/revolution.h"
#include "quality/scene_parts.h"

namespace mirrorball::quality {
namespace {

/// A curtain in deep folds, that hangs to the ground.
Scene cloth() {
  Scene scene;
  add(scene, ground(3.0f), matt({0.5f, 0.45f, 0.4f}));
  Mesh curtain = rectangle({0, 1, 0}, {1.4f, 0, 0}, {0, 1, 0}, 64);
  for (Vertex& vertex : curtain.vertices) {
    const float fold = vertex.position.x * 9.0f + 0.5f * std::sin(2.0f * vertex.position.y);
    vertex.position.z += 0.28f * std::sin(fold) * (1.1f - 0.3f * vertex.position.y);
    vertex.position.x += 0.06f * std::cos(fold);
  }
  computeNormals(curtain);
  Material velvet = *materialNamed("velvet");
  velvet.double_sided = true;
  add(scene, std::move(curtain), velvet);
  return scene;
}

/// The outside of a bottle, or its inside when it is narrower.
std::vector<ProfilePoint> bottleProfile(double narrower) {
  const double body = 0.55 - narrower;
  const double neck = 0.2 - narrower;
  std::vector<ProfilePoint> profile{{{0.0, 2.2 - narrower}, profile::kUp},
                                    {{neck, 2.2 - narrower}, profile::kUp},
                                    {{neck, 2.2 - narrower}, profile::kOut},
                                    {{neck, 1.7}, profile::kOut}};
  addArc(profile, {body - 0.25, 1.15}, 0.25, 60.0, 0.0, 6);
  profile.insert(
      profile.end(),
      {{{body, narrower}, profile::kOut}, {{body, narrower}, profile::kDown}, {{0.0, narrower}, profile::kDown}});
  return profile;
}

/// Bottles of long triangles: of green glass with a cap of metal, and of plastic.
Scene bottles() {
  Scene scene;
  add(scene, ground(3.0f), matt({0.6f, 0.5f, 0.4f}));
  const auto standing = [](Mesh mesh, float x) {
    for (Vertex& vertex : mesh.vertices) vertex.position.x += x;
    return mesh;
  };
  Material glass = *materialNamed("glass");
  glass.dispersion = 0.0f;
  glass.attenuation_color = {0.2f, 0.7f, 0.3f};
  glass.attenuation_distance = 0.8f;
  add(scene, standing(revolvedMesh(bottleProfile(0.0), 32), -0.75f), glass);
  add(scene, ball({-0.75f, 2.3f, 0.0f}, 0.25f), *materialNamed("rough-metal"));
  add(scene, standing(revolvedMesh(bottleProfile(0.0), 32), 0.75f), matt({0.8f, 0.25f, 0.1f}, 0.3f));
  return scene;
}

/// A thin pane, a thick slab and a frosted one, each in front of half of a striped board.
Scene panes() {
  Scene scene;
  add(scene, ground(3.0f), matt({0.6f, 0.6f, 0.6f}));
  for (int stripe = 0; stripe < 6; ++stripe)
    add(scene, box({0.0f, 0.2f + 0.3f * static_cast<float>(stripe), -0.5f}, {1.8f, 0.15f, 0.05f}),
        matt(stripe % 2 == 0 ? glm::vec3(0.8f, 0.2f, 0.1f) : glm::vec3(0.1f, 0.3f, 0.7f)));
  Material thick = *materialNamed("glass");
  thick.dispersion = 0.0f;
  thick.attenuation_color = {0.6f, 0.9f, 0.8f};
  thick.attenuation_distance = 0.5f;
  Material thin = thick;
  thin.thin_walled = true;
  Material frosted = thick;
  frosted.perceptual_roughness = 0.3f;
  add(scene, rectangle({-1.2f, 0.7f, 0.2f}, {0.45f, 0, 0}, {0, 0.7f, 0}), thin);
  add(scene, box({0.0f, 0.7f, 0.2f}, {0.45f, 0.69f, 0.15f}), thick);
  add(scene, box({1.2f, 0.7f, 0.2f}, {0.45f, 0.69f, 0.15f}), frosted);
  return scene;
}

/// Sixteen lamps of four strengths and colours in front of a board.
Scene lamps() {
  Scene scene;
  add(scene, rectangle({0, 0, -0.15f}, {1.3f, 0, 0}, {0, 1.3f, 0}, 8), matt(glm::vec3(0.8f)));
  constexpr std::array<glm::vec3, 4> kColors{
      glm::vec3(1.0f, 0.25f, 0.1f), {0.2f, 0.9f, 0.3f}, {0.2f, 0.4f, 1.0f}, glm::vec3(1.0f)};
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      Material lamp = matt(glm::vec3(0.05f));
      lamp.emission = kColors[static_cast<std::size_t>(row)] * 0.5f * std::exp2(static_cast<float>(column));
      add(scene,
          box(glm::vec3(0.6f * static_cast<float>(column) - 0.9f, 0.9f - 0.6f * static_cast<float>(row), 0.05f),
              glm::vec3(0.15f)),
          lamp);
    }
  return scene;
}

/// The corner of a room of three large planes, coloured at their corners, with a white ball and a box.
Scene room() {
  Scene scene;
  const auto painted = [](Mesh mesh, glm::vec3 first, glm::vec3 second) {
    for (Vertex& vertex : mesh.vertices) vertex.color = glm::vec4(glm::mix(first, second, vertex.uv[0].y), 1.0f);
    return mesh;
  };
  const Material white = matt(glm::vec3(0.9f));
  add(scene, painted(ground(1.5f), {0.8f, 0.7f, 0.2f}, {0.9f, 0.9f, 0.9f}), white);
  add(scene, painted(rectangle({0, 1.5f, -1.5f}, {1.5f, 0, 0}, {0, 1.5f, 0}), {0.2f, 0.5f, 0.9f}, {0.7f, 0.8f, 0.9f}),
      white);
  add(scene, painted(rectangle({-1.5f, 1.5f, 0}, {0, 0, -1.5f}, {0, 1.5f, 0}), {0.9f, 0.3f, 0.2f}, {0.9f, 0.8f, 0.7f}),
      white);
  add(scene, ball({0.4f, 0.5f, 0.3f}, 0.5f), white);
  add(scene, box({-0.8f, 0.4f, -0.6f}, {0.4f, 0.4f, 0.4f}), white);
  return scene;
}

/// Boxes with small print, stacked on a table.
Scene labels() {
  Scene scene;
  scene.textures.push_back(smallText());
  Material label = matt(glm::vec3(1.0f), 0.35f);
  label.base_color_map.texture = 0;
  add(scene, ground(3.0f), matt({0.35f, 0.25f, 0.2f}, 0.4f));
  add(scene, box({-0.55f, 0.5f, 0.0f}, glm::vec3(0.5f)), label);
  add(scene, box({0.55f, 0.5f, 0.1f}, glm::vec3(0.5f)), label);
  add(scene, box({0.0f, 1.4f, 0.0f}, glm::vec3(0.4f)), label);
  return scene;
}

/// Leaves, cut out of rectangles, over a table.
Scene leaves() {
  Scene scene;
  scene.textures.push_back(leaf());
  Material cut = matt(glm::vec3(1.0f), 0.5f);
  cut.base_color_map.texture = 0;
  cut.alpha_mode = AlphaMode::mask;
  cut.double_sided = true;
  add(scene, ground(2.0f), matt({0.7f, 0.65f, 0.6f}));
  for (int each = 0; each < 9; ++each) {
    const float turned = 2.4f * static_cast<float>(each);
    const glm::vec3 out(std::cos(turned), 0.0f, std::sin(turned));
    const glm::vec3 side(-out.z, 0.0f, out.x);
    const float height = 0.25f + 0.1f * static_cast<float>(each);
    add(scene, rectangle(0.55f * out + glm::vec3(0, height, 0), 0.5f * side, 0.6f * out + glm::vec3(0, 0.3f, 0)), cut);
  }
  return scene;
}

/// Balls of metal and of plastic, of four roughnesses, before a board.
Scene balls() {
  Scene scene;
  add(scene, ground(3.0f), matt({0.5f, 0.5f, 0.5f}, 0.5f));
  add(scene, box({0.0f, 1.0f, -0.8f}, {2.2f, 1.0f, 0.1f}), matt({0.3f, 0.5f, 0.2f}));
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 2; ++row) {
      Material material = matt({0.9f, 0.6f, 0.4f}, 0.05f + 0.25f * static_cast<float>(column));
      material.metallic = row == 0 ? 0.0f : 1.0f;
      add(scene, ball({1.0f * static_cast<float>(column) - 1.5f, 0.45f + 0.95f * static_cast<float>(row), 0.0f}, 0.42f),
          material);
    }
  return scene;
}

/// A table under a polished clear coat, with a lamp, a ball and a board on it.
Scene coat() {
  Scene scene;
  Material table = matt({0.6f, 0.1f, 0.05f}, 0.6f);
  table.clearcoat = 1.0f;
  table.clearcoat_roughness = 0.0f;
  add(scene, ground(2.0f), table);
  Material lamp = matt(glm::vec3(0.05f));
  lamp.emission = glm::vec3(1.5f, 1.2f, 0.8f);
  add(scene, ball({-0.7f, 0.6f, 0.0f}, 0.35f), lamp);
  add(scene, ball({0.1f, 0.4f, 0.3f}, 0.4f), matt({0.1f, 0.2f, 0.7f}));
  add(scene, box({0.9f, 0.6f, -0.1f}, {0.05f, 0.6f, 0.4f}), matt({0.7f, 0.7f, 0.6f}));
  return scene;
}

/// A basin of still water, in which a board, a ball and a lamp at its far side are mirrored.
Scene basin() {
  Scene scene;
  add(scene, ground(3.0f), matt(glm::vec3(0.1f)));
  Material water = *materialNamed("water");
  water.dispersion = 0.0f;
  add(scene, box({0.0f, 0.11f, 0.3f}, {1.4f, 0.1f, 1.0f}), water);
  add(scene, box({-0.8f, 0.7f, -1.0f}, {0.4f, 0.7f, 0.05f}), matt({0.8f, 0.3f, 0.1f}));
  add(scene, ball({0.15f, 0.55f, -1.1f}, 0.35f), *materialNamed("gold"));
  Material lamp = matt(glm::vec3(0.05f));
  lamp.emission = glm::vec3(1.5f, 1.2f, 0.8f);
  add(scene, ball({0.9f, 0.9f, -1.1f}, 0.2f), lamp);
  return scene;
}

constexpr auto kScenes = std::to_array<SampleScene>({
    {"cloth", "SheenChair, SheenCloth", cloth, "-e studio --camera 35,8", 32.6, 38.3},
    {"bottles", "WaterBottle, IridescentDishWithOlives", bottles, "-e studio --camera 20,15", 27.5, 31.4},
    {"panes", "TransmissionTest, CompareVolume, GlassHurricaneCandleHolder", panes, "-e studio --camera 15,12", 22.7,
     31.9},
    {"basin", "CompareIor, TransmissionTest", basin, "-e studio --camera 12,14,1.3 --target 0,0.4,-0.2 --fov 40", 23.1,
     27.0},
    {"lamps", "EmissiveStrengthTest, CompareEmissiveStrength", lamps, "-e studio --camera 25,15", 22.6, 29.1},
    {"room", "VertexColorTest, BoxVertexColors", room, "-e studio --camera 40,25", 18.8, 24.4},
    {"labels", "BoomBox, TextureSettingsTest", labels, "-e studio --camera 30,20", 34.3, 36.3},
    {"leaves", "AlphaBlendModeTest, DiffuseTransmissionPlant", leaves, "-e studio --camera 30,40", 25.2, 32.5},
    {"leaves_below", "AlphaBlendModeTest, DiffuseTransmissionPlant", leaves, "-e studio --camera 30,-35", 34.8, 42.4},
    {"balls", "MetalRoughSpheres, EnvironmentTest", balls, "-e studio --camera 10,12", 24.2, 31.6},
    {"coat", "ClearCoatTest, ClearCoatCarPaint", coat, "-e studio --env-intensity 0.3 --camera 20,20", 27.9, 35.7},
});

}  // namespace

std::span<const SampleScene> sampleScenes() { return kScenes; }

Result<std::filesystem::path> writeScene(const SampleScene& scene, const std::filesystem::path& folder) {
  return writeGlb(scene.make(), scene.name, folder);
}

}  // namespace mirrorball::quality
