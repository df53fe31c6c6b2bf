#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/scene/animation/pose.h"
#include "mirrorball/scene/gltf/gltf.h"
#include "mirrorball/scene/gltf/gltf_testing.h"

namespace mirrorball::testing {

/// A file of the triangle (0,0,0), (1,0,0), (0,1,0), which faces +Z.
struct TriangleFile {
  GltfMaker maker;
  bool has_normals = true;

  TriangleFile() {
    maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    maker.accessor(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  }

  /// A sparse accessor of displacements, which raises one vertex by 1 along Z.
  int raised(std::uint8_t vertex) {
    const std::string places = std::to_string(maker.view(std::vector<std::uint8_t>{vertex}));
    const std::string values = std::to_string(maker.view(std::vector<float>{0, 0, 1}));
    return maker.rawAccessor(R"({"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,"indices":)"
                             R"({"bufferView":)" +
                             places + R"(,"componentType":5121},"values":{"bufferView":)" + values + "}}}");
  }
  /// A morph target that moves the places so.
  static std::string targets(int accessor) { return "{\"POSITION\":" + std::to_string(accessor) + "}"; }

  /// rest         more of the root, which may be nodes of its own
  /// attributes   more of them
  std::string json(const std::string& rest, const std::string& targets = "", const std::string& more = "",
                   const std::string& attributes = "") const {
    const std::string normals = has_normals ? ",\"NORMAL\":1" : "";
    return maker.gltf("{\"attributes\":{\"POSITION\":0" + normals + attributes + "}" + more +
                          (targets.empty() ? "" : ",\"targets\":[" + targets + "]") + "}",
                      rest);
  }
};

inline Result<Scene> decodedText(const std::string& json) {
  return decodeGltf({reinterpret_cast<const std::uint8_t*>(json.data()), json.size()}, "model.gltf");
}

inline Scene decodedScene(const std::string& json) {
  const Result<Scene> scene = decodedText(json);
  EXPECT_TRUE(scene) << scene.error().message << "\n" << json;
  return scene ? *scene : Scene{};
}

/// The first animation at a time.
inline Scene decodedPose(const Scene& rest, double seconds) {
  const Result<Scene> scene = posed(rest, 0, seconds);
  EXPECT_TRUE(scene) << scene.error().message;
  return scene ? *scene : Scene{};
}

/// Where a vertex of an instance is in the world.
inline glm::vec3 placeOf(const Scene& scene, std::size_t instance, std::size_t vertex) {
  const Instance& of = scene.instances.at(instance);
  return of.world_from_object * glm::vec4(scene.meshes.at(std::size_t(of.mesh))->vertices.at(vertex).position, 1.0f);
}

inline void expectPlace(glm::vec3 is, glm::vec3 wanted) {
  EXPECT_LT(glm::distance(is, wanted), 1e-5f) << is.x << " " << is.y << " " << is.z;
}

inline void expectFinite(const Scene& scene) {
  for (const Mesh& mesh : scene.meshes)
    for (const Vertex& vertex : mesh.vertices) {
      EXPECT_TRUE(std::isfinite(glm::dot(vertex.position, glm::vec3(1.0f))));
      EXPECT_NEAR(glm::length(vertex.normal), 1.0f, 1e-4f);
      EXPECT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1.0f, 1e-4f);
    }
}

/// Expects that triangles are seen counter-clockwise from where their normals point to.
inline void expectOutside(const Scene& scene) {
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const Mesh& mesh = scene.meshes.at(std::size_t(instance.mesh));
    const glm::mat3 normals = glm::transpose(glm::inverse(glm::mat3(instance.world_from_object)));
    for (std::size_t first = 0; first < mesh.indices.size(); first += 3) {
      const glm::vec3 a = placeOf(scene, i, mesh.indices[first]), b = placeOf(scene, i, mesh.indices[first + 1]),
                      c = placeOf(scene, i, mesh.indices[first + 2]);
      EXPECT_GT(glm::dot(glm::cross(b - a, c - a), normals * mesh.vertices[mesh.indices[first]].normal), 0.0f) << i;
    }
  }
}

}  // namespace mirrorball::testing
