#include "mirrorball/base/json_memory.h"

#include <string>

#include <gtest/gtest.h>
#include <malloc.h>
#include <nlohmann/json.hpp>

namespace mirrorball {
namespace {

/// A text of many equal elements.
std::string listOf(const std::string& element, int count) {
  std::string text = "[" + element;
  for (int i = 1; i < count; ++i) text += "," + element;
  return text + "]";
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
/// What the allocator has handed out.
std::uint64_t allocatedBytes() {
  const struct mallinfo2 now = ::mallinfo2();
  return now.uordblks + now.hblkhd;
}

// 70 000 elements, so that the list's vector is nearly half empty.
TEST(JsonMemory, BoundsTheParsedTreeFromAboveAndNotByMuch) {
  for (const std::string element :
       {"{}", "[]", "0", "1.5", "null", "\"short\"", "\"longer than fits into a string\"", R"({"mesh":0})",
        R"({"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]})", R"({"name":"node 4711 of a long name","children":[4712]})",
        R"("a\"b\\")", "[[[[]]]]", R"({"attributes":{"POSITION":0,"a name that is longer":1},"material":2})"}) {
    const std::string text = listOf(element, 70000);
    const std::uint64_t before = allocatedBytes();
    const nlohmann::json tree = nlohmann::json::parse(text);
    const std::uint64_t taken = allocatedBytes() - before;
    EXPECT_GE(jsonMemory(text).tree, taken) << element;
    EXPECT_LE(jsonMemory(text).tree, 3 * taken) << element;
  }
}
#endif

TEST(JsonMemory, BracketsInStringsAreLetters) {
  EXPECT_EQ(jsonMemory(R"(["{[:,\"{[:,\\"])").tree, jsonMemory(R"(["aaaaaaaaaaaaaa"])").tree);
}

TEST(JsonMemory, ALongStringIsCopiedByTheParser) {
  const std::string text = "[\"" + std::string(1000000, 'a') + "\",\"b\"]";
  EXPECT_GE(jsonMemory(text).tree, 1000000u);
  EXPECT_LE(jsonMemory(text).tree, 1001000u);
  EXPECT_EQ(jsonMemory(text).parsing, 3000000u);
}

TEST(JsonMemory, WhatEndsTooEarlyIsCountedAsFarAsItGoes) {
  EXPECT_EQ(jsonMemory("").parsing, 0u);
  EXPECT_EQ(jsonMemory("[\"abc").parsing, 9u);
  EXPECT_EQ(jsonMemory("[\"abc\\").parsing, 12u);
}

}  // namespace
}  // namespace mirrorball
