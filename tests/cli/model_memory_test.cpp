// Small model files that ask for much memory: each is refused in one line before the memory is taken.

#include <algorithm>
#include <cstdint>
#include <string>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class ModelMemoryTest : public PeakMemoryTest {
 protected:
  static std::string repeated(const std::string& element, int count, const std::string& between) {
    std::string text = element;
    for (int i = 1; i < count; ++i) text += between + element;
    return text;
  }

  /// A triangle on the first of the nodes, with more nodes and more members of the root.
  static std::string gltf(const std::string& nodes, const std::string& members) {
    return R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0})" + nodes +
           R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,)"
           R"("componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
           R"("buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
           R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}])" +
           members + "}";
  }
};

// Of what the limit lets pass, no more is taken than it says and the program's own.
TEST_F(ModelMemoryTest, ManySmallPartsOfAModelAreRefusedBeforeTheirMemoryIsTaken) {
  write("one.gltf", gltf("", ""));
  const std::uint64_t own = peakOf("info one.gltf");
  constexpr int kCount = 150000;
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  write("empty.gltf", gltf("," + repeated("{}", kCount, ","), ""));
  write("placed.gltf", gltf("," + repeated(R"({"mesh":0})", kCount, ","), ""));
  write("named.gltf", gltf("," + repeated(R"({"name":"a name that is rather long"})", kCount, ","), ""));
  write("materials.gltf", gltf("", R"(,"materials":[)" + repeated("{}", kCount, ",") + "]"));
  write("extras.gltf", gltf("", R"(,"extras":[)" + repeated("{}", 4 * kCount, ",") + "]"));
  write("faces.obj", corners + repeated("f 1 2 3", kCount, "\n") + "\n");
  write("materials.mtl", repeated("newmtl a\nnewmtl b", kCount / 2, "\n") + "\n");
  write("materials.obj", "mtllib materials.mtl\n" + corners + "f 1 2 3\n");
  for (const std::string file :
       {"empty.gltf", "placed.gltf", "named.gltf", "materials.gltf", "extras.gltf", "faces.obj", "materials.obj"}) {
    const Outcome refused = run("info " + file + " --max-memory 50M");
    EXPECT_EQ(refused.exit_code, 1) << file;
    EXPECT_THAT(refused.err, AllOf(HasSubstr(file), HasSubstr("50 MB may be used"))) << file;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_LT(refused.peak_memory, own + 60 * kMega) << file;
    const Outcome read = run("info " + file);
    EXPECT_EQ(read.exit_code, 0) << file << ": " << read.err;
  }
}

}  // namespace
}  // namespace mirrorball::testing
