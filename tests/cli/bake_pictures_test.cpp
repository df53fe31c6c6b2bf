// bake's cubes as pictures, and its skybox.

#include <algorithm>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

class BakePicturesTest : public CliTest {
 protected:
  BakePicturesTest() { write("map.exr", smoothPanorama()); }

  /// The greatest difference of light, of images with alpha or without.
  static float difference(const Image& a, const Image& b) {
    float max = 0.0f;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x) {
        const glm::vec3 between = glm::abs(rgbAt(a, x, y) - rgbAt(b, x, y));
        max = std::max({max, between.x, between.y, between.z});
      }
    return max;
  }

  /// Whether six pictures are the faces of a texture's level.
  void expectFaces(const std::string& stem, const std::string& extension, const ImageSet& cube, int level,
                   float tolerance) const {
    int face = 0;
    for (const std::string ending : {"px", "nx", "py", "ny", "pz", "nz"}) {
      const std::string name = stem + "_" + ending + "." + extension;
      const Image picture = image(name);
      ASSERT_EQ(picture.width(), cube.at(level, face).width()) << name;
      EXPECT_LE(difference(picture, cube.at(level, face++)), tolerance) << name;
    }
  }
};

constexpr const char* kSmallPictures = "bake map.exr --size 16 --irradiance-size 4 --brdf-size 8 ";

TEST_F(BakePicturesTest, EachLevelIsSixPictures) {
  for (const std::string program : {"", " --for unreal"}) {
    const std::string line = kSmallPictures + std::string("--skybox") + program;
    succeed(line + " --extension ktx2 --format float32 -o cubes");
    const ImageSet specular = texture("cubes/specular.ktx2");
    for (const std::string extension : {"exr", "hdr"}) {
      const std::string folder = extension + program.substr(program.rfind(' ') + 1);
      succeed(line + " --extension " + extension + " -o " + folder);
      // RGBE has 8 bits for the brightest channel, and light is below 2.
      const float tolerance = extension == "hdr" ? 2.0f / 256.0f : 0.0f;
      for (int level = 0; level < 3; ++level)
        expectFaces(folder + "/m" + std::to_string(level), extension, specular, level, tolerance);
      expectFaces(folder + "/i", extension, texture("cubes/irradiance.ktx2"), 0, tolerance);
      expectFaces(folder + "/skybox", extension, texture("cubes/skybox.ktx2"), 0, tolerance);
      EXPECT_THAT(files(), Contains(folder + "/brdf.exr"));
    }
  }
}

TEST_F(BakePicturesTest, TheManifestNamesEachOfThem) {
  succeed(kSmallPictures + std::string("--extension exr --format half --skybox -o out"));
  const nlohmann::json manifest = jsonIn("out/manifest.json");
  EXPECT_EQ(manifest["specular"]["format"], "three channels of half floats");
  std::vector<std::string> named{"brdf.exr", "lobe_rows.json", "lobe_rows.ktx2", "manifest.json", "sh.h", "sh.json"};
  const auto add = [&](const nlohmann::json& map) {
    for (const nlohmann::json& file : map["files"]) named.push_back(file);
  };
  for (const nlohmann::json& level : manifest["specular"]["levels"]) add(level);
  add(manifest["irradiance"]);
  add(manifest["skybox"]);
  std::ranges::sort(named);
  std::vector<std::string> there;
  for (const std::string& file : files())
    if (file.starts_with("out/") && file != "out/") there.push_back(file.substr(4));
  EXPECT_EQ(there, named);
  EXPECT_EQ(manifest["specular"]["levels"][2]["files"][0], "m2_px.exr");
}

TEST_F(BakePicturesTest, SixPicturesAreReadAsACube) {
  succeed(kSmallPictures + std::string("--extension exr --for three --mip-mapping filament -o out"));
  EXPECT_THAT(succeed("info out/m1_ny.exr"), HasSubstr("cube, faces, axes="));
  succeed(kSmallPictures + std::string("--format float32 -o ours"));
  succeed("convert out/m0_px.exr --to equirect --size 16 -o its.exr");
  succeed("convert ours/specular.ktx2 --to equirect --size 16 -o our.exr");
  EXPECT_EQ(difference(image("its.exr"), image("our.exr")), 0.0f);
}

TEST_F(BakePicturesTest, PicturesOfAnOlderSetGo) {
  succeed(kSmallPictures + std::string("--extension exr --skybox -o out"));
  EXPECT_THAT(files(), IsSupersetOf({"out/m2_px.exr", "out/skybox_nz.exr"}));
  write("out/m7_px.exr", std::string("the user's own"));
  succeed(kSmallPictures + std::string("--extension exr --levels 2 -o out"));
  EXPECT_THAT(files(), AllOf(IsSupersetOf({"out/m1_px.exr", "out/m7_px.exr"}), Not(Contains("out/m2_px.exr")),
                             Not(Contains("out/skybox_nz.exr"))));
  std::filesystem::remove(path("out/m7_px.exr"));
  succeed(kSmallPictures + std::string("-o out"));
  EXPECT_THAT(files(),
              ElementsAre("map.exr", "out/", "out/brdf.ktx2", "out/irradiance.ktx2", "out/lobe_rows.json",
                          "out/lobe_rows.ktx2", "out/manifest.json", "out/sh.h", "out/sh.json", "out/specular.ktx2"));
}

TEST_F(BakePicturesTest, NoPictureOverwritesTheInput) {
  succeed(kSmallPictures + std::string("--extension exr -o out"));
  EXPECT_THAT(refuse(2, "bake out/m0_px.exr --size 8 --brdf-size 8 --extension exr -o out"),
              HasSubstr("is the input itself"));
}

TEST_F(BakePicturesTest, TheSkyboxIsTheEnvironmentConverted) {
  for (const std::string program : {"", " --for unreal", " --for three"}) {
    const std::string to = " --format float32 --rotate 40,10" + program;
    succeed(kSmallPictures + std::string("--mip-mapping filament --skybox-size 64 --extension ktx2 -o out") + to);
    succeed("convert --quiet map.exr --to cube --size 64 -o cube.ktx2" + to);
    const ImageSet skybox = texture("out/skybox.ktx2");
    const ImageSet cube = texture("cube.ktx2");
    for (int face = 0; face < 6; ++face) EXPECT_EQ(difference(skybox.at(0, face), cube.at(0, face)), 0.0f);
  }
  EXPECT_EQ(jsonIn("out/manifest.json")["skybox"]["file"], "skybox.ktx2");
  EXPECT_EQ(jsonIn("out/manifest.json")["skybox"]["size"], 64);
  EXPECT_EQ(jsonIn("out/manifest.json")["skybox"]["format"], "r32g32b32a32 sfloat");
}

// As fine as 32 rows; of a function, which has any detail, as much as an engine wants.
TEST_F(BakePicturesTest, TheSkyboxIsAsFineAsTheEnvironment) {
  succeed(kSmallPictures + std::string("--skybox -o out"));
  EXPECT_EQ(texture("out/skybox.ktx2").at(0, 0).width(), 16);
  write("wide.exr", Image(6144, 3072, 3, 0.5f));
  succeed("bake wide.exr --size 8 --irradiance-size 4 --brdf-size 8 --skybox -o out");
  EXPECT_EQ(texture("out/skybox.ktx2").at(0, 0).width(), 1024);
  succeed("bake wide.exr --size 8 --irradiance-size 4 --brdf-size 8 -o out");
  EXPECT_THAT(files(), Not(Contains("out/skybox.ktx2")));
}

TEST_F(BakePicturesTest, OneFileHasNoPictures) {
  EXPECT_THAT(refuse(2, "bake map.exr -o chain.exr"), HasSubstr("name a folder"));
  EXPECT_THAT(refuse(2, "bake map.exr -o chain.ktx2 --skybox"), HasSubstr("--skybox"));
  EXPECT_THAT(refuse(2, kSmallPictures + std::string("-o out --extension exr --format bc6h")),
              HasSubstr("cannot hold bc6h texels"));
  EXPECT_THAT(refuse(2, kSmallPictures + std::string("-o out --extension exr --zstd 3")),
              HasSubstr("no Zstandard compression; .ktx2 has"));
}

}  // namespace
}  // namespace mirrorball::testing
