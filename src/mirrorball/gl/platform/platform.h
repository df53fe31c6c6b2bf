#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/context.h"

namespace mirrorball::gl {

// What lies below OpenGL: how a context comes to be, and what of it can be asked and must be enabled. One file of this
// folder is compiled: egl_platform.cpp, or for browsers webgl_platform.cpp.

/// A context that this program has made; it ends with this.
class PlatformContext {
 public:
  virtual ~PlatformContext() = default;
  PlatformContext(const PlatformContext&) = delete;
  PlatformContext& operator=(const PlatformContext&) = delete;

  /// Makes it current in the calling thread, unless it is; false where that is refused.
  virtual bool makeCurrent() = 0;

  /// Makes another context, of whatever thread, that has this one's textures, buffers and programs; null where the
  /// driver refuses it.
  virtual std::unique_ptr<PlatformContext> share() = 0;

 protected:
  PlatformContext() = default;
};

/// Makes a context without a window, and makes it current.
///
/// errors   as Context::createHeadless
Result<std::unique_ptr<PlatformContext>> makeHeadlessContext(Api api);

/// The context that is current in the calling thread, whoever has made it; 0: none is, or it is of a kind that is not
/// known here.
std::uintptr_t currentContext();

/// Makes the context current again that is so now in the calling thread, or none where none is. One of a kind that is
/// not known here is taken for none.
std::function<void()> currentContextRestorer();

/// Which of both APIs the calling thread's current context has.
///
/// errors   no_gl: none is current, or it is older than both
Result<Api> apiOfCurrentContext();

/// Enables what WebGL has only where it is asked for by name: float targets, blending into them, filtering of floats.
/// For the current context.
void enableExtensions();

/// Sets what drawing and uploading depend on and only some contexts have, as a new one has it.
void resetPlatform(Api api);

/// Whether the driver was reset, and the current context has lost all that was in it; drivers tell it once, and of
/// contexts that were made to be told.
bool wasReset();

/// Whether the current context has the extension: "GL_OES_texture_float_linear".
bool hasExtension(const char* name);

}  // namespace mirrorball::gl
