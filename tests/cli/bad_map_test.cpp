// Environments that cannot be read: one clear line each, exit code 1, nothing written.

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <sys/stat.h>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class BadMapTest : public CliTest {
 protected:
  /// Every command that reads a map refuses this one, in a line that begins with its name and says `what`.
  void everyCommandRefuses(const std::string& name, const std::string& what = "") const {
    for (const std::string& command : {"info " + name, "convert " + name + " --to cube --size 4 -o out.exr",
                                       "render none --size 8x8 -o out.png -e " + name})
      EXPECT_THAT(refuse(1, command), AllOf(StartsWith(name + ": "), HasSubstr(what))) << command;
  }
};

const std::vector<std::string> kExtensions{"hdr", "exr", "png", "jpg"};

TEST_F(BadMapTest, AFileThatIsNotThere) {
  everyCommandRefuses("missing.hdr", "no such file");
  everyCommandRefuses("folder/missing.hdr", "no such file");
  everyCommandRefuses("stduio", "studio");
}

TEST_F(BadMapTest, LightThatCannotBeSummed) {
  Image map = smoothPanorama();
  map.samples()[5] = 3e38f;
  write("map.exr", map);
  for (const std::string command :
       {"bake map.exr --size 8 -o maps", "render none --size 8x8 -o out.png -e map.exr",
        "render sphere --reference --size 8x8 -o out.png -e map.exr", "capture none --at 0,0,0 -o out.exr -e map.exr"})
    EXPECT_THAT(refuse(1, command), AllOf(StartsWith("map.exr: 1 value is above 1e36, too bright to be summed"),
                                          HasSubstr("--scale-light")))
        << command;
}

TEST_F(BadMapTest, AFolder) {
  std::filesystem::create_directory(path("folder.hdr"));
  everyCommandRefuses("folder.hdr", "is a folder");
}

TEST_F(BadMapTest, ANameThatATerminalWouldObey) {
  const std::string name = "a\x1b[2J\nb.hdr";
  EXPECT_THAT(refuse(1, Arguments(std::vector<std::string>{"info", name})), StartsWith("a?[2J?b.hdr: no such file"));
  write(name, std::string("no picture"));
  EXPECT_THAT(refuse(1, Arguments(std::vector<std::string>{"info", name})), StartsWith("a?[2J?b.hdr: "));
}

TEST_F(BadMapTest, WhatIsPrintedOfAGoodFileIsNoCommandToATerminal) {
  const std::string name =
      "a\x1b[2J\nb\xe2\x80\xae.exr";  // ESC, a newline, and U+202E, which turns the direction of writing
  write(name, smoothPanorama());
  const auto printed = [&](std::vector<std::string> words) { return succeed(Arguments(std::move(words))); };
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"info", name}, {"info", name, name, "--direction", "0,0,1"}, {"lights", name}, {"compare", name, name}})
    EXPECT_THAT(printed(words), AllOf(HasSubstr("a?[2J?b?.exr"), Not(HasSubstr("\x1b")), Not(HasSubstr("\xae"))));
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"info", name, "--json"}, {"lights", name, "--json"}, {"compare", name, name, "--json"}})
    EXPECT_THAT(printed(words),
                AllOf(HasSubstr("a\\u001b[2J\\nb\\u202e.exr"), Not(HasSubstr("\x1b")), Not(HasSubstr("\xae"))));
}

TEST_F(BadMapTest, APipe) {
  ASSERT_EQ(::mkfifo(path("pipe.hdr").c_str(), 0600), 0);
  everyCommandRefuses("pipe.hdr", "a pipe or a device");
}

TEST_F(BadMapTest, ATable) {
  succeed("bake white --size 8 --brdf-size 16 -o room/");
  EXPECT_THAT(refuse(1, "convert room/brdf.ktx2 --to cube -o out.exr"), HasSubstr("room/brdf.ktx2: is a BRDF table"));
  EXPECT_THAT(refuse(1, "convert room/lobe_rows.ktx2 --to cube -o out.exr"),
              HasSubstr("room/lobe_rows.ktx2: is a table of lobe rows"));
  succeed("bake white --size 8 --brdf-size 16 --extension exr -o pictures/");
  EXPECT_THAT(refuse(1, "convert pictures/brdf.exr --to cube -o out.exr"),
              HasSubstr("pictures/brdf.exr: is a BRDF table"));
}

TEST_F(BadMapTest, AnEmptyFile) {
  for (const std::string& extension : kExtensions) {
    write("empty." + extension, std::string());
    everyCommandRefuses("empty." + extension, "is empty");
  }
}

TEST_F(BadMapTest, AFileOfAnotherKind) {
  for (const std::string& extension : kExtensions) {
    write("wrong." + extension, std::string("These are no texels but words.\n"));
    everyCommandRefuses("wrong." + extension, "is not an image that can be read");
  }
}

TEST_F(BadMapTest, WhatStandsInAFilesPlaceIsNamed) {
  write("probe.hdr", std::string("version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n"));
  everyCommandRefuses("probe.hdr", "probe.hdr: is a Git LFS pointer, which is not read; run `git lfs pull`");
  write("probe.exr", std::string("<!DOCTYPE html>\n<html>404</html>\n"));
  EXPECT_THAT(refuse(1, "info probe.exr"), HasSubstr("probe.exr: is a web page"));
  write("probe.jpg", std::string("Kaydara FBX Binary  "));
  EXPECT_THAT(refuse(1, "info probe.jpg"), HasSubstr("probe.jpg: is an FBX, a model and no picture"));
}

TEST_F(BadMapTest, ATruncatedFile) {
  for (const std::string& extension : kExtensions) {
    const std::string name = "whole." + extension;
    succeed("convert uv --to equirect --size 64 -o " + name);
    const Bytes whole = bytes(name);
    write("cut." + extension, Bytes(whole.begin(), whole.begin() + 20));
    everyCommandRefuses("cut." + extension);
    succeed("info " + name);
    if (extension == "jpg" || extension == "png") continue;  // OddPictureTest
    const std::string most = "most." + extension;
    write(most, Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(whole.size() * 3 / 4)));
    for (const std::string& command : {"info " + most, "convert " + most + " --to cube --size 4 -o out.exr",
                                       "render none --size 8x8 -o out.png -e " + most})
      EXPECT_THAT(run(command).err, HasSubstr("note: " + most + ": ends before its last row: the ")) << command;
  }
}

TEST_F(BadMapTest, APanoramaThatIsNot2To1) {
  write("odd.exr", Image(40, 21, 3, 1.0f));
  everyCommandRefuses("odd.exr", "is 40x21");
  EXPECT_THAT(refuse(1, "info odd.exr --from equirect"), HasSubstr("2:1"));
  EXPECT_THAT(refuse(1, "info odd.exr --from sphere"), HasSubstr("square"));
  EXPECT_THAT(refuse(1, "info odd.exr --from cube"), HasSubstr("4:3"));
}

std::string hdrHeader(const std::string& size) {
  return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + size + "\n" + std::string(16, '\2');
}

void putBigEndian(Bytes& bytes, std::size_t at, std::uint32_t number) {
  for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<std::uint8_t>(number >> (24 - 8 * i));
}

/// A PNG with another size in its header: bytes 16 … 23, under the checksum of bytes 12 … 28.
Bytes resizedPng(Bytes bytes, std::uint32_t width, std::uint32_t height) {
  putBigEndian(bytes, 16, width);
  putBigEndian(bytes, 20, height);
  std::uint32_t crc = ~0u;  // bit by bit, as in PNG's annex D
  for (std::size_t i = 12; i < 29; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320u : 0u);
  }
  putBigEndian(bytes, 29, ~crc);
  return bytes;
}

/// An OpenEXR file with another data window, which begins at (0, 0).
Bytes resizedExr(Bytes bytes, std::int32_t width, std::int32_t height) {
  const std::string key("dataWindow\0box2i\0", 17);
  const auto found = std::search(bytes.begin(), bytes.end(), key.begin(), key.end());
  const std::int32_t window[4] = {0, 0, width - 1, height - 1};
  std::memcpy(&*found + key.size() + 4, window, sizeof window);
  return bytes;
}

TEST_F(BadMapTest, AnImageOf0Texels) {
  write("zero.hdr", hdrHeader("-Y 0 +X 8"));
  everyCommandRefuses("zero.hdr");
  write("one.png", Image(2, 1, 3, 0.5f));
  write("zero.png", resizedPng(bytes("one.png"), 0, 1));
  everyCommandRefuses("zero.png");
  write("one.exr", Image(2, 1, 3, 0.5f));
  write("zero.exr", resizedExr(bytes("one.exr"), 0, 1));
  everyCommandRefuses("zero.exr");
}

TEST_F(BadMapTest, AnImageOf2To31Texels) {
  write("huge.hdr", hdrHeader("-Y 32768 +X 65536"));
  everyCommandRefuses("huge.hdr", "65536x32768");
  write("long.hdr", hdrHeader("-Y 1 +X 2147483648"));
  everyCommandRefuses("long.hdr", "2147483648x1");
  write("one.png", Image(2, 1, 3, 0.5f));
  write("huge.png", resizedPng(bytes("one.png"), 65536, 32768));
  everyCommandRefuses("huge.png", "65536x32768");
  write("long.png", resizedPng(bytes("one.png"), 1u << 31, 1));
  everyCommandRefuses("long.png");
  write("one.exr", Image(2, 1, 3, 0.5f));
  write("huge.exr", resizedExr(bytes("one.exr"), 65536, 32768));
  everyCommandRefuses("huge.exr", "65536x32768");
}

TEST_F(BadMapTest, ManyTexelsThatTheFileDoesNotHold) {
  // As many as are read at most, 2³⁰, from a few bytes: refused before memory is taken for them.
  write("empty.hdr", hdrHeader("-Y 16384 +X 65536"));
  everyCommandRefuses("empty.hdr", "truncated");
}

TEST_F(BadMapTest, SixFacesThatDoNotFitTogether) {
  succeed("convert uv --to cube --layout faces --size 8 -o room.exr");
  write("room_ny.exr", Image(9, 8, 3));
  EXPECT_THAT(refuse(1, "info room_px.exr"), StartsWith("room_ny.exr: is 9x8"));
  std::filesystem::remove(path("room_nx.exr"));
  EXPECT_THAT(
      refuse(1, "info room_px.exr"),
      StartsWith(
          "room_px.exr: is one of the six faces of a cube, without room_nx.exr; put all in one folder, or name its "
          "form with --from"));
}

class BadTexelTest : public RenderCliTest {
 protected:
  void SetUp() override {
    RenderCliTest::SetUp();
    Image map(16, 8, 3, 2.0f);
    map.texel(3, 1)[0] = std::numeric_limits<float>::quiet_NaN();
    map.texel(5, 2)[2] = std::numeric_limits<float>::infinity();
    map.texel(6, 7)[1] = -std::numeric_limits<float>::infinity();
    write("bad.exr", map);
  }
};

TEST_F(BadTexelTest, AreRefusedWithCountAndFirstPlace) {
  for (const std::string command : {"convert bad.exr --to cube -o out.exr", "render none -e bad.exr -o out.png"})
    EXPECT_THAT(refuse(1, command),
                AllOf(StartsWith("bad.exr: 3 texels are NaN or infinite, the first at (3, 1)"), HasSubstr("--repair")));
}

TEST_F(BadTexelTest, AreRepairedFromTheirNeighbours) {
  succeed("convert bad.exr --repair --to equirect -o good.exr");
  const Image good = image("good.exr");
  for (const float sample : good.samples()) EXPECT_NEAR(sample, 2.0f, 1e-5f);
  succeed("render none -e bad.exr --repair --size 16x16 -o good.png");
}

TEST_F(BadTexelTest, AMapWithoutAGoodTexelCannotBeRepaired) {
  write("bad.exr", Image(4, 2, 3, std::numeric_limits<float>::quiet_NaN()));
  EXPECT_THAT(refuse(1, "convert bad.exr --repair --to cube -o out.exr"), StartsWith("bad.exr: "));
  succeed("info bad.exr");
}

TEST_F(BadTexelTest, AreToldByTheFaceThatHasThem) {
  succeed("convert white --to cube --layout faces --size 4 -o room.exr");
  Image face(4, 4, 3, 1.0f);
  face.texel(2, 3)[0] = std::numeric_limits<float>::quiet_NaN();
  write("room_py.exr", face);
  EXPECT_THAT(refuse(1, "convert room_px.exr --to equirect -o out.exr"),
              StartsWith("room_py.exr: 1 texel is NaN or infinite, the first at (2, 3)"));
}

// The library says what is wrong, the command line with which of its options to mend it.
TEST_F(BadMapTest, TheLineEndsWithTheOptionThatHelps) {
  Image bad(8, 4, 3, 1.0f);
  bad.texel(3, 1)[0] = std::numeric_limits<float>::quiet_NaN();
  write("bad.exr", bad);
  write("odd.exr", Image(5, 3, 3));
  succeed("convert uv --to cube --size 8 -o cube.ktx2");
  succeed("convert uv --to cube --size 8 --mips -o sheet.png");
  succeed("convert white --to equirect --size 256 -o large.exr");
  const auto line = [&](const std::string& command) {
    return refuse(1, "convert " + command + " --to cube --size 64");
  };
  EXPECT_THAT(line("bad.exr -o out.exr"), EndsWith("the first at (3, 1); --repair replaces them by their neighbours"));
  EXPECT_THAT(line("odd.exr -o out.exr"), EndsWith("; crop it, or name its form with --from"));
  EXPECT_THAT(line("cube.ktx2 --from equirect -o out.exr"),
              EndsWith(" is one picture; leave --from out, or name cube or eac"));
  EXPECT_THAT(line("sheet.png -o out.exr"), EndsWith("; name what it was made of, or one level: convert --level"));
  EXPECT_THAT(line("large.exr -o out.ktx2 --max-memory 1e5"), EndsWith(" at a time; raise --max-memory"));
  EXPECT_THAT(line("large.exr --repair -o out.exr --max-memory 1M"),
              EndsWith(" may be used; --max-memory raises that, a smaller --size needs less"));
  for (const std::string without_size : {"info large.exr", "lights large.exr"})
    EXPECT_THAT(refuse(1, without_size + " --max-memory 1e5"), EndsWith(" may be used; raise --max-memory"));
  EXPECT_THAT(refuse(2, "convert uv --to cube --for blender -o out.exr"),
              EndsWith(" has no cube maps; give it a panorama (convert --to equirect)"));
}

}  // namespace
}  // namespace mirrorball::testing
