#include "mirrorball/trace/media.h"

#include <algorithm>
#include <span>

namespace mirrorball {
namespace {

int priorityOf(const Scene& scene, std::uint32_t instance) { return materialOf(scene, instance).priority; }

}  // namespace

void Media::enter(std::uint32_t instance) {
  if (count_ < kMax) instances_[count_++] = instance;
}

void Media::leave(std::uint32_t instance) {
  const std::span entered(instances_.data(), count_);
  const auto found = std::find(entered.rbegin(), entered.rend(), instance);
  if (found == entered.rend()) return;
  std::copy(found.base(), entered.end(), found.base() - 1);
  --count_;
}

bool Media::contains(std::uint32_t instance) const {
  return std::find(instances_.begin(), instances_.begin() + count_, instance) != instances_.begin() + count_;
}

std::optional<std::uint32_t> Media::filling(const Scene& scene) const {
  std::optional<std::uint32_t> greatest;
  for (std::uint32_t i = 0; i < count_; ++i)
    if (!greatest || priorityOf(scene, instances_[i]) >= priorityOf(scene, *greatest)) greatest = instances_[i];
  return greatest;
}

std::optional<std::uint32_t> Media::fillingWithout(const Scene& scene, std::uint32_t instance) const {
  Media others = *this;
  others.leave(instance);
  return others.filling(scene);
}

bool Media::hasSurface(const Scene& scene, std::uint32_t instance, bool is_entering) const {
  const auto entered = std::count(instances_.begin(), instances_.begin() + count_, instance);
  // Where parts of one mesh overlap, they are one body.
  if (entered > (is_entering ? 0 : 1)) return false;
  const auto current = filling(scene);
  if (!current) return true;
  if (is_entering) return priorityOf(scene, instance) >= priorityOf(scene, *current);
  return entered == 0 || *current == instance;
}

}  // namespace mirrorball
