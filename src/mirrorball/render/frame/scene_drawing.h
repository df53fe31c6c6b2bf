#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/render/frame/ground_mirror.h"
#include "mirrorball/render/frame/screen_layers.h"
#include "mirrorball/render/light/environment_light.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/stage/device_state.h"
#include "mirrorball/render/stage/staged_scene.h"
#include "mirrorball/render/surface/back_faces.h"
#include "mirrorball/render/surface/frame_uniforms.h"
#include "mirrorball/render/surface/nearness_picture.h"
#include "mirrorball/render/surface/opaque_picture.h"
#include "mirrorball/render/surface/relief_hits.h"
#include "mirrorball/render/surface/surface_drawing.h"

namespace mirrorball {

/// How one sample of a view's picture is drawn: the surfaces of a scene, and the environment behind them.
class SceneDrawing {
 public:
  /// On a device, which outlives it.
  explicit SceneDrawing(Device::State& device) : device_(&device) {}

  /// Draws that scene from now on, which must be called before anything else.
  void show(std::shared_ptr<StagedScene> staged) { staged_ = std::move(staged); }

  StagedScene& staged() const { return *staged_; }
  const Scene& scene() const { return staged_->scene(); }

  /// Makes what a frame needs of the scene.
  ///
  /// sample   of the frame's camera
  /// proxy    of the frame's light
  /// returns  valid until the next call
  /// errors   too_large; unsupported (the driver has no anisotropic filter, or does not compile a shader)
  Result<SceneUniforms> begin(const FrameSettings& settings, const SampleUniforms& sample, ProxyUniforms& proxy);

  /// Makes one of the programs that a frame needs and that there are not, and draws with it into a corner of the
  /// target, so that the driver makes all of it now. Pictures that a sample makes on its way have programs of their
  /// own.
  ///
  /// frame    as draw's
  /// returns  how many are left
  /// errors   unsupported
  Result<int> makeProgram(const gl::Framebuffer& target, const EnvironmentLight& light, FrameUniforms frame,
                          const FrameSettings& settings);

  /// Which program each instance needs in a frame, without those of pictures that a sample makes on its way.
  ///
  /// frame    as draw's
  std::vector<SurfaceVariant> variants(const EnvironmentLight& light, const FrameUniforms& frame,
                                       const FrameSettings& settings) {
    return surfaces_.variants(scene(), staged_->buffers(), light, frame, settings);
  }

  /// Draws one sample of all pixels, into a framebuffer of floats with depth and of the settings' size.
  ///
  /// frame    with the sample's own camera and number, and what `begin` has returned; its screen is made here
  /// errors   unsupported
  Result<void> draw(const gl::Framebuffer& target, const EnvironmentLight& light, const FrameUniforms& frame,
                    const FrameSettings& settings);

  /// Draws how near all is that a frame shows, the environment's proxy too (NearnessPicture), in distances of the
  /// scene's radius.
  ///
  /// picture  of the frame
  /// returns  valid until the next call
  /// errors   too_large; unsupported
  Result<const gl::Texture*> drawNearness(const gl::Framebuffer& picture, const FrameUniforms& frame);

 private:
  gl::Api api() const { return device_->context.api(); }
  Result<void> drawMirrored(const EnvironmentLight& light, FrameUniforms frame, FrameSettings settings);
  Result<void> drawOnce(const gl::Framebuffer& target, const EnvironmentLight& light, FrameUniforms frame,
                        const FrameSettings& settings);
  Result<void> beginSurfaces(const gl::Framebuffer& target, const EnvironmentLight& light, const FrameUniforms& frame,
                             const FrameSettings& settings);
  Result<void> filterMaps(TextureFilter filter);
  Result<void> makeBodies(const FrameSettings& settings, const SampleUniforms& sample, SceneUniforms& uniforms);
  Result<void> makeSceneTriangles(const FrameSettings& settings, SceneUniforms& uniforms);
  bool readsBackFaces(const FrameSettings& settings) const;
  bool readsReliefHits(const FrameSettings& settings) const;
  Result<void> makeSearchedPictures(const FrameSettings& settings);
  void chooseScreenPictures(const FrameSettings& settings, ScreenUniforms& screen) const;
  Result<void> drawBackFaces(const FrameSettings& settings, const SampleUniforms& sample);
  bool someSeeScreenRoughly(const FrameSettings& settings) const;
  Result<void> makeOpaquePicture(const FrameSettings& settings);
  Result<void> copyScreen(const gl::Framebuffer& target, const EnvironmentLight& light, FrameUniforms& frame,
                          const FrameSettings& settings);
  Result<void> drawLayers(const gl::Framebuffer& target, const EnvironmentLight& light, FrameUniforms frame,
                          const FrameSettings& settings, const std::vector<ScreenLayer>& layers);
  Result<void> drawReliefHits(const FrameSettings& settings, const SampleUniforms& sample);
  const std::vector<int>& byDistance(const FrameUniforms& frame, bool is_blended);
  std::vector<int> sortedByDistance(const FrameUniforms& frame, bool is_blended) const;
  void keepWhatShowsThrough(const std::vector<ScreenLayer>& layers, const FrameUniforms& frame);
  void drawWhatSeesNothing(const std::vector<int>& order, const FrameUniforms& frame, const FrameSettings& settings);
  void drawInstances(const std::vector<int>& instances, const FrameUniforms& frame, const FrameSettings& settings);
  void drawInstance(int instance, const FrameUniforms& frame, const FrameSettings& settings);
  void chooseCulling(int instance, const FrameUniforms& frame) const;
  void drawBlended(const FrameUniforms& frame, const FrameSettings& settings);

  /// Instances as they are drawn from a place, kept since all samples of a frame have the same.
  struct Order {
    std::uint64_t version = 0;  ///< of the scene's meshes, places and traits
    glm::vec3 position{0.0f};
    glm::vec3 forward{0.0f};
    bool orthographic = false;
    bool is_blended = false;
    std::vector<int> hidden = {};
    std::vector<int> instances = {};

    bool isFor(const Order& wanted) const;
  };

  Device::State* device_;
  std::shared_ptr<StagedScene> staged_;
  SurfaceDrawing surfaces_;
  std::list<Order> orders_;  ///< the last ones, the newest at the end
  // Each is made when a frame first needs it.
  std::optional<BackFaces> back_faces_;
  std::optional<ReliefHits> relief_hits_;
  std::optional<GroundMirror> ground_mirror_;
  std::optional<NearnessPicture> nearness_;
  std::optional<OpaquePicture> opaque_picture_;
};

}  // namespace mirrorball
