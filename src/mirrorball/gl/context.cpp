#include "mirrorball/gl/context.h"

#include <cassert>
#include <functional>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace mirrorball::gl {

/// A display that is initialised, for as long as a context on it lives.
struct Display {
  EGLDisplay handle;
  explicit Display(EGLDisplay initialised) : handle(initialised) {}
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;
  ~Display() { eglTerminate(handle); }
};

namespace {

constexpr const char* kHowToInstall =
    "on Debian install libegl1 libopengl0 libgles2 libgl1-mesa-dri, which draw without a GPU too";

/// A way to reach a driver, which costs nothing until it is opened.
struct Candidate {
  std::string name;
  std::function<EGLDisplay()> open;
};

/// Like epoxy_has_egl_extension, which asks only about displays.
bool clientHas(const char* extension) {
  const char* all = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  return all != nullptr && epoxy_extension_in_string(all, extension);
}

/// A function of an extension. libepoxy ends the process when it is asked for one that is missing.
template <typename Function>
Function extensionFunction(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

/// The devices that EGL knows of, GPUs apart from software.
struct Devices {
  std::vector<EGLDeviceEXT> hardware;
  std::vector<EGLDeviceEXT> software;
};

Devices findDevices() {
  Devices found;
  if (!clientHas("EGL_EXT_platform_device")) return found;
  if (!clientHas("EGL_EXT_device_enumeration") && !clientHas("EGL_EXT_device_base")) return found;
  const auto query_devices = extensionFunction<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  const auto query_string = extensionFunction<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  EGLint count = 0;
  if (!query_devices || !query_devices(0, nullptr, &count) || count <= 0) return found;
  std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
  if (!query_devices(count, devices.data(), &count)) return found;
  devices.resize(static_cast<std::size_t>(count));
  for (EGLDeviceEXT device : devices) {
    const char* about = query_string ? query_string(device, EGL_EXTENSIONS) : nullptr;
    const bool software = about != nullptr && epoxy_extension_in_string(about, "EGL_MESA_device_software");
    (software ? found.software : found.hardware).push_back(device);
  }
  return found;
}

/// Every way to a driver, the fastest driver first. Mesa's surfaceless platform comes before its
/// software device, which is the same llvmpipe, because older versions of Mesa lack the latter.
std::vector<Candidate> findCandidates() {
  std::vector<Candidate> candidates;
  if (!epoxy_has_egl()) return candidates;
  const auto platform_display = extensionFunction<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  const Devices devices = platform_display ? findDevices() : Devices{};
  const auto add_device = [&](EGLDeviceEXT device, const char* name) {
    candidates.push_back({name, [=] { return platform_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr); }});
  };
  for (EGLDeviceEXT device : devices.hardware) add_device(device, "GPU");
  if (platform_display && clientHas("EGL_MESA_platform_surfaceless")) {
    candidates.push_back({"surfaceless display", [=] {
                            return platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
                          }});
  }
  for (EGLDeviceEXT device : devices.software) add_device(device, "software device");
  candidates.push_back({"default display", [] { return eglGetDisplay(EGL_DEFAULT_DISPLAY); }});
  return candidates;
}

/// Initialises a display, or shares it with the contexts that are on it already: EGL counts a
/// display's initialisations as one, so that the first eglTerminate would end them all.
std::shared_ptr<Display> initialise(EGLDisplay handle) {
  static std::mutex mutex;
  static std::map<EGLDisplay, std::weak_ptr<Display>> known;
  if (handle == EGL_NO_DISPLAY) return nullptr;
  const std::lock_guard lock(mutex);
  if (auto display = known[handle].lock()) return display;
  if (!eglInitialize(handle, nullptr, nullptr)) return nullptr;
  auto display = std::make_shared<Display>(handle);
  known[handle] = display;
  return display;
}

bool bindApi(Api api) { return eglBindAPI(api == Api::desktop43 ? EGL_OPENGL_API : EGL_OPENGL_ES_API) == EGL_TRUE; }

/// Whether the library is there that libepoxy takes the API's functions from: it ends the process
/// when it is not.
bool hasLibrary(Api api) {
  // Not closed again, since libepoxy opens it next.
  if (api == Api::es30) return dlopen("libGLESv2.so.2", RTLD_LAZY) != nullptr;
  return dlopen("libOpenGL.so.0", RTLD_LAZY) != nullptr || dlopen("libGL.so.1", RTLD_LAZY) != nullptr;
}

EGLContext createContext(EGLDisplay display, Api api) {
  constexpr EGLint kDesktop[] = {
      EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  constexpr EGLint kEmbedded[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
  return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, api == Api::desktop43 ? kDesktop : kEmbedded);
}

std::string glString(GLenum what) {
  const GLubyte* text = glGetString(what);
  return text ? reinterpret_cast<const char*>(text) : "unknown";
}

/// Says what a driver that refuses our version offers instead.
std::string describeOldDriver(EGLDisplay display, Api api) {
  const EGLint any_version[] = {EGL_NONE};
  EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, any_version);
  if (context == EGL_NO_CONTEXT) return {};
  std::string text;
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    text = "the driver \"" + glString(GL_RENDERER) + "\" offers only version " + glString(GL_VERSION) + "; " +
           nameOf(api) + " is needed";
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  eglDestroyContext(display, context);
  return text;
}

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
  std::shared_ptr<Display> display;  ///< none of an adopted context
  EGLContext context = EGL_NO_CONTEXT;
  Api api = Api::desktop43;

  State(std::shared_ptr<Display> on, EGLContext made, Api of) : display(std::move(on)), context(made), api(of) {}
  explicit State(Api of) : api(of) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (!display) return;
    bindApi(api);  // eglGetCurrentContext answers for the API that is bound
    if (eglGetCurrentContext() == context) {
      eglMakeCurrent(display->handle, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(display->handle, context);
  }
};

Result<Context> Context::createHeadless(Api api) {
  const std::vector<Candidate> candidates = findCandidates();
  if (candidates.empty()) {
    return fail(ErrorCode::no_gl, std::string("no EGL library found; ") + kHowToInstall);
  }
  if (!hasLibrary(api)) {
    return fail(ErrorCode::no_gl, std::string("no library for ") + nameOf(api) + " found; " + kHowToInstall);
  }
  std::string tried;
  std::string too_old;
  for (const Candidate& candidate : candidates) {
    tried += (tried.empty() ? "" : ", ") + candidate.name;
    std::shared_ptr<Display> display = initialise(candidate.open());
    if (!display) continue;
    if (!epoxy_has_egl_extension(display->handle, "EGL_KHR_surfaceless_context") ||
        !epoxy_has_egl_extension(display->handle, "EGL_KHR_no_config_context")) {
      tried += " (draws only into windows)";
      continue;
    }
    if (!bindApi(api)) {
      tried += std::string(" (without ") + nameOf(api) + ")";
      continue;
    }
    EGLContext handle = createContext(display->handle, api);
    if (handle == EGL_NO_CONTEXT) {
      if (too_old.empty()) too_old = describeOldDriver(display->handle, api);
      continue;
    }
    Context context(std::make_unique<State>(std::move(display), handle, api));
    if (!eglMakeCurrent(context.state_->display->handle, EGL_NO_SURFACE, EGL_NO_SURFACE, handle)) {
      tried += " (context refused)";
      continue;
    }
    setDefaults(api);
    return context;
  }
  if (!too_old.empty()) return fail(ErrorCode::no_gl, too_old);
  return fail(ErrorCode::no_gl,
              std::string("no driver for ") + nameOf(api) + " found (tried: " + tried + "); " + kHowToInstall);
}

Result<Context> Context::adoptCurrent() {
  if (glGetString(GL_VERSION) == nullptr)
    return fail(ErrorCode::no_gl, "no OpenGL context is current in this thread; make the window's current first");
  const Api api = epoxy_is_desktop_gl() ? Api::desktop43 : Api::es30;
  if (epoxy_gl_version() < (api == Api::desktop43 ? 43 : 30))
    return fail(ErrorCode::no_gl,
                "the current OpenGL context is of version " + glString(GL_VERSION) + "; " + nameOf(api) + " is needed");
  setDefaults(api);
  return Context(std::make_unique<State>(api));
}

Context::Context(std::unique_ptr<State> state) : state_(std::move(state)) {}
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

void Context::makeCurrent() {
  assert(state_->display && "an adopted context is made current by its owner");
  bindApi(state_->api);
  [[maybe_unused]] const EGLBoolean made =
      eglMakeCurrent(state_->display->handle, EGL_NO_SURFACE, EGL_NO_SURFACE, state_->context);
  assert(made && "the context is current in another thread");
}

Api Context::api() const { return state_->api; }
std::string Context::renderer() const { return glString(GL_RENDERER); }
std::string Context::version() const { return glString(GL_VERSION); }

bool Context::filtersFloats() const {
  return state_->api == Api::desktop43 || epoxy_has_gl_extension("GL_OES_texture_float_linear");
}

float Context::largestAnisotropy() const {
  GLfloat largest = 1.0f;
  if (epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic"))
    glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &largest);
  return largest;
}

int Context::largestTexture() const {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  return largest;
}

}  // namespace mirrorball::gl
