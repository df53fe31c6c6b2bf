#include "mirrorball/gl/context.h"

#include <cassert>
#include <utility>

#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/platform/gl_string.h"
#include "mirrorball/gl/platform/platform.h"

namespace mirrorball::gl {
namespace {

/// State that every part of this room and of the renderer counts on.
void setDefaults(Api api) {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  if (api == Api::desktop43) {  // in OpenGL ES 3.0 both are always on
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glEnable(GL_FRAMEBUFFER_SRGB);
  }
}

}  // namespace

const char* nameOf(Api api) { return api == Api::desktop43 ? "OpenGL 4.3" : "OpenGL ES 3.0"; }

struct Context::State {
  std::unique_ptr<PlatformContext> own;  ///< none of an adopted context
  Api api;
};

Result<Context> Context::createHeadless(Api api) {
  MIRRORBALL_TRY(made, makeHeadlessContext(api));
  enableExtensions();
  setDefaults(api);
  return Context(std::make_unique<State>(State{std::move(made), api}));
}

Result<Context> Context::adoptCurrent() {
  MIRRORBALL_TRY(api, apiOfCurrentContext());
  enableExtensions();
  setDefaults(api);
  return Context(std::make_unique<State>(State{nullptr, api}));
}

Context::Context(std::unique_ptr<State> state) : state_(std::move(state)) {}
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

void Context::makeCurrent() {
  assert(state_->own && "an adopted context is made current by its owner");
  [[maybe_unused]] const bool made = state_->own->makeCurrent();
  assert(made && "the context is current in another thread");
}

Api Context::api() const { return state_->api; }
std::string Context::renderer() const { return glString(GL_RENDERER); }
std::string Context::version() const { return glString(GL_VERSION); }

bool Context::filtersFloats() const {
  return state_->api == Api::desktop43 || hasExtension("GL_OES_texture_float_linear");
}

float Context::largestAnisotropy() const {
  GLfloat largest = 1.0f;
  if (hasExtension("GL_EXT_texture_filter_anisotropic")) glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &largest);
  return largest;
}

int Context::largestTexture() const {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  return largest;
}

}  // namespace mirrorball::gl
