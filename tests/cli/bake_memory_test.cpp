// bake and --max-memory: what is asked for is what is taken.

#include <string>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class BakeMemoryTest : public PeakMemoryTest {
 protected:
  BakeMemoryTest() { write("map.exr", noisyPanorama()); }

  /// The MB that a command says it needs.
  int needOf(const std::string& command) const {
    const std::string refusal = refuse(1, command + " --max-memory 16M");
    EXPECT_THAT(refusal, AllOf(HasSubstr("map.exr: needs "), HasSubstr("--max-memory"))) << command;
    return std::stoi(refusal.substr(refusal.find("needs ") + 6));
  }
};

// Takes seconds: a peak above the program's own needs chains of some hundred MB.
//
// Not counted: large pages, which round a face up by as much as 2 MB, and what the C library keeps of the small pieces
// that it is given back.
TEST_F(BakeMemoryTest, ThePeakIsBelowWhatWasAskedFor) {
  constexpr std::uint64_t kUncounted = 32 * kMega;
  const std::uint64_t own = peakOf("bake white -o own --size 8 --irradiance-size 2 --brdf-size 2");
  for (const std::string command :
       {"bake map.exr -o chain.ktx2 --size 512", "bake map.exr -o chain.ktx2 --size 1024",
        "bake map.exr -o chain.dds --size 512 --mip-mapping unreal --for unreal",
        "bake map.exr -o out --size 256 --irradiance-size 1024", "bake map.exr -o out --size 256 --brdf-size 1024",
        "bake map.exr -o out --size 256 --skybox-size 1024"}) {
    const int need_mb = needOf(command);
    refuse(1, command + " --max-memory " + std::to_string(need_mb - 1) + "M");
    const std::uint64_t peak = peakOf(command + " --max-memory " + std::to_string(need_mb + 1) + "M");
    EXPECT_LT(peak, own + kUncounted + std::uint64_t(need_mb) * kMega) << command;
    // Nor is much more asked for than such noise needs.
    EXPECT_GT(peak, std::uint64_t(need_mb) * kMega) << command;
  }
}

TEST_F(BakeMemoryTest, ALargeTableIsRefusedBeforeTheEnvironmentIsRead) {
  EXPECT_THAT(refuse(1, "bake missing.exr -o out --brdf-size 4096 --max-memory 100M"),
              StartsWith("the BRDF table: needs 192 MB"));
}

// The chain of 8192² a face and its first level's bands would take 7 GB.
TEST_F(BakeMemoryTest, ARefusedChainTakesNoMemory) {
  const std::uint64_t own = peakOf("bake white -o own --size 8 --irradiance-size 2 --brdf-size 2");
  const Outcome refused = run("bake map.exr -o chain.ktx2 --size 8192 --max-memory 4G");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, AllOf(StartsWith("mirrorball: map.exr: needs "), HasSubstr("4.0 GB may be")));
  EXPECT_LT(refused.peak_memory, own + 16 * kMega);
}

}  // namespace
}  // namespace mirrorball::testing
