// Blender's calc_tangents, which is the rule's own code, as a second opinion on computeTangents.

#include "mirrorball/scene/tangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using glm::dvec3;

/// What Blender found: a mesh whose corners are equal vertices where they are in its own, and its tangents.
struct TangentCase {
  std::string name;
  Mesh mesh;
  std::vector<glm::vec4> tangents;  ///< of the corners
};

/// As blender_tangents.py writes them.
std::vector<TangentCase> readCases(const std::string& path) {
  std::vector<TangentCase> cases;
  std::ifstream file(path);
  std::string word;
  std::size_t triangles = 0;
  while (file >> word >> word >> triangles) {
    TangentCase& read = cases.emplace_back();
    read.name = word;
    std::map<std::array<float, 8>, std::uint32_t> known;
    for (std::size_t corner = 0; corner < 3 * triangles; ++corner) {
      std::array<float, 8> key{};
      for (float& number : key) file >> number;
      glm::vec4& tangent = read.tangents.emplace_back();
      file >> tangent.x >> tangent.y >> tangent.z >> tangent.w;
      const auto [found, is_new] = known.emplace(key, static_cast<std::uint32_t>(known.size()));
      read.mesh.indices.push_back(found->second);
      if (!is_new) continue;
      Vertex& vertex = read.mesh.vertices.emplace_back();
      vertex.position = {key[0], key[1], key[2]};
      vertex.normal = {key[3], key[4], key[5]};
      vertex.uv[0] = {key[6], -key[7]};  // Blender's v grows upwards; where it is 0 is all the same
    }
  }
  return cases;
}

double angleBetween(dvec3 a, dvec3 b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

/// Across the normal, as ours are: where it has no direction, Blender's is the x axis.
dvec3 acrossNormal(glm::vec4 tangent, dvec3 normal) {
  const dvec3 along{glm::vec3(tangent)};
  return along - normal * glm::dot(normal, along);
}

class TangentsTest : public CliTest {
 protected:
  void SetUp() override {
    if (std::system("blender --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "Blender is not installed";
    const std::string line = "cd '" + path("").string() +
                             "' && blender --background --factory-startup --python-exit-code 1 --python "
                             "'" MIRRORBALL_SOURCE_DIR "/tests/peer/blender_tangents.py' -- tangents.txt >log 2>&1";
    ASSERT_EQ(std::system(line.c_str()), 0);
    cases_ = readCases(path("tangents.txt").string());
    ASSERT_GE(cases_.size(), 18u);
  }

  std::vector<TangentCase> cases_;
};

TEST_F(TangentsTest, AreThoseOfBlender) {
  for (const TangentCase& theirs : cases_) {
    Mesh ours = theirs.mesh;
    computeTangents(ours);
    double worst = 0.0;
    for (std::size_t corner = 0; corner < ours.indices.size(); ++corner) {
      const Vertex& vertex = ours.vertices[ours.indices[corner]];
      const glm::vec4 wanted = theirs.tangents[corner];
      EXPECT_EQ(vertex.tangent.w, wanted.w) << theirs.name << ", corner " << corner;
      worst = std::max(worst, angleBetween(dvec3(glm::vec3(vertex.tangent)), acrossNormal(wanted, vertex.normal)));
    }
    EXPECT_LT(worst, 1e-3) << theirs.name;
  }
}

// Corners of one vertex stay one where Blender gives them the same tangent, and only there.
TEST_F(TangentsTest, SplitTheSameVertices) {
  std::size_t split = 0;
  for (const TangentCase& theirs : cases_) {
    Mesh ours = theirs.mesh;
    computeTangents(ours);
    std::map<std::uint32_t, std::vector<std::size_t>> corners_of;
    for (std::size_t corner = 0; corner < ours.indices.size(); ++corner)
      corners_of[theirs.mesh.indices[corner]].push_back(corner);
    for (const auto& [vertex, corners] : corners_of)
      for (const std::size_t a : corners)
        for (const std::size_t b : corners) {
          const bool are_one = glm::distance(theirs.tangents[a], theirs.tangents[b]) < 1e-5f;
          EXPECT_EQ(ours.indices[a] == ours.indices[b], are_one) << theirs.name << ", corners " << a << " and " << b;
        }
    split += ours.vertices.size() - theirs.mesh.vertices.size();
  }
  EXPECT_GT(split, 100u);
}

}  // namespace
}  // namespace mirrorball::testing
