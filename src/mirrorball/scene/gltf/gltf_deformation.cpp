#include "mirrorball/scene/gltf/gltf_deformation.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "mirrorball/base/text.h"

// glTF 2.0, sections 3.7.2.2 and 3.7.3.

namespace mirrorball::gltf {
namespace {

/// Joints have 16 bits at most.
constexpr float kMaxJoint = 65535.0f;

/// The joints and weights of a primitive's vertices: of each set four a vertex.
struct JointSet {
  Numbers joints;
  Numbers weights;
};

Result<std::vector<JointSet>> readJointSets(const Primitive& primitive, const ReadAttribute& attribute,
                                            const std::string& key) {
  std::vector<JointSet> sets(jointSets(primitive));
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const std::string joints_name = "JOINTS_" + std::to_string(i), weights_name = "WEIGHTS_" + std::to_string(i);
    MIRRORBALL_TRY(joints, attribute(joints_name, 4, 4));
    MIRRORBALL_TRY(weights, attribute(weights_name, 4, 4));
    if (weights.values.size() != joints.values.size())
      return fail(ErrorCode::bad_file,
                  key + ".attributes." + weights_name + " is missing, and " + joints_name + " is there");
    for (const float joint : joints.values)
      if (!(joint >= 0.0f && joint <= kMaxJoint && joint == std::floor(joint)))
        return fail(ErrorCode::bad_file,
                    key + ".attributes." + joints_name + " names the joint " + formatNumber(double(joint)));
    sets[i] = {std::move(joints), std::move(weights)};
  }
  return sets;
}

/// The joints of a vertex of the file that carry something of it.
void addInfluences(const std::vector<JointSet>& sets, std::size_t source, MeshDeformation& deformation) {
  const std::size_t first = deformation.influences.size();
  float sum = 0.0f;
  for (const JointSet& set : sets) {
    for (std::size_t i = source * 4; i < source * 4 + 4; ++i) {
      const float weight = set.weights.values[i];
      if (!(weight > 0.0f && std::isfinite(weight))) continue;
      deformation.influences.push_back({static_cast<std::uint32_t>(set.joints.values[i]), weight});
      sum += weight;
    }
  }
  // What hangs on nothing hangs on the first joint that it names.
  if (!(sum > 0.0f))
    deformation.influences.push_back({static_cast<std::uint32_t>(sets[0].joints.values[source * 4]), sum = 1.0f});
  for (std::size_t i = first; i < deformation.influences.size(); ++i) {
    deformation.influences[i].weight /= sum;
    deformation.joints = std::max(deformation.joints, deformation.influences[i].joint + 1);
  }
}

Result<void> readInfluences(const Primitive& primitive, std::span<const std::uint32_t> sources,
                            const ReadAttribute& attribute, const std::string& key, MeshDeformation& deformation) {
  MIRRORBALL_TRY(sets, readJointSets(primitive, attribute, key));
  if (sets.empty()) return {};
  deformation.first_influence.reserve(sources.size() + 1);
  for (const std::uint32_t source : sources) {
    deformation.first_influence.push_back(deformation.influences.size());
    addInfluences(sets, source, deformation);
  }
  deformation.first_influence.push_back(deformation.influences.size());
  return {};
}

/// What a morph target adds to an attribute of the file's vertices; none: nothing.
Result<Numbers> readDifferences(const File& file, const std::map<std::string, int>& target, const char* name,
                                std::size_t vertices, const std::string& target_key) {
  const auto found = target.find(name);
  if (found == target.end()) return Numbers{};
  const std::string key = target_key + "." + name;
  MIRRORBALL_TRY(numbers, readFiniteNumbers(file, found->second, key));
  if (numbers.components != 3)
    return fail(ErrorCode::bad_file, key + " has " + counted(numbers.components, "component"));
  if (numbers.count() != vertices)
    return fail(ErrorCode::bad_file,
                key + " has " + counted(numbers.count(), "element") + ", but POSITION has " + std::to_string(vertices));
  return numbers;
}

glm::vec3 differenceAt(const Numbers& numbers, std::size_t vertex) {
  if (numbers.values.empty()) return glm::vec3(0.0f);
  const float* d = numbers.values.data() + vertex * 3;
  return {d[0], d[1], d[2]};
}

Result<void> readTargets(const File& file, const Primitive& primitive, std::span<const std::uint32_t> sources,
                         std::size_t vertices, const std::string& key, MeshDeformation& deformation) {
  for (std::size_t i = 0; i < primitive.targets.size(); ++i) {
    const std::string target_key = key + "." + quoted("targets", i);
    const auto read = [&](const char* name) {
      return readDifferences(file, primitive.targets[i], name, vertices, target_key);
    };
    MIRRORBALL_TRY(positions, read("POSITION"));
    MIRRORBALL_TRY(normals, read("NORMAL"));
    MIRRORBALL_TRY(tangents, read("TANGENT"));
    std::vector<MeshDeformation::Displacement>& target = deformation.targets.emplace_back();
    for (std::size_t vertex = 0; vertex < sources.size(); ++vertex) {
      const std::size_t source = sources[vertex];
      const glm::vec3 p = differenceAt(positions, source), n = differenceAt(normals, source),
                      t = differenceAt(tangents, source);
      const glm::vec3 none(0.0f);
      if (p != none || n != none || t != none) target.push_back({static_cast<std::uint32_t>(vertex), p, n, t});
    }
  }
  return {};
}

}  // namespace

std::size_t jointSets(const Primitive& primitive) {
  std::size_t sets = 0;
  while (primitive.attributes.contains("JOINTS_" + std::to_string(sets)) ||
         primitive.draco_attributes.contains("JOINTS_" + std::to_string(sets)))
    ++sets;
  return sets;
}

std::size_t deformationSize(const Primitive& primitive, WantedDeformation wanted, std::size_t vertices) {
  std::size_t each = 0;
  if (wanted.skin) each += 4 * jointSets(primitive) * sizeof(MeshDeformation::Influence) + sizeof(std::size_t);
  if (wanted.targets) each += primitive.targets.size() * sizeof(MeshDeformation::Displacement);
  return vertices * (each + (wanted.any() ? sizeof(MeshDeformation::Basis) : 0));
}

Result<std::shared_ptr<const MeshDeformation>> readDeformation(const File& file, const Primitive& primitive,
                                                               WantedDeformation wanted, const FileVertices& vertices,
                                                               const ReadAttribute& attribute, const std::string& key,
                                                               std::vector<Damage>& damage) {
  auto deformation = std::make_shared<MeshDeformation>();
  if (wanted.skin)
    MIRRORBALL_TRY_VOID(notedIn(damage, "skin of the primitive",
                                readInfluences(primitive, vertices.sources, attribute, key, *deformation)));
  if (wanted.targets) {
    const Result<void> read = readTargets(file, primitive, vertices.sources, vertices.count, key, *deformation);
    if (!read) deformation->targets.clear();
    MIRRORBALL_TRY_VOID(notedIn(damage, "morphing of the primitive", read));
  }
  if (!deformation->hasSkin() && deformation->targets.empty()) return std::shared_ptr<const MeshDeformation>();
  deformation->is_flat = vertices.are_flat;
  deformation->vertices.reserve(vertices.mesh.vertices.size());
  for (const Vertex& vertex : vertices.mesh.vertices)
    deformation->vertices.push_back({vertex.position, vertex.normal, vertex.tangent});
  return std::shared_ptr<const MeshDeformation>(std::move(deformation));
}

}  // namespace mirrorball::gltf
