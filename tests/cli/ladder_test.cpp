// `surface --ladder`: all kinds of relief on one sheet, from outside.

#include <chrono>
#include <csignal>
#include <cstdint>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

using LadderTest = RenderCliTest;

// Nothing to hide: where the heights are all 1, each kind of relief is the mesh itself, and PSNR is but noise.
TEST_F(LadderTest, HasAllKindsAtThreeAngles) {
  write("flat.exr", Image(4, 4, 1, 1.0f));
  const std::string told = succeed("surface flat.exr --ladder -e uv --size 16x12 --samples 8 --no-cache -o ladder.png");
  EXPECT_THAT(files(), ElementsAre("flat.exr", "ladder.png"));
  std::istringstream lines(told);
  for (const char* angle : {"60", "30", "10"})
    for (const char* kind :
         {"none", "bump", "parallax", "steep", "occlusion", "linear-binary", "cone", "exact", "geometry"}) {
      std::string found_angle, found_kind, rest;
      double psnr_dB = 0.0;
      lines >> found_angle >> found_kind >> psnr_dB;
      std::getline(lines, rest);
      EXPECT_EQ(found_angle + " " + found_kind, std::string(angle) + " " + kind);
      EXPECT_GT(psnr_dB, 15.0) << found_angle << " " << found_kind;
      EXPECT_THAT(rest, HasSubstr(" x bump"));
    }
  // Ten columns as wide as "linear-binary", and gaps between; three rows of a title, a picture and four lines.
  const Image8 sheet = decodeTexture(bytes("ladder.png")).value();
  EXPECT_EQ(sheet.width(), 8 + 10 * (13 * 7 + 8));
  EXPECT_EQ(sheet.height(), 8 + 3 * (12 + 12 + 4 + 4 * 12 + 8));
}

// Times differ from run to run; the pictures between the lines of text do not.
TEST_F(LadderTest, TheScaleIsTheDepth) {
  Image hill(4, 4, 1);
  hill.texel(1, 2)[0] = 1.0f;
  write("hill.exr", hill);
  const auto picturesAt = [&](const std::string& scale) {
    const std::string told = succeed(
        "surface hill.exr --ladder -e uv --size 8x6 --samples 1 --relief-steps 4 --scale " + scale + " -o a.png");
    EXPECT_THAT(told, Not(AnyOf(HasSubstr("nan"), HasSubstr("inf")))) << "one sample takes time, too";
    const Image8 sheet = decodeTexture(bytes("a.png")).value();
    return std::vector<std::uint8_t>(sheet.texel(0, 8 + 12), sheet.texel(0, 8 + 12 + 6));
  };
  const auto shallow = picturesAt("0.01");
  EXPECT_NE(shallow, picturesAt("0.3"));
  EXPECT_EQ(shallow, picturesAt("0.01"));
}

TEST_F(LadderTest, WhatMakesNoSenseIsRefused) {
  EXPECT_THAT(refuse(2, "surface brick --ladder"), HasSubstr("-o"));
  EXPECT_THAT(refuse(2, "surface brick --ladder -o ladder.exr"), HasSubstr(".png"));
  EXPECT_THAT(refuse(2, "surface brick --ladder --to cone -o ladder.png"), HasSubstr("--to changes nothing"));
  EXPECT_THAT(refuse(2, "surface brick --ladder --edges clamped -o ladder.png"), HasSubstr("--edges"));
  EXPECT_THAT(refuse(2, "surface brick --samples 3 -o normal.png"), HasSubstr("add --ladder"));
  EXPECT_THAT(refuse(2, "surface brick -e uv -o normal.png"), HasSubstr("--env is of the ladder"));
  EXPECT_THAT(refuse(1, "surface absent.png --ladder -o ladder.png"), HasSubstr("absent.png"));
  EXPECT_THAT(refuse(1, "surface brick --ladder -o nowhere/ladder.png"), HasSubstr("nowhere"));
  write("own.png", Image(2, 2, 1, 0.5f));
  EXPECT_THAT(refuse(2, "surface own.png --ladder -o own.png"), HasSubstr("own.png"));
}

TEST_F(LadderTest, AnInterruptionLeavesNothing) {
  Program program({.arguments = Arguments("surface cobbles --ladder -e uv -o ladder.png").words, .folder = path("")});
  program.waitUntilItCatchesInterrupts();
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  ASSERT_TRUE(program.running()) << "it was done before it could be interrupted";
  program.interrupt();
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.signal, SIGINT) << "ended with " << outcome.exit_code;
  EXPECT_THAT(outcome.err, HasSubstr("mirrorball: interrupted"));
  EXPECT_THAT(files(), ElementsAre());
}

}  // namespace
}  // namespace mirrorball::testing
