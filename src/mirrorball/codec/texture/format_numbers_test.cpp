#include "mirrorball/codec/texture/format_numbers.h"

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

/// A family of compressed formats: the enumeration's first number of it, and its last.
struct Numbers {
  std::uint32_t first, last;
  std::string name;
};

// Numbers of vulkan_core.h. ASTC HDR of 4x4 texels, 1000066000, is read.
TEST(FormatNumbers, VulkanFormatsThatAreNotReadAreNamed) {
  for (const auto& [first, last, name] : std::vector<Numbers>{{131, 134, "BC1"},
                                                              {135, 136, "BC2"},
                                                              {137, 138, "BC3"},
                                                              {139, 140, "BC4"},
                                                              {141, 142, "BC5"},
                                                              {145, 146, "BC7"},
                                                              {147, 152, "ETC2"},
                                                              {153, 156, "EAC"},
                                                              {157, 184, "ASTC"},
                                                              {1000054000, 1000054007, "PVRTC"},
                                                              {1000066001, 1000066013, "ASTC HDR"}})
    for (const std::uint32_t number : {first, last})
      EXPECT_EQ(nameOfVulkan(number), name + " block compression") << number;
  EXPECT_EQ(nameOfVulkan(185), "VkFormat 185");
}

// Numbers of dxgiformat.h.
TEST(FormatNumbers, DxgiFormatsThatAreNotReadAreNamed) {
  for (const auto& [first, last, name] : std::vector<Numbers>{
           {70, 72, "BC1"}, {73, 75, "BC2"}, {76, 78, "BC3"}, {79, 81, "BC4"}, {82, 84, "BC5"}, {97, 99, "BC7"}})
    for (const std::uint32_t number : {first, last})
      EXPECT_EQ(nameOfDxgi(number), name + " block compression") << number;
  EXPECT_EQ(nameOfDxgi(100), "DXGI_FORMAT 100");
}

}  // namespace
}  // namespace mirrorball
