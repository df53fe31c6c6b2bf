#include "mirrorball/scene/material/builtin_picture.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>

#include "mirrorball/base/range.h"

namespace mirrorball {
namespace {

constexpr std::array<std::string_view, 1> kNames{"stripes"};

constexpr int kSide = 1024;
constexpr int kStripe = 16;

}  // namespace

std::span<const std::string_view> builtinPictureNames() { return kNames; }

Image8 builtinPicture(std::string_view name) {
  assert(contains(kNames, name));
  static_cast<void>(name);
  Image8 stripes(kSide, kSide, 4, 255);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      if (x / kStripe % 2 == 1) std::fill_n(stripes.texel(x, y), 3, std::uint8_t{0});
  return stripes;
}

}  // namespace mirrorball
