#include "mirrorball/environment/cube_layout.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/environment/environment_testing.h"

namespace mirrorball {
namespace {

/// A cube whose texels are all different.
ImageSet numberedCube(int side) {
  ImageSet faces(1, 6);
  float number = 0.0f;
  for (int face = 0; face < 6; ++face) {
    faces.at(0, face) = Image(side, side, 3);
    for (float& sample : faces.at(0, face).samples()) sample = number++;
  }
  return faces;
}

CubeLayout layoutAt(std::size_t index) { return static_cast<CubeLayout>(index); }

TEST(CubeLayout, EveryLayoutComesBack) {
  const ImageSet cube = numberedCube(5);
  for (std::size_t index = 1; index < cubeLayoutNames().size(); ++index) {
    const Image picture = composeLayout(cube, layoutAt(index));
    const CubeLayout of_its_shape = layoutAt(index) == CubeLayout::seed ? CubeLayout::hcross : layoutAt(index);
    EXPECT_EQ(layoutOfShape(picture.width(), picture.height()), of_its_shape);
    const ImageSet back = *splitLayout(picture, layoutAt(index));
    for (int face = 0; face < 6; ++face)
      EXPECT_TRUE(std::equal(cube.at(0, face).samples().begin(), cube.at(0, face).samples().end(),
                             back.at(0, face).samples().begin()))
          << nameOf(layoutAt(index)) << " face " << face;
  }
}

/// How many pairs of cells with faces, side by side or one above the other, a layout has; expects the picture to go on
/// from each into the other: texels on both sides of the edge lie in nearly the same direction.
int expectContinuous(CubeLayout layout) {
  constexpr int kSide = 64;
  ImageSet faces(1, 6);
  for (int face = 0; face < 6; ++face) faces.at(0, face) = testing::directionsOfFace(face, kSide);
  const Image picture = composeLayout(faces, layout);
  const auto isFace = [&](glm::ivec2 cell) {
    return rgbAt(picture, cell.x * kSide, cell.y * kSide) != glm::vec3(0.0f);
  };
  const auto directionIn = [&](glm::ivec2 cell, glm::ivec2 texel) {
    return rgbAt(picture, cell.x * kSide + texel.x, cell.y * kSide + texel.y);
  };
  int neighbours = 0;
  for (const glm::ivec2 step : {glm::ivec2(1, 0), glm::ivec2(0, 1)})
    for (int row = 0; row + step.y < cellsOf(layout).y; ++row)
      for (int column = 0; column + step.x < cellsOf(layout).x; ++column) {
        const glm::ivec2 cell(column, row);
        if (!isFace(cell) || !isFace(cell + step)) continue;
        ++neighbours;
        for (int i = 0; i < kSide; ++i) {
          const glm::ivec2 along = i * glm::ivec2(step.y, step.x);
          const glm::vec3 last = directionIn(cell, along + (kSide - 1) * step);
          EXPECT_LT(glm::length(last - directionIn(cell + step, along)), 0.05f)
              << nameOf(layout) << " after column " << column << ", row " << row << " at " << i;
        }
      }
  return neighbours;
}

TEST(CubeLayout, CrossesAreUnfoldedWithoutABreak) {
  for (const CubeLayout cross : {CubeLayout::hcross, CubeLayout::vcross, CubeLayout::seed})
    EXPECT_EQ(expectContinuous(cross), 5) << nameOf(cross);
}

// The drawing in the seed: bottom, front, top and back in the row, left above the top and right below it.
TEST(CubeLayout, TheSeedsCrossHasTheFacesOfItsDrawing) {
  ImageSet faces(1, 6);
  for (int face = 0; face < 6; ++face) faces.at(0, face) = Image(1, 1, 1, static_cast<float>(face + 1));
  const Image picture = composeLayout(faces, CubeLayout::seed);
  const float right = 1, left = 2, top = 3, bottom = 4, front = 5, back = 6;
  EXPECT_THAT(picture.samples(), ::testing::ElementsAre(0, 0, left, 0,             //
                                                        bottom, front, top, back,  //
                                                        0, 0, right, 0));
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
