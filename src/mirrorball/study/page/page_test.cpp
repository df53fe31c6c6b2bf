#include "mirrorball/study/page/page.h"

#include <regex>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/image_file.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> allOf(const std::string& text, const std::string& pattern) {
  std::vector<std::string> found;
  const std::regex expression(pattern);
  for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it) found.push_back((*it)[1]);
  return found;
}

Bytes decodedBase64(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  Bytes bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char letter : text) {
    if (letter == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(letters.find(letter));
    if ((count += 6) >= 8) bytes.push_back(static_cast<std::uint8_t>(bits >> (count -= 8)));
  }
  return bytes;
}

StudiedPicture pictureOf(const std::string& technique, double psnr, std::uint8_t grey) {
  StudiedPicture picture{.technique = technique,
                         .settings = "blur=mip",
                         .drawn = DrawCost{.frame_ms = 1.25, .light = {.texture_bytes = 3 << 20, .reads = 7}},
                         .picture = Image8(2, 2, 3, grey),
                         .flip = Image8(2, 2, 3, 10),
                         .difference = Image8(2, 2, 3, 20)};
  picture.values[static_cast<std::size_t>(Metric::psnr)] = psnr;
  picture.values[static_cast<std::size_t>(Metric::flip)] = 0.125;
  picture.by_angle[3] = 0.5;
  return picture;
}

Study smallStudy() {
  StudiedSection section{.id = "blur",
                         .title = "Rough <metal>",
                         .teaches = "Blur & more.",
                         .compared_with = "all bounces",
                         .axis = "perceptual roughness",
                         .by_angle = true};
  for (const double value : {0.1, 0.5, 1.0})
    section.shots.push_back({.label = std::to_string(value),
                             .value = value,
                             .reference = Image8(2, 2, 3, 200),
                             .pictures = {pictureOf("exact", 30.0 + value, 100), pictureOf("mip", 20.0, 90)}});
  StudiedSection other{
      .id = "look-up", .title = "Look-up", .teaches = "One.", .compared_with = "one bounce", .axis = ""};
  other.shots.push_back(
      {.label = "sphere", .reference = Image8(2, 2, 3, 1), .pictures = {pictureOf("cube", INFINITY, 1)}});
  return {.driver = "a <driver>", .size = {2, 2}, .samples = 4, .sections = {section, other}};
}

class PageTest : public ::testing::Test {
 protected:
  const std::string page_ = *pageOf(smallStudy(), {.title = "A & B", .made_by = "mirrorball study <x>"});
};

TEST_F(PageTest, EveryNameIsThereOnceAndEveryReferenceHasOne) {
  const std::vector<std::string> names = allOf(page_, " id=\"([^\"]+)\"");
  const std::set<std::string> once(names.begin(), names.end());
  EXPECT_EQ(once.size(), names.size());
  for (const char* pattern : {" href=\"#([^\"]+)\"", " aria-labelledby=\"([^\"]+)\""}) {
    const std::vector<std::string> references = allOf(page_, pattern);
    EXPECT_FALSE(references.empty()) << pattern;
    for (const std::string& reference : references) EXPECT_TRUE(once.contains(reference)) << reference;
  }
}

TEST_F(PageTest, EveryElementThatIsOpenedIsClosed) {
  const std::string text = std::regex_replace(page_, std::regex("<(script|style)>[^]*?</\\1>"), "");
  std::vector<std::string> open;
  const std::set<std::string> empty{"meta", "img", "br", "line", "polyline", "!DOCTYPE"};
  const std::regex tag("<(/?)([!A-Za-z0-9]+)[^>]*?(/?)>");
  for (std::sregex_iterator it(text.begin(), text.end(), tag), end; it != end; ++it) {
    const std::string name = (*it)[2];
    if (empty.contains(name) || (*it)[3] == "/") continue;
    if ((*it)[1] != "/") {
      open.push_back(name);
      continue;
    }
    ASSERT_FALSE(open.empty()) << name;
    ASSERT_EQ(open.back(), name);
    open.pop_back();
  }
  EXPECT_TRUE(open.empty());
}

TEST_F(PageTest, HoldsEveryPictureItself) {
  const std::vector<std::string> sources = allOf(page_, " src=\"([^\"]+)\"");
  ASSERT_EQ(sources.size(), 3u * (1 + 2 * 3) + 1 + 3);
  std::set<int> greys;
  for (const std::string& source : sources) {
    const std::string begin = "data:image/png;base64,";
    ASSERT_TRUE(source.starts_with(begin)) << source.substr(0, 40);
    const auto picture = decodeTexture(decodedBase64(source.substr(begin.size())));
    ASSERT_TRUE(picture) << picture.error().message;
    EXPECT_EQ(picture->width(), 2);
    greys.insert(picture->texel(1, 1)[0]);
  }
  EXPECT_EQ(greys, (std::set<int>{1, 10, 20, 90, 100, 200}));
}

TEST_F(PageTest, AsksForNothing) {
  EXPECT_THAT(page_, Not(HasSubstr("http")));
  EXPECT_THAT(page_, Not(HasSubstr("url(")));
  EXPECT_THAT(page_, Not(HasSubstr("@import")));
  EXPECT_THAT(page_, Not(HasSubstr("import(")));
}

TEST_F(PageTest, TellsTheNumbersAndTextsAsTheyAre) {
  for (const char* text : {"<title>A &amp; B</title>", "Rough &lt;metal&gt;", "Blur &amp; more.", "a &lt;driver&gt;",
                           "mirrorball study &lt;x&gt;", "30.10 dB", "infinite", "1.25 ms", "3.00 MiB", "<td>7</td>"})
    EXPECT_THAT(page_, HasSubstr(text));
}

// All numbers of a row at a glance are of one picture, the worst one.
TEST_F(PageTest, AGlanceIsOfTheWorstPictures) {
  EXPECT_THAT(page_, HasSubstr("<td>exact</td><td>0.100000</td><td>30.10 dB</td><td>0.125</td><td>1.25 ms</td>"));
  EXPECT_THAT(page_, HasSubstr("<td>cube</td><td>sphere</td><td>infinite</td>"));
}

TEST_F(PageTest, TellsWhatAnInterruptionLeftOut) {
  EXPECT_THAT(page_, Not(HasSubstr("Interrupted")));
  Study interrupted = smallStudy();
  interrupted.planned = 3;
  EXPECT_THAT(*pageOf(interrupted, {.title = "x"}), HasSubstr("Interrupted: 2 of 3 subjects are here."));
}

TEST_F(PageTest, PlotsWhatThereIsToPlot) {
  for (const char* id : {"blur-psnr", "blur-flip", "blur-angle"})
    EXPECT_THAT(page_, HasSubstr("<svg id=\"" + std::string(id) + "\""));
  EXPECT_THAT(page_, Not(HasSubstr("<svg id=\"look-up")));
  EXPECT_EQ(allOf(page_, "<title>(exact: 30\\.5 at 0\\.5)</title>").size(), 1u);
}

}  // namespace
}  // namespace mirrorball
