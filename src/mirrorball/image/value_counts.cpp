#include "mirrorball/image/value_counts.h"

#include <span>

namespace mirrorball {

void ValueCounts::add(const Image& image) {
  constexpr float kClear = 0x1p-11f;
  constexpr float kBrightest = 1e36f;
  const std::span<const float> samples = image.samples();
  const bool has_alpha = image.channels() == 4;
  ValueCounts here{.all = has_alpha ? samples.size() / 4 * 3 : samples.size()};
  // Alpha counts as black, so that one pass without branches is enough.
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const float sample = has_alpha && i % 4 == 3 ? 0.0f : samples[i];
    here.lit += sample > 0.0f ? 1 : 0;
    here.clear += sample > kClear ? 1 : 0;
    here.too_bright += sample > kBrightest ? 1 : 0;
  }
  add(here);
}

void ValueCounts::add(const ValueCounts& other) {
  all += other.all;
  lit += other.lit;
  clear += other.clear;
  too_bright += other.too_bright;
}

}  // namespace mirrorball
