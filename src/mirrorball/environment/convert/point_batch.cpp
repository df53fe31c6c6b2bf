// The projections that most conversions go between have a twin in vector instructions of the formula in formula/
// (point_batch_test holds each to it); the others call the formula point by point.

#include "mirrorball/environment/convert/point_batch.h"

#include "mirrorball/base/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mirrorball/environment/convert/point_batch.cpp"
// Highway needs its headers in this order.
// clang-format off
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include <hwy/contrib/math/math-inl.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace mirrorball::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr float kPi = 3.14159265358979f;
using Lanes = hn::CappedTag<float, 16>;
using IntLanes = hn::RebindToSigned<Lanes>;
using Floats = hn::Vec<Lanes>;

/// The angle of (x, y) from the axis +X in (−π, π], as atan(y, x) of GLSL, to about 3 units in the last place. Both
/// may be 0: the angle is then 0.
Floats angleOf(Lanes d, Floats y, Floats x) {
  const Floats zero = hn::Zero(d);
  const Floats high = hn::Max(hn::Abs(x), hn::Abs(y));
  const Floats low = hn::Min(hn::Abs(x), hn::Abs(y));
  const Floats ratio = hn::IfThenElse(high == zero, zero, low / high);
  Floats angle = hn::Atan(d, ratio);
  angle = hn::IfThenElse(hn::Abs(y) > hn::Abs(x), hn::Set(d, kPi / 2.0f) - angle, angle);
  angle = hn::IfThenElse(x < zero, hn::Set(d, kPi) - angle, angle);
  return hn::CopySign(angle, y);
}

/// formula/projection/projection.glsl, equirectPosition.
void equirectPositions(PointBatch& batch) {
  const Lanes d;
  const Floats zero = hn::Zero(d);
  const Floats one = hn::Set(d, 1.0f);
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const Floats x = hn::Load(d, &batch.x[i]);
    const Floats y = hn::Load(d, &batch.y[i]);
    const Floats z = hn::Load(d, &batch.z[i]);
    const Floats u = angleOf(d, x, zero - z) * hn::Set(d, 0.5f / kPi);
    const Floats v = angleOf(d, hn::Sqrt(x * x + z * z), y) * hn::Set(d, 1.0f / kPi);
    hn::Store(hn::IfThenElse(u < zero, u + one, u), d, &batch.u[i]);
    hn::Store(v, d, &batch.v[i]);
    hn::Store(hn::Zero(IntLanes()), IntLanes(), &batch.face[i]);
  }
}

/// formula/projection/projection.glsl, equirectDirection.
void equirectDirections(PointBatch& batch) {
  const Lanes d;
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const Floats longitude = hn::Load(d, &batch.u[i]) * hn::Set(d, 2.0f * kPi);
    const Floats latitude = hn::Load(d, &batch.v[i]) * hn::Set(d, kPi);
    const Floats ring = hn::Sin(d, latitude);
    hn::Store(ring * hn::Sin(d, longitude), d, &batch.x[i]);
    hn::Store(hn::Cos(d, latitude), d, &batch.y[i]);
    hn::Store(hn::Neg(ring * hn::Cos(d, longitude)), d, &batch.z[i]);
  }
}

/// formula/projection/cube.glsl, cubeDirection.
void cubeDirections(PointBatch& batch) {
  const Lanes d;
  const Floats one = hn::Set(d, 1.0f);
  const int face = batch.face[0];
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const Floats sc = hn::Load(d, &batch.u[i]) * hn::Set(d, 2.0f) - one;
    const Floats tc = hn::Load(d, &batch.v[i]) * hn::Set(d, 2.0f) - one;
    const Floats ma = one / hn::Sqrt(sc * sc + tc * tc + one);
    const Floats s = sc * ma;
    const Floats t = tc * ma;
    Floats x = s, y = hn::Neg(t), z = ma;
    if (face == 0) x = ma, z = hn::Neg(s);
    if (face == 1) x = hn::Neg(ma), z = s;
    if (face == 2) y = ma, z = t;
    if (face == 3) y = hn::Neg(ma), z = hn::Neg(t);
    if (face == 5) x = hn::Neg(s), z = hn::Neg(ma);
    hn::Store(x, d, &batch.x[i]);
    hn::Store(y, d, &batch.y[i]);
    hn::Store(z, d, &batch.z[i]);
  }
}

/// formula/projection/cube.glsl, cubeFace and cubeCoordinates.
void cubePositions(PointBatch& batch) {
  const Lanes d;
  const IntLanes di;
  const Floats zero = hn::Zero(d);
  const Floats half = hn::Set(d, 0.5f);
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const Floats x = hn::Load(d, &batch.x[i]);
    const Floats y = hn::Load(d, &batch.y[i]);
    const Floats z = hn::Load(d, &batch.z[i]);
    const auto along_x = hn::And(hn::Abs(x) >= hn::Abs(y), hn::Abs(x) >= hn::Abs(z));
    const auto along_y = hn::AndNot(along_x, hn::Abs(y) >= hn::Abs(z));
    const Floats longest = hn::IfThenElse(along_x, x, hn::IfThenElse(along_y, y, z));
    const auto negative = longest < zero;
    // (sc, tc) of +X (−z, −y), −X (z, −y), +Y (x, z), −Y (x, −z), +Z (x, −y), −Z (−x, −y).
    const Floats signed_x = hn::IfThenElse(negative, hn::Neg(x), x);
    const Floats signed_z = hn::IfThenElse(negative, hn::Neg(z), z);
    const Floats sc = hn::IfThenElse(along_x, hn::Neg(signed_z), hn::IfThenElse(along_y, x, signed_x));
    const Floats tc = hn::IfThenElse(along_y, signed_z, hn::Neg(y));
    const Floats scale = half / hn::Abs(longest);
    hn::Store(sc * scale + half, d, &batch.u[i]);
    hn::Store(tc * scale + half, d, &batch.v[i]);
    const Floats pair = hn::IfThenElse(along_x, zero, hn::IfThenElse(along_y, hn::Set(d, 2.0f), hn::Set(d, 4.0f)));
    const Floats face = pair + hn::IfThenElse(negative, hn::Set(d, 1.0f), zero);
    hn::Store(hn::ConvertTo(di, face), di, &batch.face[i]);
  }
}

}  // namespace mirrorball::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mirrorball {

HWY_EXPORT(equirectPositions);
HWY_EXPORT(equirectDirections);
HWY_EXPORT(cubePositions);
HWY_EXPORT(cubeDirections);

void directionsAt(Projection projection, PointBatch& batch) {
  if (projection == Projection::equirect) return HWY_DYNAMIC_DISPATCH(equirectDirections)(batch);
  if (projection == Projection::cube) return HWY_DYNAMIC_DISPATCH(cubeDirections)(batch);
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
    const glm::vec3 direction = directionAt(projection, {batch.face[i], {batch.u[i], batch.v[i]}});
    batch.x[i] = direction.x;
    batch.y[i] = direction.y;
    batch.z[i] = direction.z;
  }
}

void positionsOf(Projection projection, PointBatch& batch) {
  if (projection == Projection::equirect) return HWY_DYNAMIC_DISPATCH(equirectPositions)(batch);
  if (projection == Projection::cube) return HWY_DYNAMIC_DISPATCH(cubePositions)(batch);
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
    const MapPosition position = positionOf(projection, {batch.x[i], batch.y[i], batch.z[i]});
    batch.face[i] = position.face;
    batch.u[i] = position.uv.x;
    batch.v[i] = position.uv.y;
  }
}

void turn(const glm::mat3& rotation, PointBatch& batch) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
    const glm::vec3 turned = rotation * glm::vec3(batch.x[i], batch.y[i], batch.z[i]);
    batch.x[i] = turned.x;
    batch.y[i] = turned.y;
    batch.z[i] = turned.z;
  }
}

}  // namespace mirrorball
#endif
