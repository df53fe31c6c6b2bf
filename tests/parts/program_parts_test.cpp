// The program of any build: what is left out is answered by one line, and only that.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "cli/program.h"
#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::Outcome;

const std::string kLeftOut = MIRRORBALL_LEFT_OUT;

bool isLeftOut(std::string_view part) {
  for (std::string_view name : split(kLeftOut, ',')) {
    name.remove_prefix(std::min(name.find_first_not_of(' '), name.size()));
    if (name == part) return true;
  }
  return false;
}

class ProgramParts : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  Outcome run(const std::string& line) const {
    return testing::Program({.arguments = split(line, ' '), .folder = folder_}).wait();
  }

  const fs::path folder_ = fs::path(::testing::TempDir()) / ("mirrorball_parts_" + std::to_string(::getpid()));
};

TEST_F(ProgramParts, VersionTellsWhatIsLeftOut) {
  const std::string left_out = kLeftOut.empty() ? "" : "built without " + kLeftOut + "\n";
  EXPECT_EQ(run("--version").out, "mirrorball " MIRRORBALL_VERSION "\n" + left_out);
}

TEST_F(ProgramParts, WhatIsLeftOutIsAnsweredByOneLine) {
  const std::string gltf = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":"data:;base64,AAAAAA=="}],)";
  write("a.exr", "\x76\x2f\x31\x01 and so on");
  write("a.jpg", "\xff\xd8\xff and so on");
  write("a.png", "\x89PNG\r\n\x1a\n and so on");
  write("a.tif", std::string("II\x2a\0", 4) + " and so on");
  write("a.webp", "RIFF1234WEBPVP8 and so on");
  write("a.avif", std::string("\0\0\0\x10", 4) + "ftypavif and so on");
  write("a.jxl", "\xff\x0a and so on");
  write("draco.gltf", gltf + R"("bufferViews":[{"buffer":0,"byteLength":4}],"meshes":[{"primitives":[{"attributes":)"
                             R"({"POSITION":0},"extensions":{"KHR_draco_mesh_compression":{"bufferView":0,)"
                             R"("attributes":{"POSITION":0}}}}]}],"accessors":[{"componentType":5126,"count":3,)"
                             R"("type":"VEC3"}],"nodes":[{"mesh":0}]})");
  write("meshopt.gltf", gltf + R"("bufferViews":[{"buffer":0,"byteLength":16,"extensions":{"EXT_meshopt_compression":)"
                               R"({"buffer":0,"byteLength":4,"byteStride":16,"count":1,"mode":"ATTRIBUTES"}}}]})");
  struct Case {
    const char* part;
    const char* line;
    const char* answer;
  };
  for (const Case& one : {Case{"OpenEXR", "info a.exr", "a.exr: this build reads no OpenEXR"},
                          Case{"JPEG", "info a.jpg", "a.jpg: this build reads no JPEG"},
                          Case{"PNG", "info a.png", "a.png: this build reads no PNG"},
                          Case{"TIFF", "info a.tif", "a.tif: this build reads no TIFF"},
                          Case{"WebP", "info a.webp", "a.webp: this build reads no WebP"},
                          Case{"AVIF", "info a.avif", "a.avif: this build reads no AVIF"},
                          Case{"JPEG-XL", "info a.jxl", "a.jxl: this build reads no JPEG XL"},
                          Case{"OpenEXR", "convert white --size 8 -o b.exr", "b.exr: this build writes no OpenEXR"},
                          Case{"JPEG", "convert white --size 8 -o b.jpg", "b.jpg: this build writes no JPEG"},
                          Case{"PNG", "convert white --size 8 -o b.png", "b.png: this build writes no PNG"},
                          Case{"OpenEXR", "convert sunset --size 8 -o b.hdr", "this build has no sunset"},
                          Case{"Zstandard", "convert white --to cube --size 8 --zstd 3 -o b.ktx2",
                               "b.ktx2: this build knows no Zstandard"},
                          Case{"Draco", "export draco.gltf -o b.glb", "this build reads no meshes compressed by Draco"},
                          Case{"meshoptimizer", "export meshopt.gltf -o b.glb",
                               "this build reads no meshes compressed by meshoptimizer"}}) {
    const Outcome outcome = run(one.line);
    EXPECT_EQ(outcome.err.find(one.answer) != std::string::npos, isLeftOut(one.part)) << one.line << "\n"
                                                                                      << outcome.err;
    if (!isLeftOut(one.part)) continue;
    EXPECT_EQ(outcome.exit_code, 1) << one.line;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  }
}

TEST_F(ProgramParts, ASphereInTheStudioAndTheShowcaseAreDrawn) {
  const Outcome sphere = run("render sphere -e studio --size 64x36 --samples 1 --no-cache -o sphere.hdr");
  if (sphere.err.find("OpenGL") != std::string::npos) GTEST_SKIP() << sphere.err;
  EXPECT_EQ(sphere.exit_code, 0) << sphere.err;
  EXPECT_TRUE(fs::exists(folder_ / "sphere.hdr"));

  const Outcome showcase = run("render --size 64x36 --samples 1 --no-cache -o showcase.hdr");
  EXPECT_EQ(showcase.exit_code, 0) << showcase.err;
  EXPECT_TRUE(fs::exists(folder_ / "showcase.hdr"));
  EXPECT_EQ(showcase.err.find("the showcase is in the studio") != std::string::npos, isLeftOut("OpenEXR"))
      << showcase.err;
}

TEST_F(ProgramParts, HelpNamesTheFormatsThatAreThere) {
  const std::string help = run("info --help").out;
  EXPECT_THAT(help, HasSubstr(".hdr"));
  EXPECT_EQ(help.find(".tif") != std::string::npos, !isLeftOut("TIFF"));
  EXPECT_EQ(help.find(".webp") != std::string::npos, !isLeftOut("WebP"));
  EXPECT_EQ(help.find(".avif") != std::string::npos, !isLeftOut("AVIF"));
  EXPECT_EQ(help.find(".jxl") != std::string::npos, !isLeftOut("JPEG-XL"));
}

}  // namespace
}  // namespace mirrorball
