#include "mirrorball/scene/bodies/body_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include "formula/bodies.h"
#include "formula/projection.h"
#include "mirrorball/base/bit_cast.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/scene/bodies/box_tree.h"
#include "mirrorball/scene/closed_surface.h"
#include "mirrorball/scene/unit_vector.h"

namespace mirrorball {
namespace {

/// Fewer than kTrianglesOfLeaf: a test costs about as much as a visit of a node.
constexpr std::uint32_t kTrianglesKept = 4;
/// While the tree is built: a triangle, its box, its place in the tree and its share of the nodes and words.
constexpr std::uint64_t kBytesPerTriangle = 260;

/// Beside the number of a corner.
constexpr std::uint32_t kFlag = 0x80000000u;

using Texel = glm::uvec4;

/// Without a 0 to divide by.
glm::vec3 sizeOf(const Box& all) {
  const glm::vec3 size = all.high - all.low;
  return glm::mix(size, glm::vec3(1.0f), glm::lessThanEqual(size, glm::vec3(0.0f)));
}

std::uint32_t wordOf(float number) { return bitCast<std::uint32_t>(number); }
Texel texelOf(glm::vec3 numbers, std::uint32_t last) {
  return {wordOf(numbers.x), wordOf(numbers.y), wordOf(numbers.z), last};
}

/// A triangle of a body in the world.
struct PlacedTriangle {
  std::array<glm::vec3, 3> corners;
  std::array<glm::vec2, 3> normals;  ///< octahedral
  std::uint32_t instance;
  std::uint32_t first;  ///< of its corners in the indices of its mesh

  Box box() const {
    Box all;
    for (const glm::vec3& corner : corners) all.include({corner, corner});
    return all;
  }
};

/// Adds the triangles of one instance.
void addTriangles(const Scene& scene, std::uint32_t number, std::vector<PlacedTriangle>& triangles) {
  const Instance& instance = scene.instances[number];
  const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
  const glm::mat4& world_from_object = instance.world_from_object;
  const glm::mat3 world_from_normal = glm::transpose(glm::inverse(glm::mat3(world_from_object)));
  for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
    PlacedTriangle triangle{.corners = {}, .normals = {}, .instance = number, .first = std::uint32_t(first)};
    bool is_finite = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec3& position = mesh.vertices[mesh.indices[first + i]].position;
      triangle.corners[i] = glm::vec3(world_from_object * glm::vec4(position, 1.0f));
      is_finite = is_finite && isFinite(triangle.corners[i]);
    }
    const glm::vec3 facing =
        glm::cross(triangle.corners[1] - triangle.corners[0], triangle.corners[2] - triangle.corners[0]);
    const glm::vec3 geometric_normal = directionOr(facing, glm::vec3(0.0f));
    if (!is_finite || geometric_normal == glm::vec3(0.0f)) continue;  // or without an area
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec3 normal = glm::normalize(world_from_normal * mesh.vertices[mesh.indices[first + i]].normal);
      triangle.normals[i] = formula::octahedralPosition(isFinite(normal) ? normal : geometric_normal);
    }
    triangles.push_back(triangle);
  }
}

/// The number by which a node knows one of its children.
std::uint32_t childWord(const BoxTree::Child& child) {
  if (child.count == 0) return formula::kTexelsOfHead + child.first * formula::kTexelsOfNode;
  return static_cast<std::uint32_t>(formula::leafOf(static_cast<int>(child.first), static_cast<int>(child.count)));
}

/// A place in the box around all, as 16 bits, so far outside of it that rounding does not bring it in again.
std::uint32_t stepOf(float place, float outwards) {
  constexpr float kMargin = 0.25f;
  const float steps = place * 65535.0f + outwards * kMargin;
  return static_cast<std::uint32_t>(std::clamp(outwards < 0.0f ? std::floor(steps) : std::ceil(steps), 0.0f, 65535.0f));
}

Texel childTexel(const BoxTree::Child& child, const Box& all) {
  const glm::vec3 size = sizeOf(all);
  std::array<std::uint32_t, 6> steps;
  for (int axis = 0; axis < 3; ++axis) {
    const auto place = [&](float value) { return (value - all.low[axis]) / size[axis]; };
    steps[std::size_t(axis)] = stepOf(place(child.box.low[axis]), -1.0f);
    steps[std::size_t(axis) + 3] = stepOf(place(child.box.high[axis]), 1.0f);
  }
  return {steps[0] | steps[1] << 16, steps[2] | steps[3] << 16, steps[4] | steps[5] << 16, childWord(child)};
}

void writeTriangle(const PlacedTriangle& triangle, std::vector<Texel>& words) {
  const auto& [a, b, c] = triangle.normals;
  words.push_back(texelOf(triangle.corners[0], triangle.instance));
  words.push_back(texelOf(triangle.corners[1], wordOf(a.x)));
  words.push_back(texelOf(triangle.corners[2], wordOf(a.y)));
  words.push_back({wordOf(b.x), wordOf(b.y), wordOf(c.x), wordOf(c.y)});
}

void writeBody(const Material& material, std::vector<Texel>& words) {
  words.push_back(texelOf(material.base_color, wordOf(material.ior)));
  words.push_back(texelOf(material.attenuation_color, wordOf(material.attenuation_distance)));
  words.push_back(texelOf({material.perceptual_roughness, material.dispersion, material.specular},
                          static_cast<std::uint32_t>(material.priority)));
  words.push_back(glm::floatBitsToUint(material.sellmeier_b));
  words.push_back(glm::floatBitsToUint(material.sellmeier_c));
}

/// A tree, and its triangles in its order.
struct SortedTriangles {
  BodyTree tree;
  std::vector<PlacedTriangle> triangles;
};

using IsWanted = bool (*)(const Scene& scene, std::size_t instance);

/// More balls would make the tree too deep.
constexpr std::size_t kMostBalls = 32;

/// The triangles of a scene that are wanted: those of all but the balls, then each ball's.
struct WantedTriangles {
  std::vector<PlacedTriangle> triangles;
  std::vector<std::size_t> ends;     ///< of these parts, of which none is empty
  std::vector<std::uint32_t> balls;  ///< instances; the last parts
};

WantedTriangles wantedTriangles(const Scene& scene, IsWanted is_wanted, bool keeps_balls_apart) {
  WantedTriangles wanted;
  std::vector<std::uint32_t> balls;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    if (!is_wanted(scene, i)) continue;
    const Mesh& mesh = scene.meshes[std::size_t(scene.instances[i].mesh)];
    if (keeps_balls_apart && balls.size() < kMostBalls && isBall(mesh))
      balls.push_back(i);
    else
      addTriangles(scene, i, wanted.triangles);
  }
  if (!wanted.triangles.empty()) wanted.ends.push_back(wanted.triangles.size());
  for (const std::uint32_t ball : balls) {
    const std::size_t begin = wanted.triangles.size();
    addTriangles(scene, ball, wanted.triangles);
    if (wanted.triangles.size() == begin) continue;
    wanted.ends.push_back(wanted.triangles.size());
    wanted.balls.push_back(ball);
  }
  return wanted;
}

/// A tree of the triangles of the instances that are wanted.
///
/// name   of the triangles, for messages
Result<std::optional<SortedTriangles>> sortedTriangles(const Scene& scene, const std::string& name, IsWanted is_wanted,
                                                       bool keeps_balls_apart) {
  std::uint64_t count = 0;
  bool disperses = false;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    if (!is_wanted(scene, i)) continue;
    count += scene.meshes[std::size_t(scene.instances[i].mesh)]->indices.size() / 3;
    disperses = disperses || materialOf(scene, i).dispersion > 0.0f;
  }
  if (count > std::uint64_t{1} << 27)
    return fail(ErrorCode::too_large, name + " are more than the 134 million that can be traced");
  MIRRORBALL_TRY_VOID(withName(name, checkMemory(count * kBytesPerTriangle)));

  const auto [triangles, ends, balls] = wantedTriangles(scene, is_wanted, keeps_balls_apart);
  if (triangles.empty()) return std::optional<SortedTriangles>();

  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const PlacedTriangle& triangle : triangles) boxes.push_back(triangle.box());
  std::vector<BoxTree::Child> roots;
  const BoxTree tree = ends.size() == 1 ? boxTree(boxes, kTrianglesKept, formula::kDeepestNode)
                                        : boxTreeOfParts(boxes, ends, kTrianglesKept, formula::kDeepestNode, roots);

  BodyTree bodies;
  const std::size_t first_triangle = formula::kTexelsOfHead + tree.nodes.size() * formula::kTexelsOfNode;
  const std::size_t first_body = first_triangle + triangles.size() * formula::kTexelsOfTriangle;
  bodies.words.reserve(first_body + scene.instances.size() * formula::kTexelsOfBody);
  bodies.words.emplace_back(childWord(tree.root), first_triangle, first_body, disperses ? 1 : 0);
  bodies.words.push_back(texelOf(tree.root.box.low, 0));
  bodies.words.push_back(texelOf(sizeOf(tree.root.box), 0));
  for (const BoxTree::Node& node : tree.nodes)
    for (const BoxTree::Child& child : node.children) bodies.words.push_back(childTexel(child, tree.root.box));
  bodies.unseen_by_itself.assign(scene.instances.size(), 0);
  for (std::size_t i = 0; i < roots.size(); ++i)
    if (i + balls.size() >= roots.size())
      bodies.unseen_by_itself[balls[i + balls.size() - roots.size()]] = static_cast<int>(childWord(roots[i]));
  std::vector<PlacedTriangle> sorted;
  sorted.reserve(triangles.size());
  for (const std::uint32_t item : tree.items) sorted.push_back(triangles[item]);
  for (const PlacedTriangle& triangle : sorted) writeTriangle(triangle, bodies.words);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) writeBody(materialOf(scene, i), bodies.words);
  return SortedTriangles{std::move(bodies), std::move(sorted)};
}

Result<std::optional<BodyTree>> treeOf(const Scene& scene, const std::string& name, IsWanted is_wanted) {
  MIRRORBALL_TRY(sorted, sortedTriangles(scene, name, is_wanted, false));
  return sorted ? std::optional<BodyTree>(std::move(sorted->tree)) : std::nullopt;
}

/// As many as half floats hold.
std::uint32_t halves(float a, float b) {
  return glm::packHalf2x16(glm::clamp(glm::vec2(a, b), glm::vec2(-65504.0f), glm::vec2(65504.0f)));
}

void writeVertex(const VertexOcclusion& occlusion, const VertexMaterial& material, std::vector<Texel>& words) {
  const auto& [occluded, open, interreflected, lit_from, emitted] = occlusion;
  words.emplace_back(halves(occluded.x, occluded.y), halves(occluded.z, open),
                     halves(interreflected.x, interreflected.y), halves(interreflected.z, material.metallic));
  words.emplace_back(halves(material.base_color.x, material.base_color.y),
                     halves(material.base_color.z, material.perceptual_roughness),
                     halves(material.emission.x, material.emission.y), halves(material.emission.z, 0.0f));
  words.emplace_back(halves(lit_from.x, lit_from.y), halves(lit_from.z, 0.0f), halves(emitted.x, emitted.y),
                     halves(emitted.z, 0.0f));
}

void writeHoles(const TriangleHoles& holes, std::vector<Texel>& words) {
  words.emplace_back(static_cast<std::uint32_t>(holes.rows), 0u, 0u, 0u);
  const auto bits = [&](std::size_t word) { return word < holes.bits.size() ? holes.bits[word] : 0u; };
  for (std::size_t word = 0; word < holes.bits.size(); word += 4)
    words.emplace_back(bits(word), bits(word + 1), bits(word + 2), bits(word + 3));
}

}  // namespace

Result<std::optional<BodyTree>> bodyTree(const Scene& scene) {
  return treeOf(scene, "the triangles of glass",
                [](const Scene& of, std::size_t instance) { return isBody(materialOf(of, instance)); });
}

Result<std::optional<BodyTree>> triangleTree(const Scene& scene) {
  return treeOf(scene, "its triangles", [](const Scene&, std::size_t) { return true; });
}

Result<std::optional<BodyTree>> sceneTree(const Scene& scene) {
  const IsWanted is_wanted = [](const Scene& of, std::size_t instance) {
    const Material& material = materialOf(of, instance);
    return material.transmission <= 0.0f && material.alpha_mode != AlphaMode::blend &&
           !of.instances[instance].vertex_materials.empty();
  };
  MIRRORBALL_TRY(sorted, sortedTriangles(scene, "the triangles that reflections show", is_wanted, true));
  if (!sorted) return std::optional<BodyTree>();
  std::vector<Texel>& words = sorted->tree.words;
  const auto sidesOf = [&](std::size_t instance) { return knowsBacks(scene, instance) ? 2u : 1u; };
  // Three texels for each side of a vertex of all instances whose materials are known, and where those of an instance
  // begin.
  std::vector<std::uint32_t> first_vertex;
  std::uint32_t vertices = 0;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    first_vertex.push_back(vertices);
    if (is_wanted(scene, i))
      vertices += sidesOf(i) * static_cast<std::uint32_t>(scene.instances[i].vertex_materials.size());
  }
  words[1].w = static_cast<std::uint32_t>(words.size());
  words[2].w = static_cast<std::uint32_t>(words.size() + sorted->triangles.size());
  for (const PlacedTriangle& triangle : sorted->triangles) {
    const Mesh& mesh = scene.meshes[std::size_t(scene.instances[triangle.instance].mesh)];
    const std::uint32_t* const corner = mesh.indices.data() + triangle.first;
    const std::uint32_t sides = sidesOf(triangle.instance);
    const glm::uvec3 numbers = first_vertex[triangle.instance] + sides * glm::uvec3(corner[0], corner[1], corner[2]);
    const bool has_back = materialOf(scene, triangle.instance).double_sided;
    words.emplace_back(numbers.x | (sides > 1 ? kFlag : 0u), numbers.y | (has_back ? 0u : kFlag), numbers.z, 0u);
  }
  const std::size_t of_triangles = words[1].w;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    if (!is_wanted(scene, i)) continue;
    for (std::size_t v = 0; v < instance.vertex_materials.size(); ++v)
      for (std::size_t side = 0; side < sidesOf(i); ++side)
        writeVertex(instance.occlusion[side * instance.vertex_materials.size() + v], instance.vertex_materials[v],
                    words);
  }
  for (std::size_t i = 0; i < sorted->triangles.size(); ++i) {
    const PlacedTriangle& triangle = sorted->triangles[i];
    const std::vector<TriangleHoles>& holes = scene.instances[triangle.instance].holes;
    if (holes.empty() || holes[triangle.first / 3].rows == 0) continue;
    words[of_triangles + i].w = static_cast<std::uint32_t>(words.size());
    writeHoles(holes[triangle.first / 3], words);
  }
  return std::optional<BodyTree>(std::move(sorted->tree));
}

}  // namespace mirrorball
