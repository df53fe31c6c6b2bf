#include "mirrorball/environment/cube/cube_layout.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/file/map_form.h"

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
    const CubeLayout of_its_shape = layoutAt(index) == CubeLayout::lecture ? CubeLayout::hcross : layoutAt(index);
    EXPECT_EQ(layoutOfShape(picture.width(), picture.height()), of_its_shape);
    const ImageSet back = *splitLayout(picture, layoutAt(index));
    for (int face = 0; face < 6; ++face)
      EXPECT_TRUE(std::equal(cube.at(0, face).samples().begin(), cube.at(0, face).samples().end(),
                             back.at(0, face).samples().begin()))
          << nameOf(layoutAt(index)) << " face " << face;
  }
}

TEST(CubeLayout, APlaceOfAFaceIsFoundInThePicture) {
  constexpr int kSide = 4;
  const ImageSet cube = numberedCube(kSide);
  for (std::size_t index = 1; index < cubeLayoutNames().size(); ++index) {
    const Image picture = composeLayout(cube, layoutAt(index));
    for (int face = 0; face < 6; ++face)
      for (const glm::ivec2 texel : {glm::ivec2(0, 0), glm::ivec2(3, 0), glm::ivec2(1, 2)}) {
        const glm::vec2 place = placeInLayout({face, (glm::vec2(texel) + 0.5f) / float(kSide)}, layoutAt(index));
        const glm::ivec2 found(place * glm::vec2(picture.width(), picture.height()));
        EXPECT_EQ(rgbAt(picture, found.x, found.y), rgbAt(cube.at(0, face), texel.x, texel.y))
            << nameOf(layoutAt(index)) << " face " << face;
      }
  }
}

/// How many pairs of cells with faces, side by side or one above the other, a cube has in one picture; expects the
/// picture to go on from each into the other: texels on both sides of the edge lie in nearly the same direction.
int expectContinuous(CubeLayout layout, const CubeArrangement& arrangement) {
  constexpr int kSide = 64;
  ImageSet faces(1, 6);
  for (int face = 0; face < 6; ++face) faces.at(0, face) = testing::directionsOfFace(face, kSide);
  const Image picture =
      pictureOf(EnvironmentMap(Projection::cube, std::move(faces)), {Projection::cube, layout, arrangement});
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
              << nameOf(layout) << " " << textOf(arrangement) << " after column " << column << ", row " << row << " at "
              << i;
        }
      }
  return neighbours;
}

TEST(CubeLayout, EachFaceLiesInItsCell) {
  const ImageSet cube = numberedCube(1);
  for (std::size_t index = 1; index < cubeLayoutNames().size(); ++index) {
    const Image picture = composeLayout(cube, layoutAt(index));
    for (int face = 0; face < 6; ++face) {
      const glm::ivec2 cell = cellOf(layoutAt(index), face);
      EXPECT_EQ(rgbAt(picture, cell.x, cell.y), rgbAt(cube.at(0, face), 0, 0))
          << nameOf(layoutAt(index)) << " " << cubeFaceName(face);
    }
  }
}

TEST(CubeLayout, CrossesAreUnfoldedWithoutABreak) {
  const CubeArrangement ours;
  const WorldAxes z_up{SignedAxis::plus_x, SignedAxis::plus_z, SignedAxis::plus_y};
  for (const CubeLayout cross : {CubeLayout::hcross, CubeLayout::vcross, CubeLayout::lecture})
    for (const CubeArrangement& arrangement :
         {ours, asSeen(ours), flipped(ours, Flip::vertical), flipped(ours, Flip::both), inWorld(ours, z_up),
          inWorld(ours, {.x = SignedAxis::minus_x}), asSeen(inWorld(ours, z_up))})
      EXPECT_EQ(expectContinuous(cross, arrangement), 5) << nameOf(cross);
}

TEST(CubeLayout, TheMiddleRowOfTheCrossAsSeenIsWhatAnEyeTurningRightSees) {
  ImageSet faces(1, 6);
  for (int face = 0; face < 6; ++face) faces.at(0, face) = Image(1, 1, 1, static_cast<float>(face));
  const Image picture = pictureOf(EnvironmentMap(Projection::cube, std::move(faces)),
                                  {Projection::cube, CubeLayout::hcross, asSeen(CubeArrangement{})});
  const float plus_x = 0, minus_x = 1, plus_z = 4, minus_z = 5;
  EXPECT_THAT(picture.row(1), ::testing::ElementsAre(plus_x, plus_z, minus_x, minus_z));
}

// The drawing in the lecture: bottom, front, top and back in the row, left above the top and right below it.
TEST(CubeLayout, TheSeedsCrossHasTheFacesOfItsDrawing) {
  ImageSet faces(1, 6);
  for (int face = 0; face < 6; ++face) faces.at(0, face) = Image(1, 1, 1, static_cast<float>(face + 1));
  const Image picture = composeLayout(faces, CubeLayout::lecture);
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
