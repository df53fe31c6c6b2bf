#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/metric/picture/comparison_sheet.h"
#include "mirrorball/render/stage/device_state.h"
#include "mirrorball/view/viewer/background_task.h"
#include "mirrorball/view/viewer/viewer_status.h"

namespace mirrorball {

/// By what the two halves of a comparison differ (metric/comparison.h), found beside its owner. The second is what the
/// first is compared with.
class ComparedSides {
 public:
  /// Which pictures: DrawnSide's or TracedSide's versions of both, with whatever else tells them from others.
  using Version = std::vector<int>;

  explicit ComparedSides(const Device& device);

  /// Compares two pictures of the same size, unless they are those that were compared last. While others are compared
  /// it does nothing.
  ///
  /// errors   no_gl
  Result<void> compare(const gl::Framebuffer& first, const gl::Framebuffer& second, const Version& version);
  /// Takes what was found.
  ///
  /// returns  whether there is anything new
  /// errors   no_gl; too_large (for this driver)
  Result<bool> take();

  bool isRunning() const { return comparing_.isRunning(); }
  /// Whether those were compared last, and all is found.
  bool isDone(const Version& version) const { return !comparing_.isRunning() && begun_ == version; }
  /// Of the pictures of that version; null: it is not there.
  const gl::Framebuffer* heatMap(HeatMapKind kind, const Version& version) const;
  /// Of the pictures that were compared last; empty: none were.
  const std::vector<ErrorText>& errors() const { return errors_; }

 private:
  struct Found {
    Image8 difference;
    Image8 flip;
    std::vector<ErrorText> errors;
  };
  static Result<Found> found(Image first, Image second, const ProgressFunction& progress);

  struct OnDevice {
    Device device;  // outlives all else
    std::optional<gl::Framebuffer> difference = {};
    std::optional<gl::Framebuffer> flip = {};
  };
  std::unique_ptr<OnDevice, EndOnDevice> on_;
  BackgroundTask<Found> comparing_;
  Version begun_;
  Version found_;  // whose maps there are
  std::vector<ErrorText> errors_;
};

}  // namespace mirrorball
