#include "mirrorball/view/workspace/arguments.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/view/workspace/workspace_file.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

Result<Workspace> read(const std::vector<std::string>& words) { return workspaceOf(words); }

/// A file of the tests with a text.
std::string fileWith(const char* name, const std::string& text) {
  const std::string path = ::testing::TempDir() + name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

TEST(Arguments, AreWordsOfRender) {
  const Workspace workspace =
      *read({"teapot", "-e", "sky:elevation=20", "--fov", "50", "--material=gold", "--self-reflection", "--rotate=40"});
  EXPECT_EQ(workspace.model, "teapot");
  EXPECT_EQ(workspace.maps, std::vector<std::string>{"sky:elevation=20"});
  EXPECT_FLOAT_EQ(frameOf(workspace, 0)->camera.fov_deg, 50.0f);
  EXPECT_TRUE(frameOf(workspace, 0)->self_reflection);
  EXPECT_FLOAT_EQ(frameOf(workspace, 0)->env_rotation_deg.x, 40.0f);
  EXPECT_EQ(materialsOf(workspace.materials)->material, "gold");
  EXPECT_EQ(*read({"-e", "studio"}), Workspace());
  EXPECT_EQ(*read({}), withShowcase({})) << "as render shows it";
  EXPECT_EQ(*read({"--camera=10,20"}), withShowcase(*read({"-e", "studio", "--camera=10,20"})));
}

TEST(Arguments, SayHowAModelStandsBeforeItIsNamed) {
  const Workspace workspace = *read({"--up", "z", "--animation=Walk@0.5", "--camera=10,20,3", "knot"});
  EXPECT_EQ(workspace.model, "knot");
  EXPECT_EQ(*stanceOf(workspace.stance), (ModelStance{UpAxis::z, {"Walk", 0.5f}}));
  EXPECT_EQ(frameOf(workspace, 0)->camera.distance, 3.0f);
  EXPECT_EQ(*read(*renderArguments(workspace, 0)), workspace);
}

TEST(Arguments, OpenAWorkspaceAsItIs) {
  Workspace workspace;
  workspace.frame = {{"fov", {"20"}}};
  const std::string path = fileWith("showcase.json", writtenWorkspace(workspace));
  EXPECT_EQ(*read({path}), workspace) << "its showcase stands in the studio";
  const std::string map = ::testing::TempDir() + "arguments_map.hdr";
  ASSERT_TRUE(writeImage(map, Image(4, 2, 3, 0.5f)));
  EXPECT_EQ(read({map})->maps, std::vector<std::string>{map}) << "nobody has asked for another";
  EXPECT_EQ(read({"-e", "white", map})->maps, (std::vector<std::string>{"white", map}));
}

TEST(Arguments, RefusesOthers) {
  EXPECT_THAT(read({"--no-such"}).error().message, HasSubstr("--no-such"));
  EXPECT_EQ(read({"--rougness=1"}).error().message, "there is no option --rougness; did you mean --ground-roughness?");
  EXPECT_EQ(read({"--teme=light"}).error().message, "there is no option --teme; did you mean --theme?");
  EXPECT_THAT(read({"-x"}).error().message, HasSubstr("there is no option -x"));
  EXPECT_EQ(read({"--env=uv"})->maps, std::vector<std::string>{"uv"});
  EXPECT_EQ(*read({"--reference", "--reference"}), *read({"--reference"}));
  EXPECT_FALSE(read({"--reference=no"}));
  EXPECT_EQ(read({"--backgroud=light"}).error().message, "there is no option --backgroud; did you mean --background?");
  EXPECT_THAT(read({"--fov"}).error().message, HasSubstr("needs a value"));
  EXPECT_THAT(read({"--fov", "wide"}).error().message, HasSubstr("fov"));
  EXPECT_THAT(read({"nowhere.glb"}).error().message, HasSubstr("nowhere.glb"));
  EXPECT_FALSE(read({"-e"}));
  EXPECT_TRUE(read({"--quality", "draft"}));
  EXPECT_EQ(qualityOf(read({"--quality=best"})->frame), Quality::best);
}

TEST(Arguments, SayAWorkspaceAgain) {
  Workspace workspace = *read({"knot", "-e", "white", "--camera=10,20,3", "--light=1,2,3,4,5,6", "--light=2,2,3,4,5,6",
                               "--set=metallic=1", "--background=#336699"});
  const auto words = renderArguments(workspace, 0);
  ASSERT_TRUE(words && read(*words));
  EXPECT_EQ(*read(*words), workspace);
  EXPECT_THAT(*renderCommandLine(workspace, 0), HasSubstr("mirrorball render knot -e white"));
  EXPECT_THAT(*renderCommandLine(workspace, 0), HasSubstr("'--background=#336699'"));
  workspace.compare_by = CompareBy::slider;
  workspace.edited_side = 1;
  workspace = *withOption(workspace, OptionTable::frame, "blur", "mip");
  EXPECT_EQ(*frameOf(*read(*renderArguments(workspace, 1)), 0), *frameOf(workspace, 1));
  workspace.selected_material = 0;
  workspace = *withOption(workspace, OptionTable::parameter, "metallic", "0.5");
  EXPECT_FALSE(renderArguments(workspace, 0));
}

TEST(OpenedFile, SixFacesAreOneMap) {
  const std::string folder = ::testing::TempDir() + "six_faces/";
  std::filesystem::create_directories(folder);
  std::vector<std::string> paths;
  for (const char* face : {"px", "nx", "py", "ny", "pz", "nz"}) {
    paths.push_back(folder + "room_" + face + ".hdr");
    ASSERT_TRUE(writeImage(paths.back(), Image(4, 4, 3, 0.5f)));
  }
  EXPECT_EQ(filesToOpen(paths), std::vector<std::string>{paths.front()});
  EXPECT_EQ(withFile({}, folder)->maps.back(), folder);
  const std::string other = ::testing::TempDir() + "alone.hdr";
  ASSERT_TRUE(writeImage(other, Image(4, 2, 3, 0.5f)));
  EXPECT_EQ(filesToOpen(std::vector{other, paths[3], paths[0]}), (std::vector{other, paths[3]}));
  EXPECT_FALSE(withFile({}, ::testing::TempDir()));
}

TEST(OpenedFile, IsTakenForWhatItIs) {
  Image8 picture(4, 2, 3);
  const std::string map = ::testing::TempDir() + "opened.png";
  ASSERT_TRUE(savePicture(map, picture));
  EXPECT_EQ(withFile({}, map)->maps.back(), map);
  const std::string model = fileWith("opened.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(withFile({}, model)->model, model);
  EXPECT_EQ(withFile({}, "studio")->shown_map, 0u);
  EXPECT_EQ(withFile({}, "teapot")->model, "teapot");
  Workspace saved;
  saved.model = "torus";
  EXPECT_EQ(*withFile({}, fileWith("opened.json", writtenWorkspace(saved))), saved);
  EXPECT_FALSE(withFile({}, fileWith("opened.txt", "hello")));
  EXPECT_FALSE(withFile({}, fileWith("opened_empty", "")));
  EXPECT_FALSE(withFile({}, ::testing::TempDir() + "opened_nowhere.hdr"));
}

TEST(TypedPath, HomeIsWhatAShellWouldMakeOfIt) {
  const std::string home = std::getenv("HOME") != nullptr ? std::getenv("HOME") : "~";
  EXPECT_EQ(typedPath("~/maps/sky.hdr"), home + "/maps/sky.hdr");
  EXPECT_EQ(typedPath("~"), home);
  EXPECT_EQ(typedPath("~other/sky.hdr"), "~other/sky.hdr") << "another user's, whom we do not know";
  EXPECT_EQ(typedPath("a~/sky.hdr"), "a~/sky.hdr");
  EXPECT_EQ(typedPath(""), "");
}

}  // namespace
}  // namespace mirrorball
