#pragma once

#include <string>

#include "mirrorball/gl/gl_api.h"

namespace mirrorball::gl {

/// What the driver says of GL_VERSION and the like; "unknown" where it says nothing.
inline std::string glString(GLenum what) {
  const GLubyte* text = glGetString(what);
  return text ? reinterpret_cast<const char*>(text) : "unknown";
}

}  // namespace mirrorball::gl
