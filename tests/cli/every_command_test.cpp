// What docs/command_line.md promises of all commands, for each of them.

#include <algorithm>
#include <csignal>
#include <string>
#include <string_view>
#include <vector>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

/// A way to call a command, and the files that it reads; those that it writes begin with "out".
struct Call {
  std::string name;
  std::string words;
  std::vector<std::string> inputs = {};
  bool writes = true;       ///< files
  bool is_the_same = true;  ///< it writes the same bytes each time: no times that were measured
};

std::vector<Call> calls() {
  return {
      {"render", "render square.obj -e map.exr --size 24x16 -o out.png", {"square.obj", "map.exr"}},
      {"render_good",
       "render square.obj -e map.exr --size 24x16 --quality good --stand -o out.exr",
       {"square.obj", "map.exr"}},
      {"render_frames", "render sphere -e map.exr --size 8x8 --frames 2 -o out.png", {"map.exr"}},
      {"render_reference",
       "render square.obj -e map.exr --reference --samples 4 --size 24x16 -o out.exr",
       {"square.obj", "map.exr"}},
      {"convert_picture", "convert map.exr --to cube --size 8 -o out.exr", {"map.exr"}},
      {"convert_texture", "convert map.exr --to cube --size 8 --mips -o out.ktx2", {"map.exr"}},
      {"convert_faces", "convert map.exr --to cube --size 8 --layout faces -o out.png", {"map.exr"}},
      {"bake", "bake map.exr --size 16 -o out", {"map.exr"}},
      {"capture", "capture square.obj --at 0,0,1 -e map.exr --size 8 -o out.exr", {"square.obj", "map.exr"}},
      {"capture_reference",
       "capture square.obj --at 0,0,1 -e map.exr --reference --samples 4 --size 8 -o out.exr",
       {"square.obj", "map.exr"}},
      {"export", "export square.obj -o out.glb", {"square.obj"}},
      {"info", "info map.exr", {"map.exr"}, false},
      {"info_model", "info square.obj", {"square.obj"}, false},
      {"compare", "compare map.exr map.exr", {"map.exr"}, false},
      {"compare_difference", "compare map.exr map.exr --heat-map out.png", {"map.exr"}},
      {"contact", "contact map.exr --size 1024 -o out.png", {"map.exr"}},
      {"contact_models",
       "contact square.obj -e map.exr --size 32 --samples 1 --quality draft -o out.png",
       {"square.obj", "map.exr"}},
      {"study",
       "study square.obj -e map.exr --size 16x12 --samples 4 -o out.html",
       {"square.obj", "map.exr"},
       true,
       false},
      {"fresnel", "fresnel gold", {}, false},
      {"fresnel_plot", "fresnel gold -o out.svg"},
      {"photo", "photo ball.exr --circle 32,32,30 --size 8 --to cube -o out.exr", {"ball.exr"}},
      {"surface", "surface heights.exr --to normal -o out.exr", {"heights.exr"}},
      {"surface_cone", "surface heights.exr --to cone -o out.png", {"heights.exr"}},
      {"transfer", "transfer square.obj square.obj --size 16 -o out.png", {"square.obj"}},
      {"reference", "reference", {}, false},
      {"cache", "cache", {}, false},
      {"cache_warm", "cache warm square.obj -e map.exr --size 24x16 --quality draft", {"square.obj", "map.exr"}, false},
  };
}

class EveryCommandTest : public RenderCliTest, public ::testing::WithParamInterface<Call> {
 protected:
  void SetUp() override {
    RenderCliTest::SetUp();
    write("map.exr", smoothPanorama());
    write("square.obj", std::string("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                                    "f 1/1 2/2 3/3 4/4\n"));
    Image photo(64, 64, 3, 0.5f);
    write("ball.exr", photo);
    Image heights(16, 16, 1);
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) heights.texel(x, y)[0] = static_cast<float>((3 * x + 5 * y) % 16) / 15.0f;
    write("heights.exr", heights);
    given_ = files();
  }

  /// Whether the program has ended by itself: done, or with one line that says why not, which nothing of a file in it
  /// can act on a terminal by; and what it made is whole or not there.
  void expectDoneOrOneLine(const Outcome& outcome, const std::string& what) const {
    EXPECT_EQ(outcome.signal, 0) << what;
    if (outcome.exit_code == 0) return;
    EXPECT_EQ(outcome.exit_code, 1) << what;
    EXPECT_EQ(std::ranges::count(errorsIn(outcome.err), '\n'), 1) << what << ": " << outcome.err;
    EXPECT_TRUE(std::ranges::none_of(outcome.err, [](unsigned char c) { return (c < 32 && c != '\n') || c == 127; }))
        << what << ": " << outcome.err;
    EXPECT_EQ(files(), given_) << what;
  }

  /// Standard error without remarks.
  static std::string errorsIn(const std::string& err) {
    std::string errors;
    for (std::size_t begin = 0; begin < err.size();) {
      const std::size_t end = std::min(err.find('\n', begin), err.size() - 1) + 1;
      const std::string line = err.substr(begin, end - begin);
      if (line.find("note:") == std::string::npos) errors += line;
      begin = end;
    }
    return errors;
  }

  /// The files that it makes, with their bytes; they are removed.
  std::vector<std::pair<std::string, Bytes>> taken() const {
    std::vector<std::pair<std::string, Bytes>> made;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path(""))) {
      const std::string name = std::filesystem::relative(entry.path(), path("")).string();
      if (entry.is_regular_file() && name.starts_with("out")) made.emplace_back(name, bytes(name));
    }
    std::ranges::sort(made);
    for (const std::string& name : files())
      if (name.starts_with("out")) std::filesystem::remove_all(path(name));
    return made;
  }

  std::vector<std::string> given_;  ///< the files that are there before
};

TEST_P(EveryCommandTest, WritesTheSameBytesForAnyNumberOfThreads) {
  const Call& call = GetParam();
  const Outcome one = run(call.words + " --threads 1");
  ASSERT_EQ(one.exit_code, 0) << one.err;
  const auto made = taken();
  EXPECT_EQ(made.empty(), !call.writes);
  const Outcome three = run(call.words + " --threads 3");
  ASSERT_EQ(three.exit_code, 0) << three.err;
  if (!call.is_the_same) return;
  EXPECT_EQ(one.out, three.out);
  EXPECT_TRUE(made == taken());
}

TEST_P(EveryCommandTest, SaysInOneLineWhichInputIsMissing) {
  for (const std::string& input : GetParam().inputs) {
    const Bytes whole = bytes(input);
    std::filesystem::remove(path(input));
    EXPECT_THAT(refuse(1, GetParam().words), ::testing::HasSubstr(input));
    write(input, whole);
  }
}

TEST_P(EveryCommandTest, RefusesWhatIsNoFileOfItsKind) {
  for (const std::string& input : GetParam().inputs) {
    const Bytes whole = bytes(input);
    std::string noise(1000, '\0');
    for (std::size_t i = 0; i < noise.size(); ++i) noise[i] = static_cast<char>(i * i * 31 + i / 7 + 200);
    write(input, noise);
    EXPECT_THAT(refuse(1, GetParam().words), ::testing::HasSubstr(input));
    write(input, whole);
  }
}

TEST_P(EveryCommandTest, TakesOrRefusesAFileThatIsCut) {
  for (const std::string& input : GetParam().inputs) {
    const Bytes whole = bytes(input);
    for (const std::size_t share : {0, 1, 2, 3}) {
      write(input, Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.size() * share / 4)));
      expectDoneOrOneLine(run(GetParam().words), input + " cut to " + std::to_string(share) + " quarters");
      taken();
    }
    write(input, whole);
  }
}

TEST_P(EveryCommandTest, LeavesNothingOnAFullDisk) {
  if (!GetParam().writes) {
    EXPECT_EQ(run(GetParam().words, {.output_is_full = true}).exit_code, 1);
    return;
  }
  const Outcome outcome = run(GetParam().words, {.largest_file = 100});
  EXPECT_EQ(outcome.exit_code, 1);
  expectDoneOrOneLine(outcome, "a disk that is full");
}

TEST_P(EveryCommandTest, EndsInOneLineWithLittleMemory) {
  // A model's own file is compared with the limit from 64 MB on.
  const auto is_picture = [](const std::string& input) { return input.ends_with(".exr"); };
  if (std::ranges::none_of(GetParam().inputs, is_picture)) return;
  write("map.exr", Image(1024, 512, 3, 0.5f));
  write("ball.exr", Image(1024, 1024, 3, 0.5f));
  write("heights.exr", Image(1024, 1024, 1, 0.5f));
  const Outcome outcome = run(GetParam().words + " --max-memory 1M");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, ::testing::HasSubstr("memory"));
  expectDoneOrOneLine(outcome, "little memory");
}

TEST_P(EveryCommandTest, LeavesWholeFilesOrNoneWhenInterrupted) {
  const Call& call = GetParam();
  ASSERT_EQ(run(call.words).exit_code, 0);
  auto whole = taken();
  // A traced picture is kept as far as it has come: after one or two of its four paths a pixel.
  const std::string four = "--samples 4";
  const std::size_t paths =
      call.words.find(" --reference") == std::string::npos ? std::string::npos : call.words.find(four);
  for (const char* fewer : {"--samples 1", "--samples 2"}) {
    if (paths == std::string::npos) break;
    ASSERT_EQ(run(std::string(call.words).replace(paths, four.size(), fewer)).exit_code, 0);
    for (auto& file : taken()) whole.push_back(std::move(file));
  }
  Program program({.arguments = Arguments(call.words).words, .folder = path(""), .cores = 1});
  program.waitUntilItCatchesInterrupts();
  program.interrupt();
  const Outcome outcome = program.wait();
  EXPECT_TRUE(outcome.exit_code == 0 || outcome.signal == SIGINT) << outcome.err;
  if (!call.is_the_same) return;
  for (const auto& file : taken()) EXPECT_NE(std::ranges::find(whole, file), whole.end()) << file.first;
  EXPECT_EQ(files(), given_);
}

TEST_P(EveryCommandTest, PrintsOnlyErrorsIfItIsToldToBeQuiet) {
  if (GetParam().name == "cache" || GetParam().name == "reference") return;  // which have nothing else to print
  const Outcome outcome = run(GetParam().words + " --quiet");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
}

INSTANTIATE_TEST_SUITE_P(All, EveryCommandTest, ::testing::ValuesIn(calls()),
                         [](const auto& call) { return call.param.name; });

}  // namespace
}  // namespace mirrorball::testing
