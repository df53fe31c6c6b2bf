// --max-memory, and panoramas that are converted while they are read, by rows.

#include <chrono>
#include <csignal>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "cli/cli_testing.h"
#include "cli/measure.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// 2048x1024 texels are 32 MB in floats with the alpha that a PNG may have. What the program has of its own is the same
// whether it reads them or not.
TEST_F(PeakMemoryTest, ARefusedMapTakesNoMemory) {
  succeed("convert white --to equirect --size 1024 -o large.png");
  const std::uint64_t taken = peakOf("convert large.png --to cube --size 8 -o out.exr");
  for (const std::string command : {"convert large.png --to cube --size 8 -o out.exr", "info large.png",
                                    "convert large.png --repair --to cube --size 8 -o out.ktx2"}) {
    const Outcome refused = run(command + " --max-memory 20M");
    EXPECT_EQ(refused.exit_code, 1) << command;
    EXPECT_THAT(refused.err, AllOf(StartsWith("mirrorball: large.png: needs 32 MB"), HasSubstr("20 MB may be used"),
                                   HasSubstr("--max-memory")));
    EXPECT_LT(refused.peak_memory + 20 * kMega, taken) << command;
  }
}

TEST_F(PeakMemoryTest, ARefusedOutputTakesNoMemory) {
  const std::string command = "convert white --to cube --size 512 -o out.exr";
  const std::uint64_t taken = peakOf(command);
  const Outcome refused = run(command + " --max-memory 17M");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("the converted map: needs 18 MB"), HasSubstr("17 MB may be used")));
  EXPECT_LT(refused.peak_memory + 12 * kMega, taken);
}

// Texels go into the file as they are made: 6 x 512² of them, 18 MB as floats, never are in memory together.
TEST_F(PeakMemoryTest, APlainTextureNeedsNoMemoryForItsTexels) {
  const std::uint64_t whole = peakOf("convert white --to cube --size 512 -o out.exr");
  EXPECT_LT(peakOf("convert white --to cube --size 512 -o out.ktx2 --max-memory 1M") + 12 * kMega, whole);
  EXPECT_LT(peakOf("convert white --to cube --size 512 -o out.dds --max-memory 1M") + 12 * kMega, whole);
  EXPECT_THAT(refuse(1, "convert white --to cube --size 512 -o no.ktx2 --mips --max-memory 1M"),
              HasSubstr("--max-memory"));
}

// A header that claims 6 GB, and a few bytes behind it.
TEST_F(PeakMemoryTest, AHeaderThatLiesTakesNoMemory) {
  const std::uint64_t own = peakOf("info white");
  write("liar.hdr", std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16384 +X 32768\n\x02\x02\x40\x00\x81"));
  for (const std::string command : {"convert liar.hdr --to cube --size 8 -o out.exr", "info liar.hdr"}) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.exit_code, 1) << command;
    EXPECT_THAT(outcome.err, AllOf(StartsWith("mirrorball: liar.hdr: "), HasSubstr("byte"))) << command;
    EXPECT_LT(outcome.peak_memory, own + 100 * kMega) << command;
  }
  EXPECT_THAT(files(), ElementsAre("liar.hdr"));
}

/// A panorama of 512 x 256 texels, 1.5 MB in floats: as a whole it does not fit into the 1 MB that it is given here, so
/// it goes by rows or not at all.
class ConvertRowsTest : public CliTest {
 protected:
  void SetUp() override {
    write("smooth.exr", smoothPanorama());
    for (const std::string extension : {"exr", "hdr", "png"})
      succeed("convert smooth.exr --to equirect --size 256 -o map." + extension);
  }
};

TEST_F(ConvertRowsTest, OnlyFilesThatAreReadByRowsFit) {
  succeed("convert map.exr --to cube --size 32 -o cube.exr --max-memory 1M");
  succeed("convert map.hdr --to cube --size 32 -o cube.exr --max-memory 1M");
  for (const std::string whole : {"map.png", "map.exr --repair"})
    EXPECT_THAT(refuse(1, "convert " + whole + " --to cube --size 32 -o out.exr --max-memory 1M"),
                HasSubstr("needs 2 MB"))
        << whole;
}

// 1.5 MB of a picture that is read as a whole and 18 MB of faces: either fits, both do not.
TEST_F(ConvertRowsTest, InputAndOutputCountTogether) {
  const std::string command = "convert map.png --to cube --size 512 -o out.exr --max-memory ";
  EXPECT_THAT(refuse(1, command + "19M"), HasSubstr("needs 20 MB"));
  succeed(command + "20M");
}

TEST_F(ConvertRowsTest, TheResultIsTheSameToTheLastBit) {
  for (const std::string input : {"map.exr", "map.hdr"})
    for (const std::string to :
         {"cube --size 64 -o a.exr", "cube --size 64 -o a.ktx2", "cube --size 32 --mips -o a.dds", "sphere -o a.ktx2",
          "equirect --size 64 -o a.hdr --rotate 30,20", "octahedral --size 128 -o a.ktx --centre 1,1,0",
          "cube --size 64 -o a.ktx2 --filter bilinear --for three", "equirect --size 128 -o a.exr --for unity"}) {
      const std::string file = to.substr(to.find("a."), to.find(' ', to.find("a.")) - to.find("a."));
      succeed("convert " + input + " --to " + to);
      const Bytes whole = bytes(file);
      succeed("convert " + input + " --to " + to + " --max-memory 1.4M");
      EXPECT_TRUE(bytes(file) == whole) << input << " --to " << to;
    }
}

// What the picture has in its middle is heeded by rows as well.
TEST_F(ConvertRowsTest, APanoramaOfAnotherProgramIsTheSameToo) {
  for (const std::string program : {"three", "unreal"}) {
    succeed("convert --quiet map.exr --to equirect --size 256 -o its.exr --for " + program);
    succeed("convert its.exr --to cube --size 32 -o whole.exr");
    succeed("convert its.exr --to cube --size 32 -o rows.exr --max-memory 1M");
    EXPECT_LT(maxDifference(image("rows.exr"), image("whole.exr")), 1e-5) << program;
  }
}

TEST_F(ConvertRowsTest, LightBeyondHalfFloatsIsFoundByRowsToo) {
  Image bright = image("map.exr");
  bright.texel(300, 200)[0] = 1e6f;
  write("bright.exr", bright);
  const Outcome outcome = run("convert bright.exr --to cube --size 128 -o out.ktx2 --max-memory 1M");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err,
            "mirrorball: note: out.ktx2: holds light that half floats do not; written in 32-bit floats; --format half "
            "is half as large, and cuts what is brighter than 65504\n");
  succeed("convert bright.exr --to cube --size 128 -o whole.ktx2 --format float32");
  EXPECT_TRUE(bytes("out.ktx2") == bytes("whole.ktx2"));
}

TEST_F(ConvertRowsTest, ABadTexelIsNamedByItsPlaceInThePicture) {
  Image bad = image("map.exr");
  bad.texel(17, 203)[1] = std::numeric_limits<float>::infinity();
  write("bad.exr", bad);
  EXPECT_THAT(refuse(1, "convert bad.exr --to cube --size 32 -o out.ktx2 --max-memory 1M"),
              AllOf(StartsWith("bad.exr: "), HasSubstr("(17, 203)"), HasSubstr("--repair")));
}

TEST_F(ConvertRowsTest, AFileThatIsCutIsConvertedAsFarAsItGoes) {
  for (const std::string file : {"map.exr", "map.hdr"}) {
    Bytes cut = bytes(file);
    cut.resize(cut.size() * 2 / 3);
    write("cut" + file.substr(3), cut);
    const Outcome outcome = run("convert cut" + file.substr(3) + " --to cube --size 64 -o out.ktx2 --max-memory 1M");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("rows that are missing are black"));
  }
}

TEST_F(ConvertRowsTest, TooLittleForTheRowsIsToldBeforeAnyIsRead) {
  EXPECT_THAT(refuse(1, "convert map.exr --to cube --size 64 -o out.ktx2 --max-memory 0.1M"),
              AllOf(StartsWith("map.exr: needs "), HasSubstr("--max-memory")));
}

TEST_F(ConvertRowsTest, ALargePanoramaTakesLessMemoryByRows) {
  if (isSanitized()) GTEST_SKIP() << "the address sanitizer's own memory is larger than what is measured";
  // 100 MB as floats: far more than what the program, and this one that starts it, have of their own.
  succeed("convert smooth.exr --to equirect --size 2048 -o large.hdr");
  const std::string command = "convert large.hdr --to cube --size 64 -o out.ktx2";
  const std::uint64_t whole = peakOf(command);
  EXPECT_LT(peakOf(command + " --max-memory 40M") + 30 * kMega, whole);
}

// On one core 6 x 4096² texels take more than a second; they are interrupted after a twentieth of one.
TEST_F(ConvertRowsTest, CtrlCLeavesNothing) {
  const std::vector<std::string> before = files();
  for (const std::string output : {"out.ktx2", "out.dds"}) {
    Program program({.arguments = Arguments("convert map.hdr --to cube --size 4096 --max-memory 1M -o " + output).words,
                     .folder = path(""),
                     .cores = 1});
    program.waitUntilItCatchesInterrupts();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    ASSERT_TRUE(program.running()) << "it was done before it could be interrupted";
    program.interrupt();
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.signal, SIGINT) << "ended with " << outcome.exit_code;
    EXPECT_EQ(outcome.err, "mirrorball: interrupted; nothing was written\n") << output;
    EXPECT_EQ(files(), before) << output;
  }
}

}  // namespace
}  // namespace mirrorball::testing
