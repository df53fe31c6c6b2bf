// export: scenes as files for other programs.

#include <string>

#include <nlohmann/json.hpp>

#include "cli/cli_testing.h"
#include "cli/measure.h"

namespace mirrorball::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

using ExportTest = CliTest;

/// The JSON of a .glb, which follows two headers of 12 and 8 bytes.
nlohmann::json jsonOf(const Bytes& glb) {
  const std::size_t length = glb.at(12) | glb.at(13) << 8 | glb.at(14) << 16;
  return nlohmann::json::parse(glb.begin() + 20, glb.begin() + 20 + static_cast<std::ptrdiff_t>(length));
}

// A metal, a dielectric and bodies that transmit, by the path tracer and through the file.
TEST_F(ExportTest, TheFileShowsTheSamePicture) {
  for (const std::string materials :
       {"knot --set metallic=1 --set base_color=0.9,0.6,0.3 --set perceptual_roughness=0.3",
        "teapot --material plastic", "sphere --set transmission=1 --set ior=1.4 --set perceptual_roughness=0.1"}) {
    const std::string view = " --camera 70,20 --size 48x32";
    succeed("export " + materials + view + " -o model.glb");
    const std::string how = view + " --reference --samples 4 -e studio -o ";
    trace("render " + materials + how + "wanted.exr");
    trace("render model.glb" + how + "found.exr");
    EXPECT_GT(maxDifference(image("wanted.exr"), Image(48, 32, 4, 0.0f)), 0.5f);
    EXPECT_LT(maxDifference(image("wanted.exr"), image("found.exr")), 1e-4f) << materials;
  }
}

TEST_F(ExportTest, TheCameraIsThatOfThePicture) {
  succeed("export sphere --camera 0,0,4 --fov 40 --size 80x20 -o model.glb");
  const nlohmann::json json = jsonOf(bytes("model.glb"));
  const nlohmann::json& lens = json.at("cameras").at(0).at("perspective");
  EXPECT_NEAR(lens.at("aspectRatio").get<float>(), 4.0f, 1e-5f);
  EXPECT_NEAR(lens.at("yfov").get<float>(), glm::radians(40.0f), 1e-5f);
  // On +Z at four radii, looking along −Z as glTF's cameras do.
  const nlohmann::json& node = json.at("nodes").back();
  EXPECT_EQ(node.at("camera"), 0);
  EXPECT_NEAR(node.at("matrix").at(14).get<float>(), 4.0f, 1e-4f);
  EXPECT_NEAR(node.at("matrix").at(10).get<float>(), 1.0f, 1e-6f);
}

TEST_F(ExportTest, WhatIsLeftOutIsTold) {
  const Outcome outcome = run("export showcase -o showcase.glb");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("note: showcase.glb: materials[1] (gold): the metal's complex index"));
  EXPECT_THAT(outcome.err, HasSubstr("(orange): height, height_scale and height_frequency are left out"));
  EXPECT_THAT(outcome.err, ::testing::Not(HasSubstr("mirror)")));
}

TEST_F(ExportTest, BadRequestsAreRefused) {
  EXPECT_THAT(refuse(2, "export sphere"), HasSubstr("export needs an output"));
  EXPECT_THAT(refuse(2, "export sphere -o ball.obj"), HasSubstr("FILE.glb"));
  EXPECT_THAT(refuse(1, "export none -o none.glb"), HasSubstr("no triangles"));
  EXPECT_THAT(refuse(2, "export sphere --set colour=1 -o ball.glb"), HasSubstr("colour"));
  succeed("export sphere -o ball.glb");
  EXPECT_THAT(refuse(2, "export ball.glb -o ball.glb"), HasSubstr("ball.glb"));
  EXPECT_THAT(files(), ElementsAre("ball.glb"));
}

TEST_F(ExportTest, StandardOutputTakesTheFile) {
  succeed("export sphere -o ball.glb");
  const std::string piped = run("export sphere -o -.glb").out;
  EXPECT_EQ(Bytes(piped.begin(), piped.end()), bytes("ball.glb"));
}

}  // namespace
}  // namespace mirrorball::testing
