// Contexts without a window, by EGL, on GPUs and on Mesa's software driver.

#include <functional>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include <dlfcn.h>
#include <epoxy/egl.h>

#include "mirrorball/gl/platform/gl_string.h"
#include "mirrorball/gl/platform/platform.h"

namespace mirrorball::gl {
namespace {

/// A display that is initialised, for as long as a context on it lives.
struct Display {
  EGLDisplay handle;
  explicit Display(EGLDisplay initialised) : handle(initialised) {}
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;
  ~Display() { eglTerminate(handle); }
};

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

/// shared   whose objects it has, too; EGL_NO_CONTEXT: none's
EGLContext createContext(EGLDisplay display, Api api, EGLContext shared) {
  constexpr EGLint kDesktop[] = {
      EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  constexpr EGLint kEmbedded[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
  return eglCreateContext(display, EGL_NO_CONFIG_KHR, shared, api == Api::desktop43 ? kDesktop : kEmbedded);
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

class EglContext : public PlatformContext {
 public:
  EglContext(std::shared_ptr<Display> display, EGLContext context, Api api)
      : display_(std::move(display)), context_(context), api_(api) {}

  ~EglContext() override {
    bindApi(api_);  // eglGetCurrentContext answers for the API that is bound
    if (eglGetCurrentContext() == context_) {
      eglMakeCurrent(display_->handle, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(display_->handle, context_);
  }

  bool makeCurrent() override {
    bindApi(api_);
    if (eglGetCurrentContext() == context_) return true;
    return eglMakeCurrent(display_->handle, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }

  std::unique_ptr<PlatformContext> share() override {
    if (!bindApi(api_)) return nullptr;
    EGLContext made = createContext(display_->handle, api_, context_);
    if (made == EGL_NO_CONTEXT) return nullptr;
    return std::make_unique<EglContext>(display_, made, api_);
  }

 private:
  std::shared_ptr<Display> display_;
  EGLContext context_;
  Api api_;
};

}  // namespace

Result<std::unique_ptr<PlatformContext>> makeHeadlessContext(Api api) {
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
    EGLContext handle = createContext(display->handle, api, EGL_NO_CONTEXT);
    if (handle == EGL_NO_CONTEXT) {
      if (too_old.empty()) too_old = describeOldDriver(display->handle, api);
      continue;
    }
    auto context = std::make_unique<EglContext>(std::move(display), handle, api);
    if (context->makeCurrent()) return context;
    tried += " (context refused)";
  }
  if (!too_old.empty()) return fail(ErrorCode::no_gl, too_old);
  return fail(ErrorCode::no_gl,
              std::string("no driver for ") + nameOf(api) + " found (tried: " + tried + "); " + kHowToInstall);
}

std::function<void()> currentContextRestorer() {
  if (!epoxy_has_egl()) return {};
  if (eglGetCurrentContext() == EGL_NO_CONTEXT)
    return [] { eglMakeCurrent(eglGetCurrentDisplay(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); };
  return [api = eglQueryAPI(), display = eglGetCurrentDisplay(), draw = eglGetCurrentSurface(EGL_DRAW),
          read = eglGetCurrentSurface(EGL_READ), context = eglGetCurrentContext()] {
    eglBindAPI(api);
    eglMakeCurrent(display, draw, read, context);
  };
}

// EGL's, or that of X11's own way to OpenGL, which libraries for windows may choose.
std::uintptr_t currentContext() {
  if (epoxy_has_egl())
    if (const EGLContext context = eglGetCurrentContext(); context != EGL_NO_CONTEXT)
      return reinterpret_cast<std::uintptr_t>(context);
  for (const char* library : {"libGL.so.1", "libGLX.so.0"}) {
    void* const loaded = dlopen(library, RTLD_LAZY | RTLD_NOLOAD);
    if (!loaded) continue;
    const auto current = reinterpret_cast<void* (*)()>(dlsym(loaded, "glXGetCurrentContext"));
    const auto context = current ? reinterpret_cast<std::uintptr_t>(current()) : 0;
    dlclose(loaded);  // counts as it did before
    if (context != 0) return context;
  }
  return 0;
}

Result<Api> apiOfCurrentContext() {
  if (glGetString(GL_VERSION) == nullptr)
    return fail(ErrorCode::no_gl, "no OpenGL context is current in this thread; make the window's current first");
  const Api api = epoxy_is_desktop_gl() ? Api::desktop43 : Api::es30;
  if (epoxy_gl_version() < (api == Api::desktop43 ? 43 : 30))
    return fail(ErrorCode::no_gl,
                "the current OpenGL context is of version " + glString(GL_VERSION) + "; " + nameOf(api) + " is needed");
  return api;
}

// A driver's extensions are there unasked.
void enableExtensions() {}

void resetPlatform(Api api) {
  glDisable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
  if (api == Api::es30) return;
  for (const GLenum capability : {GL_COLOR_LOGIC_OP, GL_PRIMITIVE_RESTART, GL_SAMPLE_MASK, GL_DEPTH_CLAMP})
    glDisable(capability);
  constexpr GLenum kClipDistances = 8;  // that OpenGL promises
  for (GLenum i = 0; i < kClipDistances; ++i) glDisable(GL_CLIP_DISTANCE0 + i);
  for (const GLenum parameter : {GL_PACK_SWAP_BYTES, GL_UNPACK_SWAP_BYTES, GL_PACK_LSB_FIRST, GL_UNPACK_LSB_FIRST})
    glPixelStorei(parameter, GL_FALSE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  if (hasExtension("GL_ARB_clip_control")) glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
}

bool wasReset() {
  const int tells_since = epoxy_is_desktop_gl() ? 45 : 32;
  if (epoxy_gl_version() >= tells_since || hasExtension("GL_KHR_robustness"))
    return glGetGraphicsResetStatus() != GL_NO_ERROR;
  return hasExtension("GL_ARB_robustness") && glGetGraphicsResetStatusARB() != GL_NO_ERROR;
}

bool hasExtension(const char* name) { return epoxy_has_gl_extension(name); }

}  // namespace mirrorball::gl
