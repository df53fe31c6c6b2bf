// Ctrl-C in the middle of long work.

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

class InterruptTest : public CliTest {
 protected:
  static void expectInterrupted(const Outcome& outcome) {
    EXPECT_EQ(outcome.signal, SIGINT) << "ended with " << outcome.exit_code;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(outcome.err.starts_with("mirrorball: interrupted")) << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  }
};

// A loop of a shell goes on after a program that only says that it was interrupted,
// and ends with one that the signal ended.
TEST_F(InterruptTest, EachSignalEndsItAfterItHasCleanedUp) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    Program program(
        {.arguments = Arguments("convert sky -o out.exr --to cube --size 1024").words, .folder = path(""), .cores = 1});
    program.waitUntilItCatchesInterrupts();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    program.interrupt(signal);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.signal, signal) << "ended with " << outcome.exit_code;
    EXPECT_EQ(outcome.err, "mirrorball: interrupted; nothing was written\n");
    EXPECT_THAT(files(), ElementsAre());
  }
}

// On one core each conversion takes more than a second; they are interrupted after a tenth of one.
TEST_F(InterruptTest, AConversionLeavesNothing) {
  for (const std::string form : {"equirect --size 2048", "cube --size 1024", "cube --size 1024 --layout faces"}) {
    Program program(
        {.arguments = Arguments("convert sky -o out.exr --to " + form).words, .folder = path(""), .cores = 1});
    program.waitUntilItCatchesInterrupts();
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    ASSERT_TRUE(program.running()) << "it was done before it could be interrupted";
    program.interrupt();
    expectInterrupted(program.wait());
    EXPECT_THAT(files(), ElementsAre()) << form;
  }
}

TEST_F(InterruptTest, AConversionLeavesWhatWasThere) {
  write("out.exr", std::string("the old file"));
  Program program({.arguments = Arguments("convert sky --size 2048 --to equirect -o out.exr").words,
                   .folder = path(""),
                   .cores = 1});
  program.waitUntilItCatchesInterrupts();
  program.interrupt();
  expectInterrupted(program.wait());
  EXPECT_THAT(files(), ElementsAre("out.exr"));
  EXPECT_EQ(bytes("out.exr").size(), std::string("the old file").size());
}

using InterruptRenderTest = RenderCliTest;

TEST_F(InterruptRenderTest, ATurntableLeavesWholePictures) {
  Program program({.arguments = Arguments("render none -e white --size 64x64 --frames 100000 -o turn.png").words,
                   .folder = path("")});
  while (program.running() && !std::filesystem::exists(path("turn_00001.png")))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  program.interrupt();
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.signal, SIGINT) << "ended with " << outcome.exit_code;
  const std::vector<std::string> left = files();
  EXPECT_GE(left.size(), 2u);
  EXPECT_EQ(outcome.err,
            "mirrorball: interrupted after " + std::to_string(left.size()) + " of 100000 pictures; those are whole\n");
  for (const std::string& name : left) {
    EXPECT_THAT(name, Not(HasSubstr(".part")));
    EXPECT_EQ(image(name).width(), 64) << name;
  }
}

TEST_F(InterruptRenderTest, ATurntableThatHasNoPictureYetSaysSo) {
  const std::string line = "render showcase -e white --size 512x512 --samples 4096 --frames 200 -o turn.png";
  Program program({.arguments = Arguments(line).words, .folder = path(""), .cores = 1});
  program.waitUntilItCatchesInterrupts();
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  program.interrupt();
  // What the quality chose is noted before the first picture, if there was time for it.
  EXPECT_THAT(program.wait().err, EndsWith("mirrorball: interrupted; nothing was written\n"));
  EXPECT_THAT(files(), ElementsAre());
}

TEST_F(InterruptRenderTest, ATurntableShowsItsProgressOnATerminalAndClearsIt) {
  const std::string line = "render none -e white --size 64x64 --frames 100000 -o turn.png";
  Program program({.arguments = Arguments(line).words, .folder = path(""), .on_terminal = true});
  program.waitUntilShown(" s left");
  program.interrupt();
  const std::string shown = program.wait().err;
  EXPECT_THAT(shown, ContainsRegex("turntable \\[#*\\.*\\] [0-9]+/100000 pictures, [0-9]+ s left"));
  EXPECT_THAT(shown, HasSubstr("\r\033[Kmirrorball: interrupted after "));
}

TEST_F(InterruptRenderTest, WhatWarmsTheCachesShowsHowManyProgramsAreLeft) {
  Program program({.arguments = Arguments("cache warm showcase --quality good").words,
                   .folder = path(""),
                   .environment = {{"MESA_SHADER_CACHE_DIR", path("driver").string()}},
                   .cores = 1,
                   .on_terminal = true});
  program.waitUntilShown(" programs, ");
  program.interrupt();
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.signal, SIGINT) << "ended with " << outcome.exit_code;
  EXPECT_THAT(outcome.err, ContainsRegex("showcase \\[#*\\.*\\] [0-9]+/[0-9]+ programs, [0-9]+ s left"));
  EXPECT_THAT(outcome.err, HasSubstr("mirrorball: interrupted; what was prepared until now stays in the caches"));
}

/// A quarter of a second is what work may take to stop by itself; the rest is for a machine that does much else.
constexpr std::chrono::seconds kSoonInterrupted(5);

class LongStepTest : public CliTest {
 protected:
  /// Presses Ctrl-C some time after the program has begun, or after it has written the file `first`; returns what it
  /// said in the end, which must be soon.
  std::string interruptAfter(std::chrono::milliseconds time, const std::string& line,
                             const std::string& first = "") const {
    Program program({.arguments = Arguments(line).words, .folder = path(""), .cores = 1});
    program.waitUntilItCatchesInterrupts();
    while (program.running() && !std::filesystem::exists(path(first)))
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(time);
    EXPECT_TRUE(program.running()) << line << ": was done before it could be interrupted";
    const auto pressed = std::chrono::steady_clock::now();
    program.interrupt();
    const Outcome outcome = program.wait();
    EXPECT_LT(std::chrono::steady_clock::now() - pressed, kSoonInterrupted) << line;
    EXPECT_EQ(outcome.signal, SIGINT) << line << "\nended with " << outcome.exit_code;
    return outcome.err;
  }
};

// Zstandard compresses a level in one go, which takes half a minute here.
TEST_F(LongStepTest, IsNotWaitedFor) {
  succeed("convert sky --to cube --size 512 --format half -o sky.ktx2");
  const std::vector<std::string> before = files();
  EXPECT_EQ(interruptAfter(std::chrono::milliseconds(1500), "convert sky.ktx2 --to cube --zstd 22 -o out.ktx2"),
            "mirrorball: interrupted; nothing was written\n");
  EXPECT_EQ(files(), before);
}

// Of many the finished ones stay.
TEST_F(LongStepTest, LeavesWhatWasFinished) {
  succeed("convert sky --to cube --size 512 --format half -o sky.ktx2");
  write("small.exr", smoothPanorama());
  EXPECT_EQ(interruptAfter(std::chrono::milliseconds(1000),
                           "convert small.exr sky.ktx2 --to cube --zstd 22 --extension ktx2 -o out", "out/small.ktx2"),
            "mirrorball: interrupted; what was finished stays in out\n");
  EXPECT_THAT(files(), ElementsAre("out/", "out/small.ktx2", "sky.ktx2", "small.exr"));
}

TEST_F(LongStepTest, CompressionAsksWhetherToStop) {
  succeed("convert sky --to cube --size 2048 --format half -o sky.ktx2");
  EXPECT_EQ(interruptAfter(std::chrono::milliseconds(1000), "convert sky.ktx2 --format bc6h --mips -o out.ktx2"),
            "mirrorball: interrupted; nothing was written\n");
  EXPECT_THAT(files(), ElementsAre("sky.ktx2"));
}

}  // namespace
}  // namespace mirrorball::testing
