#include "mirrorball/environment/cube/cube_arrangement.h"

#include <algorithm>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/environment/environment_testing.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

constexpr int kFaceSide = 5;

/// A few arrangements, among them some whose images are turned by a quarter.
std::vector<CubeArrangement> someArrangements() {
  const CubeArrangement ours;
  const WorldAxes z_up{SignedAxis::plus_x, SignedAxis::plus_z, SignedAxis::plus_y};
  return {ours,
          asSeen(ours),
          flipped(ours, Flip::vertical),
          flipped(ours, Flip::both),
          inWorld(ours, {.x = SignedAxis::minus_x}),
          inWorld(ours, z_up),
          inWorld(asSeen(ours), {SignedAxis::minus_z, SignedAxis::plus_x, SignedAxis::minus_y}),
          reordered(inWorld(ours, z_up), {2, 3, 4, 5, 0, 1})};
}

/// A cube whose texels hold their direction, unit.
ImageSet cubeOfDirections() {
  ImageSet faces(1, 6);
  for (int face = 0; face < 6; ++face) faces.at(0, face) = testing::directionsOfFace(face, kFaceSide);
  return faces;
}

bool areEqual(const Image& a, const Image& b) {
  return a.width() == b.width() && std::equal(a.samples().begin(), a.samples().end(), b.samples().begin());
}

TEST(CubeArrangement, OursIsTheFormulasTable) {
  const CubeArrangement ours;
  for (int face = 0; face < 6; ++face) {
    const FaceFrame& frame = ours.slots[static_cast<std::size_t>(face)];
    EXPECT_EQ(directionAt(Projection::cube, {face, {0.5f, 0.5f}}), vectorOf(frame.centre));
    const glm::vec3 corner = vectorOf(frame.centre) + vectorOf(frame.right) + vectorOf(frame.down);
    EXPECT_LT(glm::length(directionAt(Projection::cube, {face, {1.0f, 1.0f}}) - glm::normalize(corner)), 1e-6f);
  }
}

// The one promise of an arrangement, for every texel of every slot.
TEST(CubeArrangement, EveryTexelAnswersForTheDirectionThatItsFrameSays) {
  for (const CubeArrangement& arrangement : someArrangements()) {
    ASSERT_TRUE(isComplete(arrangement));
    const ImageSet images = arranged(cubeOfDirections(), arrangement);
    for (int slot = 0; slot < 6; ++slot) {
      const FaceFrame& frame = arrangement.slots[static_cast<std::size_t>(slot)];
      for (int y = 0; y < kFaceSide; ++y)
        for (int x = 0; x < kFaceSide; ++x) {
          const glm::vec2 st = 2.0f * (glm::vec2(x, y) + 0.5f) / float(kFaceSide) - 1.0f;
          const glm::vec3 d = vectorOf(frame.centre) + st.x * vectorOf(frame.right) + st.y * vectorOf(frame.down);
          EXPECT_LT(glm::length(rgbAt(images.at(0, slot), x, y) - glm::normalize(d)), 1e-6f)
              << textOf(arrangement) << " slot " << slot << " at " << x << ", " << y;
        }
    }
  }
}

TEST(CubeArrangement, TheInverseRestoresEveryBitOfEveryLevelAndLayer) {
  ImageSet cube(2, 6, 2);
  float number = 0.0f;
  for (int level = 0; level < 2; ++level)
    for (int layer = 0; layer < 2; ++layer)
      for (int face = 0; face < 6; ++face) {
        Image& image = cube.at(level, face, layer) = Image(levelSide(6, level), levelSide(6, level), 4);
        for (float& sample : image.samples()) sample = number++;
      }
  for (const CubeArrangement& arrangement : someArrangements()) {
    const ImageSet back = restored(arranged(cube, arrangement), arrangement);
    for (int level = 0; level < 2; ++level)
      for (int layer = 0; layer < 2; ++layer)
        for (int face = 0; face < 6; ++face)
          EXPECT_TRUE(areEqual(back.at(level, face, layer), cube.at(level, face, layer))) << textOf(arrangement);
  }
}

// A picture is what an eye sees if, looking at its centre with its lower edge down, right is on the right.
TEST(CubeArrangement, AsSeenIsWhatAnEyeSeesFromInside) {
  for (const FaceFrame& frame : asSeen(CubeArrangement{}).slots)
    EXPECT_EQ(glm::cross(vectorOf(frame.centre), -vectorOf(frame.down)), vectorOf(frame.right));
}

TEST(CubeArrangement, ALeftHandedWorldSeesOpenGlsTableAsPictures) {
  const CubeArrangement mirrored = inWorld(CubeArrangement{}, {.x = SignedAxis::minus_x});
  EXPECT_EQ(mirrored, reordered(asSeen(CubeArrangement{}), {1, 0, 2, 3, 4, 5}));
}

TEST(CubeArrangement, TextsAreReadBack) {
  EXPECT_EQ(textOf(CubeArrangement{}), "");
  EXPECT_EQ(textOf(asSeen(CubeArrangement{})), "as-seen");
  EXPECT_EQ(textOf(inWorld(CubeArrangement{}, {.x = SignedAxis::minus_x})),
            "axes=-x-z-y|+x+z-y|+y-x+z|-y-x-z|+z-x-y|-z+x-y");
  EXPECT_EQ(textOf(turned(CubeArrangement{}, std::array{SignedAxis::minus_z})), "turn=-z");
  EXPECT_EQ(textOf(flipped(CubeArrangement{}, Flip::both)), "turn=+x-x+y-y+z-z");
  for (const CubeArrangement& arrangement : someArrangements())
    if (arrangement != CubeArrangement{}) {
      EXPECT_EQ(*rearranged(CubeArrangement{}, textOf(arrangement)), arrangement);
    }
}

TEST(CubeArrangement, WordsChangeWhatWasBefore) {
  const CubeArrangement ours;
  EXPECT_EQ(*rearranged(asSeen(ours), "flip=horizontal"), ours);
  EXPECT_EQ(*rearranged(*rearranged(ours, "flip=vertical"), "order=-x+x+y-y+z-z"),
            reordered(flipped(ours, Flip::vertical), {1, 0, 2, 3, 4, 5}));
  EXPECT_EQ(*faceOrderNamed("+X,-X,+Z,-Z,+Y,-Y"), (FaceOrder{0, 1, 4, 5, 2, 3}));

  const auto messageOf = [&](std::string_view word) { return rearranged(ours, word).error().message; };
  EXPECT_THAT(messageOf("as-sen"), HasSubstr("did you mean 'as-seen'?"));
  EXPECT_EQ(*rearranged(*rearranged(ours, "turn=-z,+y"), "turn=+y"), *rearranged(ours, "turn=-z"));
  EXPECT_THAT(messageOf("turn="), HasSubstr("as in turn=-z"));
  EXPECT_THAT(messageOf("turn=-w"), HasSubstr("'-w'"));
  EXPECT_THAT(messageOf("flip=up"), HasSubstr("none, horizontal, vertical, both"));
  EXPECT_THAT(messageOf("order=+x+x+y-y+z-z"), HasSubstr("each of the six once"));
  EXPECT_THAT(messageOf("order=+x-x+y-y+z"), HasSubstr("each of the six once"));
  EXPECT_THAT(messageOf("order=+x-x+y-y+z-z+z"), HasSubstr("each of the six once"));
  EXPECT_THAT(messageOf("order=+x-w"), HasSubstr("'-w'"));
  EXPECT_THAT(messageOf("axes=+x-x-y|-x+z-y|+y+x+z|-y+x-z|+z+x-y|-z-x-y"), HasSubstr("is no cube"));
  EXPECT_THAT(messageOf("axes=+x-z-y"), HasSubstr("is no cube"));
}

TEST(SquareSymmetry, AQuarterClockwisePutsTheLeftColumnOnTop) {
  const SquareSymmetry quarter = turnedClockwise(1);
  EXPECT_EQ(quarter.from({0, 0}, 4), glm::ivec2(0, 3));
  EXPECT_EQ(quarter.from({3, 0}, 4), glm::ivec2(0, 0));
  EXPECT_EQ(quarter.from({3, 3}, 4), glm::ivec2(3, 0));
  EXPECT_EQ(turnedClockwise(2).from({0, 1}, 4), glm::ivec2(3, 2));
  EXPECT_EQ(turnedClockwise(4).from({1, 2}, 4), glm::ivec2(1, 2));
}

}  // namespace
}  // namespace mirrorball
