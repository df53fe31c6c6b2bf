#include "mirrorball/codec/dxgi_format.h"

namespace mirrorball {
namespace {

struct Row {
  std::uint32_t dxgi_format;
  StoredFormat format;
};

/// From dxgiformat.h.
constexpr Row kRows[] = {
    {2, {SampleType::float32, 4}},       {6, {SampleType::float32, 3}},
    {10, {SampleType::half, 4}},         {11, {SampleType::unorm16, 4}},
    {16, {SampleType::float32, 2}},      {26, {SampleType::b10g11r11, 3}},
    {28, {SampleType::unorm8, 4}},       {29, {SampleType::srgb8, 4}},
    {34, {SampleType::half, 2}},         {35, {SampleType::unorm16, 2}},
    {41, {SampleType::float32, 1}},      {49, {SampleType::unorm8, 2}},
    {54, {SampleType::half, 1}},         {56, {SampleType::unorm16, 1}},
    {61, {SampleType::unorm8, 1}},       {67, {SampleType::e5b9g9r9, 3}},
    {87, {SampleType::unorm8, 4, true}}, {88, {SampleType::unorm8, 4, true, true}},
    {91, {SampleType::srgb8, 4, true}},  {93, {SampleType::srgb8, 4, true, true}},
};

struct BlockFormats {
  std::uint32_t first;
  std::uint32_t last;
  const char* name;
};
constexpr BlockFormats kBlockFormats[] = {
    {70, 72, "BC1"}, {73, 75, "BC2"},  {76, 78, "BC3"}, {79, 81, "BC4"},
    {82, 84, "BC5"}, {94, 96, "BC6H"}, {97, 99, "BC7"},
};

}  // namespace

std::optional<StoredFormat> storedFormatOfDxgi(std::uint32_t dxgi_format) {
  for (const Row& row : kRows)
    if (row.dxgi_format == dxgi_format) return row.format;
  return {};
}

std::uint32_t dxgiFormat(TexelFormat format) {
  for (const Row& row : kRows)
    if (row.format == storedFormat(format)) return row.dxgi_format;
  return 0;
}

std::string dxgiFormatName(std::uint32_t dxgi_format) {
  for (const BlockFormats& block : kBlockFormats)
    if (dxgi_format >= block.first && dxgi_format <= block.last) return std::string(block.name) + " block compression";
  return "DXGI_FORMAT " + std::to_string(dxgi_format);
}

}  // namespace mirrorball
