#include "mirrorball/codec/ldr/gain_map_metadata.h"

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/color/icc_testing.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

constexpr GainMap kSuns{.min_log2 = glm::vec3(-2.5f),
                        .max_log2 = glm::vec3(16.015625f),
                        .gamma = glm::vec3(0.5f),
                        .offset_sdr = glm::vec3(1.0f / 1024.0f),
                        .offset_hdr = glm::vec3(1.0f / 64.0f),
                        .headroom_min_log2 = 0.0f,
                        .headroom_max_log2 = 16.015625f};

/// As Adobe's programs write it, with that in its description.
std::string packet(const std::string& attributes, const std::string& elements = "") {
  return "<?xpacket begin='' id='W5M0MpCehiHzreSzNTczkc9d'?><x:xmpmeta xmlns:x='adobe:ns:meta/'>\n <rdf:RDF "
         "xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#'>\n  <rdf:Description rdf:about=''\n    "
         "xmlns:hdrgm=\"http://ns.adobe.com/hdr-gain-map/1.0/\"\n    " +
         attributes + ">" + elements + "</rdf:Description></rdf:RDF></x:xmpmeta>";
}

TEST(GainMapXmp, WhatIsWrittenComesBack) {
  const auto back = readGainMapXmp(gainMapXmp(kSuns));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(*back, kSuns);
}

TEST(GainMapXmp, AbsentNumbersAreTheSpecifications) {
  const auto map = readGainMapXmp(packet("hdrgm:Version='1.0' hdrgm:GainMapMax = \"3\"\n hdrgm:HDRCapacityMax='2'"));
  ASSERT_TRUE(map) << map.error().message;
  EXPECT_EQ(*map, (GainMap{.max_log2 = glm::vec3(3.0f), .headroom_max_log2 = 2.0f}));
}

TEST(GainMapXmp, ListsHoldANumberForEachChannel) {
  const auto map = readGainMapXmp(
      packet(R"(hdrgm:Version="1.0" hdrgm:HDRCapacityMax="2")",
             "<hdrgm:GainMapMax>\n<rdf:Seq> <rdf:li> 1.5</rdf:li><rdf:li>2</rdf:li>\n<rdf:li>-0.25</rdf:li></rdf:Seq>"
             "</hdrgm:GainMapMax><hdrgm:GainMapMin>-1</hdrgm:GainMapMin>"));
  ASSERT_TRUE(map) << map.error().message;
  EXPECT_EQ(map->max_log2, glm::vec3(1.5f, 2.0f, -0.25f));
  EXPECT_EQ(map->min_log2, glm::vec3(-1.0f));
}

TEST(GainMapXmp, TheNamespaceMayHaveAnotherName) {
  std::string xmp = packet("g:Version='1.0' g:GainMapMax='3' g:HDRCapacityMax='2'");
  xmp.replace(xmp.find("xmlns:hdrgm"), 11, "xmlns:g");
  EXPECT_TRUE(speaksOfGainMap(xmp));
  EXPECT_TRUE(readGainMapXmp(xmp));
}

TEST(GainMapXmp, OtherPacketsSpeakOfNone) {
  EXPECT_FALSE(speaksOfGainMap(""));
  EXPECT_FALSE(speaksOfGainMap("hdrgm:Version='1.0'"));
  EXPECT_FALSE(speaksOfGainMap(packet("tiff:Orientation='1'")));
  EXPECT_TRUE(speaksOfGainMap(gainMapContainerXmp(99)));
  EXPECT_THAT(gainMapContainerXmp(99), HasSubstr("Item:Length=\"99\""));
}

TEST(GainMapXmp, DamageIsNamed) {
  const auto refused = [](const std::string& numbers, ErrorCode code, const char* what) {
    const auto map = readGainMapXmp(packet(numbers));
    ASSERT_FALSE(map) << numbers;
    EXPECT_EQ(map.error().code, code) << numbers;
    EXPECT_THAT(map.error().message, HasSubstr(what));
  };
  const std::string good = "hdrgm:Version='1.0' hdrgm:HDRCapacityMax='2' ";
  refused(good, ErrorCode::bad_file, "GainMapMax has 0 values");
  refused(good + "hdrgm:GainMapMax='NaN'", ErrorCode::bad_file, "GainMapMax is 'NaN', no number");
  refused(good + "hdrgm:GainMapMax='1e30'", ErrorCode::bad_file, "gains");
  refused(good + "hdrgm:GainMapMax='2' hdrgm:Gamma='0'", ErrorCode::bad_file, "gamma");
  refused(good + "hdrgm:GainMapMax='", ErrorCode::bad_file, "no number");
  refused("hdrgm:Version='2.0'", ErrorCode::unsupported, "version '2.0'");
  refused(good + "hdrgm:GainMapMax='2' hdrgm:BaseRenditionIsHDR='True'", ErrorCode::unsupported, "darker");
}

TEST(GainMapXmp, EveryTruncationIsSurvived) {
  const std::string xmp = packet("hdrgm:Version='1.0' hdrgm:HDRCapacityMax='2'",
                                 "<hdrgm:GainMapMax><rdf:Seq><rdf:li>3</rdf:li></rdf:Seq></hdrgm:GainMapMax>");
  ASSERT_TRUE(readGainMapXmp(xmp));
  const std::size_t whole = xmp.find("</hdrgm:GainMapMax>");
  for (std::size_t length = 0; length < whole; ++length) {
    const auto map = readGainMapXmp(xmp.substr(0, length));
    EXPECT_EQ(map ? map->max_log2 : glm::vec3(3.0f), glm::vec3(3.0f)) << length;
  }
}

TEST(GainMapIso, WhatIsWrittenComesBack) {
  const auto back = readGainMapIso(gainMapIso(kSuns));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(*back, kSuns);
}

TEST(GainMapIso, OneChannelWithOneDenominator) {
  Bytes bytes{0, 0, 0, 0, 0x48};
  for (const std::uint32_t word : {100u, 0u, 300u, 0xffffff9cu, 250u, 200u, 1u, 2u}) testing::appendBigU32(bytes, word);
  const auto map = readGainMapIso(bytes);
  ASSERT_TRUE(map) << map.error().message;
  EXPECT_EQ(*map, (GainMap{.min_log2 = glm::vec3(-1.0f),
                           .max_log2 = glm::vec3(2.5f),
                           .gamma = glm::vec3(2.0f),
                           .offset_sdr = glm::vec3(0.01f),
                           .offset_hdr = glm::vec3(0.02f),
                           .headroom_max_log2 = 3.0f}));
}

TEST(GainMapIso, EveryTruncationIsAnError) {
  const Bytes bytes = gainMapIso(kSuns);
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_FALSE(readGainMapIso(std::span(bytes).first(length))) << length;
}

TEST(GainMapIso, DamageIsNamed) {
  Bytes version = gainMapIso(kSuns);
  version[1] = 1;
  EXPECT_EQ(readGainMapIso(version).error().code, ErrorCode::unsupported);
  Bytes hdr_base = gainMapIso(kSuns);
  std::swap_ranges(hdr_base.begin() + 5, hdr_base.begin() + 13, hdr_base.begin() + 13);
  EXPECT_EQ(readGainMapIso(hdr_base).error().code, ErrorCode::unsupported);
  Bytes no_denominator = gainMapIso(kSuns);
  for (std::size_t i = 9; i < 13; ++i) no_denominator[i] = 0;
  EXPECT_THAT(readGainMapIso(no_denominator).error().message, HasSubstr("headroom"));
}

}  // namespace
}  // namespace mirrorball
