#include "quality/scene_parts.h"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "formula/constants.h"
#include "mirrorball/base/file.h"
#include "mirrorball/scene/gltf/gltf_writer.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball::quality {
namespace {

/// Seven rows of five dots each, of the letters that one word needs.
constexpr std::string_view kLetters = "MIROBAL";
constexpr std::array<std::string_view, 7> kDots{"#...#.###.####..###.####...#..#....",  //
                                                "##.##..#..#...##...##...#.#.#.#....",  //
                                                "#.#.#..#..#...##...##...##...##....",  //
                                                "#.#.#..#..####.#...#####.#...##....",  //
                                                "#...#..#..#.#..#...##...#######....",  //
                                                "#...#..#..#..#.#...##...##...##....",  //
                                                "#...#.###.#...#.###.####.#...######"};

bool isInked(char letter, int x, int y) {
  const auto row = static_cast<std::size_t>(y);
  return x < 5 && y < 7 && kDots[row][kLetters.find(letter) * 5 + static_cast<std::size_t>(x)] == '#';
}

void setTexel(Texture& texture, int x, int y, std::array<int, 4> color) {
  for (std::size_t channel = 0; channel < 4; ++channel)
    texture.image.edit().texel(x, y)[channel] = static_cast<std::uint8_t>(color[channel]);
}

}  // namespace

Mesh rectangle(glm::vec3 middle, glm::vec3 across, glm::vec3 up, int divisions) {
  Mesh mesh;
  const glm::vec3 normal = glm::normalize(glm::cross(across, up));
  const int row = divisions + 1;
  for (int j = 0; j < row; ++j)
    for (int i = 0; i < row; ++i) {
      const glm::vec2 uv = glm::vec2(i, j) / static_cast<float>(divisions);
      Vertex vertex{.position = middle + (2.0f * uv.x - 1.0f) * across + (1.0f - 2.0f * uv.y) * up, .normal = normal};
      vertex.tangent = glm::vec4(glm::normalize(across), 1.0f);
      vertex.uv[0] = uv;
      mesh.vertices.push_back(vertex);
    }
  for (int j = 0; j < divisions; ++j)
    for (int i = 0; i < divisions; ++i) {
      const auto corner = static_cast<std::uint32_t>(j * row + i);
      const auto below = corner + static_cast<std::uint32_t>(row);
      for (const std::uint32_t index : {corner, below, below + 1, corner, below + 1, corner + 1})
        mesh.indices.push_back(index);
    }
  return mesh;
}

Mesh box(glm::vec3 middle, glm::vec3 half) {
  Mesh whole;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f}) {
      glm::vec3 out(0.0f), across(0.0f), up(0.0f);
      out[axis] = side * half[axis];
      // Texts stand upright on the four sides.
      const int upright = axis == 1 ? 2 : 1;
      up[upright] = axis == 1 ? -side * half.z : half.y;
      across = glm::cross(glm::normalize(up), glm::normalize(out));
      across *= half[3 - axis - upright];
      const Mesh face = rectangle(middle + out, across, up);
      const auto first = static_cast<std::uint32_t>(whole.vertices.size());
      whole.vertices.insert(whole.vertices.end(), face.vertices.begin(), face.vertices.end());
      for (const std::uint32_t index : face.indices) whole.indices.push_back(first + index);
    }
  return whole;
}

Mesh ground(float half, int divisions) { return rectangle({0, 0, 0}, {half, 0, 0}, {0, 0, -half}, divisions); }

Mesh ball(glm::vec3 middle, float radius, int rings) {
  Mesh mesh = sphereMesh(rings, 2 * rings);
  for (Vertex& vertex : mesh.vertices) vertex.position = middle + radius * vertex.position;
  return mesh;
}

void add(Scene& scene, Mesh mesh, const Material& material) {
  mesh.material = static_cast<int>(scene.materials.size());
  scene.materials.push_back(material);
  scene.instances.push_back({.mesh = static_cast<int>(scene.meshes.size())});
  scene.meshes.push_back(std::move(mesh));
}

Material matt(glm::vec3 base_color, float perceptual_roughness) {
  Material material;
  material.base_color = base_color;
  material.perceptual_roughness = perceptual_roughness;
  return material;
}

Material roughMetal(glm::vec3 reflectance, float perceptual_roughness) {
  Material material = matt(reflectance, perceptual_roughness);
  material.metallic = 1.0f;
  return material;
}

Texture smallText() {
  constexpr std::string_view kWord = "MIRRORBALL ";
  constexpr int kSide = 256;
  Texture text{.image = Image8(kSide, kSide, 4), .srgb = true};
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const char letter = kWord[static_cast<std::size_t>(x / 6 + y / 10) % kWord.size()];
      const bool is_inked = letter != ' ' && isInked(letter, x % 6, y % 10);
      setTexel(text, x, y, is_inked ? std::array{20, 24, 60, 255} : std::array{235, 225, 200, 255});
    }
  return text;
}

Texture leaf() {
  constexpr int kSide = 128;
  Texture leaf{.image = Image8(kSide, kSide, 4), .srgb = true, .wrap_s = Wrap::clamp_to_edge};
  leaf.wrap_t = Wrap::clamp_to_edge;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const glm::vec2 place = (glm::vec2(x, y) + 0.5f) / (0.5f * kSide) - 1.0f;
      const float half_width = 0.55f * std::cos(0.5f * formula::kPi * place.y) + 0.06f * std::sin(40.0f * place.y);
      const bool is_inside = std::abs(place.x) < half_width;
      const bool is_vein = std::abs(place.x) < 0.03f;
      setTexel(leaf, x, y, {is_vein ? 170 : 60, is_vein ? 190 : 130, 50, is_inside ? 255 : 0});
    }
  return leaf;
}

Result<std::filesystem::path> writeGlb(const Scene& scene, const std::string& name,
                                       const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / (name + ".glb");
  MIRRORBALL_TRY(encoded, encodeGlb(scene));
  MIRRORBALL_TRY_VOID(writeFile(file, encoded.bytes));
  return file;
}

}  // namespace mirrorball::quality
