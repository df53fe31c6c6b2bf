#include "mirrorball/codec/hdr/hdr_header.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/hdr/hdr.h"
#include "mirrorball/codec/image_file_testing.h"

namespace mirrorball {
namespace {

using testing::bytesOf;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Oddities = std::vector<std::string>;

const std::string kFormat = "FORMAT=32-bit_rle_rgbe\n";
const std::string kUsual = "#?RADIANCE\n" + kFormat + "\n";

/// A picture of two texels of 16 behind a header; none of its light depends on how the header is spelled.
DecodedImage pictureBehind(const std::string& header, const std::string& resolution = "-Y 1 +X 2\n") {
  Bytes bytes = bytesOf(header + resolution);
  bytes.insert(bytes.end(), {16, 32, 64, 136, 16, 32, 64, 136});
  EXPECT_TRUE(isHdr(bytes)) << header;
  auto decoded = decodeHdr(bytes);
  if (!decoded) {
    ADD_FAILURE() << header << ": " << decoded.error().message;
    return DecodedImage{.image = Image(1, 1, 3), .metadata = {}, .format = {}};
  }
  return std::move(*decoded);
}

glm::vec3 lightBehind(const std::string& header) { return rgbAt(pictureBehind(header).image, 1, 0); }
Oddities remarksOn(const std::string& header) { return pictureBehind(header).oddities; }

TEST(HdrHeader, SpellingsOfProgramsAreReadInSilence) {
  const std::string spellings[] = {
      kUsual,
      "#?RGBE\n" + kFormat + "\n",
      "#?AUTOPANO\n" + kFormat + "\n",  // Autopano Giga (darktable-org/darktable#18414)
      "#?\n" + kFormat + "\n",
      "#?RADIANCE\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n",
      "#?RADIANCE\nFORMAT=32-bit_rle_rgbe \n\n",
      "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n\n",
      "#?RADIANCE\nFORMAT= 32-bit_rle_rgbe\n \t\n",
      "#?RADIANCE\nFORMAT =\t32-bit_rle_rgbe\n\n",
      // Photoshop's, FreeImage's without its exposure, rpict's.
      "#?RADIANCE\n# Made with Adobe Photoshop\nGAMMA=1\nPRIMARIES=0 0 0 0 0 0 0 0\n" + kFormat + "\n",
      "#?RADIANCE\n" + kFormat + "EXPOSURE=          1.0000000000000\n\n",
      "#?RADIANCE\noconv sky.rad\nrpict -vta\n\tVIEW= -vta -vp 0 0 0\nPIXASPECT= 1\nCAPDATE= 2020:01:01\n" + kFormat +
          "\n",
  };
  for (const std::string& spelling : spellings) {
    EXPECT_EQ(lightBehind(spelling), glm::vec3(16, 32, 64)) << spelling;
    EXPECT_THAT(remarksOn(spelling), IsEmpty()) << spelling;
  }
}

TEST(HdrHeader, TheResolutionMayHaveBlanksBetweenAndBehind) {
  for (const char* resolution :
       {"-Y   1 +X    2\n", "-Y 1 +X 2 \n", "-Y\t1 +X 2\r\n", " -Y 1 +X 2\n", "-Y 0001 +X 0002\n"}) {
    const DecodedImage picture = pictureBehind(kUsual, resolution);
    EXPECT_EQ(picture.image.width(), 2) << resolution;
    EXPECT_EQ(picture.image.height(), 1) << resolution;
  }
}

TEST(HdrHeader, AnExposureThatCannotBeDividedOutIsOne) {
  // FreeImage writes 0.
  const std::string substance = "#?RADIANCE\n# Made with FreeImage 3.17.0\n" + kFormat + "GAMMA=1\nEXPOSURE=0\n\n";
  EXPECT_EQ(lightBehind(substance), glm::vec3(16, 32, 64));
  EXPECT_THAT(remarksOn(substance), ElementsAre("line 5 says EXPOSURE=0, which cannot be divided out: taken as 1"));
  EXPECT_THAT(remarksOn("#?RADIANCE\n" + kFormat + "EXPOSURE=0\nEXPOSURE=0\nEXPOSURE=0\n\n"),
              ElementsAre("line 3 says EXPOSURE=0, and 2 more such lines, which cannot be divided out: taken as 1"));
  for (const char* wrong : {"EXPOSURE=-2", "EXPOSURE=nan", "EXPOSURE=", "EXPOSURE=1e300", "EXPOSURE=1 2",
                            "EXPOSURE=bright", "COLORCORR=1 2", "COLORCORR=1 0 1", "COLORCORR=1,2,3"}) {
    const std::string header = "#?RADIANCE\n" + kFormat + "EXPOSURE=2\n" + wrong + "\nEXPOSURE=4\n\n";
    EXPECT_EQ(lightBehind(header), glm::vec3(2, 4, 8)) << wrong << " hides no other line";
    EXPECT_THAT(remarksOn(header), ElementsAre(::testing::StartsWith("line 4 says "))) << wrong;
  }
}

TEST(HdrHeader, DecimalCommasArePoints) {
  const std::string header = "#?RADIANCE\n" + kFormat + "EXPOSURE=0,500000\nCOLORCORR=1,0 0,5 2\n\n";
  EXPECT_EQ(lightBehind(header), glm::vec3(32, 128, 64));
  EXPECT_THAT(remarksOn(header), ElementsAre("has numbers with decimal commas: read as points"));
}

TEST(HdrHeader, LinesOfPicturesThatItWasMadeOfSayNothing) {
  EXPECT_EQ(lightBehind("#?RADIANCE\n" + kFormat + "left.hdr:\n\tEXPOSURE=4\n EXPOSURE=4\n\n"), glm::vec3(16, 32, 64));
}

TEST(HdrHeader, WhatIsMissingIsTold) {
  EXPECT_THAT(remarksOn("#?RADIANCE\n\n"), ElementsAre("does not say its FORMAT: read as 32-bit_rle_rgbe"));
  EXPECT_THAT(remarksOn("rpict -vp 0 0 0\n" + kFormat + "\n"),
              ElementsAre("lacks the signature '#?RADIANCE': read as what its FORMAT says"));
  EXPECT_THAT(remarksOn("\xef\xbb\xbf" + kUsual), ElementsAre("begins with a byte-order mark: left out"));
  EXPECT_EQ(lightBehind("\xef\xbb\xbf" + kUsual), glm::vec3(16, 32, 64));
}

TEST(HdrHeader, WhatIsNotAppliedIsTold) {
  const std::string header = "#?RADIANCE\n" + kFormat + "GAMMA=2.2\nPIXASPECT=0.5\nPIXASPECT=0.5\n\n";
  EXPECT_EQ(lightBehind(header), glm::vec3(16, 32, 64));
  EXPECT_THAT(remarksOn(header), ElementsAre("says GAMMA=2.2, which Radiance does not define: not applied",
                                             "says PIXASPECT=0.25: its pixels are taken as square"));
  EXPECT_THAT(remarksOn("#?RADIANCE\n" + kFormat + "PIXASPECT=1.002\nGAMMA=?\n\n"), IsEmpty());
}

TEST(HdrHeader, OtherTextsAreNone) {
  for (const std::string& text :
       {std::string("# FORMAT=32-bit_rle_rgbe\n"), std::string("P6\n2 1\n255\n"), kFormat.substr(0, 16),
        std::string("FORMAT=png\n\n"), std::string("a\n\n") + kFormat, std::string("\x01\n") + kFormat, std::string()})
    EXPECT_FALSE(isHdr(bytesOf(text))) << text;
  EXPECT_TRUE(isHdr(bytesOf(kFormat)));
}

TEST(HdrHeader, EveryTruncationIsAnErrorOrTheHeader) {
  const std::string whole = "\xef\xbb\xbf#?RADIANCE\r\n" + kFormat + "EXPOSURE=0,5\nCOLORCORR=1 2 3\n\n-Y 1 +X 2\n";
  for (std::size_t size = 0; size <= whole.size(); ++size)
    EXPECT_EQ(parseHdrHeader(bytesOf(whole.substr(0, size))).has_value(), size == whole.size()) << size;
}

}  // namespace
}  // namespace mirrorball
