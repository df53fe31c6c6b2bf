#pragma once

#include <memory>

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"

namespace mirrorball {

/// What frames of a kind need of a stage's scene and takes long, done apart from the stage: in any thread, while the
/// stage is drawn and changes. Stage::workFor gives it, and Stage::take shows what has become of it.
class StageWork {
 public:
  struct State;
  explicit StageWork(std::unique_ptr<State> state);
  StageWork(StageWork&&) noexcept;
  StageWork& operator=(StageWork&&) noexcept;
  ~StageWork();

  /// Does what the stage has not yet, once: the relief that the frames show (prepareRelief), what vertices know of the
  /// scene (findOcclusionOnce), the prisms and trees of triangles that rays in shaders go through, where a ground's
  /// shadow comes from and what throws it, and the triangles in which places are picked. No OpenGL is called.
  ///
  /// progress  may be called from several threads, but not at once
  /// errors    interrupted; as those functions'
  Result<void> run(const ProgressFunction& progress = {});

  /// Whether that is anything: else frames have all that they need, or make it in no time.
  bool isNeeded() const;

  State& state() const { return *state_; }

 private:
  std::unique_ptr<State> state_;
};

}  // namespace mirrorball
