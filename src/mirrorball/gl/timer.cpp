#include "mirrorball/gl/timer.h"

#include "mirrorball/gl/gl_api.h"

namespace mirrorball::gl {

void deleteQuery(unsigned name) { glDeleteQueries(1, &name); }

void Timer::Reading::take() {
  if (query.name() == 0) {
    unsigned name = 0;
    glGenQueries(1, &name);
    query = Handle<deleteQuery>(name);
  }
  glQueryCounter(query.name(), GL_TIMESTAMP);
}

double Timer::Reading::seconds() const {
  GLuint64 nanoseconds = 0;
  glGetQueryObjectui64v(query.name(), GL_QUERY_RESULT, &nanoseconds);
  return 1e-9 * double(nanoseconds);
}

void Timer::begin(const Context& context) {
  measures_ = context.api() == Api::desktop43;
  if (measures_) begin_.take();
}

void Timer::end() {
  if (measures_) end_.take();
}

std::optional<double> Timer::seconds() const {
  return measures_ ? std::optional(end_.seconds() - begin_.seconds()) : std::nullopt;
}

}  // namespace mirrorball::gl
