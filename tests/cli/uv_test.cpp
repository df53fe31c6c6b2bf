// Which way round things are: every map that the program writes, and the background that it draws.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "cli/cli_testing.h"
#include "cli/measure.h"

namespace mirrorball::testing {
namespace {

constexpr float kPi = 3.14159265f;

/// A face of the cube by OpenGL's table: its axis, and the directions in which s and t grow.
struct FaceFrame {
  const char* suffix;
  const char* name;
  glm::vec3 axis;
  glm::vec3 right;
  glm::vec3 down;
};

// From the table's (sc, tc): +X (−z, −y), −X (z, −y), +Y (x, z), −Y (x, −z), +Z (x, −y), −Z (−x, −y).
const std::array<FaceFrame, 6> kFrames{{
    {"px", "+X", {1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
    {"nx", "-X", {-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
    {"py", "+Y", {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
    {"ny", "-Y", {0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
    {"pz", "+Z", {0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
    {"nz", "-Z", {0, 0, -1}, {-1, 0, 0}, {0, -1, 0}},
}};

/// A layout as a picture of faces: the names of each row's cells, and the face that stands on its head.
struct LayoutPicture {
  const char* name;
  std::vector<std::vector<const char*>> rows;
  const char* turned = "";
};

const std::array<LayoutPicture, 5> kLayouts{{
    {"hcross", {{"", "+Y", "", ""}, {"-X", "+Z", "+X", "-Z"}, {"", "-Y", "", ""}}},
    {"vcross", {{"", "+Y", ""}, {"-X", "+Z", "+X"}, {"", "-Y", ""}, {"", "-Z", ""}}, "-Z"},
    {"hstrip", {{"+X", "-X", "+Y", "-Y", "+Z", "-Z"}}},
    {"vstrip", {{"+X"}, {"-X"}, {"+Y"}, {"-Y"}, {"+Z"}, {"-Z"}}},
    {"3x2", {{"+X", "-X", "+Y"}, {"-Y", "+Z", "-Z"}}},
}};

/// A panorama whose colour is the direction, (d + 1) / 2, by the conventions' formula read backwards:
/// u = atan2(x, −z) / 2π, v = acos(y) / π.
Image directionPanorama() {
  Image image(256, 128, 3);
  for (int j = 0; j < 128; ++j)
    for (int i = 0; i < 256; ++i) {
      const float longitude = 2.0f * kPi * (static_cast<float>(i) + 0.5f) / 256.0f;
      const float latitude = kPi * (static_cast<float>(j) + 0.5f) / 128.0f;
      const glm::vec3 d(std::sin(latitude) * std::sin(longitude), std::cos(latitude),
                        -std::sin(latitude) * std::cos(longitude));
      for (int channel = 0; channel < 3; ++channel) image.texel(i, j)[channel] = (d[channel] + 1.0f) / 2.0f;
    }
  return image;
}

/// Expects a map of directionPanorama() to show a direction at a place.
void expectDirection(const Image& image, glm::vec2 place, glm::vec3 direction, const std::string& what) {
  const glm::ivec2 texel(place * glm::vec2(image.width(), image.height()));
  const glm::vec3 shown = rgbAt(image, texel.x, texel.y) * 2.0f - 1.0f;
  // A texel's centre is up to ¾ of a texel, 1/170 of the map, away from the place; on a disc that is at most 0.05 rad.
  EXPECT_LT(glm::length(shown - glm::normalize(direction)), 0.06f) << what << " at " << place.x << ", " << place.y;
}

void expectFace(const Image& image, glm::vec2 place, const std::string& face) {
  EXPECT_EQ(uvFaceAt(image, place), face) << "at " << place.x << ", " << place.y;
}

using UvTest = CliTest;
using UvRenderTest = RenderCliTest;

TEST_F(UvTest, KnownTexelsOfAPanorama) {
  succeed("convert uv --to equirect --size 256 -o map.exr");
  const Image map = image("map.exr");
  ASSERT_EQ(map.width(), 512);
  ASSERT_EQ(map.height(), 256);
  expectFace(map, {0.5f, 0.5f}, "+Z");
  expectFace(map, {0.25f, 0.5f}, "+X");
  expectFace(map, {0.75f, 0.5f}, "-X");
  expectFace(map, {0.0f, 0.5f}, "-Z");
  expectFace(map, {1.0f, 0.5f}, "-Z");
  expectFace(map, {0.5f, 0.0f}, "+Y");
  expectFace(map, {0.5f, 1.0f}, "-Y");
  for (const float left : {0.125f, 0.375f, 0.625f})
    EXPECT_EQ(orientationOfName(map, {left, 0.25f}, {0.25f, 0.5f}), "upright");
  // −Z lies across the seam.
  expectFace(map, {1.0f - 0.55f / 8.0f, 0.5f}, "name");
  expectFace(map, {0.55f / 8.0f, 0.5f}, "-Z");
}

// A mirror ball's normal at (n_x, n_y) shows the direction to which it halves the way from +Z: ±X and ±Y at sin 45° of
// the radius, an edge of face +Z at sin 22.5°.
TEST_F(UvTest, KnownTexelsOfASphereMap) {
  succeed("convert uv --to sphere --size 256 -o map.exr");
  const Image map = image("map.exr");
  ASSERT_EQ(map.width(), 256);
  ASSERT_EQ(map.height(), 256);
  expectFace(map, {0.5f, 0.5f}, "+Z");
  expectFace(map, {0.854f, 0.5f}, "+X");
  expectFace(map, {0.146f, 0.5f}, "-X");
  expectFace(map, {0.5f, 0.146f}, "+Y");
  expectFace(map, {0.5f, 0.854f}, "-Y");
  expectFace(map, {0.5f, 0.0f}, "-Z");
  expectFace(map, {0.5f, 1.0f}, "-Z");
  EXPECT_EQ(orientationOfName(map, glm::vec2(0.5f - 0.1913f), glm::vec2(2.0f * 0.1913f)), "mirrored");
  for (const auto& [x, y] : {std::pair{0, 0}, {255, 0}, {0, 255}, {255, 255}})
    EXPECT_EQ(rgbaAt(map, x, y), glm::vec4(0.0f)) << "beside the disc";
  EXPECT_EQ(rgbaAt(map, 128, 128).w, 1.0f);
}

// The distance from the centre is the angle from +Z, half the width being 180°.
TEST_F(UvTest, KnownTexelsOfAnAngularMap) {
  succeed("convert uv --to angular --size 256 -o map.exr");
  const Image map = image("map.exr");
  ASSERT_EQ(map.width(), 256);
  ASSERT_EQ(map.height(), 256);
  expectFace(map, {0.5f, 0.5f}, "+Z");
  expectFace(map, {0.75f, 0.5f}, "+X");
  expectFace(map, {0.25f, 0.5f}, "-X");
  expectFace(map, {0.5f, 0.25f}, "+Y");
  expectFace(map, {0.5f, 0.75f}, "-Y");
  expectFace(map, {0.5f, 0.02f}, "-Z");
  EXPECT_EQ(orientationOfName(map, {0.375f, 0.375f}, {0.25f, 0.25f}), "mirrored");
  EXPECT_EQ(rgbaAt(map, 0, 0), glm::vec4(0.0f)) << "beside the disc";
}

TEST_F(UvTest, EveryCubeLayoutHasItsFacesInTheirCellsWithMirroredNames) {
  for (const LayoutPicture& layout : kLayouts) {
    SCOPED_TRACE(layout.name);
    const std::string file = std::string(layout.name) + ".exr";
    succeed("convert uv --to cube --size 64 -o " + file + " --layout " + layout.name);
    const Image map = image(file);
    const glm::ivec2 cells(layout.rows[0].size(), layout.rows.size());
    ASSERT_EQ(map.width(), 64 * cells.x);
    ASSERT_EQ(map.height(), 64 * cells.y);
    const glm::vec2 size = 1.0f / glm::vec2(cells);
    for (int row = 0; row < cells.y; ++row)
      for (int column = 0; column < cells.x; ++column) {
        const std::string face = layout.rows[std::size_t(row)][std::size_t(column)];
        SCOPED_TRACE("the cell of " + face);
        const glm::vec2 corner = size * glm::vec2(column, row);
        expectFace(map, corner + size / 2.0f, face.empty() ? "black" : face);
        if (face.empty()) continue;
        EXPECT_EQ(orientationOfName(map, corner, size), face == layout.turned ? "mirrored and turned" : "mirrored");
      }
  }
}

TEST_F(UvTest, SixFilesHoldAFaceEach) {
  succeed("convert uv --to cube --layout faces --size 64 -o room.exr");
  EXPECT_EQ(files().size(), 6u);
  for (const FaceFrame& frame : kFrames) {
    SCOPED_TRACE(frame.name);
    const Image face = image(std::string("room_") + frame.suffix + ".exr");
    ASSERT_EQ(face.width(), 64);
    ASSERT_EQ(face.height(), 64);
    expectFace(face, {0.5f, 0.5f}, frame.name);
    EXPECT_EQ(orientationOfName(face), "mirrored");
  }
}

// Whatever `uv` itself may be: a panorama made in the test says by its colour which direction a texel looks.
TEST_F(UvTest, TexelsLookWhereTheConventionsSay) {
  write("in.exr", directionPanorama());
  succeed("convert in.exr --to cube --layout faces --size 128 -o cube.exr");
  for (const FaceFrame& frame : kFrames) {
    const Image face = image(std::string("cube_") + frame.suffix + ".exr");
    // Halfway from the middle to an edge the face's plane is ½ away from its axis.
    expectDirection(face, {0.5f, 0.5f}, frame.axis, frame.name);
    expectDirection(face, {0.75f, 0.5f}, frame.axis + 0.5f * frame.right, frame.name);
    expectDirection(face, {0.5f, 0.75f}, frame.axis + 0.5f * frame.down, frame.name);
  }
  succeed("convert in.exr --to sphere --size 256 -o ball.exr");
  succeed("convert in.exr --to angular --size 256 -o probe.exr");
  // GL_SPHERE_MAP: half the radius right is n = (½, 0, ¾^½), which shows r = (2 n_z n_x, 0, 2 n_z² − 1)
  // = (0.866, 0, ½).
  expectDirection(image("ball.exr"), {0.5f, 0.5f}, {0, 0, 1}, "sphere");
  expectDirection(image("ball.exr"), {0.75f, 0.5f}, {0.866f, 0, 0.5f}, "sphere");
  expectDirection(image("ball.exr"), {0.5f, 0.25f}, {0, 0.866f, 0.5f}, "sphere");
  expectDirection(image("probe.exr"), {0.625f, 0.5f}, {1, 0, 1}, "angular");
  expectDirection(image("probe.exr"), {0.5f, 0.125f}, {0, 1, -1}, "angular");
  succeed("convert ball.exr --to equirect --size 128 -o again.exr");
  expectDirection(image("again.exr"), {0.25f, 0.5f}, {1, 0, 0}, "equirect");
  expectDirection(image("again.exr"), {0.375f, 0.25f}, {0.5f, 0.707f, 0.5f}, "equirect");
}

/// What a camera sees of `uv`, with 120° across: the faces in its middle and towards the picture's edges.
struct View {
  const char* camera;
  const char* middle;
  const char* left;
  const char* right;
  const char* above;
  const char* below;
};

TEST_F(UvRenderTest, TheBackgroundIsSeenFromInside) {
  succeed("convert uv --to cube --size 128 -o uv.exr");
  // The camera stands opposite to where it looks. Overhead and underfoot, azimuth 180 has −Z and +Z above.
  for (const View& view :
       {View{"180,0", "+Z", "+X", "-X", "+Y", "-Y"}, View{"0,0", "-Z", "-X", "+X", "+Y", "-Y"},
        View{"270,0", "+X", "-Z", "+Z", "+Y", "-Y"}, View{"90,0", "-X", "+Z", "-Z", "+Y", "-Y"},
        View{"180,90", "-Y", "+X", "-X", "+Z", "-Z"}, View{"180,-90", "+Y", "+X", "-X", "-Z", "+Z"}}) {
    SCOPED_TRACE(view.camera);
    const std::string camera = std::string(" --camera ") + view.camera;
    succeed("render none -e uv.exr --fov 120 --size 64x64 -o wide.exr" + camera);
    const Image wide = image("wide.exr");
    expectFace(wide, {0.5f, 0.5f}, view.middle);
    expectFace(wide, {0.1f, 0.5f}, view.left);
    expectFace(wide, {0.9f, 0.5f}, view.right);
    expectFace(wide, {0.5f, 0.1f}, view.above);
    expectFace(wide, {0.5f, 0.9f}, view.below);
    // At 90° the picture is just one face, whose name reads normally.
    succeed("render none -e uv.exr --fov 90 --size 128x128 -o face.exr" + camera);
    EXPECT_EQ(orientationOfName(image("face.exr")), "upright");
  }
}

TEST_F(UvRenderTest, APictureShowsWhatItsRadianceShows) {
  succeed("convert uv --to cube --size 64 -o uv.exr");
  for (const char* file : {"view.png", "view.jpg", "view.hdr"}) {
    succeed("render none -e uv.exr --camera 180,0 --fov 90 --size 128x128 -o " + std::string(file));
    expectFace(image(file), {0.5f, 0.5f}, "+Z");
    EXPECT_EQ(orientationOfName(image(file)), "upright") << file;
  }
}

}  // namespace
}  // namespace mirrorball::testing
