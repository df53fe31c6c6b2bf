// bake: Ctrl-C in each of its stages, and failures that do not wait for long work.

#include <chrono>
#include <csignal>
#include <string>
#include <vector>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

/// Some tenths of a second where nothing else runs; all of the work takes a minute.
constexpr std::chrono::seconds kSoon(10);

class BakeInterruptTest : public CliTest {
 protected:
  BakeInterruptTest() { write("map.exr", noisyPanorama()); }

  /// Presses Ctrl-C when the terminal shows a text; returns what it showed in the end. The program must stop soon.
  std::string interruptAt(const std::string& shown, const std::string& line) const {
    Program program({.arguments = Arguments(line).words, .folder = path(""), .cores = 1, .on_terminal = true});
    program.waitUntilShown(shown);
    EXPECT_TRUE(program.running()) << line << ": was done before it could be interrupted";
    const auto pressed = std::chrono::steady_clock::now();
    program.interrupt();
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.signal, SIGINT) << line << "\nended with " << outcome.exit_code;
    EXPECT_THAT(outcome.err, HasSubstr(shown)) << line;
    EXPECT_LT(std::chrono::steady_clock::now() - pressed, kSoon) << line;
    return outcome.err;
  }
};

constexpr const char* kNothing = "\r\033[Kmirrorball: interrupted; nothing was written";

// Takes seconds: each stage must be long enough to be met by Ctrl-C on any machine.
TEST_F(BakeInterruptTest, NoStageLeavesAnything) {
  for (const auto& [stage, line] : std::vector<std::pair<std::string, std::string>>{
           {"BRDF table [", "bake white -o new/out --size 4 --brdf-size 4096 --distribution charlie"},
           {"analyse light [", "bake map.exr -o new/out --size 8192 --brdf-size 2"},
           {"prefilter [", "bake white -o new/out --size 8192 --brdf-size 2"},
           {"irradiance [", "bake map.exr -o new/out --size 4 --brdf-size 2 --irradiance-size 1024"},
           {"analyse light [", "bake map.exr -o chain.ktx2 --size 8192"},
           {"prefilter [", "bake white -o chain.dds --size 8192"}}) {
    EXPECT_THAT(interruptAt(stage, line), HasSubstr(kNothing)) << line;
    EXPECT_THAT(files(), ElementsAre("map.exr")) << line;
  }
}

TEST_F(BakeInterruptTest, AnOlderSetStaysWholeUntilTheNewOneIsWritten) {
  succeed("bake white -o out --size 8 --brdf-size 4");
  const std::vector<std::string> before = files();
  const Bytes manifest = bytes("out/manifest.json");
  const Bytes specular = bytes("out/specular.ktx2");
  interruptAt("prefilter [", "bake white -o out --size 8192 --brdf-size 2");
  EXPECT_EQ(files(), before);
  EXPECT_EQ(bytes("out/manifest.json"), manifest);
  EXPECT_EQ(bytes("out/specular.ktx2"), specular);
}

// Zstandard takes seconds for the irradiance that is written after the chain.
TEST_F(BakeInterruptTest, WritingStopsBetweenFiles) {
  const std::string line = "bake map.exr --size 8 --brdf-size 2 --irradiance-size 256 --zstd 22 -o ";
  EXPECT_THAT(interruptAt("wrote new/out/specular.ktx2", line + "new/out"),
              HasSubstr("mirrorball: interrupted; nothing was written"));
  EXPECT_THAT(files(), ElementsAre("map.exr"));

  succeed("bake white -o out --size 8 --brdf-size 4");
  EXPECT_THAT(interruptAt("wrote out/specular.ktx2", line + "out"),
              HasSubstr("mirrorball: interrupted; out has only some of the new files, and no manifest"));
  EXPECT_THAT(files(), AllOf(IsSupersetOf({"out/brdf.ktx2", "out/sh.h", "out/sh.json", "out/specular.ktx2"}),
                             Not(Contains("out/manifest.json")), Not(Contains(HasSubstr(".part")))));
}

TEST_F(BakeInterruptTest, OfANewFolderWhatOthersPutThereStays) {
  const std::string line = "bake map.exr --size 8 --brdf-size 2 --irradiance-size 256 --zstd 22 -o new/out";
  Program program({.arguments = Arguments(line).words, .folder = path(""), .cores = 1, .on_terminal = true});
  program.waitUntilShown("wrote new/out/specular.ktx2");
  write("new/out/others.txt", std::string("finished"));
  program.interrupt();
  EXPECT_EQ(program.wait().signal, SIGINT);
  EXPECT_THAT(files(), AllOf(Contains("new/out/others.txt"), Not(Contains(HasSubstr(".ktx2")))));
}

// The one that is being written goes away, and the ones before it stay.
TEST_F(BakeInterruptTest, OfManyTheFinishedOnesStay) {
  const std::string line = "bake white map.exr --size 8 --brdf-size 2 --irradiance-size 256 --zstd 22 -o out";
  EXPECT_THAT(interruptAt("wrote out/map/specular.ktx2", line),
              HasSubstr("mirrorball: interrupted; what was finished stays in out"));
  EXPECT_THAT(files(), AllOf(Contains("out/white/manifest.json"), Not(Contains("out/map/"))));
}

TEST_F(BakeInterruptTest, PicturesStopBetweenLevels) {
  const std::string line = "bake white --size 1024 --brdf-size 2 --extension exr -o ";
  EXPECT_THAT(interruptAt("wrote new/out/m0_px.exr", line + "new/out"),
              HasSubstr("mirrorball: interrupted; nothing was written"));
  EXPECT_THAT(files(), ElementsAre("map.exr"));
}

TEST_F(BakeInterruptTest, WhatCannotBeReadIsToldAtOnce) {
  write("broken.exr", std::string("no picture"));
  for (const std::string name : {"missing.exr", "broken.exr"}) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_THAT(refuse(1, "bake " + name + " -o out --brdf-size 4096 --distribution charlie"), HasSubstr(name));
    EXPECT_LT(std::chrono::steady_clock::now() - start, kSoon) << name;
  }
}

}  // namespace
}  // namespace mirrorball::testing
