// contact: a sheet of many maps and models.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <sys/inotify.h>
#include <unistd.h>

#include "cli/cli_testing.h"
#include "mirrorball/base/descriptor.h"

namespace mirrorball::testing {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

class ContactCommandTest : public CliTest {
 protected:
  void SetUp() override { write("attic.exr", smoothPanorama()); }

  Image8 picture(const std::string& name) const { return *decodeTexture(bytes(name)); }
};

class ContactOfModelsTest : public RenderCliTest {};

TEST_F(ContactCommandTest, EachInputHasACell) {
  succeed("contact attic.exr sky uv --size 64 --columns 3 -o three.png");
  succeed("contact attic.exr sky uv --size 64 --columns 1 -o column.png");
  succeed("contact attic.exr --size 64 -o one.jpg");
  const Image8 three = picture("three.png");
  EXPECT_GT(three.width(), 3 * 64);
  EXPECT_EQ(three.height(), picture("one.jpg").height());
  EXPECT_GT(picture("column.png").height(), 3 * 32);
}

TEST_F(ContactCommandTest, ACubeOfSixFilesIsTakenOnce) {
  succeed("convert uv --to cube --layout faces --size 8 -o sky.exr");
  const std::string six = "sky_px.exr sky_nx.exr sky_py.exr sky_ny.exr sky_pz.exr sky_nz.exr";
  const Outcome outcome = run("contact " + six + " attic.exr --size 64 --columns 9 -o a.png");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("faces of one cube, which is taken once"));
  succeed("contact sky_px.exr attic.exr --size 64 --columns 9 -o b.png");
  EXPECT_TRUE(bytes("a.png") == bytes("b.png"));
}

TEST_F(ContactCommandTest, ABadInputHasACellTooAndTheOthersGoOn) {
  write("bad.hdr", std::string("no map"));
  const Outcome outcome = run("contact attic.exr bad.hdr none.hdr --size 64 --columns 3 -o sheet.png");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("mirrorball: bad.hdr: is not an image"));
  EXPECT_THAT(outcome.err, HasSubstr("mirrorball: none.hdr"));
  EXPECT_THAT(outcome.err, HasSubstr("mirrorball: 2 of 3 inputs could not be shown\n"));
  EXPECT_GT(picture("sheet.png").width(), 3 * 64);
}

TEST_F(ContactCommandTest, WhereNothingCanBeShownThereIsNoSheet) {
  write("bad.hdr", std::string("no map"));
  EXPECT_THAT(refuse(1, "contact bad.hdr -o sheet.png"), HasSubstr("bad.hdr: is not an image"));
  const Outcome outcome = run("contact bad.hdr none.hdr -o sheet.png");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("none of 2 inputs could be shown"));
  EXPECT_THAT(files(), Not(Contains("sheet.png")));
}

TEST_F(ContactCommandTest, OutputsThatCannotBeAreRefusedFirst) {
  EXPECT_THAT(refuse(2, "contact attic.exr"), HasSubstr("-o FILE"));
  EXPECT_THAT(refuse(2, "contact attic.exr sheet.png"), HasSubstr("say -o sheet.png"));
  EXPECT_THAT(refuse(2, "contact attic.exr -o sheet.exr"), HasSubstr(".png or .jpg"));
  EXPECT_THAT(refuse(2, "contact attic.exr -o attic.exr"), HasSubstr(".png or .jpg"));
  EXPECT_THAT(refuse(1, "contact attic.exr -o none/sheet.png"), HasSubstr("folder none"));
  write("attic.png", Image(16, 8, 3, 0.5f));
  EXPECT_THAT(refuse(2, "contact attic.exr attic.png -o attic.png"), HasSubstr("is the input itself"));
  EXPECT_THAT(refuse(2, "contact attic.exr --columns -1 -o a.png"), HasSubstr("columns"));
  EXPECT_THAT(refuse(2, "contact attic.exr --background red -o a.png"), HasSubstr("#rrggbb"));
  EXPECT_THAT(refuse(1, "contact attic.exr --size 4096 --max-memory 1M -o a.png"), HasSubstr("memory"));
}

TEST_F(ContactCommandTest, TexelsThatAreNotFiniteAreMendedWithANote) {
  Image image = smoothPanorama();
  image.texel(3, 4)[1] = std::numeric_limits<float>::quiet_NaN();
  image.texel(9, 4)[0] = std::numeric_limits<float>::infinity();
  write("bad.exr", image);
  const Outcome outcome = run("contact bad.exr --size 64 -o sheet.png");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("note: bad.exr: 2 texels are NaN or infinite, the first at (3, 4)"));
}

TEST_F(ContactCommandTest, NamesDoNotActOnTheTerminal) {
  write("\x1b[31m.exr", smoothPanorama());
  const Outcome outcome = run(Arguments(std::vector<std::string>{"contact", "\x1b[31m.exr", "-o", "sheet.png"}));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, Not(HasSubstr("\x1b")));
}

TEST_F(ContactCommandTest, WithoutModelsTheirOptionsChangeNothing) {
  const Outcome outcome = run("contact attic.exr -e white --samples 2 --size 64 -o a.png");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("note: --env and --samples change nothing: none of the inputs is a model"));
}

TEST_F(ContactCommandTest, ManyInputsAndASizeOfOneTexel) {
  write("dot.exr", Image(2, 1, 3, 0.5f));
  std::string words = "contact";
  for (int i = 0; i < 200; ++i) words += i % 2 == 0 ? " dot.exr" : " attic.exr";
  succeed(words + " --size 32 -o sheet.png");
  const Image8 sheet = picture("sheet.png");
  EXPECT_GT(sheet.width(), sheet.height());
}

TEST_F(ContactOfModelsTest, ModelsAndMapsShareASheet) {
  succeed("contact sphere white cube --size 64 --columns 3 --background #204060 --quality draft -o sheet.png");
  const Image8 sheet = *decodeTexture(bytes("sheet.png"));
  EXPECT_GT(sheet.height(), 48);
  // The corner of a model's cell has exactly the sheet's colour, and its middle another.
  const auto isPaper = [&](int x, int y) {
    const std::uint8_t* texel = sheet.texel(x, y);
    return texel[0] == 0x20 && texel[1] == 0x40 && texel[2] == 0x60;
  };
  for (const int x : {8, 8 + 2 * 72}) {
    EXPECT_TRUE(isPaper(x, 8));
    EXPECT_FALSE(isPaper(x + 32, 8 + 24));
  }
}

// What stood on the stage before changes nothing of a model's picture.
TEST_F(ContactOfModelsTest, AModelLooksTheSameInAnyCompany) {
  const std::string look = " --size 64 --columns 9 --samples 1 -o ";
  succeed("contact tumbler sphere" + look + "a.png");
  succeed("contact teapot sphere" + look + "b.png");
  const Image8 a = *decodeTexture(bytes("a.png"));
  const Image8 b = *decodeTexture(bytes("b.png"));
  ASSERT_EQ(a.width(), b.width());
  for (int y = 8; y < 8 + 48; ++y)
    for (int x = 80; x < 80 + 64; ++x) ASSERT_EQ(a.texel(x, y)[0], b.texel(x, y)[0]) << x << ", " << y;
}

TEST_F(ContactOfModelsTest, WithoutItsEnvironmentNoModelIsShown) {
  EXPECT_THAT(refuse(1, "contact sphere white -e none.hdr -o sheet.png"), HasSubstr("none.hdr"));
}

TEST_F(ContactOfModelsTest, TheEnvironmentMayComeThroughAPipe) {
  write("attic.exr", smoothPanorama());
  const std::string look = " --size 64 --quality draft --samples 1 ";
  succeed("contact sphere -e attic.exr" + look + "-o file.png");
  succeed("contact sphere -e -" + look + "-o piped.png", {.input = bytes("attic.exr")});
  EXPECT_TRUE(bytes("piped.png") == bytes("file.png"));
  EXPECT_THAT(refuse(2, "contact - -e - -o both.png", {.input = bytes("attic.exr")}), HasSubstr("2 times"));
}

// As with render, a quality chooses only what is left open.
TEST_F(ContactOfModelsTest, OptionsThatAreStatedStayAsTheyAreInAnyQuality) {
  const std::string line = "contact sphere -e white --size 32 --quality best -o ";
  succeed(line + "one.png --samples 1");
  succeed(line + "four.png --samples 4");
  EXPECT_FALSE(bytes("one.png") == bytes("four.png"));
}

// What kind an input is of is found out once, not by each step that depends on it.
TEST_F(ContactCommandTest, AFileIsOpenedAFewTimes) {
  const Descriptor watch(::inotify_init1(IN_CLOEXEC | IN_NONBLOCK));
  // With the closings between them, openings are not merged into one event.
  ASSERT_GE(::inotify_add_watch(watch.number(), path("attic.exr").c_str(), IN_OPEN | IN_CLOSE_NOWRITE), 0);
  succeed("contact attic.exr --size 64 -o sheet.png");
  std::array<inotify_event, 256> events;  // of a file, and so without names
  const ssize_t bytes = ::read(watch.number(), events.data(), sizeof(events));
  ASSERT_GT(bytes, 0);
  const auto end = events.begin() + bytes / ssize_t(sizeof(inotify_event));
  const auto openings =
      std::count_if(events.begin(), end, [](const inotify_event& event) { return event.mask & IN_OPEN; });
  EXPECT_GE(openings, 1);
  EXPECT_LE(openings, 3);
}

}  // namespace
}  // namespace mirrorball::testing
