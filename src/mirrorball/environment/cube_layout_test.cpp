#include "mirrorball/environment/cube_layout.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

/// A cube whose texels are all different.
EnvironmentMap numberedCube(int side) {
  ImageSet faces(1, 6);
  float number = 0.0f;
  for (int face = 0; face < 6; ++face) {
    faces.at(0, face) = Image(side, side, 3);
    for (float& sample : faces.at(0, face).samples()) sample = number++;
  }
  return EnvironmentMap(Projection::cube, std::move(faces));
}

CubeLayout layoutAt(std::size_t index) { return static_cast<CubeLayout>(index); }

TEST(CubeLayout, EveryLayoutComesBack) {
  const EnvironmentMap cube = numberedCube(5);
  for (std::size_t index = 1; index < cubeLayoutNames().size(); ++index) {
    const Image picture = composeLayout(cube, layoutAt(index));
    EXPECT_EQ(layoutOfShape(picture.width(), picture.height()), layoutAt(index));
    const EnvironmentMap back = *splitLayout(picture, layoutAt(index));
    for (int face = 0; face < 6; ++face)
      EXPECT_TRUE(std::equal(cube.face(face).samples().begin(), cube.face(face).samples().end(),
                             back.face(face).samples().begin()))
          << nameOf(layoutAt(index)) << " face " << face;
  }
}

/// Whether the lower edge of one cell of a picture continues in the cell below it: texels on both sides of the edge lie
/// in nearly the same direction.
void expectContinuous(CubeLayout layout, glm::ivec2 upper_cell) {
  constexpr int kSide = 64;
  ImageSet faces(1, 6);
  for (int face = 0; face < 6; ++face) {
    faces.at(0, face) = Image(kSide, kSide, 3);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const glm::vec3 d = directionAt(Projection::cube, {face, (glm::vec2(x, y) + 0.5f) / float(kSide)});
        std::copy_n(&d.x, 3, faces.at(0, face).texel(x, y));
      }
  }
  const Image picture = composeLayout(EnvironmentMap(Projection::cube, std::move(faces)), layout);
  const glm::ivec2 corner = upper_cell * kSide;
  for (int x = 0; x < kSide; ++x) {
    const glm::vec3 above = rgbAt(picture, corner.x + x, corner.y + kSide - 1);
    const glm::vec3 below = rgbAt(picture, corner.x + x, corner.y + kSide);
    EXPECT_LT(glm::length(above - below), 0.05f) << nameOf(layout) << " column " << x;
  }
}

TEST(CubeLayout, CrossesAreUnfoldedWithoutABreak) {
  expectContinuous(CubeLayout::hcross, {1, 0});
  expectContinuous(CubeLayout::hcross, {1, 1});
  expectContinuous(CubeLayout::vcross, {1, 0});
  expectContinuous(CubeLayout::vcross, {1, 1});
  expectContinuous(CubeLayout::vcross, {1, 2});
}

TEST(CubeLayout, WrongProportionsAreNamed) {
  const auto wrong = splitLayout(Image(10, 10, 3), CubeLayout::hcross);
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().message, "10x10 is not 4:3, as the cube layout hcross is");
  EXPECT_EQ(layoutOfShape(10, 10), std::nullopt);
  EXPECT_EQ(layoutOfShape(7, 1), std::nullopt);
}

}  // namespace
}  // namespace mirrorball
