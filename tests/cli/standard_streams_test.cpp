// "-" for standard input, "-.exr" for standard output, --quiet and --threads.

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class StandardStreamsTest : public CliTest {
 protected:
  StandardStreamsTest() { write("map.exr", smoothPanorama()); }

  static Bytes bytesOf(const std::string& text) { return {text.begin(), text.end()}; }
};

TEST_F(StandardStreamsTest, AMapMayComeThroughAPipe) {
  const Start piped{.input = bytes("map.exr")};
  const std::string said = succeed("info -", piped);
  EXPECT_THAT(said, AllOf(HasSubstr("standard input\n"), HasSubstr("size         64x32\n")));
  EXPECT_EQ(said.substr(said.find('\n')), [&] {
    const std::string of_file = succeed("info map.exr");
    return of_file.substr(of_file.find('\n'));
  }());
  succeed("convert - --to cube --size 16 -o piped.exr", piped);
  succeed("convert map.exr --to cube --size 16 -o read.exr");
  EXPECT_TRUE(bytes("piped.exr") == bytes("read.exr"));
  succeed("convert - --to cube --size 16 --extension exr -o folder/", piped);
  EXPECT_TRUE(bytes("folder/stdin.exr") == bytes("read.exr"));
  succeed("bake - --size 8 -o piped.ktx2", piped);
  succeed("bake map.exr --size 8 -o read.ktx2");
  EXPECT_TRUE(bytes("piped.ktx2") == bytes("read.ktx2"));
}

TEST_F(StandardStreamsTest, APanoramaThatIsReadByRowsMayToo) {
  succeed("convert - --to cube --size 16 --max-memory 1M -o piped.ktx2", {.input = bytes("map.exr")});
  succeed("convert map.exr --to cube --size 16 -o read.ktx2");
  EXPECT_TRUE(bytes("piped.ktx2") == bytes("read.ktx2"));
}

TEST_F(StandardStreamsTest, WhatIsNoMapIsSaidOfStandardInput) {
  EXPECT_THAT(refuse(1, "info -", {.input = bytesOf("no map")}), HasSubstr("standard input: is not an image"));
  EXPECT_THAT(refuse(1, "info -", {.input = Bytes{}}), HasSubstr("standard input: is empty"));
  EXPECT_THAT(refuse(1, "convert - --to cube -o out.exr", {.input = bytesOf(std::string("glTF\2\0\0\0", 8))}),
              HasSubstr("standard input: is a glTF model, no map; try `mirrorball render -`"));
}

TEST_F(StandardStreamsTest, WhatNeverEndsIsRefusedByItsFirstBytes) {
  EXPECT_THAT(refuse(1, "info -", {.input = Bytes(4096, 'y')}),
              HasSubstr("standard input: does not begin as an image"));
}

TEST_F(StandardStreamsTest, NoMoreIsKeptThanMayBe) {
  Bytes large = bytes("map.exr");
  large.resize(std::size_t{500} << 10, 0);
  for (const std::string line :
       {"info - --max-memory 256000", "bake - -o out --max-memory 256000", "lights --max-memory 256000 -",
        "convert - --to cube -o out.exr --max-memory 256000", "render sphere -e - -o out.png --max-memory 256000"})
    EXPECT_THAT(refuse(1, line, {.input = large}), AllOf(HasSubstr("standard input: needs "), HasSubstr("may be used")))
        << line;
}

TEST_F(StandardStreamsTest, StandardOutputHasTheFileAndNothingElse) {
  for (const std::string format : {"exr", "hdr", "png", "ktx2", "ktx", "dds"}) {
    const std::string line = "convert map.exr --to cube --size 16 -o ";
    succeed(line + "file." + format);
    EXPECT_TRUE(bytesOf(succeed(line + "-." + format)) == bytes("file." + format)) << format;
  }
  succeed("bake map.exr --size 8 -o file.ktx2");
  EXPECT_TRUE(bytesOf(succeed("bake map.exr --size 8 -o -.ktx2")) == bytes("file.ktx2"));
}

TEST_F(StandardStreamsTest, NothingStaysInTheTemporaryFolder) {
  std::filesystem::create_directory(path("tmp"));
  const Start how{.environment = {{"TMPDIR", path("tmp").string()}}};
  succeed("convert map.exr --to cube --size 16 -o -.exr", how);
  EXPECT_TRUE(std::filesystem::is_empty(path("tmp")));
  EXPECT_EQ(run("convert missing.exr --to cube -o -.exr", how).exit_code, 1);
  EXPECT_TRUE(std::filesystem::is_empty(path("tmp")));
  Start slow = how;
  slow.arguments = Arguments("convert sky --to cube --size 1024 -o -.exr").words;
  slow.folder = path("");
  slow.cores = 1;
  Program program(slow);
  program.waitUntilItCatchesInterrupts();
  program.interrupt();
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.signal, SIGINT);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(std::filesystem::is_empty(path("tmp")));
}

// A pipe takes 64 kB, and nobody reads it: the program waits with the rest of its output, or still works.
TEST_F(StandardStreamsTest, NothingStaysOfAKilledRun) {
  std::filesystem::create_directory(path("tmp"));
  for (const std::string line : {"convert map.exr --to cube --size 256 -o -.exr", "bake map.exr -o -.ktx2",
                                 "convert map.exr --to cube --size 128 --mips -o -.ktx2"}) {
    int ends[2];
    ASSERT_EQ(::pipe2(ends, O_CLOEXEC), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      ::dup2(ends[1], STDOUT_FILENO);
      ::setenv("TMPDIR", path("tmp").c_str(), 1);
      std::vector<std::string> words = Arguments(line).words;
      words.insert(words.begin(), programFile().string());
      std::vector<char*> arguments;
      for (std::string& word : words) arguments.push_back(word.data());
      arguments.push_back(nullptr);
      if (::chdir(path("").c_str()) == 0) ::execv(arguments[0], arguments.data());
      ::_exit(127);
    }
    ::close(ends[1]);
    pollfd output{.fd = ends[0], .events = POLLIN, .revents = 0};
    constexpr int kAtMost_ms = 60000;
    EXPECT_EQ(::poll(&output, 1, kAtMost_ms), 1) << line;
    EXPECT_TRUE(output.revents & POLLIN) << line;
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ::close(ends[0]);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << line;
    EXPECT_TRUE(std::filesystem::is_empty(path("tmp"))) << line;
  }
}

TEST_F(StandardStreamsTest, AnUnusableTemporaryFolderIsAnErrorBeforeTheWork) {
  const Start how{.environment = {{"TMPDIR", path("missing").string()}}};
  EXPECT_THAT(refuse(1, "convert absent.exr --to cube -o -.exr", how),
              AllOf(HasSubstr("standard output: no temporary file can be made"), HasSubstr("TMPDIR")));
  EXPECT_THAT(refuse(1, "render sphere -e absent.exr -o -.png", how), HasSubstr("TMPDIR"));
}

TEST_F(StandardStreamsTest, WhatStandardOutputCannotTakeIsToldAtOnce) {
  EXPECT_THAT(refuse(2, "convert map.exr --to cube -o -"), HasSubstr("-o -.exr"));
  EXPECT_THAT(refuse(2, "convert map.exr --to cube --layout faces -o -.exr"), HasSubstr("one file"));
  EXPECT_THAT(refuse(2, "convert map.exr --to cube -o -.tga"),
              AllOf(HasSubstr("standard output"), Not(HasSubstr("tmp"))));
  EXPECT_THAT(refuse(1, "convert missing.exr --to cube -o -.exr"), HasSubstr("missing.exr"));
}

using StandardStreamsRenderTest = RenderCliTest;

TEST_F(StandardStreamsRenderTest, AModelAndAPictureMayGoThroughPipes) {
  write("ball.ply",
        std::string("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
                    "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 "
                    "0\n3 0 1 2\n"));
  succeed("render ball.ply -e white --size 8x8 -o file.png");
  const std::string picture = succeed("render - -e white --size 8x8 -o -.png", {.input = bytes("ball.ply")});
  EXPECT_TRUE(Bytes(picture.begin(), picture.end()) == bytes("file.png"));
  EXPECT_THAT(refuse(2, "render none -e white --frames 2 -o -.png"), HasSubstr("one picture"));
}

TEST_F(StandardStreamsTest, WhatCannotBePrintedIsAnError) {
  const Start full{.output_is_full = true};
  for (const std::string line :
       {"info map.exr", "info map.exr --json", "reference", "cache show", "--help", "--version", "help info"})
    EXPECT_THAT(refuse(1, line, full), HasSubstr("standard output: cannot be written")) << line;
  EXPECT_THAT(refuse(1, "info map.exr", full), HasSubstr("No space left on device"));
  EXPECT_THAT(refuse(1, "convert map.exr --to cube --size 8 -o -.exr", full), HasSubstr("No space left on device"));
  EXPECT_THAT(refuse(1, "info missing.exr", full), HasSubstr("missing.exr"));
}

TEST_F(StandardStreamsTest, QuietSaysNothingButErrors) {
  write("bright.exr", Image(8, 4, 3, 1e6f));
  const std::string line = "convert bright.exr --to cube --size 16 -o out.ktx2";
  EXPECT_THAT(run(line).err, HasSubstr("mirrorball: note: "));
  EXPECT_EQ(run(line + " --quiet").err, "");
  EXPECT_EQ(run(line + " --quiet", {.on_terminal = true}).err, "");
  EXPECT_THAT(refuse(1, "convert missing.exr --to cube -o out.exr --quiet"), HasSubstr("missing.exr"));
  EXPECT_EQ(run("convert map.exr missing.exr --to cube --size 8 -o many/ --quiet").err.find("mirrorball: missing.exr"),
            0u);
}

TEST_F(StandardStreamsTest, TheResultIsTheSameForAnyNumberOfThreads) {
  for (const std::string line : {"convert map.exr --to cube --size 64 --mips -o ", "bake map.exr --size 16 -o "}) {
    succeed(line + "all.ktx2");
    for (const std::string threads : {"1", "2", "7"}) {
      succeed(line + "some.ktx2 --threads " + threads);
      EXPECT_TRUE(bytes("some.ktx2") == bytes("all.ktx2")) << line << threads;
    }
  }
  EXPECT_THAT(refuse(2, "info white --threads -1"), HasSubstr("--threads"));
}

TEST_F(StandardStreamsRenderTest, SoIsAPicture) {
  write("map.exr", smoothPanorama());
  succeed("render sphere -e map.exr --material rough-metal --size 32x32 --no-cache -o all.png");
  succeed("render sphere -e map.exr --material rough-metal --size 32x32 --no-cache -o one.png --threads 1");
  EXPECT_TRUE(bytes("one.png") == bytes("all.png"));
}

}  // namespace
}  // namespace mirrorball::testing
