#include "mirrorball/gl/timer.h"

#include "mirrorball/gl/gl_api.h"

namespace mirrorball::gl {

void deleteQuery(unsigned name) { glDeleteQueries(1, &name); }

void Timer::begin(const Context& context) {
  if (context.api() != Api::desktop43) return;
  if (query_.name() == 0) {
    unsigned name = 0;
    glGenQueries(1, &name);
    query_ = Handle<deleteQuery>(name);
  }
  glBeginQuery(GL_TIME_ELAPSED, query_.name());
}

void Timer::end() {
  if (query_.name() != 0) glEndQuery(GL_TIME_ELAPSED);
}

std::optional<double> Timer::seconds() const {
  if (query_.name() == 0) return std::nullopt;
  unsigned nanoseconds = 0;
  glGetQueryObjectuiv(query_.name(), GL_QUERY_RESULT, &nanoseconds);
  return 1e-9 * double(nanoseconds);
}

}  // namespace mirrorball::gl
