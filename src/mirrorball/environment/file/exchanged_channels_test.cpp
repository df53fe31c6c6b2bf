/// Files whose red is blue: --from swap=rb.

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/texture/texture_testing.h"
#include "mirrorball/environment/file/load.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(ExchangedChannels, AreExchangedBackWhereTheyAreNamed) {
  const fs::path folder = fs::path(::testing::TempDir()) / "mirrorball_exchanged_channels";
  fs::create_directories(folder);
  const auto path = [&](const std::string& name) { return (folder / name).string(); };
  // Before DX10, the lowest ten bits set, whose mask is red's.
  const testing::OldDds ten{
      .width = 2, .height = 1, .flags = 0x40, .bits = 32, .masks = {0x3ff, 0xffc00, 0x3ff00000, 0}};
  ASSERT_TRUE(writeFile(path("ten.dds"), testing::oldDds(ten, {0xff, 0x03, 0, 0, 0xff, 0x03, 0, 0})));
  const auto read = [&](const std::string& name, std::string_view from) {
    return loadEnvironment(path(name), {.from = *formHintNamed(from)});
  };
  const auto guessed = read("ten.dds", "");
  ASSERT_TRUE(guessed) << guessed.error().message;
  EXPECT_EQ(guessed->environment.radiance({0, 0, 1}), glm::vec3(0, 0, 1));
  EXPECT_THAT(guessed->oddities, ElementsAre(HasSubstr("; {option:from} swap=rb exchanges them back")));
  const auto named = read("ten.dds", "swap=rb");
  EXPECT_EQ(named->environment.radiance({0, 0, 1}), glm::vec3(1, 0, 0));
  EXPECT_TRUE(named->oddities.empty());

  Image picture(2, 1, 3);
  picture.texel(0, 0)[0] = picture.texel(1, 0)[0] = 0.5f;
  ASSERT_TRUE(writeImage(path("a.hdr"), picture));
  EXPECT_EQ(read("a.hdr", "equirect:swap=rb")->environment.radiance({0, 0, 1}), glm::vec3(0, 0, 0.5f));
  EXPECT_FALSE(*openPanorama(path("a.hdr"), {.from = *formHintNamed("swap=rb")})) << "it is exchanged as a whole";
  for (const char* face : {"px", "nx", "py", "ny", "pz", "nz"}) {
    Image image(4, 4, 3);
    for (std::size_t i = 0; i < image.samples().size(); i += 3) image.samples()[i] = 0.5f;
    ASSERT_TRUE(writeImage(path(std::string("c_") + face + ".hdr"), image));
  }
  EXPECT_EQ(read("c_px.hdr", "swap=rb")->environment.radiance({1, 0, 0}), glm::vec3(0, 0, 0.5f));

  ImageSet levels(2, 1);
  for (int level = 0; level < 2; ++level) {
    levels.at(level, 0) = Image(4 >> level, 2 >> level, 3);
    for (std::size_t i = 0; i < levels.at(level, 0).samples().size(); i += 3) levels.at(level, 0).samples()[i] = 0.25f;
  }
  ASSERT_TRUE(writeImageSet(path("levels.ktx2"), levels, {}));
  const EnvironmentLoadOptions options{.from = *formHintNamed("swap=rb")};
  const auto chain = loadEnvironment(path("levels.ktx2"), options);
  ASSERT_TRUE(chain) << chain.error().message;
  const auto read_again = loadLevels(*chain, chain->recognition->form, options);
  ASSERT_TRUE(read_again && *read_again);
  EXPECT_EQ(rgbAt((*read_again)->at(1, 0), 0, 0), glm::vec3(0, 0, 0.25f));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace mirrorball
