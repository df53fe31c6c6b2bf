#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// A picture of a material.
struct MaterialMapFact {
  std::string_view name;  ///< MaterialMap::name
  glm::ivec2 size{0};     ///< texels
  bool has_floats = false;
};

/// The parameters and the pictures of a material.
struct MaterialFacts {
  std::string name;
  std::vector<std::pair<std::string_view, std::string>> parameters;  ///< that differ from glTF's defaults, as written
  std::vector<MaterialMapFact> maps;
};

/// Of each of a scene's materials, in their order.
std::vector<MaterialFacts> materialFacts(const Scene& scene);

/// How many triangles a scene shows, each as often as its mesh is placed.
std::size_t triangleCount(const Scene& scene);

/// What is likely to be a mistake of the program that a model comes from, a sentence each: it is black, or gone, or its
/// pictures do not show, or it is as small or as large as another unit would make it.
std::vector<std::string> likelyMistakes(const Scene& scene);

}  // namespace mirrorball
