#include "mirrorball/codec/vulkan_format.h"

namespace mirrorball {
namespace {

struct Row {
  std::uint32_t vk_format;
  StoredFormat format;
};

/// From vulkan_core.h.
constexpr Row kRows[] = {
    {9, {SampleType::unorm8, 1}},        {15, {SampleType::srgb8, 1}},        {16, {SampleType::unorm8, 2}},
    {22, {SampleType::srgb8, 2}},        {23, {SampleType::unorm8, 3}},       {29, {SampleType::srgb8, 3}},
    {30, {SampleType::unorm8, 3, true}}, {36, {SampleType::srgb8, 3, true}},  {37, {SampleType::unorm8, 4}},
    {43, {SampleType::srgb8, 4}},        {44, {SampleType::unorm8, 4, true}}, {50, {SampleType::srgb8, 4, true}},
    {70, {SampleType::unorm16, 1}},      {76, {SampleType::half, 1}},         {77, {SampleType::unorm16, 2}},
    {83, {SampleType::half, 2}},         {84, {SampleType::unorm16, 3}},      {90, {SampleType::half, 3}},
    {91, {SampleType::unorm16, 4}},      {97, {SampleType::half, 4}},         {100, {SampleType::float32, 1}},
    {103, {SampleType::float32, 2}},     {106, {SampleType::float32, 3}},     {109, {SampleType::float32, 4}},
    {122, {SampleType::b10g11r11, 3}},   {123, {SampleType::e5b9g9r9, 3}},
};

struct BlockFormats {
  std::uint32_t first;
  std::uint32_t last;
  const char* name;
};
constexpr BlockFormats kBlockFormats[] = {
    {131, 134, "BC1"},
    {135, 136, "BC2"},
    {137, 138, "BC3"},
    {139, 140, "BC4"},
    {141, 142, "BC5"},
    {143, 144, "BC6H"},
    {145, 146, "BC7"},
    {147, 152, "ETC2"},
    {153, 156, "EAC"},
    {157, 184, "ASTC"},
    {1000054000, 1000054007, "PVRTC"},
    {1000066000, 1000066013, "ASTC HDR"},
};

}  // namespace

std::optional<StoredFormat> storedFormatOfVulkan(std::uint32_t vk_format) {
  for (const Row& row : kRows)
    if (row.vk_format == vk_format) return row.format;
  return {};
}

std::uint32_t vulkanFormat(TexelFormat format) {
  for (const Row& row : kRows)
    if (row.format == storedFormat(format)) return row.vk_format;
  return 0;
}

std::string vulkanFormatName(std::uint32_t vk_format) {
  for (const BlockFormats& block : kBlockFormats)
    if (vk_format >= block.first && vk_format <= block.last) return std::string(block.name) + " block compression";
  return "VkFormat " + std::to_string(vk_format);
}

}  // namespace mirrorball
