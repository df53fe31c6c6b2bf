#pragma once

#include <cassert>

#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/sampler.h"

namespace mirrorball::gl {

inline GLint wrapMode(Sampling::Wrap wrap) {
  switch (wrap) {
    case Sampling::Wrap::repeat:
      return GL_REPEAT;
    case Sampling::Wrap::mirrored_repeat:
      return GL_MIRRORED_REPEAT;
    case Sampling::Wrap::clamp_to_edge:
      return GL_CLAMP_TO_EDGE;
  }
  assert(false && "no such wrap mode");
  return GL_CLAMP_TO_EDGE;
}

inline GLint minifyMode(Sampling::Filter filter) {
  switch (filter) {
    case Sampling::Filter::nearest:
      return GL_NEAREST;
    case Sampling::Filter::linear:
      return GL_LINEAR;
    case Sampling::Filter::trilinear:
      return GL_LINEAR_MIPMAP_LINEAR;
  }
  assert(false && "no such filter");
  return GL_NEAREST;
}

/// set(name, value) for each of OpenGL's parameters of a sampling, but for its anisotropy.
template <typename Set>
void forEachParameter(const Sampling& sampling, const Set& set) {
  const bool magnify_nearest = sampling.magnify_nearest || sampling.filter == Sampling::Filter::nearest;
  set(GL_TEXTURE_MIN_FILTER, minifyMode(sampling.filter));
  set(GL_TEXTURE_MAG_FILTER, magnify_nearest ? GL_NEAREST : GL_LINEAR);
  set(GL_TEXTURE_WRAP_S, wrapMode(sampling.wrap_s));
  set(GL_TEXTURE_WRAP_T, wrapMode(sampling.wrap_t));
}

}  // namespace mirrorball::gl
