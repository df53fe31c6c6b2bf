#include "mirrorball/environment/cube/face_reading.h"

#include <gtest/gtest.h>

#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/cube/preset.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/file/map_form.h"
#include "mirrorball/environment/file/recognize.h"

namespace mirrorball {
namespace {

CubeArrangement arrangedAs(const std::string& hint) { return formHintNamed(hint)->arrangement; }

/// The images of a world of waves, which look alike in no two directions, by slots.
EnvironmentMap imagesOfWaves(const CubeArrangement& arrangement) {
  static const EnvironmentMap cube = *convert(Environment(testing::waves, 1), Projection::cube, 256);
  return EnvironmentMap(Projection::cube, imagesOf(cube, {.projection = Projection::cube, .arrangement = arrangement}));
}

TEST(FaceReading, EdgesTellTheArrangementsOfEngines) {
  const std::vector<CubeArrangement> from_ours = possibleArrangements({});
  for (const char* hint : {"faces", "faces:as-seen", "faces:for=quake", "faces:turn=+y-y", "faces:as-seen,turn=+y",
                           "faces:axes=+x-z-y|-x+z-y|+y+z-x|-y-z-x|+z+x-y|-z-x-y"}) {
    const FaceReading reading = readByEdges(imagesOfWaves(arrangedAs(hint)), from_ours);
    EXPECT_EQ(reading.arrangement, arrangedAs(hint)) << hint;
    EXPECT_TRUE(reading.fit.meets()) << hint;
  }
}

TEST(FaceReading, WhatIsExpectedStaysWhereEdgesSayNothing) {
  ImageSet images(1, 6);
  for (int slot = 0; slot < 6; ++slot) images.at(0, slot) = Image(16, 16, 3, 1.0f);
  const EnvironmentMap grey(Projection::cube, std::move(images));
  for (const char* hint : {"faces", "faces:for=quake", "faces:for=krpano", "faces:for=ogre"})
    EXPECT_EQ(readByEdges(grey, possibleArrangements(arrangedAs(hint))).arrangement, arrangedAs(hint));
}

TEST(FaceReading, NumbersMayCountAround) {
  const CubeArrangement around = arrangedAs("faces:for=krpano,order=+z+x-z-x+y-y");
  EXPECT_EQ(readByEdges(imagesOfWaves(around), possibleArrangements({}, true)).arrangement, around);
  EXPECT_EQ(readByEdges(imagesOfWaves({}), possibleArrangements(around, true)).arrangement, CubeArrangement{});
  EXPECT_FALSE(readByEdges(imagesOfWaves(around), possibleArrangements({})).fit.meets());
}

TEST(FaceReading, PicturesOfNoCubeProveNone) {
  EnvironmentMap images = imagesOfWaves({});
  const std::vector<CubeArrangement> arrangements = possibleArrangements({}, true);
  EXPECT_TRUE(readByEdges(images, arrangements).is_proved);
  // Six worlds, each turned a little further.
  for (int slot = 0; slot < 6; ++slot) {
    const auto turned = [&](glm::vec3 d) {
      return testing::waves(glm::normalize(d + 0.4f * glm::vec3(slot, -slot, 1)));
    };
    const Image map = convert(Environment(turned, 1), Projection::octahedral, 256)->face(0);
    images.face(slot) = map;
  }
  EXPECT_FALSE(readByEdges(images, arrangements).is_proved);
  // Six discs on black, as photographed balls are.
  const Image disc = convert(Environment(testing::waves, 1), Projection::angular, 256)->face(0);
  for (int slot = 0; slot < 6; ++slot) images.face(slot) = disc;
  EXPECT_FALSE(readByEdges(images, arrangements).is_proved);
}

TEST(FaceReading, EdgesCannotTellAMirroredWorld) {
  const CubeArrangement ours;
  const CubeArrangement seen = arrangedAs("faces:for=krpano");
  EXPECT_EQ(mirrorReading(ours), seen);
  EXPECT_EQ(mirrorReading(seen), ours);
  for (const CubeArrangement& arrangement : {ours, seen}) {
    EXPECT_TRUE(edgeFit(imagesOfWaves(ours), arrangement).meets());
    EXPECT_TRUE(edgeFit(imagesOfWaves(seen), arrangement).meets());
  }
  // The mirror images of these nobody has: their right is at the left of their front.
  EXPECT_FALSE(mirrorReading(arrangedAs("faces:as-seen")));
  EXPECT_FALSE(mirrorReading(arrangedAs("faces:for=quake")));
}

TEST(FaceReading, AHintNamesEachArrangement) {
  for (const char* hint :
       {"faces", "faces:as-seen", "faces:for=quake", "faces:for=krpano", "faces:for=ogre", "faces:turn=+y-y"})
    EXPECT_EQ(hintForFaces(arrangedAs(hint)), hint);
  for (const CubeArrangement& arrangement : possibleArrangements({}, true))
    EXPECT_EQ(arrangedAs(hintForFaces(arrangement)), arrangement);
  // Remarks join hints with '|'.
  EXPECT_EQ(hintForFaces(arrangedAs("faces:for=unreal")).find('|'), std::string::npos);
}

}  // namespace
}  // namespace mirrorball
