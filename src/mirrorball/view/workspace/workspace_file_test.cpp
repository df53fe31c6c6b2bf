#include "mirrorball/view/workspace/workspace_file.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

Workspace something() {
  Workspace workspace{.model = "h\"elm\n.glb", .maps = {"a.hdr", "β.exr"}, .shown_map = 1};
  workspace.photos["a.hdr"] = {{"circle", {"1,2,3"}}, {"response", {"gamma"}}};
  workspace.photos["β.exr"] = {};
  workspace.frame = {{"fov", {"40.5"}}, {"light", {"1,2,3,4,5,6", "0,0,1,1,1,1"}}};
  workspace.materials = {{"set", {"metallic=1", "perceptual_roughness=0.25"}}};
  workspace.parameters[3] = {{"metallic", {"0.5"}}};
  workspace.sides[1] = {.frame = {{"blur", {"mip"}}}, .map = 0, .is_traced = true};
  workspace.compare_by = CompareBy::flip_error;
  workspace.divider = 0.1f;
  workspace.stance = {{"animation", {"Walk@0.5"}}, {"up", {"z"}}};
  workspace.plays = true;
  workspace.selected_material = 3;
  return workspace;
}

TEST(WorkspaceFile, ReadsWhatItHasWritten) {
  EXPECT_EQ(*readWorkspace(writtenWorkspace(something())), something());
  EXPECT_EQ(*readWorkspace(writtenWorkspace({})), Workspace());
}

TEST(WorkspaceFile, NamesOfFilesAreRightFromAnyFolder) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(::testing::TempDir()) / "workspace_names";
  fs::remove_all(folder);
  fs::create_directories(folder / "maps");
  const std::string ball = (folder / "maps" / "ball.jpg").string();
  Workspace workspace{.model = (folder / "helmet.glb").string(), .maps = {"studio", "elsewhere.hdr", ball}};
  workspace.photos[ball] = {{"circle", {"1,2,3"}}};
  ASSERT_TRUE(saveWorkspace((folder / "view.json").string(), workspace));
  const std::string elsewhere = fs::absolute("elsewhere.hdr").string();
  Workspace absolute = workspace;
  absolute.maps[1] = elsewhere;
  EXPECT_EQ(*loadWorkspace((folder / "view.json").string()), absolute);
  // Moved with its files.
  const fs::path moved = fs::path(::testing::TempDir()) / "workspace_names_moved";
  fs::remove_all(moved);
  fs::rename(folder, moved);
  const Workspace there = *loadWorkspace((moved / "view.json").string());
  EXPECT_EQ(there.model, (moved / "helmet.glb").string());
  EXPECT_EQ(there.maps, (std::vector<std::string>{"studio", elsewhere, (moved / "maps" / "ball.jpg").string()}));
  EXPECT_TRUE(there.photos.contains(there.maps[2]));
  fs::remove_all(moved);
}

TEST(WorkspaceFile, WhatIsNotNamedIsAsInANewOne) {
  EXPECT_EQ(*readWorkspace(R"({"mirrorball_workspace": 1, "comes_later": {"x": 1}})"), Workspace());
}

TEST(WorkspaceFile, RefusesOthersInOneLine) {
  for (const char* json : {
           "",
           "{",
           "[]",
           "{}",
           R"({"model": "sphere"})",
           R"({"mirrorball_workspace": 1, "model": 5})",
           R"({"mirrorball_workspace": 1, "maps": []})",
           R"({"mirrorball_workspace": 1, "maps": "a"})",
           R"({"mirrorball_workspace": 1, "shown_map": 1})",
           R"({"mirrorball_workspace": 1, "shown_map": -1})",
           R"({"mirrorball_workspace": 1, "frame": {"no-such": "1"}})",
           R"({"mirrorball_workspace": 1, "frame": {"samples": "many"}})",
           R"({"mirrorball_workspace": 1, "frame": {"samples": 4}})",
           R"({"mirrorball_workspace": 1, "frame": 4})",
           R"({"mirrorball_workspace": 1, "stance": {"up": "x"}})",
           R"({"mirrorball_workspace": 1, "plays": "yes"})",
           R"({"mirrorball_workspace": 1, "parameters": {"x": {}}})",
           R"({"mirrorball_workspace": 1, "parameters": {"0": {"metallic": "9"}}})",
           R"({"mirrorball_workspace": 1, "sides": [{"map": 4}]})",
           R"({"mirrorball_workspace": 1, "sides": [{"frame": {"fov": "40"}}]})",
           R"({"mirrorball_workspace": 1, "photos": {"ball.jpg": {}}})",
           R"({"mirrorball_workspace": 1, "photos": ["studio"]})",
           R"({"mirrorball_workspace": 1, "photos": {"studio": {"circle": "1,2"}}})",
           R"({"mirrorball_workspace": 1, "photos": {"studio": {"no-such": "1"}}})",
           R"({"mirrorball_workspace": 1, "photos": {"studio": {"distance": "5", "fov": "40"}}})",
           R"({"mirrorball_workspace": 1, "compare_by": "sword"})",
           R"({"mirrorball_workspace": 1, "edited_side": 2})",
       }) {
    const auto read = readWorkspace(json);
    ASSERT_FALSE(read) << json;
    EXPECT_THAT(read.error().message, Not(HasSubstr("\n"))) << json;
    EXPECT_FALSE(read.error().message.empty()) << json;
  }
}

TEST(WorkspaceFile, EveryCutAndEveryChangedByteIsReadOrRefused) {
  const std::string whole = writtenWorkspace(something());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    (void)readWorkspace(whole.substr(0, i));
    std::string damaged = whole;
    for (const char byte : {'\0', '"', '9', '\xff'}) {
      damaged[i] = byte;
      const auto read = readWorkspace(damaged);
      EXPECT_TRUE(!read || readWorkspace(writtenWorkspace(*read))) << damaged;
    }
  }
}

TEST(WorkspaceFile, ReplacesNothingThatItShows) {
  Workspace workspace;
  const std::string path = ::testing::TempDir() + "shown.glb";
  std::filesystem::remove(path);
  std::filesystem::remove(path + ".json");
  ASSERT_TRUE(saveWorkspace(path, workspace)) << "nothing is there yet";
  workspace.model = path;
  EXPECT_EQ(saveWorkspace(path, workspace).error().code, ErrorCode::usage);
  EXPECT_TRUE(saveWorkspace(path + ".json", workspace));
  EXPECT_TRUE(saveWorkspace(path + ".json", {})) << "another workspace";
  const std::string note = ::testing::TempDir() + "note.txt";
  std::ofstream(note) << "{not a workspace";
  EXPECT_EQ(saveWorkspace(note, workspace).error().code, ErrorCode::usage);
}

}  // namespace
}  // namespace mirrorball
