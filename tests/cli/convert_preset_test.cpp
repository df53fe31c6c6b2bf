// --for: cubes and panoramas as other programs have them, and the way back by the file's own word and by --from.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "cli/cli_testing.h"
#include "cli/measure.h"

namespace mirrorball::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// What docs/conventions.md says of a program.
struct Convention {
  const char* name;
  std::array<const char*, 6> slots;  ///< the face of `uv` in each of the six images
  const char* names;                 ///< how the names stand there; "" where they are turned by a quarter
  const char* middle;                ///< of its panorama
  const char* right;                 ///< a quarter to the right of the middle
};

const std::array<const char*, 6> kOurs{"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
const std::array<const char*, 6> kXExchanged{"-X", "+X", "+Y", "-Y", "+Z", "-Z"};
const std::array<const char*, 6> kZUp{"+X", "-X", "+Z", "-Z", "+Y", "-Y"};

const std::array<Convention, 9> kConventions{{{"opengl", kOurs, "mirrored", "+Z", "-X"},
                                              {"vulkan", kOurs, "mirrored", "+Z", "-X"},
                                              {"directx", kOurs, "mirrored", "+Z", "-X"},
                                              {"unity", kXExchanged, "upright", "-X", "-Z"},
                                              {"unreal", kZUp, "", "-Z", "+X"},
                                              {"godot", kOurs, "mirrored", "+Z", "-X"},
                                              {"filament", kOurs, "mirrored", "+Z", "-X"},
                                              {"three", kXExchanged, "upright", "+X", "+Z"},
                                              {"renderman", kOurs, "mirrored", "+Z", "-X"}}};

class ConvertPresetTest : public CliTest {
 protected:
  void SetUp() override { write("map.exr", smoothPanorama()); }

  /// Takes from a file all that it says of itself: other programs keep none of it.
  void silence(const std::string& name) const { write(name, image(name)); }

  /// The line of standard error on how a DDS is read again; "" without one.
  static std::string readingHint(const std::string& err) {
    const std::size_t hint = err.find("its.dds: a DDS does not say");
    if (hint == std::string::npos) return "";
    const std::size_t begin = err.rfind('\n', hint) + 1;  // of the first line 0
    return err.substr(begin, err.find('\n', hint) + 1 - begin);
  }

  /// A map converted to a panorama, as bytes.
  Bytes panoramaOf(const std::string& input) const {
    succeed("convert --quiet " + input + " --to equirect --size 32 -o panorama.exr");
    return bytes("panorama.exr");
  }
};

TEST_F(ConvertPresetTest, EachSlotHoldsTheFaceThatTheTableSays) {
  std::vector<Convention> programs(kConventions.begin(), kConventions.end());
  programs.push_back({"krpano", kXExchanged, "upright", "", ""});
  programs.push_back({"quake", kOurs, "", "", ""});
  programs.push_back({"ogre", {"+X", "-X", "+Y", "-Y", "-Z", "+Z"}, "", "", ""});
  for (const Convention& program : programs) {
    SCOPED_TRACE(program.name);
    succeed("convert --quiet uv --to cube --size 64 -o cube.ktx2 --for " + std::string(program.name));
    const ImageSet cube = texture("cube.ktx2");
    for (std::size_t slot = 0; slot < 6; ++slot) {
      const Image& picture = cube.at(0, static_cast<int>(slot));
      EXPECT_EQ(uvFaceAt(picture, {0.5f, 0.5f}), program.slots[slot]);
      if (std::string(program.names).empty()) continue;
      EXPECT_EQ(orientationOfName(picture), program.names) << "slot " << slot;
    }
  }
}

// Unreal's up is its Z: our face +Y lies in its fifth slot. What its own table has downwards there is -Y, our -Z.
TEST_F(ConvertPresetTest, UnrealsImagesAreTurnedIntoItsAxes) {
  succeed("convert map.exr --to cube --size 64 --layout faces -o ours.exr");
  succeed("convert --quiet map.exr --to cube --size 64 --layout faces -o its.exr --for unreal");
  // OpenGL's table in the axes (x, z, y): slot +Z looks along our +Y with +X to the right and down to our -Z; ours has
  // +X to the right too, and +Z below.
  const Image ours = image("ours_py.exr");
  const Image its = image("its_pz.exr");
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) EXPECT_EQ(rgbAt(its, x, y), rgbAt(ours, x, 63 - y));
  // Slot +X: to the right is the program's -Z, our -Y, and down its -Y, our -Z. Ours: -Z to the right and -Y below.
  const Image ours_x = image("ours_px.exr");
  const Image its_x = image("its_px.exr");
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) EXPECT_EQ(rgbAt(its_x, x, y), rgbAt(ours_x, y, x));
}

TEST_F(ConvertPresetTest, EachPanoramaHasItsDirectionInTheMiddle) {
  std::vector<Convention> programs(kConventions.begin(), kConventions.end());
  programs.push_back({"blender", kOurs, "", "+X", "+Z"});
  for (const char* name : {"openexr", "krpano", "quake", "ogre"}) programs.push_back({name, kOurs, "", "+Z", "-X"});
  for (const Convention& program : programs) {
    SCOPED_TRACE(program.name);
    succeed("convert --quiet uv --to equirect --size 256 -o map.exr --for " + std::string(program.name));
    const Image map = image("map.exr");
    EXPECT_EQ(uvFaceAt(map, {0.5f, 0.5f}), program.middle);
    EXPECT_EQ(uvFaceAt(map, {0.75f, 0.5f}), program.right);
    EXPECT_EQ(uvFaceAt(map, {0.5f, 0.0f}), "+Y");
    EXPECT_EQ(orientationOfName(map, {0.375f, 0.25f}, {0.25f, 0.5f}), "upright");
  }
}

TEST_F(ConvertPresetTest, ThreesPanoramaIsOneCentredOnPlusX) {
  succeed("convert map.exr --to equirect --size 32 -o three.exr --for three");
  succeed("convert map.exr --to equirect --size 32 -o turned.exr --centre 1,0,0");
  EXPECT_LT(maxDifference(image("three.exr"), image("turned.exr")), 1e-4);
}

// Texels are only moved, so that what comes back is the same to the last bit.
TEST_F(ConvertPresetTest, EveryCubeComesBackTheSame) {
  succeed("convert map.exr --to cube --size 16 -o ours.exr");
  const Bytes ours = panoramaOf("ours.exr");
  for (const Convention& program : kConventions) {
    const std::string name = program.name;
    for (const std::string layout : {"vcross", "faces"}) {
      succeed("convert --quiet map.exr --to cube --size 16 -o its.exr --layout " + layout + " --for " + name);
      const std::string file = layout == "faces" ? "its_ny.exr" : "its.exr";
      EXPECT_TRUE(panoramaOf(file) == ours) << name << ", " << layout << ", by the file's word";
      for (const std::string& each : files())
        if (each.starts_with("its") && each.ends_with(".exr")) silence(each);
      EXPECT_TRUE(panoramaOf(file + " --from " + layout + ":for=" + name) == ours) << name << ", " << layout;
      const bool is_ours = program.slots == kOurs && std::string(program.names) == "mirrored";
      EXPECT_EQ(panoramaOf(file) == ours, is_ours) << name << ", " << layout << ": nothing is left to tell it by";
    }
    succeed("convert --quiet map.exr --to cube --size 16 --format float32 -o its.ktx2 --for " + name);
    EXPECT_TRUE(panoramaOf("its.ktx2") == ours) << name << ", by the texture's word";
    // A DDS has no word of its own; where it would be taken for ours, a remark has the words to add.
    const Outcome dds = run("convert map.exr --to cube --size 16 --format float32 --mips -o its.dds --for " + name);
    EXPECT_EQ(dds.exit_code, 0);
    const bool is_ours = program.slots == kOurs;
    EXPECT_EQ(readingHint(dds.err),
              is_ours ? ""
                      : "mirrorball: note: its.dds: a DDS does not say what map it holds; to read this one, add "
                        "--from cube:for=" +
                            name + "\n");
    EXPECT_TRUE(panoramaOf("its.dds --from cube:for=" + name) == ours) << name << ", DDS";
    EXPECT_EQ(panoramaOf("its.dds") == ours, is_ours) << name << ", DDS";
  }
}

TEST_F(ConvertPresetTest, EveryPanoramaComesBackTheSame) {
  succeed("convert map.exr --to equirect --size 32 -o ours.exr");
  const Bytes ours = panoramaOf("ours.exr");
  for (const std::string name : {"unity", "unreal", "godot", "three", "blender", "renderman"}) {
    succeed("convert --quiet map.exr --to equirect --size 32 -o its.exr --for " + name);
    EXPECT_TRUE(panoramaOf("its.exr") == ours) << name << ", by the file's word";
    silence("its.exr");
    EXPECT_TRUE(panoramaOf("its.exr --from equirect:for=" + name) == ours) << name;
    for (const std::string mips : {"", " --mips"}) {
      succeed("convert --quiet map.exr --to equirect --size 32 --format float32 -o its.ktx2 --for " + name + mips);
      EXPECT_TRUE(panoramaOf("its.ktx2") == ours) << name << mips << ", texture";
    }
  }
}

// What a remark names is what reads the file again; where there is none, nothing has to be named.
TEST_F(ConvertPresetTest, ADdsTellsHowToReadItWhereItWouldBeTakenForAnother) {
  const std::string note = "mirrorball: note: its.dds: a DDS does not say what map it holds; to read this one, add ";
  for (const auto& [wish, from] : std::vector<std::pair<std::string, std::string>>{
           {"octahedral", "octahedral"},
           {"equal-area", "equal-area"},
           {"angular", "angular"},
           {"paraboloid", "paraboloid"},
           {"ball:distance=5", "ball:distance=5"},
           {"eac --for unity", "eac:for=unity"},
           {"eac --mips", "eac"},
           {"equirect --for blender", "equirect:for=blender"},
           {"cube --face-order +z,-z,+x,-x,-y,+y --as-seen", "cube:as-seen,order=+z-z+x-x-y+y"},
           {"cube --for unreal --flip vertical --mips", "cube:for=unreal,flip=vertical"},
           {"sphere", ""},
           {"equirect", ""},
           {"cube", ""},
           {"cube --as-seen", ""}}) {
    succeed("convert --quiet map.exr --size 64 --format float32 -o ours.ktx2 --to " + wish);
    const Outcome dds = run("convert map.exr --size 64 --format float32 -o its.dds --to " + wish);
    EXPECT_EQ(dds.exit_code, 0) << wish;
    EXPECT_EQ(readingHint(dds.err), from.empty() ? "" : note + "--from " + from + "\n") << wish;
    EXPECT_TRUE(panoramaOf("its.dds" + (from.empty() ? "" : " --from " + from)) == panoramaOf("ours.ktx2")) << wish;
  }
}

// OpenEXR's texels lie on the edges: there and back is two interpolations of light that varies smoothly over 32 rows.
TEST_F(ConvertPresetTest, OpenExrsMapsComeBackInterpolated) {
  succeed("convert map.exr --to cube --size 32 -o ours.exr");
  panoramaOf("ours.exr");
  const Image ours = image("panorama.exr");
  for (const std::string to : {"cube --size 32", "equirect --size 64"}) {
    succeed("convert map.exr -o its.exr --for openexr --to " + to);
    EXPECT_THAT(succeed("info its.exr"), HasSubstr("the file's metadata"));
    panoramaOf("its.exr");
    EXPECT_LT(meanDifference(image("panorama.exr"), ours), 5e-4) << to;
    silence("its.exr");
    panoramaOf("its.exr --from " + to.substr(0, to.find(' ')) + ":for=openexr");
    EXPECT_LT(meanDifference(image("panorama.exr"), ours), 5e-4) << to << ", --from";
  }
}

TEST_F(ConvertPresetTest, PresetsNameTheirFilesAndChooseTheirLayout) {
  std::filesystem::remove(path("map.exr"));
  succeed("convert white --to cube --size 4 -o room.hdr --for three");
  EXPECT_THAT(files(),
              ElementsAre("room_nx.hdr", "room_ny.hdr", "room_nz.hdr", "room_px.hdr", "room_py.hdr", "room_pz.hdr"));
  for (const std::string& file : files()) std::filesystem::remove(path(file));
  succeed("convert white --to cube --size 4 --layout faces -o room.exr --for openexr");
  EXPECT_THAT(files(),
              ElementsAre("room_+X.exr", "room_+Y.exr", "room_+Z.exr", "room_-X.exr", "room_-Y.exr", "room_-Z.exr"));
  succeed("convert white --to cube --size 4 -o tiles.exr --for godot");
  EXPECT_EQ(image("tiles.exr").width(), 12);
  EXPECT_EQ(image("tiles.exr").height(), 8);
  succeed("convert white --to cube --size 4 -o strip.exr --for openexr");
  EXPECT_EQ(image("strip.exr").height(), 24);
}

}  // namespace
}  // namespace mirrorball::testing
