#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/gl/context.h"
#include "mirrorball/image/image.h"
#include "mirrorball/render/frame/frame_settings.h"
#include "mirrorball/render/light/environment_light.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// What the light that surfaces reflect takes, beside time.
struct LightCost {
  std::size_t texture_bytes = 0;  ///< of the textures that are read for it
  int reads = 0;                  ///< of those textures, for a sample of a pixel (render/surface/light_reads.h)
};

/// Draws a scene in an environment. It owns both, and each may be replaced between frames.
///
/// A frame is: the background, the objects (each lit by the whole environment, and by point lights if there are any),
/// drawn once for each sample of a pixel with the picture shifted within the pixel, and the mean of them all, as light
/// of the display or as radiance. It is drawn at once (render, draw) or sample by sample (begin, drawSample, show), for
/// windows that must respond in between.
///
/// Each call makes its context current, and leaves it so; several renderers live side by side in one thread. After the
/// end of one with a context of its own, none is current. An adopted context must be current, else calls fail with
/// no_gl and its end leaves OpenGL's objects to the context; each call sets the state that it needs
/// (gl::Context::enter), whatever the host's is, and the end gives it back as `leave` does.
///
/// Before the first frame it needs an environment; without a scene, it shows only the environment.
class Renderer {
 public:
  /// On an OpenGL context of its own, without a window.
  ///
  /// errors   no_gl
  static Result<Renderer> headless();
  /// On that context, which is current: a window's is Context::adoptCurrent.
  ///
  /// errors   no_gl; unsupported (it does not compile a shader)
  static Result<Renderer> on(gl::Context context);

  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  /// errors   no_gl; too_large (a texture for this driver): then the scene is as before
  Result<void> setScene(Scene scene);

  /// Prepares the environment for drawing, and takes it; values below 0 become 0.
  ///
  /// cache    stores slow results for later processes; optional
  /// errors   no_gl; too_large
  /// cost     about a second on two cores, for a panorama of 1024 rows that is not in the cache;
  ///          some 50 ms for one that is
  Result<void> setEnvironment(Environment environment, const std::optional<CacheFolder>& cache = {});
  /// The same for an environment that was prepared elsewhere, for instance in another thread.
  ///
  /// errors   no_gl; too_large (a texture for this driver)
  Result<void> setEnvironment(Environment environment, const PreparedEnvironment& prepared);

  /// The driver's name for its device: "llvmpipe (LLVM 15.0.6, 256 bits)".
  std::string driver() const;
  /// Of the last frame, without its background.
  LightCost lightCost() const;

  const Scene& scene() const;
  /// Of the scene.
  const BoundingSphere& bounds() const;
  /// Puts the scene's instances elsewhere: as many, of the same meshes.
  ///
  /// errors   no_gl
  Result<void> moveInstances(const std::vector<Instance>& instances);
  /// How often a probe was captured until now: only what has changed is captured again.
  int probeCaptures() const;

  /// Draws a frame, exposed and tone mapped as the settings say,
  /// over its background where that is a display's colour, and sRGB-encoded.
  ///
  /// progress  is called after each sample of the pixels
  /// returns   4 channels, straight alpha, row 0 at the top
  /// errors    as draw's
  Result<Image8> render(const FrameSettings& settings, const ProgressFunction& progress = {});
  /// The same as linear radiance, whatever the settings' `resolve` says: 4 channels, premultiplied alpha.
  Result<Image> renderRadiance(const FrameSettings& settings, const ProgressFunction& progress = {});

  /// Draws a frame; `radiance`, `picture` and `show` then give this frame.
  ///
  /// errors    too_large; no_gl (also: the driver cannot draw floats); unsupported (it does not compile a shader);
  ///           interrupted (when `progress` says so)
  Result<void> draw(const FrameSettings& settings, const ProgressFunction& progress = {});
  /// The same with another camera than that of the settings.
  Result<void> draw(const Camera& camera, const FrameSettings& settings, const ProgressFunction& progress = {});

  /// Begins a frame, without drawing anything yet.
  ///
  /// errors   as draw's
  Result<void> begin(const FrameSettings& settings);
  Result<void> begin(const Camera& camera, const FrameSettings& settings);
  /// Draws the next sample of all pixels of the frame, if there is one left.
  ///
  /// returns  how many there are now
  /// errors   no_gl; unsupported
  Result<int> drawSample();

  /// Shows the mean of the samples that there are in a framebuffer, as a picture: exposed, tone mapped and encoded, row
  /// 0 at the bottom. It fills the lower left corner as far as it goes.
  ///
  /// framebuffer  OpenGL's name of it, of 8 bits a channel; 0 is a window's. It stays bound
  /// errors       no_gl
  Result<void> show(unsigned framebuffer) const;

  /// Gives a context that was taken over back to its host, with the state of a new one; the next call takes it again.
  ///
  /// errors   no_gl
  Result<void> leave() const;

  /// Linear radiance: 4 channels, premultiplied alpha, row 0 at the top. Of a whole frame with Resolve::radiance.
  ///
  /// errors   no_gl
  Result<Image> radiance() const;
  /// The whole frame as `render` returns it.
  Result<Image8> picture();

 private:
  struct State;
  struct End {
    void operator()(State* state) const;
  };
  using OwnedState = std::unique_ptr<State, End>;
  Result<Camera> cameraFor(const FrameSettings& settings) const;
  explicit Renderer(OwnedState state);
  OwnedState state_;
};

}  // namespace mirrorball
