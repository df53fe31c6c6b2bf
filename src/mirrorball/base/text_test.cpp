#include "mirrorball/base/text.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using ::testing::ElementsAre;

TEST(ParseNumber, TakesWholeTextsOnly) {
  EXPECT_EQ(parseNumber("1.5"), 1.5);
  EXPECT_EQ(parseNumber("+2e3"), 2000.0);
  EXPECT_EQ(parseNumber("-0.25"), -0.25);
  for (const char* wrong : {"", "1,5", "1.5x", " 1", "nan", "inf", "1e999", "1e-999", "--1", "++1", "0x10", ".", "5e"})
    EXPECT_FALSE(parseNumber(wrong)) << wrong;
}

TEST(Text, WordsAreWhatStandsBetweenWhiteSpace) {
  EXPECT_EQ(trimmed("\t a b \r\n"), "a b");
  EXPECT_EQ(trimmed(" \n"), "");
  std::string_view text = "  map_Kd \t a b.png ";
  EXPECT_EQ(takeWord(text), "map_Kd");
  EXPECT_EQ(text, "a b.png");
  EXPECT_EQ(takeWord(text), "a");
  EXPECT_EQ(takeWord(text), "b.png");
  EXPECT_EQ(takeWord(text), "");
  EXPECT_EQ(lowerCase("Room_PX.\xc3\x84"), "room_px.\xc3\x84");
}

TEST(ByteOrderMark, IsLeftOutOnceAndOnlyAtTheBegin) {
  EXPECT_EQ(withoutByteOrderMark("\xef\xbb\xbfsolid"), "solid");
  EXPECT_EQ(withoutByteOrderMark("\xef\xbb\xbf\xef\xbb\xbf"), "\xef\xbb\xbf");
  EXPECT_EQ(withoutByteOrderMark("a\xef\xbb\xbf"), "a\xef\xbb\xbf");
  EXPECT_EQ(withoutByteOrderMark("\xef\xbb"), "\xef\xbb");
}

TEST(Split, KeepsEmptyParts) {
  EXPECT_THAT(split("a,,b", ','), ElementsAre("a", "", "b"));
  EXPECT_THAT(split("", ','), ElementsAre(""));
}

TEST(Join, PutsAWordBeforeTheLast) {
  constexpr std::array<std::string_view, 3> kWords{"a", "b", "c"};
  EXPECT_EQ(join(kWords), "a, b, c");
  EXPECT_EQ(join(kWords, "|"), "a|b|c");
  EXPECT_EQ(join(kWords, ", ", " or "), "a, b or c");
  EXPECT_EQ(join(std::vector<std::string>{"a"}, ", ", " or "), "a");
  EXPECT_EQ(join(std::vector<std::string>(), ", ", " or "), "");
}

TEST(CountedAre, AgreesWithTheNumber) {
  EXPECT_EQ(countedAre(1, "texel"), "1 texel is");
  EXPECT_EQ(countedAre(0, "texel"), "0 texels are");
  EXPECT_EQ(countedAre(12, "texel"), "12 texels are");
  EXPECT_EQ(counted(1, "mesh"), "1 mesh");
  EXPECT_EQ(counted(2, "mesh"), "2 meshes");
  EXPECT_EQ(counted(2, "path"), "2 paths");
  EXPECT_EQ(thereAre(1, "light"), "there is 1 light");
  EXPECT_EQ(thereAre(0, "light"), "there are 0 lights");
}

TEST(FormatNumber, HasTheFewestDigits) {
  const std::pair<float, const char*> kTexts[]{
      {0.0f, "0"},
      {-0.0f, "-0"},
      {0.3f, "0.3"},
      {-1.5f, "-1.5"},
      {1e6f, "1000000"},
      {123456792.0f, "123456792"},
      {1e9f, "1e+09"},
      {1234567936.0f, "1234567936"},
      {1e-4f, "0.0001"},
      {1e-7f, "1e-07"},
      {1.25e-5f, "1.25e-05"},
      {1e-45f, "1e-45"},
      {3e38f, "3e+38"},
      {0x1p-96f, "1.2621775e-29"},
      {0x1p+90f, "1.2379401e+27"},
  };
  for (const auto& [number, text] : kTexts) EXPECT_EQ(formatNumber(number), text);
  EXPECT_EQ(formatNumber(-std::numeric_limits<float>::infinity()), "-inf");
}

TEST(FormatNumber, ReadsBackAsTheSameFloat) {
  for (const float number : {0.1f, 1.0f / 3.0f, 65504.0f, 1e-20f})
    EXPECT_EQ(static_cast<float>(*parseNumber(formatNumber(number))), number);
}

TEST(Printable, LeavesNoControlCharacter) {
  EXPECT_EQ(printable("R\nG\x1b[31m\x7f"), "R?G?[31m?");
  EXPECT_EQ(printable("grün"), "grün");
  EXPECT_EQ(printable("\u20AC\U0001F4A1"), "\u20AC\U0001F4A1");
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a?b");
  EXPECT_EQ(printable("\u009B31m"), "?31m") << "as ESC [ of C1";
  EXPECT_EQ(printable("\u202Egnp.exe\u2028"), "?gnp.exe?");
  // Bytes that are no UTF-8: alone, cut short, longer than needed, half of a pair, beyond the last.
  EXPECT_EQ(printable("\x9b"
                      "31m"),
            "?31m");
  EXPECT_EQ(printable("a\xE2\x82"), "a??");
  EXPECT_EQ(printable("\xC0\x8A"), "??");
  EXPECT_EQ(printable("\xED\xA0\x80"), "???");
  EXPECT_EQ(printable("\xF4\x90\x80\x80"), "????");
}

TEST(Excerpt, TellsHowMuchIsLeftOut) {
  EXPECT_EQ(excerpt("short\n"), "short?");
  EXPECT_EQ(excerpt(std::string(80, 'a')), std::string(80, 'a'));
  EXPECT_EQ(excerpt(std::string(5'000'000, 'a')), std::string(80, 'a') + "… (4999920 bytes more)");
  EXPECT_EQ(excerpt("üü\x1büü", 3), "üü?… (4 bytes more)") << "no letter is cut";
}

TEST(UnknownName, SuggestsTheNearestAndListsAll) {
  constexpr std::array<std::string_view, 3> kNames{"mirror", "chrome", "gold"};
  EXPECT_EQ(nearestWord("miror", kNames), "mirror");
  EXPECT_EQ(nearestWord("zzzzzz", kNames), std::nullopt);
  EXPECT_EQ(nearestWord("MIRORR", kNames), "mirror") << "case does not count, swapped letters are one slip";
  EXPECT_EQ(unknownName("material", "glod", kNames).message,
            "no material is named 'glod'; did you mean 'gold'? (there are: mirror, chrome, gold)");
  EXPECT_EQ(unknownName("material", "glod", kNames, std::nullopt).message,
            "no material is named 'glod' (there are: mirror, chrome, gold)");
}

TEST(Text, OnlyWhatIsCloseIsSuggested) {
  constexpr std::array<std::string_view, 4> kOptions{"--from", "--size", "--env-rotation", "-o"};
  EXPECT_EQ(nearestWord("--siez", kOptions), "--size");
  EXPECT_EQ(nearestWord("--siz", kOptions), "--size");
  EXPECT_EQ(nearestWord("--json", kOptions), std::nullopt) << "three of four letters are wrong";
  EXPECT_EQ(nearestWord("-x", kOptions), std::nullopt);
  EXPECT_EQ(nearestWord("--rotation", kOptions), "--env-rotation") << "it is a part of that";
  constexpr std::array<std::string_view, 2> kParameters{"metallic", "perceptual_roughness"};
  EXPECT_EQ(nearestWord("roughness", kParameters), "perceptual_roughness");
  EXPECT_EQ(nearestWord("rougness", kParameters), "perceptual_roughness") << "and a slip away from one";
  EXPECT_EQ(nearestWord("roundness", kParameters), std::nullopt) << "two slips of nine letters";
  EXPECT_EQ(nearestWord("--enx", kOptions), std::nullopt) << "one of three";
  EXPECT_EQ(nearestWord("", kParameters), std::nullopt);
}

TEST(Text, ANameIsFoundInAnyCaseAndByItsAliases) {
  constexpr auto kAliases = std::to_array<Alias>({{"Latlong", "equirect"}, {"dx", "direct-x"}});
  constexpr std::array<std::string_view, 3> kForms{"equirect", "equal-area", "direct-x"};
  EXPECT_EQ(indexOfName("equirect", kForms, kAliases), 0u);
  EXPECT_EQ(indexOfName("Equal_Area", kForms, kAliases), 1u);
  EXPECT_EQ(indexOfName("LATLONG", kForms, kAliases), 0u);
  EXPECT_EQ(indexOfName("DX", kForms, kAliases), 2u);
  EXPECT_EQ(indexOfName("dx", kForms), std::nullopt);
  EXPECT_EQ(indexOfName("", kForms, kAliases), std::nullopt);
}

TEST(Text, ColumnsAreCodePoints) {
  EXPECT_EQ(columnsOf(""), 0u);
  EXPECT_EQ(columnsOf("T,T,…"), 5u);
  EXPECT_EQ(columnsOf("schön"), 5u);
  EXPECT_EQ(columnsOf("scho\u0308n"), 5u) << "o and a mark";
  EXPECT_EQ(columnsOf("\u036F\u1AB0\u1DC0\u20D0\uFE20"), 0u) << "marks of all blocks";
  EXPECT_EQ(columnsOf("\u0370\u037Fθ\u1DBF\u2100"), 5u) << "letters beside them";
  EXPECT_EQ(columnsOf("\xCC\xFF"), 2u) << "bytes that are no UTF-8";
}

}  // namespace
}  // namespace mirrorball
