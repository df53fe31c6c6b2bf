#include "mirrorball/view/map/waveform.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/projection/texel_geometry.h"
#include "mirrorball/view/map/false_colors.h"

namespace mirrorball {

Waveform::Waveform(const EnvironmentMap& panorama) : columns_(panorama.extent().x) {
  assert(panorama.projection() == Projection::equirect);
  const int height = panorama.size();
  std::vector<float> weights;  // of the rows
  float whole = 0.0f;
  for (int y = 0; y < height; ++y)
    whole += weights.emplace_back(texelSolidAngle(Projection::equirect, panorama.extent(), {0, y}));
  sums_.assign(std::size_t(columns_) * (kBins + 1), 0.0f);
  parallelFor(std::size_t(columns_), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t column = begin; column < end; ++column) {
      float* const sums = sums_.data() + column * (kBins + 1);
      for (int y = 0; y < height; ++y) {
        const float stops = stopsOf(rgbAt(panorama.face(0), static_cast<int>(column), y), 0.0f);
        const float bin = (stops - kFirstStop) * kBinsPerStop;
        if (!(bin >= 0.0f)) continue;
        sums[std::min(static_cast<int>(std::min(bin, float(kBins))), kBins - 1) + 1] += weights[std::size_t(y)] / whole;
      }
      for (int bin = 1; bin <= kBins; ++bin) sums[bin] += sums[bin - 1];
    }
  });
}

float Waveform::sumBelow(int column, float stops) const {
  const float bin = std::clamp((stops - kFirstStop) * kBinsPerStop, 0.0f, float(kBins));
  const int whole = std::min(static_cast<int>(bin), kBins - 1);
  const float* const sums = sums_.data() + std::size_t(column) * (kBins + 1);
  return sums[whole] + (bin - static_cast<float>(whole)) * (sums[whole + 1] - sums[whole]);
}

float Waveform::share(int first, int last, float begin, float end) const {
  float sum = 0.0f;
  for (int column = first; column <= last; ++column) sum += sumBelow(column, end) - sumBelow(column, begin);
  return sum / static_cast<float>(last - first + 1);
}

void drawWaveform(const Waveform& waveform, const PixelRectangle& place, float exposure_ev, float range,
                  Image8& picture) {
  constexpr glm::vec3 kGround(12.0f);
  constexpr glm::vec3 kLine(60.0f);
  constexpr glm::vec3 kFull(190.0f, 255.0f, 190.0f);
  constexpr float kFullShare = 0.25f;  // of a column within a stop
  const float step = 2.0f * range / static_cast<float>(place.extent.y);
  const auto columnAt = [&](int x) {
    const long long column = static_cast<long long>(x) * waveform.columns() / std::max(place.extent.x, 1);
    return std::min(static_cast<int>(column), waveform.columns() - 1);
  };
  for (int y = 0; y < place.extent.y; ++y) {
    const float end = range - static_cast<float>(y) * step;
    const bool is_line = std::floor(end / 4.0f) != std::floor((end - step) / 4.0f);
    for (int x = 0; x < place.extent.x; ++x) {
      const int first = columnAt(x);
      const int last = std::max(columnAt(x + 1) - 1, first);
      const float share = waveform.share(first, last, end - step - exposure_ev, end - exposure_ev) / step;
      // The root shows what is little of a column, as a lamp is.
      const float brightness = std::min(std::sqrt(std::max(share, 0.0f) / kFullShare), 1.0f);
      const glm::vec4 color(glm::mix(is_line ? kLine : kGround, kFull, brightness) + 0.5f, 255.0f);
      const glm::vec<4, std::uint8_t> codes(color);
      std::copy_n(&codes.x, 4, picture.texel(place.corner.x + x, place.corner.y + y));
    }
  }
}

}  // namespace mirrorball
