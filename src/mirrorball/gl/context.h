#pragma once

#include <memory>
#include <string>

#include "mirrorball/base/result.h"

namespace mirrorball::gl {

/// The two dialects that the shaders are written for.
enum class Api {
  desktop43,  ///< OpenGL 4.3 core
  es30,       ///< OpenGL ES 3.0, which is also WebGL 2
};

/// "OpenGL 4.3" or "OpenGL ES 3.0", for messages.
const char* nameOf(Api api);

/// An OpenGL context without a window. Everything else in this room works on the context that is
/// current in the calling thread, and must be destroyed before it.
class Context {
 public:
  /// Makes a context without a display server, and makes it current. Cube maps are filtered across their edges, and
  /// rows of uploaded pixels are tightly packed.
  ///
  /// returns  a context on the first of: a GPU, Mesa's software driver, the default display
  /// errors   no_gl: no driver at all, or all of them too old; the message says what was found and what to install
  /// cost     about 25 ms on Mesa's llvmpipe, of which nearly all is the driver's own start
  static Result<Context> createHeadless(Api api = Api::desktop43);

  /// Takes over the context that is current in the calling thread, for instance a window's. The owner keeps it, makes
  /// it current, and must outlive this object. GL state is set as createHeadless does.
  ///
  /// errors   no_gl: none is current, or it is older than OpenGL 4.3 and OpenGL ES 3.0
  static Result<Context> adoptCurrent();

  Context(Context&&) noexcept;
  Context& operator=(Context&&) noexcept;
  ~Context();

  /// Makes this context current in the calling thread, for programs that have more than one. The owner of an adopted
  /// context makes it current instead.
  void makeCurrent();

  Api api() const;
  std::string renderer() const;  ///< the driver's name for the device: "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string version() const;   ///< the driver's version line: "4.5 (Core Profile) Mesa 22.3.6"
  /// Whether textures of 32-bit floats are interpolated: always, except on OpenGL ES without OES_texture_float_linear.
  bool filtersFloats() const;
  /// The largest Sampling::anisotropy; 1 where the driver has no EXT_texture_filter_anisotropic.
  float largestAnisotropy() const;
  int largestTexture() const;  ///< the longest side in texels of a 2D texture or a framebuffer

 private:
  struct State;
  explicit Context(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace mirrorball::gl
