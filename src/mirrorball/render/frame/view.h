#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"
#include "mirrorball/render/frame/picking.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/stage/stage.h"
#include "mirrorball/scene/camera/camera.h"

namespace mirrorball {

struct SurfaceVariant;

/// What the light that surfaces reflect takes, beside time.
struct LightCost {
  std::size_t texture_bytes = 0;  ///< of the textures that are read for it
  int reads = 0;                  ///< of those textures, for a sample of a pixel (render/surface/light_reads.h)
};

/// Pictures of a stage, with settings and a camera. Several views show one stage at once, each with its own technique:
/// they share its textures, light and programs.
///
/// A frame is: the background, the objects (each lit by the whole environment, and by point lights if there are any),
/// drawn once for each sample of a pixel with the picture shifted within the pixel, and the mean of them all, as light
/// of the display or as radiance. It is drawn at once (render, draw) or sample by sample (begin, drawSample, show), for
/// windows that must respond in between. The stage needs an environment.
class View {
 public:
  explicit View(const Stage& stage);
  View(View&&) noexcept;
  View& operator=(View&&) noexcept;
  ~View();

  const Stage& stage() const;

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
  ///           interrupted (when `progress` says so); usage (the stage has no environment)
  Result<void> draw(const FrameSettings& settings, const ProgressFunction& progress = {});
  /// The same with another camera than that of the settings.
  Result<void> draw(const Camera& camera, const FrameSettings& settings, const ProgressFunction& progress = {});

  /// Begins a frame, without drawing anything yet.
  ///
  /// errors   as draw's
  Result<void> begin(const FrameSettings& settings);
  Result<void> begin(const Camera& camera, const FrameSettings& settings);
  /// Makes one of the programs that the frame needs and that the device has not yet, and draws with it once: for
  /// windows that respond between a change of technique and its first sample. drawSample makes all that are left at
  /// once; begin makes those that probes are captured with.
  ///
  /// returns  how many are left: 0 if none was missing
  /// errors   as draw's
  /// cost     with llvmpipe 5 to 30 ms for a program that its cache has, else up to a second
  Result<int> makeProgram();

  /// Which program (render/surface/surface_variant.h) each instance of the scene needs in the frame that has begun: to
  /// look at programs that the driver does not get. Without those of the pictures that a sample makes on its way.
  ///
  /// errors   as draw's
  Result<std::vector<SurfaceVariant>> surfaceVariants();

  /// Draws the next sample of all pixels of the frame, if there is one left. Where the stage has changed since it
  /// began, or it could not begin, it begins again.
  ///
  /// returns  how many there are now
  /// errors   as draw's
  Result<int> drawSample();

  /// Whether all samples of the frame have been drawn, of what the stage is now: then drawSample has nothing to do.
  bool isDone() const;
  /// Of the last frame.
  const Camera& camera() const;

  // What has been drawn. Before the first sample of a frame they fail with `usage`.

  /// Shows the mean of the samples that there are in a framebuffer, as a picture: exposed, tone mapped and encoded, row
  /// 0 at the bottom.
  ///
  /// framebuffer  OpenGL's name of it, of 8 bits a channel; 0 is a window's. It stays bound
  /// corner       the lower left one of the frame in it [pixels]
  /// errors       no_gl
  Result<void> show(unsigned framebuffer, glm::ivec2 corner = glm::ivec2(0)) const;

  /// Linear radiance: 4 channels, premultiplied alpha, row 0 at the top. Of a whole frame with Resolve::radiance.
  ///
  /// errors   no_gl
  Result<Image> radiance() const;
  /// The whole frame as `render` returns it.
  Result<Image8> picture();
  /// The light of that picture, for pictures of other primaries or of more than 8 bits: what a display sends, 4
  /// channels, straight alpha, in [0, 1].
  Result<Image> displayedLight();

  /// What the frame shows at a place of it, from its top left corner [pixels]; with reliefs and holes, as rays find it
  /// (pickAlong). At least one sample must have been drawn.
  ///
  /// returns  nothing: the background, or the place is outside
  /// errors   usage (the stage has changed since); no_gl; too_large
  /// cost     some microseconds; after a change of meshes, places or of what materials are made of, sorting the
  ///          triangles (Geometry::make)
  Result<std::optional<Picked>> pick(glm::vec2 place);

  /// Of the last frame, without its background; nothing if the stage has changed since.
  LightCost lightCost() const;
  /// How often a probe was captured until now: only what has changed is captured again.
  int probeCaptures() const;

 private:
  struct OnDevice;
  struct State;
  Result<void> start();
  Result<void> enter() const;
  /// errors   usage (nothing has been drawn); no_gl
  Result<void> enterDrawn() const;
  std::unique_ptr<State> state_;
};

}  // namespace mirrorball
