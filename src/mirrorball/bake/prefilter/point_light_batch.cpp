// The twin in vector instructions of formula/bsdf/reflection_lobe.glsl.
// point_light_batch_test holds both to the same values.

#include "mirrorball/bake/prefilter/point_light_batch.h"

#include <cstddef>

#include "mirrorball/base/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mirrorball/bake/prefilter/point_light_batch.cpp"
// Highway needs its headers in this order.
// clang-format off
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include <hwy/contrib/math/math-inl.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace mirrorball::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<float, 8>;
using Floats = hn::Vec<Lanes>;

HWY_INLINE Floats set(float value) { return hn::Set(Lanes(), value); }

template <Distribution kDistribution>
HWY_INLINE Floats shapeAt(float parameter, Floats s) {
  const Lanes d;
  const Floats cosine = hn::Max(hn::NegMulAdd(set(2.0f), s, set(1.0f)), hn::Zero(d));
  switch (kDistribution) {
    case Distribution::phong:
      return hn::IfThenElseZero(cosine > hn::Zero(d), hn::Exp(d, set(parameter) * hn::Log1p(d, set(-2.0f) * s)));
    case Distribution::blinn:
      return cosine * hn::Exp(d, set(0.5f * parameter) * hn::Log1p(d, hn::Neg(s)));
    case Distribution::charlie: {
      const Floats sine2 = hn::Min(set(2.0f) * s, set(1.0f));
      return hn::IfThenElseZero(sine2 > hn::Zero(d), cosine * hn::Exp(d, set(0.5f / parameter) * hn::Log(d, sine2)));
    }
    case Distribution::ggx:
      break;
  }
  const float alpha2 = parameter * parameter;
  const Floats q = set(alpha2) / hn::MulAdd(set(1.0f - alpha2), s, set(alpha2));
  return q * q * cosine;
}

template <Distribution kDistribution>
HWY_INLINE void addOf(const PointOfLight& point, float parameter, float scale, const PointBatch& points,
                      LightChannels& light) {
  const Lanes d;
  const auto x = set(point.direction.x);
  const auto y = set(point.direction.y);
  const auto z = set(point.direction.z);
  const glm::vec3 flux = point.flux * scale;
  for (std::size_t i = 0; i < static_cast<std::size_t>(points.count); i += hn::Lanes(d)) {
    const Floats dx = x - hn::Load(d, &points.x[i]);
    const Floats dy = y - hn::Load(d, &points.y[i]);
    const Floats dz = z - hn::Load(d, &points.z[i]);
    const Floats s = set(0.25f) * hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, dz * dz));
    const Floats received = shapeAt<kDistribution>(parameter, s);
    for (std::size_t c = 0; c < 3; ++c) {
      float* channel = &light.channel[c][i];
      hn::Store(hn::MulAdd(set(flux[static_cast<int>(c)]), received, hn::Load(d, channel)), d, channel);
    }
  }
}

void add(const PointOfLight& point, const LobeShape& shape, float scale, const PointBatch& points,
         LightChannels& light) {
  switch (shape.distribution) {
    case Distribution::phong:
      return addOf<Distribution::phong>(point, shape.parameter, scale, points, light);
    case Distribution::blinn:
      return addOf<Distribution::blinn>(point, shape.parameter, scale, points, light);
    case Distribution::charlie:
      return addOf<Distribution::charlie>(point, shape.parameter, scale, points, light);
    case Distribution::ggx:
      return addOf<Distribution::ggx>(point, shape.parameter, scale, points, light);
  }
}

}  // namespace mirrorball::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mirrorball {

HWY_EXPORT(add);

LightChannels lightOfPoints(const std::vector<PointOfLight>& lights, const Lobe& lobe, const PointBatch& points) {
  LightChannels light;
  const auto add_light = HWY_DYNAMIC_DISPATCH(add);
  for (const PointOfLight& point : lights) add_light(point, lobe.shape(), lobe.scale(), points, light);
  return light;
}

}  // namespace mirrorball
#endif
