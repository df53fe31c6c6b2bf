#include "mirrorball/scene/gltf/gltf_vertex_color.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mirrorball/scene/channel_range.h"

namespace mirrorball::gltf {
namespace {

constexpr std::size_t kAlpha = 3;

}  // namespace

void normalizeColors(Document& document, Remarks& remarks) {
  for (const FileMesh& mesh : document.meshes) {
    for (const Primitive& primitive : mesh.primitives) {
      const auto color = primitive.attributes.find("COLOR_0");
      if (color == primitive.attributes.end() || color->second < 0) continue;
      const auto index = static_cast<std::size_t>(color->second);
      if (index >= document.accessors.size()) continue;
      Accessor& accessor = document.accessors[index];
      const bool is_of_codes = accessor.component_type >= kByte && accessor.component_type <= kUnsignedShort;
      if (accessor.normalized || !is_of_codes) continue;
      accessor.normalized = true;
      remarks.tellOnce(quoted("accessors", index),
                       "is of colours in integers that are not 'normalized', and is read as if they were");
    }
  }
}

ColorOddity bringIntoRange(Numbers& colors) {
  const std::size_t components = std::max<std::size_t>(colors.components, 1);
  ChannelRange color, alpha;
  for (std::size_t i = 0; i < colors.values.size(); ++i)
    (i % components == kAlpha ? alpha : color).add(colors.values[i]);
  const bool are_codes = color.isOfCodes();
  const float full_alpha = are_codes && alpha.isOfCodes() ? ChannelRange::kGreatestCode : 1.0f;
  const float full_color = are_codes ? ChannelRange::kGreatestCode : 1.0f;
  for (std::size_t i = 0; i < colors.values.size(); ++i) {
    float& number = colors.values[i];
    if (std::isfinite(number))
      number = std::clamp(number / (i % components == kAlpha ? full_alpha : full_color), 0.0f, 1.0f);
  }
  if (are_codes) return ColorOddity::codes;
  return color.isBeyond() || alpha.isBeyond() ? ColorOddity::cut : ColorOddity::none;
}

std::string remarkOn(ColorOddity oddity) {
  if (oddity == ColorOddity::codes) return "holds whole numbers up to 255 for 0 to 1, and is read in parts of 255";
  return "holds numbers beyond 0 to 1, and is cut to them";
}

}  // namespace mirrorball::gltf
