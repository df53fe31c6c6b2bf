// Many inputs in one run, into a folder.

#include <chrono>
#include <csignal>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::UnorderedElementsAre;

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

class ConvertManyTest : public CliTest {
 protected:
  /// Three maps of different forms.
  void SetUp() override {
    write("a.exr", smoothPanorama());
    succeed("convert a.exr --to sphere --size 32 -o b.hdr");
    succeed("convert a.exr --to cube --size 16 --layout faces -o room.exr");
  }
};

TEST_F(ConvertManyTest, EachIsWhatItBecomesAlone) {
  const std::vector<std::pair<std::string, std::string>> inputs{
      {"a", "a.exr"}, {"b", "b.hdr"}, {"room_py", "room_py.exr"}, {"sky", "sky:sun=0"}};
  for (const std::string extension : {"ktx2", "png"}) {
    const std::string folder = "out/" + extension;
    std::string all;
    for (const auto& [name, input] : inputs) all += " " + input;
    succeed("convert" + all + " --to cube --size 16 -o " + folder + " --extension " + extension);
    EXPECT_EQ(std::distance(fs::directory_iterator(path(folder)), fs::directory_iterator()), 4);
    for (const auto& [name, input] : inputs) {
      succeed("convert " + input + " --to cube --size 16 -o alone." + extension);
      EXPECT_TRUE(bytes(folder + "/" + name + "." + extension) == bytes("alone." + extension)) << folder << name;
    }
  }
}

TEST_F(ConvertManyTest, OneCoreOrAllGiveTheSameBytes) {
  succeed("convert a.exr b.hdr room_px.exr --to equirect --size 32 -o all --extension exr");
  succeed("convert a.exr b.hdr room_px.exr --to equirect --size 32 -o one --extension exr", {.cores = 1});
  for (const std::string file : {"/a.exr", "/b.exr", "/room_px.exr"})
    EXPECT_TRUE(bytes("all" + file) == bytes("one" + file)) << file;
}

TEST_F(ConvertManyTest, WithoutAnExtensionEachKeepsItsOwn) {
  succeed("convert a.exr b.hdr --to angular --size 16 -o out");
  EXPECT_EQ(image("out/a.exr").width(), 16);
  EXPECT_EQ(image("out/b.hdr").width(), 16);
}

TEST_F(ConvertManyTest, OneInputGoesIntoAFolderToo) {
  succeed("convert a.exr --to cube --size 8 -o new/");
  succeed("convert a.exr --to cube --size 8 -o new");
  succeed("convert a.exr --to cube --size 8 -o other --extension .ktx2");
  succeed("convert room_px.exr --to cube --size 8 --layout faces -o six/ --extension hdr");
  EXPECT_THAT(files(),
              ::testing::IsSupersetOf({"new/a.exr", "other/a.ktx2", "six/room_px_px.hdr", "six/room_px_nz.hdr"}));
  // Its own error is all there is to say.
  EXPECT_THAT(refuse(1, "convert none.exr --to cube -o new/"), StartsWith("none.exr: no such file"));
}

TEST_F(ConvertManyTest, AFolderOfSixFilesIsOneInput) {
  fs::create_directory(path("cube"));
  for (const std::string& file : files())
    if (file.starts_with("room")) fs::rename(path(file), path("cube/" + file));
  succeed("convert a.exr cube/ --to equirect --size 16 -o out --extension exr");
  succeed("convert cube --to equirect --size 16 -o alone.exr");
  EXPECT_TRUE(bytes("out/cube.exr") == bytes("alone.exr"));
}

TEST_F(ConvertManyTest, SixFilesOfOneCubeAreTakenOnce) {
  const std::string six = "room_nx.exr room_ny.exr room_nz.exr room_px.exr room_py.exr room_pz.exr";
  const Outcome outcome = run("convert " + six + " --to equirect --size 8 -o panoramas/");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err,
            "mirrorball: note: room_nx.exr: is one of 6 inputs that are the faces of one cube, which is taken once\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(path("panoramas")), fs::directory_iterator()), 1);
  EXPECT_EQ(run("convert " + six + " --to equirect --size 8 -o one.exr").exit_code, 0);
  EXPECT_TRUE(bytes("one.exr") == bytes("panoramas/room_nx.exr"));
}

TEST_F(ConvertManyTest, ABadOneIsToldOfAndTheOthersGoOn) {
  write("bad.hdr", std::string("#?RADIANCE\nnonsense"));
  const Outcome outcome = run("convert a.exr bad.hdr none.exr b.hdr --to cube --size 8 -o out --extension ktx2");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  std::vector<std::string> lines = linesOf(outcome.err);
  ASSERT_EQ(lines.size(), 3u) << outcome.err;
  EXPECT_EQ(lines.back(), "mirrorball: 2 of 4 inputs could not be converted; the others are in out");
  lines.pop_back();
  EXPECT_THAT(lines, UnorderedElementsAre(StartsWith("mirrorball: bad.hdr: "),
                                          StartsWith("mirrorball: none.exr: no such file")));
  std::vector<std::string> made;
  for (const std::string& file : files())
    if (file.starts_with("out/")) made.push_back(file);
  EXPECT_THAT(made, ElementsAre("out/", "out/a.ktx2", "out/b.ktx2")) << "no half files";
}

TEST_F(ConvertManyTest, WhereAllAreBadItSaysSo) {
  const Outcome outcome = run("convert x.exr y.exr --to cube -o out --extension ktx2");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(linesOf(outcome.err).back(), "mirrorball: none of 2 inputs could be converted");
}

TEST_F(ConvertManyTest, TwoOutputsOfOneNameAreRefused) {
  fs::create_directory(path("day"));
  fs::copy_file(path("a.exr"), path("day/a.exr"));
  EXPECT_THAT(refuse(2, "convert a.exr day/a.exr --to cube -o out"),
              AllOf(HasSubstr("a.exr and day/a.exr would both become out/a.exr"), HasSubstr("two folders")));
  EXPECT_THAT(refuse(2, "convert sky:elevation=10 sky:elevation=20 --to cube -o out --extension ktx2"),
              HasSubstr("out/sky.ktx2"));
}

TEST_F(ConvertManyTest, NoInputIsOverwritten) {
  EXPECT_THAT(refuse(2, "convert a.exr b.hdr --to cube -o ."), HasSubstr("is the input itself"));
  EXPECT_THAT(refuse(2, "convert a.exr b.hdr --to cube -o ./ --extension exr"), HasSubstr("is the input itself"));
}

// What is wrong with the options is wrong for every input: it is told once, and no folder is made.
TEST_F(ConvertManyTest, AMistakeInTheOptionsIsToldOnce) {
  const std::string two = "convert a.exr b.hdr -o out ";
  EXPECT_THAT(refuse(2, two + "--to sphere --extension ktx2 --mips"), HasSubstr("mip levels of sphere"));
  EXPECT_THAT(refuse(2, two + "--to cube --extension ktx2 --layout vcross"), HasSubstr("in no layout"));
  EXPECT_THAT(refuse(2, two + "--to cube --extension dds --zstd 3"), HasSubstr("no Zstandard compression"));
  EXPECT_THAT(refuse(2, two + "--to cube --zstd 3"), StartsWith("out/a.exr: "));
  EXPECT_THAT(refuse(2, two + "--to cube --extension tga"),
              AllOf(HasSubstr("out/a.tga"), HasSubstr(".ktx2, .ktx or .dds")));
  EXPECT_THAT(refuse(2, "convert a.exr sky --to cube -o out"), AllOf(StartsWith("sky "), HasSubstr("--extension")));
  EXPECT_THAT(refuse(2, "convert a.exr b.hdr --to cube -o out.exr"), AllOf(HasSubstr("2 inputs"), HasSubstr("folder")));
}

TEST_F(ConvertManyTest, AFolderThatCannotBeMade) {
  write("file", std::string("no folder"));
  EXPECT_THAT(refuse(1, "convert a.exr b.hdr --to cube -o file"), StartsWith("file: "));
  EXPECT_THAT(refuse(1, "convert a.exr b.hdr --to cube -o file/out"), StartsWith("file/out: cannot be made"));
}

// On one core each takes about a tenth of a second; the run is interrupted when the first is there.
TEST_F(ConvertManyTest, CtrlCLeavesWholeFilesOnly) {
  std::string inputs;
  for (int i = 10; i < 60; ++i) {
    const std::string name = "link" + std::to_string(i) + ".exr";
    fs::create_symlink("a.exr", path(name));
    inputs += " " + name;
  }
  Program program({.arguments = Arguments("convert" + inputs + " --to cube --size 512 -o out --extension ktx2").words,
                   .folder = path(""),
                   .cores = 1});
  const auto finished = [&] {
    std::error_code missing;
    for (const fs::directory_entry& entry : fs::directory_iterator(path("out"), missing))
      if (entry.path().extension() == ".ktx2" && entry.path().stem().string().starts_with("link")) return true;
    return false;
  };
  while (program.running() && !finished()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  ASSERT_TRUE(program.running()) << "it was done before it could be interrupted";
  program.interrupt();
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.signal, SIGINT) << "ended with " << outcome.exit_code;
  EXPECT_EQ(outcome.err, "mirrorball: interrupted; what was finished stays in out\n");
  succeed("convert a.exr --to cube --size 512 -o whole.ktx2");
  int count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(path("out"))) {
    const std::string name = entry.path().filename().string();
    EXPECT_THAT(name, AllOf(StartsWith("link"), EndsWith(".ktx2")));
    EXPECT_TRUE(bytes("out/" + name) == bytes("whole.ktx2")) << name;
    ++count;
  }
  EXPECT_GE(count, 1);
  EXPECT_LT(count, 50);
}

}  // namespace
}  // namespace mirrorball::testing
