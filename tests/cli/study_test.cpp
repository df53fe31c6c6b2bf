// study: a page of every technique, from outside.

#include <chrono>
#include <csignal>
#include <string>
#include <thread>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

using StudyCliTest = RenderCliTest;

TEST_F(StudyCliTest, WritesOnePage) {
  EXPECT_EQ(succeed("study cube --set perceptual_roughness=0.5 -e uv --size 16x12 --samples 2 -o page.html"), "");
  EXPECT_THAT(files(), ElementsAre("page.html"));
  const Bytes page = bytes("page.html");
  const std::string text(page.begin(), page.end());
  EXPECT_THAT(text, AllOf(HasSubstr("<title>cube in uv</title>"), HasSubstr("width=\"16\" height=\"12\""),
                          HasSubstr("id=\"look-up\""), Not(HasSubstr("id=\"distance\""))));
  EXPECT_THAT(text, HasSubstr("mirrorball study cube --set perceptual_roughness=0.5 --env uv --size 16x12 --samples 2 "
                              "--output page.html"));
}

TEST_F(StudyCliTest, WhatMakesNoSenseIsRefused) {
  EXPECT_THAT(refuse(2, "study sphere -o page.pdf"), HasSubstr("page.pdf: a study is a page, .html"));
  EXPECT_THAT(refuse(2, "study --material gold -o page.html"), HasSubstr("--material is for a scene; name one"));
  EXPECT_THAT(refuse(2, "study none -o page.html"), HasSubstr("name a model"));
  EXPECT_THAT(refuse(2, "study sphere --blur mip -o page.html"), HasSubstr("--blur"));
  EXPECT_THAT(refuse(2, "study sphere --samples 0 -o page.html"), HasSubstr("samples"));
  EXPECT_THAT(refuse(1, "study sphere -o nowhere/page.html"), HasSubstr("nowhere"));
}

TEST_F(StudyCliTest, AnInterruptionLeavesNothing) {
  Program program({.arguments = Arguments("study -e uv --size 256x256 -o page.html").words, .folder = path("")});
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
