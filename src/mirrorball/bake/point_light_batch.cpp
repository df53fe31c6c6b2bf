#include "mirrorball/bake/point_light_batch.h"

#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mirrorball/bake/point_light_batch.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mirrorball::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The twin of formula::ggxLobe for many points.
void addGgx(const PointOfLight& point, float alpha, float scale, const PointBatch& points, LightChannels& light) {
  const hn::CappedTag<float, 16> d;
  const auto x = hn::Set(d, point.direction.x);
  const auto y = hn::Set(d, point.direction.y);
  const auto z = hn::Set(d, point.direction.z);
  const glm::vec3 flux = point.flux * scale;
  const auto red = hn::Set(d, flux.x);
  const auto green = hn::Set(d, flux.y);
  const auto blue = hn::Set(d, flux.z);
  const float alpha2 = alpha * alpha;
  const auto a2 = hn::Set(d, alpha2);
  const auto rest = hn::Set(d, 1.0f - alpha2);
  const auto quarter = hn::Set(d, 0.25f);
  const auto one = hn::Set(d, 1.0f);
  for (std::size_t i = 0; i < static_cast<std::size_t>(points.count); i += hn::Lanes(d)) {
    const auto dx = hn::Sub(x, hn::Load(d, &points.x[i]));
    const auto dy = hn::Sub(y, hn::Load(d, &points.y[i]));
    const auto dz = hn::Sub(z, hn::Load(d, &points.z[i]));
    const auto s = hn::Mul(quarter, hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz))));
    const auto q = hn::Div(a2, hn::MulAdd(rest, s, a2));
    const auto cosine = hn::Max(hn::NegMulAdd(hn::Set(d, 2.0f), s, one), hn::Zero(d));
    const auto lobe = hn::Mul(hn::Mul(q, q), cosine);
    hn::Store(hn::MulAdd(red, lobe, hn::Load(d, &light.channel[0][i])), d, &light.channel[0][i]);
    hn::Store(hn::MulAdd(green, lobe, hn::Load(d, &light.channel[1][i])), d, &light.channel[1][i]);
    hn::Store(hn::MulAdd(blue, lobe, hn::Load(d, &light.channel[2][i])), d, &light.channel[2][i]);
  }
}

}  // namespace mirrorball::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mirrorball {
namespace {

HWY_EXPORT(addGgx);

void add(const PointOfLight& point, const Lobe& lobe, const PointBatch& points, LightChannels& light) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(points.count); ++i) {
    const glm::vec3 difference = point.direction - glm::vec3(points.x[i], points.y[i], points.z[i]);
    const float received = lobe.at(glm::dot(difference, difference) / 4.0f);
    for (std::size_t c = 0; c < 3; ++c) light.channel[c][i] += point.flux[static_cast<int>(c)] * received;
  }
}

}  // namespace

LightChannels lightOfPoints(const std::vector<PointOfLight>& lights, const Lobe& lobe, const PointBatch& points) {
  LightChannels light;
  for (const PointOfLight& point : lights) {
    if (lobe.ggxAlpha() > 0.0f)
      HWY_DYNAMIC_DISPATCH(addGgx)(point, lobe.ggxAlpha(), lobe.scale(), points, light);
    else
      add(point, lobe, points, light);
  }
  return light;
}

}  // namespace mirrorball
#endif
