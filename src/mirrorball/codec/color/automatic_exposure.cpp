#include "mirrorball/codec/color/automatic_exposure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "formula/color.h"

namespace mirrorball {

float automaticExposure(const Image& light) {
  constexpr double kMiddleGrey = 0.18;
  constexpr double kBright = 16.0;
  constexpr std::size_t kBrightOfAll = 100;  // one of so many texels may be brighter than that
  constexpr double kMost_ev = 30.0;
  std::vector<float> luminances;
  luminances.reserve(light.texelCount());
  double logarithms = 0.0;
  for (int y = 0; y < light.height(); ++y)
    for (int x = 0; x < light.width(); ++x) {
      const float luminance = formula::luminance(rgbAt(light, x, y));
      if (!(luminance > 0.0f) || !std::isfinite(luminance)) continue;
      luminances.push_back(luminance);
      logarithms += std::log2(double(luminance));
    }
  if (luminances.empty()) return 0.0f;
  const double to_grey = std::log2(kMiddleGrey) - logarithms / double(luminances.size());
  const auto bright =
      luminances.end() - 1 - std::ptrdiff_t(std::min(light.texelCount() / kBrightOfAll, luminances.size() - 1));
  std::nth_element(luminances.begin(), bright, luminances.end());
  const double to_bright = std::log2(kBright) - std::log2(double(*bright));
  return static_cast<float>(std::clamp(std::min(to_grey, to_bright), -kMost_ev, kMost_ev));
}

}  // namespace mirrorball
