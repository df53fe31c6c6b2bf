#include "mirrorball/gl/context.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <utility>

#include <unistd.h>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"
#include "mirrorball/gl/context_state.h"
#include "mirrorball/gl/driver_cache.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/handle.h"
#include "mirrorball/gl/platform/gl_string.h"
#include "mirrorball/gl/platform/platform.h"

namespace mirrorball::gl {
namespace {

/// One of the driver's numbers: `get` is glGetFloatv or glGetIntegerv.
template <typename Number, typename Get>
Number ask(Get get, GLenum of) {
  Number number{};
  get(of, &number);
  return number;
}

}  // namespace

const char* nameOf(Api api) { return api == Api::desktop43 ? "OpenGL 4.3" : "OpenGL ES 3.0"; }

struct Context::State {
  std::unique_ptr<PlatformContext> own;  ///< none of an adopted context
  Api api;
  std::uintptr_t adopted;  ///< currentContext() then; 0: it is not known
  // What drivers say only of the current context:
  std::string renderer = glString(GL_RENDERER);
  std::string version = glString(GL_VERSION);
  bool filters_floats = api == Api::desktop43 || hasExtension("GL_OES_texture_float_linear");
  float largest_anisotropy = hasExtension("GL_EXT_texture_filter_anisotropic")
                                 ? ask<GLfloat>(glGetFloatv, GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT)
                                 : 1.0f;
  bool is_lost = false;
  int largest_texture = ask<GLint>(glGetIntegerv, GL_MAX_TEXTURE_SIZE);
};

Result<Context> Context::createHeadless(Api api) {
  // Mesa 22.3 crashes where an allocation fails while it compiles a shader (a double free in its software driver).
  constexpr std::uint64_t kOfDriver = std::uint64_t{1} << 30;
  if (addressSpaceLeft() < kOfDriver)
    return fail(ErrorCode::too_large,
                "an OpenGL driver needs " + textOfBytes(kOfDriver) + " of address space; raise `ulimit -v`");
  MIRRORBALL_TRY(made, makeHeadlessContext(api));
  enableExtensions();
  setOurState(api);
  return Context(std::make_unique<State>(State{std::move(made), api, 0}));
}

Result<Context> Context::adoptCurrent() {
  MIRRORBALL_TRY(api, apiOfCurrentContext());
  enableExtensions();
  setOurState(api);
  return Context(std::make_unique<State>(State{nullptr, api, currentContext()}));
}

Result<Context> Context::share() const {
  std::unique_ptr<PlatformContext> made = state_->own ? state_->own->share() : nullptr;
  if (!made || !made->makeCurrent()) return fail(ErrorCode::no_gl, "the graphics driver makes no context that shares");
  setOurState(state_->api);
  return Context(std::make_unique<State>(State{std::move(made), state_->api, 0}));
}

bool Context::isOurs() const { return state_->own != nullptr; }

Context::Context(std::unique_ptr<State> state) : state_(std::move(state)) {}
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

Result<void> Context::makeCurrent() const {
  if (state_->own) {
    if (state_->own->makeCurrent()) return {};
    return fail(ErrorCode::no_gl, "this OpenGL context is current in another thread; make none current there first");
  }
  if (state_->adopted == 0 || state_->adopted == currentContext()) return {};
  return fail(ErrorCode::no_gl,
              "the OpenGL context that was taken over is not current in this thread; make it so first");
}

Result<void> Context::enter() const {
  MIRRORBALL_TRY_VOID(makeCurrent());
  if (state_->own) return {};
  state_->is_lost = state_->is_lost || wasReset();
  if (state_->is_lost) return fail(ErrorCode::no_gl, "the graphics driver was reset and has lost what was in it");
  setOurState(state_->api);
  return {};
}

Result<void> Context::leave() const {
  MIRRORBALL_TRY_VOID(makeCurrent());
  if (!state_->own) setInitialState(state_->api);
  return {};
}

Deletion::Deletion(const Context& context) : before_(leaves_names), restore_(currentContextRestorer()) {
  const std::uintptr_t current = currentContext();
  leaves_names = !context.makeCurrent();
  if (current == currentContext()) restore_ = {};  // it may end with what is deleted
}

Deletion::~Deletion() {
  leaves_names = before_;
  if (restore_) restore_();
}

Api Context::api() const { return state_->api; }
const std::string& Context::renderer() const { return state_->renderer; }
const std::string& Context::version() const { return state_->version; }
bool Context::filtersFloats() const { return state_->filters_floats; }
float Context::largestAnisotropy() const { return state_->largest_anisotropy; }
bool Context::compilesWhenDrawing() const {
  if (!renderer().starts_with("llvmpipe")) return false;
  const std::optional<DriverCache> cache = findDriverCache(version());
  if (!cache || !cache->is_on.value_or(false)) return false;
  // Mesa makes its folder with the first context, if it can.
  return std::any_of(cache->folders.begin(), cache->folders.end(),
                     [](const std::filesystem::path& folder) { return ::access(folder.c_str(), W_OK) == 0; });
}
int Context::largestTexture() const { return state_->largest_texture; }

}  // namespace mirrorball::gl
