#include "mirrorball/scene/mesh_file/number_text.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

using Kind = NumberText::Kind;
using ::testing::ElementsAre;

void expectNumber(std::string_view word, double value, Kind kind = Kind::plain) {
  const NumberText number = readNumber(word);
  EXPECT_EQ(number.value, value) << word;
  EXPECT_EQ(number.kind, kind) << word;
}

void expectNoNumber(std::string_view word, Kind kind) {
  const NumberText number = readNumber(word);
  EXPECT_TRUE(std::isnan(number.value)) << word;
  EXPECT_EQ(number.kind, kind) << word;
}

TEST(NumberText, IsTheNearestDouble) {
  for (const char* word : {"0", "-1", "+2.5", ".5", "5.", "1e3", "1E-3", "-0.25e+2", "0.1", "3.14159265358979",
                           "123456789012345678901234567890", "0.000000000000000000000000000000123", "9007199254740993",
                           "4.9e-324", "1.7976931348623157e308", "1e23", "8.5e-23", "12345678901234567890.5e-10"})
    expectNumber(word, *parseNumber(word));
  std::mt19937_64 random(1);
  for (int i = 0; i < 20'000; ++i) {
    char word[64];
    const double mantissa = std::uniform_real_distribution<>(-10.0, 10.0)(random);
    std::snprintf(word, sizeof word, "%.*ge%d", int(random() % 20) + 1, mantissa, int(random() % 60) - 30);
    const std::string text(word);
    if (text.find('e') == text.rfind('e')) expectNumber(text, *parseNumber(text));
  }
}

TEST(NumberText, BeyondAllDoublesIsZeroOrNotFinite) {
  expectNumber("1e-999", 0.0);
  expectNumber("0." + std::string(400, '0') + "1", 0.0);
  expectNumber("0e999999999999", 0.0);
  expectNoNumber("1e999", Kind::not_finite);
  expectNoNumber("-" + std::string(400, '9'), Kind::not_finite);
  expectNumber("1" + std::string(300, '0') + "e-300", 1.0);
}

TEST(NumberText, KnowsTheWordsOfLibrariesForNaNAndInfinity) {
  for (const char* word : {"nan", "NaN", "-nan", "nan(ind)", "-nan(ind)", "-nan(snan)", "1.#IND", "-1.#IND00",
                           "1.#QNAN0", "1.#INF", "-1.#INF00", "inf", "-Inf", "Infinity"})
    expectNoNumber(word, Kind::not_finite);
  for (const char* word : {"", "-", ".", "e5", "1e", "1e+", "abc", "1.2.3", "1,2,3", "0x10", "1f", "--1", "infinite"})
    expectNoNumber(word, Kind::none);
}

TEST(NumberText, ADecimalCommaIsRemarkedOn) {
  expectNumber("-1,5", -1.5, Kind::decimal_comma);
  expectNumber("2,5e-3", 2.5e-3, Kind::decimal_comma);
  expectNumber("2.5,", 2.5, Kind::comma_behind);
  expectNumber("2,5,", 2.5, Kind::decimal_comma);
  for (const char* word : {",", "1,,", "1,2,3"}) expectNoNumber(word, Kind::none);
  NumberReader numbers;
  EXPECT_EQ(numbers.read("0,5", 3).value, 0.5);
  numbers.read("0,25", 4);
  numbers.read("nan", 4);
  numbers.read("one", 5);
  numbers.read("two", 6);
  EXPECT_THAT(numbers.remarks(),
              ElementsAre("has decimal commas (the first in line 3: '0,5'), which are read as points",
                          "has 2 words for numbers that are none (the first in line 5: 'one')"));
}

TEST(NumberText, IntegersAreDigitsAlone) {
  EXPECT_EQ(readInteger("0"), 0);
  EXPECT_EQ(readInteger("-12"), -12);
  EXPECT_EQ(readInteger("+007"), 7);
  EXPECT_EQ(readInteger("2147483647"), 2147483647);
  for (const char* word : {"", "-", "1.0", "1e3", " 1", "2147483648", "99999999999999999999", "0x1"})
    EXPECT_EQ(readInteger(word), std::nullopt) << word;
}

TEST(NumberText, WhatNoFloatHoldsIsNowhere) {
  EXPECT_EQ(toFloat(0.1), 0.1f);
  EXPECT_TRUE(std::isnan(toFloat(1e39)));
  EXPECT_EQ(toPlace({1, 2, 3}), glm::dvec3(1, 2, 3));
  EXPECT_TRUE(std::isnan(toPlace({1, -1e39, 3}).x));
  EXPECT_TRUE(std::isnan(toPlace({1, 2, std::numeric_limits<double>::infinity()}).x));
}

}  // namespace
}  // namespace mirrorball
