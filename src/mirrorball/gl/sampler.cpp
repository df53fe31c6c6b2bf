#include "mirrorball/gl/sampler.h"

#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/sampling_parameters.h"

namespace mirrorball::gl {
namespace {

GLuint newSampler() {
  GLuint name = 0;
  glGenSamplers(1, &name);
  return name;
}

}  // namespace

void Sampler::destroy(unsigned name) { glDeleteSamplers(1, &name); }

Sampler::Sampler(const Sampling& sampling) : handle_(newSampler()) {
  forEachParameter(sampling, [this](GLenum name, GLint value) { glSamplerParameteri(handle_.name(), name, value); });
  // Drivers without the extension know no such parameter.
  if (sampling.anisotropy > 1.0f)
    glSamplerParameterf(handle_.name(), GL_TEXTURE_MAX_ANISOTROPY_EXT, sampling.anisotropy);
}

}  // namespace mirrorball::gl
