#pragma once

#include <optional>

#include "mirrorball/gl/context.h"
#include "mirrorball/gl/handle.h"

namespace mirrorball::gl {

void deleteQuery(unsigned name);

/// How long the GPU works on what is drawn between begin() and end(), by its own clock. Two readings of the clock, not
/// GL_TIME_ELAPSED, of which llvmpipe measures the last picture that was drawn into alone.
class Timer {
 public:
  /// Begins to measure. Without OpenGL (as in OpenGL ES) it measures nothing.
  void begin(const Context& context);
  void end();

  /// The time of what was drawn [s]; waits until that is done. Nothing: it was not measured.
  std::optional<double> seconds() const;

 private:
  struct Reading {
    Handle<deleteQuery> query;
    void take();
    double seconds() const;
  };
  bool measures_ = false;
  Reading begin_;
  Reading end_;
};

}  // namespace mirrorball::gl
