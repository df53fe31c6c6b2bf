#include "mirrorball/environment/cube/cube_edges.h"

#include <gtest/gtest.h>

#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/file/map_form.h"

namespace mirrorball {
namespace {

EnvironmentMap cubeOfWaves(Projection projection, int side) {
  return *convert(Environment(testing::waves, 1), projection, side);
}

TEST(CubeEdges, TheFacesOfACubeMeet) {
  for (const Projection projection : {Projection::cube, Projection::eac})
    for (const int side : {16, 64, 200}) {
      const EdgeFit fit = edgeFit(cubeOfWaves(projection, side));
      EXPECT_TRUE(fit.meets()) << fit.across << " " << fit.beside;
      EXPECT_FALSE(fit.jumps());
    }
}

TEST(CubeEdges, MirroredFacesInTheirOwnPlacesDoNot) {
  const MapForm seen{.projection = Projection::cube, .arrangement = asSeen(CubeArrangement{})};
  const EdgeFit fit = edgeFit(mapOfImages(imagesOf(cubeOfWaves(Projection::cube, 256), seen), {Projection::cube}));
  EXPECT_FALSE(fit.meets()) << fit.across << " " << fit.beside;
}

TEST(CubeEdges, OneFaceOnItsHeadIsSeenUnderTheOthersThatMeet) {
  const CubeArrangement turned_back = turned(CubeArrangement{}, std::array{SignedAxis::minus_z});
  const EnvironmentMap right = cubeOfWaves(Projection::cube, 64);
  const EnvironmentMap wrong =
      mapOfImages(imagesOf(right, {.projection = Projection::cube, .arrangement = turned_back}), {Projection::cube});
  EXPECT_TRUE(edgeFit(right).isClearlyBetterThan(edgeFit(right, turned_back)));
  EXPECT_TRUE(edgeFit(wrong, turned_back).isClearlyBetterThan(edgeFit(wrong)));
  EXPECT_FALSE(edgeFit(wrong).isClearlyBetterThan(edgeFit(wrong)));
  // The arrangement is only looked through: the images are what the other cube has.
  EXPECT_FLOAT_EQ(edgeFit(wrong, turned_back).across, edgeFit(right).across);
}

TEST(CubeEdges, APhotographInSixTilesDoesNot) {
  Image photograph(192, 128, 3);
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 192; ++x)
      std::fill_n(photograph.texel(x, y), 3, 0.1f + 0.8f * float(y) / 128.0f + 0.1f * std::sin(0.2f * float(x)));
  const auto map = mapOfPicture(photograph, {.projection = Projection::cube, .layout = CubeLayout::tiles});
  ASSERT_TRUE(map);
  EXPECT_TRUE(edgeFit(*map).jumps()) << edgeFit(*map).across << " " << edgeFit(*map).beside;
}

void fill(Image& face, float value) { std::fill(face.samples().begin(), face.samples().end(), value); }

TEST(CubeEdges, FacesOfOneColourEachSayNothing) {
  EnvironmentMap cube = cubeOfWaves(Projection::cube, 16);
  for (int face = 0; face < 6; ++face) fill(cube.face(face), float(face) + 0.5f);
  EXPECT_FALSE(edgeFit(cube).jumps());
  fill(cube.face(2), 0.0f);
  EXPECT_FALSE(edgeFit(cube).jumps());
}

}  // namespace
}  // namespace mirrorball
