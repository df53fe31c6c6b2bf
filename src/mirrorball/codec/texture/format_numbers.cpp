#include "mirrorball/codec/texture/format_numbers.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <utility>

namespace mirrorball {
namespace {

/// One format under its numbers in vulkan_core.h and dxgiformat.h; 0 where it has none.
struct FormatNumberRow {
  StoredFormat format;
  std::uint32_t vk_format;
  std::uint32_t dxgi_format;
};
/// Integers in words, under masks.
constexpr StoredFormat bitsFormat(std::uint32_t word_bytes, const std::array<std::uint32_t, 4>& masks) {
  return {SampleType::unorm_bits, masks[3] != 0 ? 4 : 3, false, false, word_bytes, masks};
}

constexpr FormatNumberRow kFormatNumberRows[] = {
    {{SampleType::unorm8, 1}, 9, 61},
    {{SampleType::srgb8, 1}, 15, 0},
    {{SampleType::unorm8, 2}, 16, 49},
    {{SampleType::srgb8, 2}, 22, 0},
    {{SampleType::unorm8, 3}, 23, 0},
    {{SampleType::srgb8, 3}, 29, 0},
    {{SampleType::unorm8, 3, true}, 30, 0},
    {{SampleType::srgb8, 3, true}, 36, 0},
    {{SampleType::unorm8, 4}, 37, 28},
    {{SampleType::srgb8, 4}, 43, 29},
    {{SampleType::unorm8, 4, true}, 44, 87},
    {{SampleType::srgb8, 4, true}, 50, 91},
    {{SampleType::unorm8, 4, true, true}, 0, 88},
    {{SampleType::srgb8, 4, true, true}, 0, 93},
    {{SampleType::unorm16, 1}, 70, 56},
    {{SampleType::half, 1}, 76, 54},
    {{SampleType::unorm16, 2}, 77, 35},
    {{SampleType::half, 2}, 83, 34},
    {{SampleType::unorm16, 3}, 84, 0},
    {{SampleType::half, 3}, 90, 0},
    {{SampleType::unorm16, 4}, 91, 11},
    {{SampleType::half, 4}, 97, 10},
    {{SampleType::float32, 1}, 100, 41},
    {{SampleType::float32, 2}, 103, 16},
    {{SampleType::float32, 3}, 106, 6},
    {{SampleType::float32, 4}, 109, 2},
    {{SampleType::b10g11r11, 3}, 122, 26},
    {{SampleType::e5b9g9r9, 3}, 123, 67},
    {{SampleType::bc6h_unsigned, 3}, 143, 95},
    {{SampleType::bc6h_signed, 3}, 144, 96},
    {{SampleType::uastc_hdr, 3}, 1000066000, 0},                       // VK_FORMAT_ASTC_4x4_SFLOAT_BLOCK
    {bitsFormat(4, {0x3ff, 0xffc00, 0x3ff00000, 0xc0000000}), 0, 24},  // R10G10B10A2
    {bitsFormat(2, {0xf800, 0x7e0, 0x1f, 0}), 0, 85},                  // B5G6R5, named from the lowest bits
    {bitsFormat(2, {0x7c00, 0x3e0, 0x1f, 0x8000}), 0, 86},             // B5G5R5A1
    {bitsFormat(2, {0xf00, 0xf0, 0xf, 0xf000}), 0, 115},               // B4G4R4A4
    {bitsFormat(2, {0xf000, 0xf00, 0xf0, 0xf}), 0, 191},               // A4B4G4R4
};

/// DXGI's formats that leave the type of their samples to whoever uses them, and what is taken for each: floats, where
/// there are some of that size, else unsigned shares.
constexpr std::pair<std::uint32_t, std::uint32_t> kTypeless[] = {
    {1, 2},   {5, 6},   {9, 10},  {15, 16}, {23, 24}, {27, 28}, {33, 34},
    {39, 41}, {48, 49}, {53, 54}, {60, 61}, {90, 87}, {92, 88}, {94, 95},
};

std::optional<StoredFormat> formatOf(std::uint32_t FormatNumberRow::*column, std::uint32_t number) {
  for (const FormatNumberRow& row : kFormatNumberRows)
    if (number != 0 && row.*column == number) return row.format;
  return {};
}

std::uint32_t numberOf(std::uint32_t FormatNumberRow::*column, TexelFormat format) {
  const StoredFormat stored = storedFormat(format);
  return std::find_if(std::begin(kFormatNumberRows), std::end(kFormatNumberRows), [&](const FormatNumberRow& row) {
           return row.format == stored;
         })->*column;
}

/// Numbers in a row that are one family of block compression.
struct Family {
  std::uint32_t first;
  std::uint32_t last;
  const char* name;
};
constexpr Family kVulkanFamilies[] = {
    {131, 134, "BC1"},
    {135, 136, "BC2"},
    {137, 138, "BC3"},
    {139, 140, "BC4"},
    {141, 142, "BC5"},
    {145, 146, "BC7"},
    {147, 152, "ETC2"},
    {153, 156, "EAC"},
    {157, 184, "ASTC"},
    {1000054000, 1000054007, "PVRTC"},
    {1000066001, 1000066013, "ASTC HDR"},
};
constexpr Family kDxgiFamilies[] = {
    {70, 72, "BC1"}, {73, 75, "BC2"}, {76, 78, "BC3"}, {79, 81, "BC4"}, {82, 84, "BC5"}, {97, 99, "BC7"},
};
constexpr Family kGlFamilies[] = {
    {0x83f0, 0x83f3, "BC1 to BC3 (S3TC)"},
    {0x8c4c, 0x8c4f, "BC1 to BC3 (S3TC)"},
    {0x8dbb, 0x8dbe, "BC4 or BC5 (RGTC)"},
    {0x8e8c, 0x8e8d, "BC7 (BPTC)"},
    {0x8d64, 0x8d64, "ETC1"},
    {0x9270, 0x9279, "ETC2"},
    {0x8c00, 0x8c03, "PVRTC"},
    {0x93b0, 0x93dd, "ASTC"},
};

std::optional<std::string> blockCompression(std::span<const Family> families, std::uint32_t number) {
  for (const Family& family : families)
    if (number >= family.first && number <= family.last) return std::string(family.name) + " block compression";
  return {};
}

}  // namespace

std::optional<StoredFormat> formatOfVulkan(std::uint32_t vk_format) {
  return formatOf(&FormatNumberRow::vk_format, vk_format);
}
std::optional<StoredFormat> formatOfDxgi(std::uint32_t dxgi_format) {
  return formatOf(&FormatNumberRow::dxgi_format, dxgi_format);
}

std::uint32_t typedDxgi(std::uint32_t dxgi_format) {
  for (const auto& [typeless, typed] : kTypeless)
    if (typeless == dxgi_format) return typed;
  return dxgi_format;
}

std::uint32_t vulkanNumber(TexelFormat format) { return numberOf(&FormatNumberRow::vk_format, format); }
std::uint32_t dxgiNumber(TexelFormat format) { return numberOf(&FormatNumberRow::dxgi_format, format); }

std::string nameOfVulkan(std::uint32_t vk_format) {
  return blockCompression(kVulkanFamilies, vk_format).value_or("VkFormat " + std::to_string(vk_format));
}

std::string nameOfDxgi(std::uint32_t dxgi_format) {
  return blockCompression(kDxgiFamilies, dxgi_format).value_or("DXGI_FORMAT " + std::to_string(dxgi_format));
}

std::optional<std::string> blockCompressionOfGl(std::uint32_t gl_internal_format) {
  return blockCompression(kGlFamilies, gl_internal_format);
}

tl::unexpected<Error> unsupportedTexture(const std::string& what, const std::string& instead) {
  return fail(ErrorCode::unsupported,
              "holds " + what + ", which is not read; store it as " + instead + ", for example");
}

}  // namespace mirrorball
