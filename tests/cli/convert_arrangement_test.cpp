// How a cube lies in files: --as-seen, --flip, --face-order, the lecture's cross, and what six files are called.

#include <array>
#include <string>
#include <vector>

#include "cli/cli_testing.h"
#include "cli/measure.h"

namespace mirrorball::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;

constexpr std::array<const char*, 6> kEndings{"px", "nx", "py", "ny", "pz", "nz"};
const std::vector<std::string> kFaces{"+X", "-X", "+Y", "-Y", "+Z", "-Z"};

class ConvertArrangementTest : public CliTest {
 protected:
  /// The faces of `uv` in the six files that the options make, and how their names stand if they all do so alike.
  std::vector<std::string> facesOf(const std::string& options, const std::string& names) const {
    succeed("convert uv --to cube --size 64 --layout faces -o uv.exr " + options);
    std::vector<std::string> faces;
    for (const char* ending : kEndings) {
      const Image picture = image("uv_" + std::string(ending) + ".exr");
      faces.push_back(uvFaceAt(picture, {0.5f, 0.5f}));
      EXPECT_EQ(orientationOfName(picture), names) << options << ", " << ending;
    }
    return faces;
  }

  /// Expects rows of faces in the cells of a picture, and the names of those that are there to stand in one way.
  void expectCells(const std::string& file, const std::vector<std::vector<std::string>>& rows,
                   const std::string& names) const {
    const Image map = image(file);
    const glm::vec2 size = 1.0f / glm::vec2(rows[0].size(), rows.size());
    for (std::size_t row = 0; row < rows.size(); ++row)
      for (std::size_t column = 0; column < rows[row].size(); ++column) {
        const std::string& face = rows[row][column];
        const glm::vec2 corner = size * glm::vec2(column, row);
        EXPECT_EQ(uvFaceAt(map, corner + size / 2.0f), face.empty() ? "black" : face) << row << ", " << column;
        if (face.empty() || names.empty()) continue;
        EXPECT_EQ(orientationOfName(map, corner, size), names) << file << ": " << face;
      }
  }

  Bytes panoramaOf(const std::string& input) const {
    succeed("convert " + input + " --to equirect --size 32 -o panorama.exr");
    return bytes("panorama.exr");
  }
};

TEST_F(ConvertArrangementTest, AsSeenAndFlipsTurnEachImageOverInItsSlot) {
  EXPECT_EQ(facesOf("", "mirrored"), kFaces);
  EXPECT_EQ(facesOf("--as-seen", "upright"), kFaces);
  EXPECT_EQ(facesOf("--flip none", "mirrored"), kFaces);
  EXPECT_EQ(facesOf("--flip horizontal", "upright"), kFaces);
  EXPECT_EQ(facesOf("--flip vertical", "turned"), kFaces);
  EXPECT_EQ(facesOf("--flip both", "mirrored and turned"), kFaces);
  EXPECT_EQ(facesOf("--as-seen --flip horizontal", "mirrored"), kFaces) << "turned over twice";
  EXPECT_EQ(facesOf("--for three --flip horizontal", "mirrored"),
            (std::vector<std::string>{"-X", "+X", "+Y", "-Y", "+Z", "-Z"}));
}

TEST_F(ConvertArrangementTest, TheFaceOrderFillsTheSlots) {
  const std::vector<std::string> turned{"+Z", "-Z", "+X", "-X", "-Y", "+Y"};
  EXPECT_EQ(facesOf("--face-order +z,-z,+x,-x,-y,+y", "mirrored"), turned);
  EXPECT_EQ(facesOf("--face-order +Z-Z+X-X-Y+Y", "mirrored"), turned);
  EXPECT_EQ(facesOf("--face-order +z,-z,+x,-x,-y,+y --as-seen", "upright"), turned);
  succeed("convert uv --to cube --size 64 -o uv.ktx --face-order +z,-z,+x,-x,-y,+y");
  for (int slot = 0; slot < 6; ++slot)
    EXPECT_EQ(uvFaceAt(texture("uv.ktx").at(0, slot), {0.5f, 0.5f}), turned[std::size_t(slot)]);
}

// Turned over where it lies, a cross would break at its edges: two cells change places.
TEST_F(ConvertArrangementTest, ACrossOfTurnedFacesGoesOnAcrossItsEdges) {
  succeed("convert uv --to cube --size 64 --as-seen -o uv.exr");
  expectCells("uv.exr", {{"", "+Y", "", ""}, {"+X", "+Z", "-X", "-Z"}, {"", "-Y", "", ""}}, "upright");
  succeed("convert uv --to cube --size 64 --flip vertical -o uv.exr");
  expectCells("uv.exr", {{"", "-Y", "", ""}, {"-X", "+Z", "+X", "-Z"}, {"", "+Y", "", ""}}, "turned");
}

// A rigid unfolding with +Y to the right of +Z: the row is turned by a quarter, which orientationOfName does not know,
// +X hangs upright below the top, -X on its head above it.
TEST_F(ConvertArrangementTest, TheSeedsCrossHasTheRowOfBottomFrontTopBack) {
  succeed("convert uv --to cube --size 64 --layout lecture -o lecture.exr");
  expectCells("lecture.exr", {{"", "", "-X", ""}, {"-Y", "+Z", "+Y", "-Z"}, {"", "", "+X", ""}}, "");
  const Image lecture = image("lecture.exr");
  EXPECT_EQ(orientationOfName(lecture, {0.5f, 2.0f / 3.0f}, {0.25f, 1.0f / 3.0f}), "mirrored");
  EXPECT_EQ(orientationOfName(lecture, {0.5f, 0.0f}, {0.25f, 1.0f / 3.0f}), "mirrored and turned");
  succeed("convert uv --to cube --size 64 --layout faces -o uv.exr");
  const Image front = image("uv_pz.exr");
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      EXPECT_EQ(rgbAt(lecture, 64 + 63 - y, 64 + x), rgbAt(front, x, y)) << "turned clockwise";
}

TEST_F(ConvertArrangementTest, EveryArrangementComesBackTheSame) {
  write("map.exr", smoothPanorama());
  succeed("convert map.exr --to cube --size 16 -o ours.exr");
  const Bytes ours = panoramaOf("ours.exr");
  struct Way {
    const char* options;
    const char* from;  ///< the same in words of --from
  };
  for (const Way& way : {Way{"--layout lecture", "lecture"}, Way{"--as-seen", "hcross:as-seen"},
                         Way{"--flip vertical --layout vcross", "vcross:flip=vertical"},
                         Way{"--flip both --layout lecture", "lecture:flip=both"},
                         Way{"--face-order -y+y-z+z-x+x --layout vstrip", "vstrip:order=-y+y-z+z-x+x"},
                         Way{"--as-seen --face-order -y+y-z+z-x+x", "hcross:as-seen,order=-y+y-z+z-x+x"}}) {
    succeed("convert map.exr --to cube --size 16 -o its.exr " + std::string(way.options));
    EXPECT_TRUE(panoramaOf("its.exr") == ours) << way.options << ", by the file's word";
    write("its.exr", image("its.exr"));
    EXPECT_TRUE(panoramaOf("its.exr --from " + std::string(way.from)) == ours) << way.from;
  }
}

TEST_F(ConvertArrangementTest, SixFilesAreKnownByEveryNaming) {
  write("map.exr", smoothPanorama());
  succeed("convert map.exr --to cube --size 16 -o ours.exr");
  const Bytes ours = panoramaOf("ours.exr");
  const std::vector<std::array<const char*, 6>> namings{kEndings,
                                                        {"posx", "negx", "posy", "negy", "posz", "negz"},
                                                        {"right", "left", "top", "bottom", "front", "back"},
                                                        {"right", "left", "up", "down", "front", "back"},
                                                        {"+X", "-X", "+Y", "-Y", "+Z", "-Z"},
                                                        {"PX", "NX", "PY", "NY", "PZ", "NZ"},
                                                        {"Right", "Left", "Top", "Bottom", "Front", "Back"}};
  const std::array<const char*, 4> kPrefixes{"", "room_", "my room-", "room."};
  succeed("convert map.exr --to cube --size 16 --layout faces -o face.exr");
  for (std::size_t i = 0; i < namings.size(); ++i) {
    const std::string before = std::string("cube/") + kPrefixes[i % kPrefixes.size()];
    fs::create_directory(path("cube"));
    for (std::size_t face = 0; face < 6; ++face)
      write(before + namings[i][face] + ".exr", image("face_" + std::string(kEndings[face]) + ".exr"));
    for (const std::string& input : {std::string("cube"), std::string("cube/"), before + namings[i][3] + ".exr"}) {
      // What a note says of them: RecognitionTest.
      succeed(std::vector<std::string>{"convert", "--quiet", input, "--to", "equirect", "--size", "32", "-o",
                                       "panorama.exr"});
      EXPECT_TRUE(bytes("panorama.exr") == ours) << input;
    }
    fs::remove_all(path("cube"));
  }
}

TEST_F(ConvertArrangementTest, AFolderHoldsOneCubeOrItIsRefused) {
  fs::create_directory(path("cubes"));
  EXPECT_THAT(refuse(1, "convert cubes --to equirect -o out.exr"), AllOf(HasSubstr("cubes: "), HasSubstr("six files")));
  for (const std::string name : {"a", "b"})
    succeed("convert white --to cube --size 4 --layout faces -o cubes/" + name + ".exr");
  EXPECT_THAT(refuse(2, "convert cubes --to equirect -o out.exr"),
              AllOf(HasSubstr("2 cubes"), AnyOf(HasSubstr("a_"), HasSubstr("b_"))));
  succeed("convert cubes/b_pz.exr --to equirect -o out.exr");
  fs::remove(path("cubes/a_ny.exr"));
  succeed("convert cubes --to equirect -o out.exr");
}

}  // namespace
}  // namespace mirrorball::testing
