#include "mirrorball/view/viewer/compared_sides.h"

#include <utility>

#include "mirrorball/metric/comparison.h"
#include "mirrorball/metric/picture/heat_map.h"

namespace mirrorball {
namespace {

Result<void> put(Image8 picture, std::optional<gl::Framebuffer>& framebuffer) {
  MIRRORBALL_TRY_VOID(gl::resize(framebuffer, gl::Format::rgba8, {picture.width(), picture.height()}));
  framebuffer->upload(std::move(picture));
  return {};
}

}  // namespace

ComparedSides::ComparedSides(const Device& device) : on_(new OnDevice{device}) {}

Result<void> ComparedSides::compare(const gl::Framebuffer& first, const gl::Framebuffer& second,
                                    const Version& version) {
  const bool are_alike = first.width() == second.width() && first.height() == second.height();
  if (begun_ == version || comparing_.isRunning() || !are_alike) return {};
  MIRRORBALL_TRY_VOID(on_->device.state().context.enter());
  begun_ = version;
  comparing_.begin([a = first.readFloat(), b = second.readFloat()](const ProgressFunction& progress) mutable {
    return found(std::move(a), std::move(b), progress);
  });
  return {};
}

Result<ComparedSides::Found> ComparedSides::found(Image first, Image second, const ProgressFunction& progress) {
  MIRRORBALL_TRY(test, comparedImage(std::move(first), ImageKind::picture));
  MIRRORBALL_TRY(reference, comparedImage(std::move(second), ImageKind::picture));
  MIRRORBALL_TRY(comparison, compareImages(std::move(test), std::move(reference), ImageKind::picture, {}, progress));
  Found found{
      signedHeatMap(comparison.difference, usualScale(comparison.difference)), flipHeatMap(comparison.flip), {}};
  for (const MetricText& metric : kMetrics)
    if (const auto& value = comparison.value(metric.metric))
      found.errors.push_back({std::string(metric.label), valueText(metric.metric, *value)});
  return found;
}

Result<bool> ComparedSides::take() {
  auto ready = comparing_.take();
  if (!ready || !*ready) return false;
  MIRRORBALL_TRY_VOID(on_->device.state().context.enter());
  MIRRORBALL_TRY_VOID(put(std::move((*ready)->difference), on_->difference));
  MIRRORBALL_TRY_VOID(put(std::move((*ready)->flip), on_->flip));
  errors_ = std::move((*ready)->errors);
  found_ = begun_;
  return true;
}

const gl::Framebuffer* ComparedSides::heatMap(HeatMapKind kind, const Version& version) const {
  const auto& map = kind == HeatMapKind::difference ? on_->difference : on_->flip;
  return map && found_ == version ? &*map : nullptr;
}

}  // namespace mirrorball
