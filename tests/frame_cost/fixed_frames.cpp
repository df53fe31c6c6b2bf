#include "frame_cost/fixed_frames.h"

#include <string>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/rays/occlusion_cache.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball::testing {
namespace {

Result<Scene> ballOf(std::string_view material) {
  MIRRORBALL_TRY(made, materialNamed(std::string(material)));
  return meshScene(sphereMesh(64, 128), made);
}

Result<Scene> cobbledPlane() {
  Material material;
  material.height = HeightKind::cobbles;
  material.perceptual_roughness = 0.4f;
  return meshScene(planeMesh(), material);
}

/// Four channels of noise, whose mip levels and neighbours all differ.
Texture noise(int side, unsigned seed, bool srgb) {
  Texture texture{.image = Image8(side, side, 4), .srgb = srgb};
  unsigned state = seed;
  for (std::uint8_t& sample : texture.image.edit().samples()) {
    state = state * 1664525u + 1013904223u;
    sample = static_cast<std::uint8_t>(100 + (state >> 26));
  }
  return texture;
}

/// Five meshes of 19 000 triangles, each with three textures of its own.
Result<Scene> helmetLikeLoad() {
  Scene scene;
  for (int part = 0; part < 5; ++part) {
    Material material;
    material.metallic = part % 2 == 0 ? 1.0f : 0.0f;
    const auto addTexture = [&](bool srgb) {
      scene.textures.push_back(noise(512, 7919u * static_cast<unsigned>(scene.textures.size() + 1), srgb));
      return static_cast<int>(scene.textures.size()) - 1;
    };
    material.base_color_map.texture = addTexture(true);
    material.normal_map.texture = addTexture(false);
    material.roughness_map.texture = material.metallic_map.texture = addTexture(false);
    Mesh mesh = sphereMesh(70, 140);
    mesh.material = part;
    const glm::mat4 place = glm::translate(glm::mat4(1.0f), glm::vec3(0.5f * float(part) - 1.0f, 0.0f, 0.0f));
    scene.instances.push_back({part, glm::scale(place, glm::vec3(0.5f))});
    scene.meshes.push_back(std::move(mesh));
    scene.materials.push_back(std::move(material));
  }
  return scene;
}

Result<Scene> showcaseThatSeesItself() {
  MIRRORBALL_TRY(scene, loadModel("showcase"));
  MIRRORBALL_TRY_VOID(findOcclusionOnce(scene, {.rays = 16, .finds_materials = true}, {}));
  return scene;
}

}  // namespace

std::span<const FixedFrame> fixedFrames() {
  static const std::vector<FixedFrame> frames{
      {"mirror", "studio", [] { return ballOf("mirror"); }, {}},
      {"rough metal", "studio", [] { return ballOf("rough-metal"); }, {}},
      {"glass", "studio", [] { return ballOf("glass"); }, {{"refraction", "image-space"}}},
      {"relief", "studio", cobbledPlane, {{"relief", "exact"}, {"camera", "30,45,1.5"}}},
      {"helmet-like load", "studio", helmetLikeLoad, {}},
      {"small showcase",
       "studio",
       showcaseThatSeesItself,
       {{"refraction", "auto"}, {"behind", "screen"}, {"self-reflection", "yes"}, {"occlusion", "vertex"}}},
  };
  return frames;
}

Result<Renderer> rendererOf(const FixedFrame& frame, FrameSettings& settings) {
  settings.size = {240, 135};
  settings.samples = 2;
  for (const auto& [name, value] : frame.options) set(settings, name, value);
  MIRRORBALL_TRY(scene, frame.scene());
  MIRRORBALL_TRY(environment, builtinEnvironment(std::string(frame.environment)));
  MIRRORBALL_TRY(renderer, Renderer::headless());
  MIRRORBALL_TRY_VOID(renderer.setEnvironment(std::move(environment)));
  MIRRORBALL_TRY_VOID(prepareRelief(scene, settings.relief));
  MIRRORBALL_TRY_VOID(renderer.setScene(std::move(scene)));
  return renderer;
}

}  // namespace mirrorball::testing
