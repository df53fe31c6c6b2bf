#pragma once

#include <optional>

#include "mirrorball/gl/context.h"
#include "mirrorball/gl/handle.h"

namespace mirrorball::gl {

void deleteQuery(unsigned name);

/// How long the GPU works on what is drawn between begin() and end(), by its own clock.
class Timer {
 public:
  /// Begins to measure; one timer at a time. Without OpenGL (as in OpenGL ES) it measures nothing.
  void begin(const Context& context);
  void end();

  /// The time of what was drawn [s], at most 4.29; waits until that is done. Nothing: it was not measured.
  std::optional<double> seconds() const;

 private:
  Handle<deleteQuery> query_;
};

}  // namespace mirrorball::gl
