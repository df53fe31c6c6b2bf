#include "mirrorball/scene/animation/animation.h"

#include <algorithm>
#include <span>

#include <glm/gtc/quaternion.hpp>

namespace mirrorball {
namespace {

glm::dquat unitQuaternion(std::span<const double> xyzw) {
  const glm::dquat quaternion(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
  const double length = glm::length(quaternion);
  return length > 0.0 ? quaternion / length : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

void write(const glm::dquat& quaternion, std::vector<double>& value) {
  value = {quaternion.x, quaternion.y, quaternion.z, quaternion.w};
}

/// Hermite's cubic through two values with their slopes, for unit time.
double cubic(double from, double slope_from, double to, double slope_to, double t) {
  const double t2 = t * t, t3 = t2 * t;
  return (2.0 * t3 - 3.0 * t2 + 1.0) * from + (t3 - 2.0 * t2 + t) * slope_from + (3.0 * t2 - 2.0 * t3) * to +
         (t3 - t2) * slope_to;
}

}  // namespace

std::size_t AnimationSampler::components() const {
  return values->size() / times->size() / (interpolation == KeyInterpolation::cubic_spline ? 3 : 1);
}

void sample(const AnimationSampler& sampler, double seconds, bool is_rotation, std::vector<double>& value) {
  const std::vector<float>& times = *sampler.times;
  const bool is_cubic = sampler.interpolation == KeyInterpolation::cubic_spline;
  const std::size_t components = sampler.components();
  const auto keyed = [&](std::size_t key, std::size_t which) {
    const std::size_t first = (is_cubic ? key * 3 + which : key) * components;
    return std::span(*sampler.values).subspan(first, components);
  };
  const auto after = std::upper_bound(times.begin(), times.end(), seconds);
  const std::size_t next = static_cast<std::size_t>(after - times.begin());
  const std::size_t from = next == 0 ? 0 : next - 1;
  const std::span<const float> begin = keyed(from, 1);
  value.assign(begin.begin(), begin.end());
  const bool is_between = next > 0 && next < times.size() && sampler.interpolation != KeyInterpolation::step;
  if (!is_between) {
    if (is_rotation) write(unitQuaternion(value), value);
    return;
  }
  const double duration = double(times[next]) - double(times[from]);
  const double t = (seconds - double(times[from])) / duration;
  const std::span<const float> end = keyed(next, 1);
  if (is_rotation && !is_cubic) {
    const std::vector<double> other(end.begin(), end.end());
    write(glm::slerp(unitQuaternion(value), unitQuaternion(other), t), value);
    return;
  }
  for (std::size_t i = 0; i < components; ++i)
    value[i] = is_cubic ? cubic(value[i], duration * double(keyed(from, 2)[i]), double(end[i]),
                                duration * double(keyed(next, 0)[i]), t)
                        : value[i] + t * (double(end[i]) - value[i]);
  if (is_rotation) write(unitQuaternion(value), value);
}

}  // namespace mirrorball
