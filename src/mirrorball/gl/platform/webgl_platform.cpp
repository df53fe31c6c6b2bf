// A page's WebGL 2, by Emscripten.

#include <emscripten/html5.h>

#include "mirrorball/gl/platform/gl_string.h"
#include "mirrorball/gl/platform/platform.h"

namespace mirrorball::gl {
namespace {

/// WebGL knows an extension only once it is asked for. Where the device lacks one, hasExtension says so.
constexpr const char* kWanted[] = {
    "EXT_color_buffer_float",          // float targets
    "EXT_float_blend",                 // sums of samples in them
    "OES_texture_float_linear",        // filtering of 32-bit floats
    "EXT_texture_filter_anisotropic",  // Context::largestAnisotropy
};

bool enable(const char* name) {
  return emscripten_webgl_enable_extension(emscripten_webgl_get_current_context(), name) == EM_TRUE;
}

}  // namespace

Result<std::unique_ptr<PlatformContext>> makeHeadlessContext(Api) {
  return fail(ErrorCode::no_gl, "in a browser a context belongs to a canvas; make one of WebGL 2 current and adopt it");
}

std::uintptr_t currentContext() { return static_cast<std::uintptr_t>(emscripten_webgl_get_current_context()); }

std::function<void()> currentContextRestorer() {
  const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = emscripten_webgl_get_current_context();
  return [context] { emscripten_webgl_make_context_current(context); };
}

Result<Api> apiOfCurrentContext() {
  EmscriptenWebGLContextAttributes attributes;
  const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = emscripten_webgl_get_current_context();
  if (context == 0 || emscripten_webgl_get_context_attributes(context, &attributes) != EMSCRIPTEN_RESULT_SUCCESS)
    return fail(ErrorCode::no_gl, "no WebGL context is current; make the canvas's current first");
  if (attributes.majorVersion < 2)
    return fail(ErrorCode::no_gl, "the current context is of \"" + glString(GL_VERSION) + "\"; WebGL 2 is needed");
  return Api::es30;
}

void enableExtensions() {
  for (const char* name : kWanted) enable(name);
}

// What pages' libraries set for their own pictures, and uploads from memory obey.
void resetPlatform(Api) {
  constexpr GLenum kFlipY = 0x9240;             // UNPACK_FLIP_Y_WEBGL
  constexpr GLenum kPremultiplyAlpha = 0x9241;  // UNPACK_PREMULTIPLY_ALPHA_WEBGL
  glPixelStorei(kFlipY, 0);
  glPixelStorei(kPremultiplyAlpha, 0);
}

// A page is told by an event.
bool wasReset() { return false; }

// Whether it could be enabled, as it is by that; WebGL's names lack OpenGL's "GL_".
bool hasExtension(const char* name) { return enable(name + 3); }

}  // namespace mirrorball::gl
