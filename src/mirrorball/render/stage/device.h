#pragma once

#include <memory>
#include <string>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/context.h"

namespace mirrorball {

/// What draws: an OpenGL context with the shader programs and tables that all stages and views on it share. A copy is
/// the same device. It lives as long as what is made on it.
///
/// A device, its stages and its views are of the thread that made it. Several live side by side in one thread: each
/// call of a stage or a view makes its device's context current, and leaves it so; the end of something leaves the
/// context current that was. An adopted context must be current, else calls fail with no_gl and an end leaves OpenGL's
/// objects to the context; each call sets the state that it needs (gl::Context::enter), whatever the host's is, and the
/// device's end gives it back as `leave` does.
class Device {
 public:
  /// On an OpenGL context of its own, without a window.
  ///
  /// errors   no_gl
  static Result<Device> headless();
  /// On that context, which is current: a window's is Context::adoptCurrent.
  ///
  /// errors   no_gl
  static Result<Device> on(gl::Context context);

  /// The driver's name for it: "llvmpipe (LLVM 15.0.6, 256 bits)".
  std::string driver() const;

  /// Gives a context that was taken over back to its host, with the state of a new one; the next call of a stage or a
  /// view takes it again.
  ///
  /// errors   no_gl
  Result<void> leave() const;

  /// Whether they are the same device.
  bool operator==(const Device&) const = default;

  struct State;
  State& state() const { return *state_; }

 private:
  explicit Device(std::shared_ptr<State> state) : state_(std::move(state)) {}
  std::shared_ptr<State> state_;
};

}  // namespace mirrorball
