// How large the programs of fixed frames are, compared with sizes.txt. The time that a driver takes to compile them and
// that a graphics processor takes to run them grows with their size, and it is counted without noise.
//
// MIRRORBALL_UPDATE_SIZES=1 writes what was counted into sizes.txt; the reason is then added there by hand.

#include "program_size/program_size.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "gl_driver.h"
#include "mirrorball/base/file.h"
#include "program_size/program_frames.h"
#include "program_size/size_table.h"
#include "program_size/spirv_module.h"

namespace mirrorball::testing {
namespace {

constexpr double kMoreInstructions = 1.03;
constexpr const char* kHowToRecord =
    "\nMIRRORBALL_UPDATE_SIZES=1 build/dev/tests/program_size/program_size_test records all programs anew; why one has "
    "become larger gets a line in tests/program_size/sizes.txt";

std::string tablePath() { return std::string(MIRRORBALL_SOURCE_DIR) + "/tests/program_size/sizes.txt"; }

std::string tableText() {
  const auto bytes = readFile(tablePath());
  EXPECT_TRUE(bytes) << bytes.error().message;
  return bytes ? std::string(bytes->begin(), bytes->end()) : "";
}

/// "5944 instructions (31623 inlined), 95 samplings; copies: arrivingLight 7, sightFrom 13, nearestTriangleBeside 2"
std::string written(const ProgramSize& size) {
  return std::to_string(size.instructions) + " instructions (" + std::to_string(size.inlined) + " inlined), " +
         std::to_string(size.samplings) + " samplings; copies: arrivingLight " + std::to_string(size.arriving_light) +
         ", sightFrom " + std::to_string(size.sight_from) + ", nearestTriangleBeside " + std::to_string(size.ray_walks);
}

void expectNoLarger(const std::string& name, const ProgramSize& now, const SizeTable& table) {
  const auto row = table.programs.find(name);
  ASSERT_NE(row, table.programs.end()) << "sizes.txt has no program '" << name << "'" << kHowToRecord;
  EXPECT_LE(now.instructions, kMoreInstructions * row->second.instructions)
      << name << " has become larger: " << written(now) << ", where sizes.txt has " << written(row->second)
      << kHowToRecord;
  if (now.instructions * kMoreInstructions < row->second.instructions)
    std::printf("%s has become smaller: sizes.txt has %d instructions, and guards it better with the new number%s\n",
                name.c_str(), row->second.instructions, kHowToRecord);
}

/// Expects that each of the functions whose copies are counted is still called by that name.
void expectFunctionsAreThere(const SizeTable& now) {
  ProgramSize sum;
  for (const auto& [name, size] : now.programs) {
    sum.arriving_light += size.arriving_light;
    sum.sight_from += size.sight_from;
    sum.ray_walks += size.ray_walks;
  }
  EXPECT_GT(sum.arriving_light, 0) << "no program calls arrivingLight";
  EXPECT_GT(sum.sight_from, 0) << "no program calls sightFrom";
  EXPECT_GT(sum.ray_walks, 0) << "no program calls nearestTriangleBeside";
}

TEST(ProgramSizeTest, IsNotMoreThanBefore) {
  const auto tools = findSizeTools();
  if (!tools) GTEST_SKIP() << tools.error().message;
  const bool updates = std::getenv("MIRRORBALL_UPDATE_SIZES") != nullptr;
  const auto before = parseSizeTable(tableText());
  ASSERT_TRUE(before) << before.error().message;
  if (!updates && *tools != before->tools)
    GTEST_SKIP() << "sizes.txt is of " << before->tools << ", and these are " << *tools;
  SizeTable now{.tools = *tools};
  for (const ProgramFrame& frame : programFrames()) {
    const auto programs = findPrograms(frame);
    if (!programs && programs.error().code == ErrorCode::no_gl) MIRRORBALL_END_WITHOUT_GL(programs.error().message);
    ASSERT_TRUE(programs) << frame.name << ": " << programs.error().message;
    for (const SurfaceProgram& program : *programs) {
      const auto size = measureSize(program.fragment);
      ASSERT_TRUE(size) << program.name << ": " << size.error().message;
      ASSERT_TRUE(now.programs.emplace(program.name, *size).second) << "two programs are called " << program.name;
      std::printf("%s: %s\n", program.name.c_str(), written(*size).c_str());
      if (!updates) expectNoLarger(program.name, *size, *before);
    }
  }
  expectFunctionsAreThere(now);
  if (!updates) {
    for (const auto& [name, size] : before->programs)
      EXPECT_TRUE(now.programs.contains(name))
          << "no frame has the program '" << name << "' of sizes.txt" << kHowToRecord;
    return;
  }
  const std::string text = withSizes(tableText(), now);
  ASSERT_TRUE(writeFile(tablePath(), std::vector<std::uint8_t>(text.begin(), text.end())));
}

// Of what is counted of a text.
class SizeOfTextTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (const auto tools = findSizeTools(); !tools) GTEST_SKIP() << tools.error().message;
  }

  /// A shader that samples in sightFrom, which arrivingLight calls, and whose main has those statements.
  static ProgramSize sizeWith(const std::string& statements) {
    const auto size = measureSize(
        "#version 430 core\n"
        "uniform samplerCube environment;\n"
        "in vec3 direction;\n"
        "out vec4 color;\n"
        "vec4 sightFrom(vec3 d) { return texture(environment, d); }\n"
        "vec4 arrivingLight(vec3 d) { return sightFrom(d) + sightFrom(-d); }\n"
        "void main() {\n"
        "  color = vec4(0.0);\n" +
        statements + "}\n");
    EXPECT_TRUE(size) << size.error().message;
    return size ? *size : ProgramSize{};
  }
};

TEST_F(SizeOfTextTest, EachCallIsACopy) {
  const ProgramSize once = sizeWith("color += arrivingLight(direction);\n");
  EXPECT_EQ(once.samplings, 2);
  EXPECT_EQ(once.arriving_light, 1);
  EXPECT_EQ(once.sight_from, 2);
  EXPECT_EQ(once.ray_walks, 0);
  const ProgramSize thrice = sizeWith(
      "color += arrivingLight(direction);\ncolor += arrivingLight(direction.yzx);\ncolor += "
      "arrivingLight(direction.zxy);\n");
  EXPECT_EQ(thrice.samplings, 6);
  EXPECT_EQ(thrice.sight_from, 6);
  EXPECT_GT(thrice.instructions, 2 * once.instructions);
  EXPECT_GT(thrice.inlined, 2 * once.inlined);
}

TEST_F(SizeOfTextTest, WhatAConstantExcludesIsInlinedOnly) {
  const std::string call = "color += arrivingLight(direction);\n";
  const ProgramSize without = sizeWith(call);
  const ProgramSize with = sizeWith(call + "if (1 > 2) { color += arrivingLight(direction.yzx); }\n");
  EXPECT_GT(with.inlined, without.inlined);
  EXPECT_EQ(with.instructions, without.instructions);
  EXPECT_EQ(with.samplings, without.samplings);
  EXPECT_EQ(with.arriving_light, without.arriving_light);
}

TEST_F(SizeOfTextTest, WhatIsNotAShaderIsAnError) {
  const auto size = measureSize("this is not a shader\n");
  ASSERT_FALSE(size);
  EXPECT_EQ(size.error().code, ErrorCode::unsupported);
  EXPECT_NE(size.error().message.find("all.frag"), std::string::npos) << size.error().message;
}

// A module by hand: main (1) calls another function (2) twice, which fetches a texel; a variable, labels and what
// stands outside of functions do not count.
TEST(SpirvModule, CountsWhatFunctionsDo) {
  const auto word = [](std::uint32_t words, std::uint32_t code) { return words << 16 | code; };
  const std::uint32_t in = 'i' | 'n' << 8 | '(' << 16, function = word(5, 54), end = word(1, 56);
  const std::vector<std::uint32_t> text{
      0x07230203,   0x00010000, 0,  9, 0,  // the header
      word(4, 15),  4,          1,  0,     // OpEntryPoint
      word(3, 5),   2,          in,        // OpName
      word(2, 19),  3,                     // OpTypeVoid
      function,     3,          1,  0, 4,  //
      word(2, 248), 5,                     // OpLabel
      word(4, 59),  6,          7,  7,     // OpVariable
      word(4, 57),  3,          8,  2,     // OpFunctionCall
      word(4, 57),  3,          8,  2,     //
      word(1, 253), end,                   // OpReturn
      function,     3,          2,  0, 4,  //
      word(5, 95),  3,          8,  7, 7,  // OpImageFetch
      word(1, 253), end,
  };
  const auto module = parseSpirv(text);
  ASSERT_TRUE(module) << module.error().message;
  EXPECT_EQ(module->instructions, 5);
  EXPECT_EQ(module->samplings, 1);
  EXPECT_EQ(countCopies(*module, "in"), 2);
  EXPECT_EQ(countCopies(*module, "out"), 0);
}

TEST(SpirvModule, WhatIsNoneIsAnError) {
  EXPECT_FALSE(parseSpirv({}));
  EXPECT_FALSE(parseSpirv(std::vector<std::uint32_t>{1, 2, 3, 4, 5}));
  EXPECT_FALSE(parseSpirv(std::vector<std::uint32_t>{0x07230203, 0, 0, 0, 0, 3u << 16 | 5u}));
  EXPECT_FALSE(parseSpirv(std::vector<std::uint32_t>{0x07230203, 0, 0, 0, 0, 0}));
}

TEST(SizeTable, WhatIsWrittenIsRead) {
  const SizeTable table{"glslang 1, SPIRV-Tools v1", {{"a program", {1, 2, 3, 4, 5, 6}}, {"b", {7, 8, 9, 10, 11, 12}}}};
  const auto read = parseSizeTable(withSizes("# why\ntools\tglslang 0\n", table));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->tools, table.tools);
  EXPECT_EQ(read->programs, table.programs);
  EXPECT_EQ(withSizes("# why\n", table).substr(0, 6), "# why\n");
  EXPECT_FALSE(parseSizeTable("what is this"));
  EXPECT_FALSE(parseSizeTable("a program\t1\t2\t3\t4\t5\tmany"));
}

}  // namespace
}  // namespace mirrorball::testing
