#pragma once

#include <memory>

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/gl/context.h"
#include "mirrorball/image/image.h"
#include "mirrorball/render/frame/render_options.h"
#include "mirrorball/render/light/environment_light.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Draws a scene in an environment on the current GL context.
///
/// A frame is: the background, the objects (each lit by the whole environment, and by point lights if there are any),
/// drawn once for each sample of a pixel with the picture shifted within the pixel, and the mean of them all, as light of
/// the display or as radiance.
class Renderer {
 public:
  /// Uploads everything. `scene` and `environment` must outlive the renderer.
  ///
  /// errors   too_large (a texture for this driver)
  static Result<Renderer> make(const gl::Context& context, const Scene& scene, const Environment& environment,
                               const PreparedEnvironment& prepared);

  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  /// Draws a frame; the pictures below are then of it.
  ///
  /// progress  is called after each sample of the pixels
  /// errors    too_large; no_gl (the driver cannot draw floats); unsupported (it does not compile a shader);
  ///           interrupted (when `progress` says so)
  Result<void> draw(const FrameSettings& settings, const ProgressFunction& progress = {});

  /// The same as another camera sees it, instead of the one that the settings describe.
  Result<void> draw(const Camera& camera, const FrameSettings& settings, const ProgressFunction& progress = {});

  /// Of the scene.
  const BoundingSphere& bounds() const;

  /// Linear radiance: 4 channels, premultiplied alpha, row 0 at the top. Of a frame that was drawn with Resolve::radiance.
  Image radiance() const;

  /// Exposed and tone mapped as the frame's settings say, over its background where that is a display's colour, and
  /// sRGB-encoded: 4 channels, straight alpha, row 0 at the top.
  Result<Image8> picture();

 private:
  struct State;
  explicit Renderer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace mirrorball
