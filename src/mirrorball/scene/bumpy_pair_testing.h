#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include "mirrorball/height_field/slopes.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball::testing {

// Hills on two squares side by side, on the right one mirrored: [−1, 1] × [−½, ½] in the plane z = 0, facing +Z. u
// grows to the right on the left square and to the left on the right one, v downwards on both, so that the hills meet.

/// How a material is told of the hills.
enum class BumpForm { heights, normal_map, derivative_map };
inline constexpr BumpForm kEveryBumpForm[] = {BumpForm::heights, BumpForm::normal_map, BumpForm::derivative_map};

constexpr float kHillHeight = 0.1f;  // in texture widths, which are 1 long

/// A tile of heights from 0 to 1 that no turning or mirroring leaves as it is.
inline float hillAt(glm::vec2 uv) {
  const glm::vec2 angle = glm::two_pi<float>() * uv;
  return 0.5f + 0.25f * std::sin(angle.x) + 0.25f * std::sin(angle.x + angle.y);
}

inline Image hills(int side = 64) {
  Image heights(side, side, 1);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) heights.texel(x, y)[0] = hillAt((glm::vec2(x, y) + 0.5f) / static_cast<float>(side));
  return heights;
}

inline glm::vec2 uvOfPair(glm::vec2 place) { return {1.0f - std::abs(place.x), 0.5f - place.y}; }

/// The normal that the hills have there.
inline glm::vec3 normalOfPair(glm::vec2 place) {
  const auto height = [](glm::vec2 p) { return kHillHeight * hillAt(uvOfPair(p)); };
  constexpr float kStep = 1e-3f;
  const float d_x = height(place + glm::vec2(kStep, 0.0f)) - height(place - glm::vec2(kStep, 0.0f));
  const float d_y = height(place + glm::vec2(0.0f, kStep)) - height(place - glm::vec2(0.0f, kStep));
  return glm::normalize(glm::vec3(-d_x, -d_y, 2.0f * kStep));
}

inline Mesh mirroredPair() {
  Mesh mesh;
  for (const float side : {-1.0f, 1.0f}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const glm::vec2 left_right = side < 0.0f ? glm::vec2(-1.0f, 0.0f) : glm::vec2(0.0f, 1.0f);
    for (const float y : {0.5f, -0.5f})
      for (const float x : {left_right.x, left_right.y}) {
        Vertex vertex;
        vertex.position = glm::vec3(x, y, 0.0f);
        vertex.normal = glm::vec3(0.0f, 0.0f, 1.0f);
        vertex.tangent = glm::vec4(-side, 0.0f, 0.0f, -side);  // whose bitangent goes up on both
        vertex.uv[0] = vertex.uv[1] = uvOfPair(glm::vec2(x, y));
        mesh.vertices.push_back(vertex);
      }
    for (const std::uint32_t corner : {0u, 2u, 3u, 0u, 3u, 1u}) mesh.indices.push_back(first + corner);
  }
  return mesh;
}

/// Unit normals as a texture of ½ + ½ n.
inline Texture textureOfNormals(const Image& normals) {
  Texture texture;
  texture.image = Image8(normals.width(), normals.height(), 4, 255);
  for (int y = 0; y < normals.height(); ++y)
    for (int x = 0; x < normals.width(); ++x)
      for (int channel = 0; channel < 3; ++channel)
        texture.image.edit().texel(x, y)[channel] =
            static_cast<std::uint8_t>(std::lround(255.0f * (0.5f + 0.5f * normals.texel(x, y)[channel])));
  return texture;
}

/// A mesh with a material, to which bumps are added.
///
/// heights   of a tile that is 1 long on the mesh
/// depth     of a height of 1
inline Scene bumpyScene(Mesh mesh, BumpForm form, Material material, Image heights, float depth) {
  const HeightFieldSettings settings{.scale = depth};
  switch (form) {
    case BumpForm::heights: {
      material.height = HeightKind::map;
      material.height_texture = 0;
      material.height_scale = depth;
      material.height_frequency = 1.0f;
      Scene scene = meshScene(std::move(mesh), std::move(material));
      scene.height_textures.push_back(*heightTexture(std::move(heights), MapEdges::tiled));
      return scene;
    }
    case BumpForm::normal_map: {
      material.normal_map.texture = 0;
      Scene scene = meshScene(std::move(mesh), std::move(material));
      scene.textures.push_back(textureOfNormals(*normalsFromHeights(heights, settings)));
      return scene;
    }
    case BumpForm::derivative_map:
      break;
  }
  material.slope_texture = 0;
  Scene scene = meshScene(std::move(mesh), std::move(material));
  scene.slope_textures.push_back(*derivativesFromHeights(heights, settings));
  return scene;
}

/// The pair with a material, to which the hills are added.
inline Scene bumpyPair(BumpForm form, Material material) {
  return bumpyScene(mirroredPair(), form, std::move(material), hills(), kHillHeight);
}

/// What its normals may be off by: of 8 bits, or of heights between texels.
inline float toleranceOf(BumpForm form) { return form == BumpForm::normal_map ? 0.008f : 0.003f; }

inline std::string nameOf(BumpForm form) {
  return form == BumpForm::heights ? "heights" : form == BumpForm::normal_map ? "normal map" : "derivative map";
}

}  // namespace mirrorball::testing
