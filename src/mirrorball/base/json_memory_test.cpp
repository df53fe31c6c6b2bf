#include "mirrorball/base/json_memory.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <malloc.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "test_data.h"

namespace mirrorball {
namespace {

#ifdef __GLIBC__  // whose allocator it is about; a browser has neither that nor processes
std::string repeated(const std::string& piece, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += piece;
  return text;
}

/// A text of many equal elements.
std::string listText(const std::string& element, int count) {
  std::string text = "[" + element;
  for (int i = 1; i < count; ++i) text += "," + element;
  return text + "]";
}

/// What the allocator has handed out.
std::uint64_t allocatedBytes() {
  const struct mallinfo2 now = ::mallinfo2();
  return now.uordblks + now.hblkhd;
}

// 70 000 elements, so that the list's vector is nearly half empty.
TEST(JsonMemory, BoundsTheParsedTreeFromAboveAndNotByMuch) {
  if (testing::isSanitized()) GTEST_SKIP() << "the sanitizer has an allocator of its own";
  for (const std::string element :
       {"{}", "[]", "0", "1.5", "null", "\"short\"", "\"longer than fits into a string\"", R"({"mesh":0})",
        R"({"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]})", R"({"name":"node 4711 of a long name","children":[4712]})",
        R"("a\"b\\")", "[[[[]]]]", R"({"attributes":{"POSITION":0,"a name that is longer":1},"material":2})"}) {
    const std::string text = listText(element, 70000);
    const std::uint64_t before = allocatedBytes();
    const nlohmann::json tree = nlohmann::json::parse(text);
    const std::uint64_t taken = allocatedBytes() - before;
    EXPECT_GE(jsonMemory(text).tree, taken) << element;
    EXPECT_LE(jsonMemory(text).tree, 3 * taken) << element;
  }
}

/// The most memory that this process has had at a time.
std::uint64_t peakBytes() {
  struct rusage usage {};
  ::getrusage(RUSAGE_SELF, &usage);
  return std::uint64_t(usage.ru_maxrss) * 1024;
}

/// Parses a text, as a reader does that reports that it is refused.
///
/// returns  peakBytes() at the end of that
std::uint64_t peakAfterParsing(const std::string& text) {
  try {
    const nlohmann::json tree = nlohmann::json::parse(text);
    return peakBytes();
  } catch (const nlohmann::json::parse_error&) {
    return peakBytes();
  }
}

/// What parsing a text adds to the memory of a process at most.
std::uint64_t memoryForParsing(const std::string& text) {
  std::uint64_t taken = 0;
  int ends[2];
  if (::pipe(ends) != 0) return taken;
  ::malloc_trim(0);
  const pid_t child = ::fork();
  if (child == 0) {
    // The code's own pages are in memory before.
    const std::uint64_t before = peakAfterParsing("[{\"a\":\"");
    taken = peakAfterParsing(text) - before;
    ::_exit(::write(ends[1], &taken, sizeof taken) == sizeof taken ? 0 : 1);
  }
  ::close(ends[1]);
  EXPECT_EQ(::read(ends[0], &taken, sizeof taken), ssize_t(sizeof taken));
  ::close(ends[0]);
  ::waitpid(child, nullptr, 0);
  return taken;
}

// A little more than a power of two of each, so that what grows has just done so. The kernel counts the pages of a
// process for each processor and adds them up from time to time, the more seldom the more processors there are: the
// peak that it reports is up to a megabyte off, some 3 % of the bounds here.
TEST(JsonMemory, BoundsThePeakOfParsingToo) {
  if (testing::isSanitized()) GTEST_SKIP() << "the sanitizer has an allocator of its own";
  constexpr std::uint64_t kMiscounted = std::uint64_t{1} << 20;
  constexpr std::size_t kLetters = (std::size_t{1} << 22) + 1000;
  constexpr std::size_t kDepth = (std::size_t{1} << 17) + 1000;
  for (const auto& [what, text] : std::vector<std::pair<const char*, std::string>>{
           {"a string without an end", "[\"" + std::string(kLetters, 'a')},
           {"a string of escapes without an end", "[\"" + repeated("\\u00e9", kLetters / 6)},
           {"arrays", std::string(kDepth, '[') + std::string(kDepth, ']')},
           {"arrays without an end", std::string(kDepth, '[')},
           {"objects without an end", repeated("{\"\":", kDepth)}}) {
    const JsonMemory needed = jsonMemory(text);
    const std::uint64_t taken = memoryForParsing(text);
    EXPECT_GE(needed.tree + needed.parsing + kMiscounted, taken) << what;
    EXPECT_LE(needed.tree + needed.parsing, 4 * taken) << what;
  }
}
#endif

TEST(JsonMemory, BracketsInStringsAreLetters) {
  EXPECT_EQ(jsonMemory(R"(["{[:,\"{[:,\\"])").tree, jsonMemory(R"(["aaaaaaaaaaaaaa"])").tree);
}

TEST(JsonMemory, AsManyParentsAreKeptAsAreOpen) {
  EXPECT_EQ(jsonMemory("[[],[],{}]").parsing, 48u);
  EXPECT_EQ(jsonMemory("{\"a\":[[[1]]],\"b\":{}}").parsing, 96u + 8u);
  EXPECT_EQ(jsonMemory("]]}[").parsing, 24u) << "none is open before";
}

TEST(JsonMemory, ALongStringIsCopiedByTheParser) {
  const std::string text = "[\"" + std::string(1000000, 'a') + "\",\"b\"]";
  EXPECT_GE(jsonMemory(text).tree, 1000000u);
  EXPECT_LE(jsonMemory(text).tree, 1001000u);
  EXPECT_EQ(jsonMemory(text).parsing, 8000024u);
}

TEST(JsonMemory, WhatEndsTooEarlyIsCountedAsFarAsItGoes) {
  EXPECT_EQ(jsonMemory("").parsing, 0u);
  EXPECT_EQ(jsonMemory("[\"abc").parsing, 24u + 24u);
  EXPECT_EQ(jsonMemory("[\"abc\\").parsing, 32u + 24u);
}

}  // namespace
}  // namespace mirrorball
