#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/animation/animation.h"
#include "mirrorball/scene/gltf/gltf_document.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball::gltf {

/// What of a file became what of a scene.
struct SceneOfFile {
  const Document& document;
  Scene& scene;                                ///< whose rig has its nodes
  std::vector<int> place_of_node;              ///< of each of the file's nodes in the rig; −1: it is not shown
  std::vector<int> materials;                  ///< of each of the file's materials, the scene's; −1: none
  std::vector<std::vector<int>> cameras = {};  ///< of each of the file's cameras, the scene's
  std::vector<std::vector<int>> lights = {};   ///< of each of the file's lights, the scene's
};

/// A JSON pointer's way through an array.
struct ArrayStep {
  int index;         ///< at least 0
  std::string rest;  ///< the way on, with dots in place of slashes: "extensions.KHR_materials_ior.ior"
};

/// The way of a pointer that begins with that array: "/nodes/".
///
/// returns  nothing for other pointers, and for those that end in the array
std::optional<ArrayStep> stepInto(std::string_view array, std::string_view pointer);

/// What a JSON pointer leads to.
struct Pointed {
  bool is_read = false;                       ///< whether animations move such things here
  std::vector<AnimationTarget> targets = {};  ///< none: it is not in the scene
  std::size_t components = 0;                 ///< how many numbers each has
};

/// Finds what an animation moves.
///
/// key      what holds the pointer, for messages
/// errors   bad_file: an index is out of range
Result<Pointed> pointedAt(const SceneOfFile& all, const std::string& pointer, const std::string& key);

/// A pointer with N for its indices, as in "/nodes/N/extras/speed", fit for a message.
std::string kindOfPointer(const std::string& pointer);

}  // namespace mirrorball::gltf
