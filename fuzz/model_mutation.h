#pragma once

#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "chance.h"
#include "mirrorball/base/file.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/scene/gltf/gltf_writer.h"
#include "mirrorball/scene/material/material.h"
#include "mirrorball/scene/scene.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball::fuzz {

/// A small texture of any texels.
inline Texture anyTexture(bool is_srgb, std::mt19937& random) {
  Texture texture{.image = Image8(3, 2, 4), .srgb = is_srgb};
  for (std::uint8_t& sample : texture.image.edit().samples()) sample = static_cast<std::uint8_t>(random());
  return texture;
}

/// A sphere and a cube above a plane, each of a built-in material, with a texture in one slot of each, as a .glb.
inline Bytes anyModel(std::mt19937& random) {
  Scene scene;
  const auto add = [&](Mesh mesh, glm::vec3 place, float scale) {
    Material material = *materialNamed(materialNames()[below(materialNames().size(), random)]);
    const MaterialMap& map = materialMaps()[below(materialMaps().size(), random)];
    (material.*map.slot).texture = static_cast<int>(scene.textures.size());
    scene.textures.push_back(anyTexture(map.srgb, random));
    material.alpha_mode = static_cast<AlphaMode>(below(3, random));
    material.double_sided = below(2, random) == 1;
    mesh.material = static_cast<int>(scene.materials.size());
    scene.materials.push_back(std::move(material));
    const int number = static_cast<int>(scene.meshes.size());
    scene.instances.push_back({number, glm::scale(glm::translate(glm::mat4(1.0f), place), glm::vec3(scale))});
    scene.meshes.push_back(std::move(mesh));
  };
  add(sphereMesh(4, 6), {0, 0, 0}, 1.0f);
  add(cubeMesh(), {1, 0, 0.5f}, 0.7f);
  add(planeMesh(), {0, -1, 0}, 3.0f);
  scene.lights.emplace_back();
  return encodeGlb(scene)->bytes;
}

/// The parts of a .glb: 12 bytes that say what it is, a chunk of JSON and one of a buffer, each behind 8 bytes that say
/// how long it is and of what kind.
struct GlbParts {
  std::string json;
  Bytes buffer;
};

inline GlbParts partsOf(const Bytes& glb) {
  constexpr std::size_t kHeader = 12, kChunk = 8;
  const std::size_t length = littleU32(glb.data() + kHeader);
  const auto json = glb.begin() + kHeader + kChunk;
  const auto buffer = json + static_cast<std::ptrdiff_t>(length + kChunk);
  return {std::string(json, json + static_cast<std::ptrdiff_t>(length)), Bytes(buffer, glb.end())};
}

inline void appendU32(Bytes& bytes, std::size_t number) {
  for (int byte = 0; byte < 4; ++byte) bytes.push_back(static_cast<std::uint8_t>(number >> 8 * byte));
}

inline Bytes glbOf(GlbParts parts) {
  constexpr std::size_t kFrames = 12 + 8 + 8;
  parts.json.resize((parts.json.size() + 3) / 4 * 4, ' ');
  Bytes glb{'g', 'l', 'T', 'F'};
  appendU32(glb, 2);
  appendU32(glb, kFrames + parts.json.size() + parts.buffer.size());
  appendU32(glb, parts.json.size());
  glb.insert(glb.end(), {'J', 'S', 'O', 'N'});
  glb.insert(glb.end(), parts.json.begin(), parts.json.end());
  appendU32(glb, parts.buffer.size());
  glb.insert(glb.end(), {'B', 'I', 'N', 0});
  glb.insert(glb.end(), parts.buffer.begin(), parts.buffer.end());
  return glb;
}

/// Where numbers stand in a text: where each begins and how long it is.
inline std::vector<std::pair<std::size_t, std::size_t>> numbersIn(std::string_view json) {
  std::vector<std::pair<std::size_t, std::size_t>> places;
  for (std::size_t at = 1; at < json.size(); ++at) {
    if (std::string_view(":,[").find(json[at - 1]) == std::string_view::npos) continue;
    const std::size_t end = json.find_first_not_of("+-.0123456789eE", at);
    if (end != std::string_view::npos && end > at) places.emplace_back(at, end - at);
  }
  return places;
}

/// The same model, but for one number of its JSON or one float of its buffer.
///
/// glb   of anyModel, changed or not
inline Bytes withAnotherNumber(const Bytes& glb, std::mt19937& random) {
  constexpr auto kNumbers = std::to_array<std::string_view>(
      {"0",     "1",    "-1",   "0.5",    "2",       "3",    "1e-3", "1e-30", "1e-45",      "1e6",      "1e15",
       "-1e15", "1e19", "1e30", "3.4e38", "-3.4e38", "1e39", "255",  "65535", "4294967295", "0.999999", "-0.0"});
  const std::string_view number = kNumbers[below(kNumbers.size(), random)];
  GlbParts parts = partsOf(glb);
  if (below(4, random) > 0) {
    const auto places = numbersIn(parts.json);
    const auto [at, length] = places[below(places.size(), random)];
    parts.json.replace(at, length, number);
  } else {
    float value = 0.0f;
    std::from_chars(number.data(), number.data() + number.size(), value);
    const std::size_t at = below(parts.buffer.size() / sizeof(value), random) * sizeof(value);
    std::memcpy(parts.buffer.data() + at, &value, sizeof(value));
  }
  return glbOf(std::move(parts));
}

/// A model of any materials of which up to three numbers are others, as a .glb: the same for the same two numbers.
/// Models that differ in `change` alone have few shaders that are not the same, which take most of the time.
inline Bytes mutatedModel(std::uint32_t model, std::uint32_t change) {
  std::mt19937 random(model);
  Bytes glb = anyModel(random);
  random.seed(change);
  for (std::size_t changes = below(4, random); changes > 0; --changes) glb = withAnotherNumber(glb, random);
  return glb;
}

}  // namespace mirrorball::fuzz
