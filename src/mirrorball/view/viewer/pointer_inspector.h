#pragma once

#include <memory>
#include <optional>
#include <string>

#include "mirrorball/view/inspect/inspector.h"
#include "mirrorball/view/viewer/background_task.h"
#include "mirrorball/view/viewer/lit_stage.h"
#include "mirrorball/view/viewer/under_pointer.h"

namespace mirrorball {

/// Tells what a pointer meets of a stage. The triangles are sorted beside its owner.
class PointerInspector {
 public:
  /// Begins to sort the stage's triangles where that is needed, and takes what was sorted.
  void follow(const LitStage& stage, const FrameSettings& frame);

  /// errors   as framedCamera's and placedProxy's
  /// returns  nothing: it is not known yet, or the place is outside of the picture
  Result<std::optional<Inspection>> at(const LitStage& stage, const FrameSettings& frame, glm::vec2 place_px) const;

  /// Whether the triangles of that stage are sorted, or cannot be.
  bool isDone(const LitStage& stage, const FrameSettings& frame) const {
    return isOf(stage, frame) && !sorting_.isRunning();
  }
  bool isRunning() const { return sorting_.isRunning(); }
  const std::string& problem() const { return problem_; }

 private:
  bool isOf(const LitStage& stage, const FrameSettings& frame) const {
    return begun_version_ == stage.version() && begun_relief_ == frame.relief;
  }

  BackgroundTask<std::shared_ptr<const Inspector>> sorting_;
  std::shared_ptr<const Inspector> inspector_;
  int begun_version_ = 0;  // of the stage
  ReliefKind begun_relief_ = ReliefKind::bump;
  std::string problem_;
};

/// What a face draws of it: rows, the paths over the picture, Fresnel's curve.
///
/// frame    as inspected
UnderPointer drawnInspection(const Inspection& inspection, const Camera& camera, glm::ivec2 size_px);

// Colours of the two paths, sRGB-encoded.
inline constexpr glm::vec3 kReflectedColor{1.0f, 0.85f, 0.2f};
inline constexpr glm::vec3 kRefractedColor{0.3f, 0.85f, 1.0f};

}  // namespace mirrorball
