#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <glm/glm.hpp>

#include "fuzz.h"
#include "made_input.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/image/image.h"
#include "mirrorball/scene/gltf/gltf.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/mesh_file/obj.h"
#include "mirrorball/scene/mesh_file/ply.h"
#include "mirrorball/scene/mesh_file/stl.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball::fuzz {

/// A model of any format, told by its bytes.
inline Result<Scene> decodeModel(std::span<const std::uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with("glTF") || text.starts_with("{")) return decodeGltf(bytes, "a.gltf");
  if (text.starts_with("ply")) return decodePly(bytes, "a.ply");
  const bool is_binary = text.find('\0') != std::string_view::npos;
  return is_binary || text.starts_with("solid") ? decodeStl(bytes, "a.stl") : decodeObj(bytes, "a.obj");
}

/// A model that may be shown: what loadModel takes, if it is not too large for thousands of them to be tried.
inline std::optional<Scene> modelToShow(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kMostIndices = 3000;
  constexpr int kLargestTexture = 256;
  auto scene = decodeModel(bytes);
  if (!scene || !checkExtent(*scene)) return std::nullopt;
  std::size_t indices = 0;
  for (const Instance& instance : scene->instances)
    indices += scene->meshes[std::size_t(instance.mesh)]->indices.size();
  if (indices > kMostIndices) return std::nullopt;
  for (const Texture& texture : scene->textures)
    if (std::max(texture.image.width(), texture.image.height()) > kLargestTexture) return std::nullopt;
  return std::move(*scene);
}

/// A bright half of the sky with a small sun in it.
inline Environment lightToShowIn() {
  return Environment(
      [](glm::vec3 d) {
        const bool is_sun = glm::dot(d, glm::normalize(glm::vec3(1.0f, 1.0f, 1.0f))) > 0.99f;
        return glm::vec3(1.0f) + 0.5f * d + (is_sun ? 1e4f : 0.0f);
      },
      32);
}

inline constexpr glm::ivec2 kShownSize{16, 16};

/// Every pixel is a number.
inline void checkPicture(const Image& picture) {
  check(glm::ivec2(picture.width(), picture.height()) == kShownSize, "a picture has the size that was asked for");
  checkFinite(picture.samples(), "pixels are numbers");
}

/// What a harness does that shows models: each is refused in a line, or becomes such a picture.
///
/// show   Result<Image>(Scene)
template <typename Show>
void checkShown(std::span<const std::uint8_t> bytes, Show show) {
  auto scene = modelToShow(bytes);
  if (!scene) return;
  const Result<Image> picture = show(std::move(*scene));
  checkError(picture);
  if (picture) checkPicture(*picture);
}

}  // namespace mirrorball::fuzz
