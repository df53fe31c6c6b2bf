#include "mirrorball/contact/contact.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/memory.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/contact/cell_picture.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::StartsWith;

/// A sheet, and the errors of its inputs.
struct Made {
  Result<ContactSheet> sheet;
  std::vector<Error> errors = {};
};

Made make(const std::vector<ContactInput>& inputs, const ContactSettings& settings = {},
          const Observer& observer = {}) {
  std::vector<Error> errors;
  auto sheet = makeContactSheet(inputs, settings, {}, observer, [&](const Error& error) { errors.push_back(error); });
  return {std::move(sheet), std::move(errors)};
}

/// A folder for files, which goes away with the test.
class ContactTest : public ::testing::Test {
 protected:
  ContactTest() : folder_(std::filesystem::temp_directory_path() / ("contact_test_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~ContactTest() override { std::filesystem::remove_all(folder_); }

  /// A panorama whose light depends on the direction, as a file.
  std::string writePanorama(const std::string& name, float factor = 1.0f) const {
    Image image(256, 128, 3);
    for (int y = 0; y < 128; ++y)
      for (int x = 0; x < 256; ++x)
        for (int channel = 0; channel < 3; ++channel)
          image.texel(x, y)[channel] = factor * float(1 + (x / 8 + y / 4 + channel) % 7);
    const std::string path = (folder_ / name).string();
    EXPECT_TRUE(writeImage(path, image));
    return path;
  }

  const std::filesystem::path folder_;
};

TEST_F(ContactTest, ABadInputIsReportedAndTheOthersAreShown) {
  const Made made = make({{"white", "white", false}, {"/none.hdr", "none.hdr", false}, {"sky", "sky", false}},
                         {.columns = 3, .width_px = 64});
  ASSERT_TRUE(made.sheet);
  ASSERT_THAT(made.errors, SizeIs(1));
  EXPECT_THAT(made.errors[0].message, HasSubstr("/none.hdr"));
}

TEST_F(ContactTest, DarkAndBrightMapsLookAlikeUnlessTheyHaveOneExposure) {
  const ContactSettings automatic{.width_px = 64};
  const Observer observer;
  const auto dark = mapCellPicture(writePanorama("dark.hdr", 1e-4f), 64, automatic, observer, {});
  const auto bright = mapCellPicture(writePanorama("bright.hdr", 1e4f), 64, automatic, observer, {});
  ASSERT_TRUE(dark && bright);
  for (std::size_t i = 0; i < dark->picture.samples().size(); ++i)
    ASSERT_NEAR(dark->picture.samples()[i], bright->picture.samples()[i], 3);
  EXPECT_THAT(dark->facts, StartsWith("256x128 equirect, +"));
  EXPECT_THAT(bright->facts, StartsWith("256x128 equirect, -"));
  const auto black =
      mapCellPicture(writePanorama("same.hdr", 1e-4f), 64, {.width_px = 64, .exposure_ev = 0.0f}, observer, {});
  ASSERT_TRUE(black);
  EXPECT_THAT(black->facts, "256x128 equirect, +0.0 EV");
  EXPECT_LT(black->picture.texel(30, 10)[0], 10);
}

// Where memory is short, a panorama is read by rows, and looks the same.
TEST_F(ContactTest, ByRowsAPanoramaLooksTheSame) {
  const std::string path = writePanorama("attic.hdr");
  const auto whole = mapCellPicture(path, 64, {}, {}, {});
  const std::uint64_t before = memoryLimit();
  setMemoryLimit(300'000);  // the panorama takes 393216
  const auto by_rows = mapCellPicture(path, 64, {}, {}, {});
  setMemoryLimit(before);
  ASSERT_TRUE(whole);
  ASSERT_TRUE(by_rows) << by_rows.error().message;
  EXPECT_TRUE(std::equal(whole->picture.samples().begin(), whole->picture.samples().end(),
                         by_rows->picture.samples().begin(), by_rows->picture.samples().end()));
  EXPECT_EQ(whole->facts, by_rows->facts);
  EXPECT_THAT(by_rows->files, ElementsAre(path));
}

TEST_F(ContactTest, ANameWithoutLatinLettersIsFoundByItsNumber) {
  const Made made =
      make({{"white", "white", false}, {"uv", "夜景.hdr", false}, {"sky", "Zürich.hdr", false}}, {.width_px = 64});
  ASSERT_TRUE(made.sheet);
  EXPECT_THAT(made.sheet->notes, ElementsAre(HasSubstr("夜景.hdr: is number 2 on the sheet")));
}

TEST_F(ContactTest, StopsWhenItIsAskedTo) {
  Observer observer;
  observer.progress = [](std::string_view) -> ProgressFunction {
    return [](std::size_t done, std::size_t) { return done < 1; };
  };
  const Made made = make({{"white", "white", false}, {"sky", "sky", false}}, {.width_px = 64}, observer);
  ASSERT_FALSE(made.sheet);
  EXPECT_EQ(made.sheet.error().code, ErrorCode::interrupted);
  EXPECT_THAT(made.errors, SizeIs(0));
}

TEST_F(ContactTest, KnowsModelsFromMaps) {
  for (const char* model : {"sphere", "showcase", "none.glb"}) EXPECT_TRUE(isModelInput(model)) << model;
  for (const char* map : {"studio", "sky:elevation=3", "none.hdr", "glb"}) EXPECT_FALSE(isModelInput(map)) << map;
}

TEST(ContactSettings, TextsOfItsOptionsComeBack) {
  ContactSettings settings;
  const auto set = [&](const char* name, const char* value) {
    for (const auto& option : contactOptions())
      if (option.text.name == name) return assign(option, settings, value);
    return Result<void>(fail(ErrorCode::usage, "none"));
  };
  const auto text = [&](const char* name) {
    for (const auto& option : contactOptions())
      if (option.text.name == name) return written(option, settings);
    return std::string();
  };
  EXPECT_EQ(text("exposure"), "auto");
  EXPECT_EQ(text("background"), "#2a2a2a");
  EXPECT_TRUE(set("exposure", "-1.5") && set("background", "#ffffff"));
  EXPECT_EQ(text("exposure"), "-1.5");
  EXPECT_EQ(text("background"), "#ffffff");
  EXPECT_TRUE(set("exposure", "AUTO"));
  EXPECT_EQ(text("exposure"), "auto");
  EXPECT_THAT(set("exposure", "bright").error().message, HasSubstr("a number or auto"));
  EXPECT_FALSE(set("exposure", "31"));
  EXPECT_THAT(set("background", "red").error().message, HasSubstr("#rrggbb"));
  EXPECT_FALSE(set("size", "31") || set("columns", "-1"));
}

}  // namespace
}  // namespace mirrorball
