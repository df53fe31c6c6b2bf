#pragma once

#include <functional>
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

/// An OpenGL context, made without a window or taken over. Everything else in this room works on the context that is
/// current in the calling thread, and must be destroyed before it, while it is current or under a Deletion.
class Context {
 public:
  /// Makes a context without a display server, and makes it current. Cube maps are filtered across their edges, and
  /// rows of uploaded pixels are tightly packed.
  ///
  /// returns  a context on the first of: a GPU, Mesa's software driver, the default display
  /// errors   no_gl: no driver at all, or all of them too old; the message says what was found and what to install
  /// cost     about 25 ms on Mesa's llvmpipe, of which nearly all is the driver's own start
  static Result<Context> createHeadless(Api api = Api::desktop43);

  /// Takes over the context that is current in the calling thread, for instance a window's. The owner keeps it, and it
  /// must outlive this object. GL state is set as createHeadless does.
  ///
  /// errors   no_gl: none is current, or it is older than OpenGL 4.3 and OpenGL ES 3.0
  static Result<Context> adoptCurrent();

  /// Makes a context that has the textures, buffers, samplers and programs of this one, and makes it current in the
  /// calling thread. Framebuffers and vertex arrays are each context's own.
  ///
  /// errors   no_gl: this context was taken over, or the driver makes no such context
  Result<Context> share() const;
  /// Whether this context was made here, as share() needs it.
  bool isOurs() const;

  Context(Context&&) noexcept;
  Context& operator=(Context&&) noexcept;
  ~Context();

  /// Makes this context current in the calling thread, which costs nothing if it is. An adopted one is made current by
  /// its owner; here it is only asked for.
  ///
  /// errors   no_gl: it is current in another thread, or adopted and not current
  Result<void> makeCurrent() const;

  // A context that is taken over has a host with a state of its own: a window's library that clips, blends and leaves
  // its textures bound. Between enter() and leave() the context is ours. One of our own both only make current.

  /// Sets all state that this room and the renderer count on and do not set at each draw.
  ///
  /// errors   as makeCurrent's; no_gl: the driver was reset, and the context never draws again
  /// cost     some 50 calls of OpenGL, none of which waits
  Result<void> enter() const;
  /// Sets the state that they change, but for the viewport, as a new context has it: no textures, buffers and programs
  /// are bound.
  ///
  /// errors   as makeCurrent's
  Result<void> leave() const;

  Api api() const;
  const std::string& renderer() const;  ///< the driver's name for the device: "llvmpipe (LLVM 15.0.6, 256 bits)"
  const std::string& version() const;   ///< the driver's version line: "4.5 (Core Profile) Mesa 22.3.6"
  /// Whether textures of 32-bit floats are interpolated: always, except on OpenGL ES without OES_texture_float_linear.
  bool filtersFloats() const;
  /// The largest Sampling::anisotropy; 1 where the driver has no EXT_texture_filter_anisotropic.
  float largestAnisotropy() const;
  /// Whether it compiles a program in the thread that first draws with it, and keeps what it has compiled for other
  /// contexts: Mesa's software driver, unless its cache is off or has no folder. It writes there in another thread, so
  /// that what was compiled just now may not be found yet. Not for a loop: this looks at the disk.
  bool compilesWhenDrawing() const;
  int largestTexture() const;  ///< the longest side in texels of a 2D texture or a framebuffer

 private:
  struct State;
  explicit Context(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// While it lives, what is destroyed in this thread is deleted from that context, which it makes current. If that is
/// not possible, nothing is deleted: its names may be others' in the context that is current. At its end the context is
/// current again that was before, unless it has ended or is of a kind that gl/platform does not know.
class Deletion {
 public:
  explicit Deletion(const Context& context);
  ~Deletion();
  Deletion(const Deletion&) = delete;
  Deletion& operator=(const Deletion&) = delete;

 private:
  bool before_;                    // the thread's state
  std::function<void()> restore_;  // null: none was current
};

}  // namespace mirrorball::gl
