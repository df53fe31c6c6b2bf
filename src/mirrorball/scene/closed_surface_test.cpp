#include "mirrorball/scene/closed_surface.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <gmock/gmock.h>

#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

bool isModelClosed(const char* name) { return std::ranges::all_of(loadModel(name)->meshes, isClosed); }

TEST(ClosedSurface, OfTheBuiltinModels) {
  for (const char* name :
       {"sphere", "torus", "knot", "cube", "brilliant", "prism", "bowl", "tumbler", "tumbler-water", "spheres", "none"})
    EXPECT_TRUE(isModelClosed(name)) << name;
  EXPECT_FALSE(isModelClosed("plane"));
  EXPECT_FALSE(isModelClosed("teapot")) << "its spout and its handle are";
}

TEST(ClosedSurface, IsOpenWithoutOneTriangleOrWithOneTurned) {
  const Mesh whole = sphereMesh(16, 32);
  for (std::size_t i = 0; i < whole.indices.size(); i += 30) {
    Mesh pierced = whole;
    const auto first = pierced.indices.begin() + static_cast<std::ptrdiff_t>(i);
    pierced.indices.erase(first, first + 3);
    EXPECT_FALSE(isClosed(pierced)) << i;
    Mesh turned = whole;
    std::swap(turned.indices[i], turned.indices[i + 1]);
    EXPECT_FALSE(isClosed(turned)) << i;
  }
}

TEST(ClosedSurface, IsNotAboutVertices) {
  Mesh loose;  // each triangle with corners of its own, in any order
  const Mesh cube = cubeMesh();
  for (std::size_t i = cube.indices.size(); i > 0; --i) {
    loose.vertices.push_back(cube.vertices[cube.indices[i - 1]]);
    loose.indices.push_back(static_cast<std::uint32_t>(loose.indices.size()));
  }
  EXPECT_TRUE(isClosed(loose)) << "inside out, it has no border either";
  const float side = loose.vertices[0].position.x;
  for (Vertex& vertex : loose.vertices)
    if (vertex.position.x == side) vertex.position.x = 0.0f;
  loose.vertices[0].position.x = -0.0f;
  EXPECT_TRUE(isClosed(loose)) << "0 and -0 are one place";
  loose.vertices[0].position.x = std::numeric_limits<float>::denorm_min();
  EXPECT_FALSE(isClosed(loose));
}

TEST(ClosedSurface, EveryTriangleFromBothSidesIsClosed) {
  Mesh sheet = planeMesh();
  const std::vector<std::uint32_t> front = sheet.indices;
  sheet.indices.insert(sheet.indices.end(), front.rbegin(), front.rend());
  EXPECT_TRUE(isClosed(sheet));
  sheet.indices.insert(sheet.indices.end(), front.begin(), front.end());
  EXPECT_FALSE(isClosed(sheet));
}

TEST(IsBall, KnowsBallsByTheirTriangles) {
  EXPECT_TRUE(isBall(sphereMesh()));
  EXPECT_TRUE(isBall(sphereMesh(24, 48)));
  EXPECT_FALSE(isBall(sphereMesh(4, 8))) << "whose middles lie deep";
  EXPECT_FALSE(isBall(torusMesh()));
  EXPECT_FALSE(isBall(cubeMesh())) << "all its corners are on a ball";
  EXPECT_FALSE(isBall(Mesh{}));
  Mesh hollow = sphereMesh();
  for (std::size_t i = 0; i < hollow.indices.size(); i += 3) std::swap(hollow.indices[i], hollow.indices[i + 1]);
  EXPECT_FALSE(isBall(hollow)) << "it is seen from inside, and sees itself";
  Mesh dented = sphereMesh();
  dented.vertices[5000].position *= 0.999f;
  EXPECT_FALSE(isBall(dented));
}

TEST(ClosedSurface, FacesInwardsIfItsTrianglesAreTurnedRound) {
  for (Mesh mesh : {sphereMesh(8, 16), torusMesh(24, 12), cubeMesh()}) {
    for (Vertex& vertex : mesh.vertices) vertex.position += glm::vec3(7.0f, -3.0f, 2.0f);
    EXPECT_FALSE(facesInwards(mesh));
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i], mesh.indices[i + 1]);
    EXPECT_TRUE(facesInwards(mesh));
    mesh.indices.resize(mesh.indices.size() - 3);
    EXPECT_FALSE(facesInwards(mesh)) << "it is open";
  }
  EXPECT_FALSE(facesInwards(planeMesh()));
  EXPECT_FALSE(facesInwards(Mesh{}));
}

TEST(OpenBodies, AreThoseThatTransmitAndHaveAnInside) {
  Scene scene = *loadModel("plane");
  EXPECT_TRUE(openBodies(scene).empty()) << "it is opaque";
  scene.materials[0] = *materialNamed("glass");
  EXPECT_THAT(openBodies(scene), ElementsAre(AllOf(HasSubstr("'glass'"), HasSubstr("open"))));
  scene.materials[0].name.clear();
  scene.meshes.push_back(cubeMesh());
  EXPECT_THAT(openBodies(scene), ElementsAre(HasSubstr("1 of 2 surfaces of material 0")));
  scene.materials[0].thin_walled = true;
  EXPECT_TRUE(openBodies(scene).empty());
}

}  // namespace
}  // namespace mirrorball
