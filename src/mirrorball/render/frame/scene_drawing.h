#pragma once

#include <future>
#include <optional>
#include <set>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/context.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/image/image.h"
#include "mirrorball/render/frame/background.h"
#include "mirrorball/render/frame/frame_settings.h"
#include "mirrorball/render/frame/ground_mirror.h"
#include "mirrorball/render/frame/screen_layers.h"
#include "mirrorball/render/light/environment_light.h"
#include "mirrorball/render/surface/back_faces.h"
#include "mirrorball/render/surface/depth_pass.h"
#include "mirrorball/render/surface/nearness_picture.h"
#include "mirrorball/render/surface/opaque_picture.h"
#include "mirrorball/render/surface/relief_hits.h"
#include "mirrorball/render/surface/scene_buffers.h"
#include "mirrorball/render/surface/surface_program.h"
#include "mirrorball/scene/bodies/body_tree.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// A scene on the GPU, and how one sample of its picture is drawn: the surfaces, and the environment behind them.
class SceneDrawing {
 public:
  /// brdf_table   surfaceBrdfTable(); waited for at the first frame
  explicit SceneDrawing(std::future<Result<Image>> brdf_table) : brdf_table_(std::move(brdf_table)) {}

  /// errors   too_large (a texture for this driver); then the scene is as before
  Result<void> setScene(Scene scene);
  const Scene& scene() const { return scene_; }
  const BoundingSphere& bounds() const { return bounds_; }
  /// Puts the instances elsewhere: as many, of the same meshes.
  void moveInstances(const std::vector<Instance>& instances);
  /// Another number for each scene, and wherever its instances are put.
  int version() const { return version_; }

  /// Makes what a frame needs, and says it in `frame`, whose camera and proxy must be set.
  ///
  /// errors   too_large; unsupported (the driver has no anisotropic filter, or does not compile a shader)
  Result<void> begin(const gl::Context& context, const FrameSettings& settings, FrameUniforms& frame);

  /// Draws one sample of all pixels, into a framebuffer of floats with depth and of the settings' size.
  ///
  /// frame    of `begin`, but with the sample's own camera and number
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
  Result<void> drawMirrored(const EnvironmentLight& light, FrameUniforms frame, FrameSettings settings);
  Result<void> drawOnce(const gl::Framebuffer& target, const EnvironmentLight& light, FrameUniforms frame,
                        const FrameSettings& settings);
  Result<void> makeSurfaces(gl::Api api);
  Result<void> filterMaps(const gl::Context& context, TextureFilter filter);
  Result<void> makePrisms(ReliefKind relief);
  bool someRefract(RefractionKind kind, RefractionKind chosen) const;
  Result<void> makeBodyTree();
  Result<void> makeBodies(const FrameSettings& settings, FrameUniforms& frame);
  bool liesInBody(std::size_t instance) const;
  Result<void> findIorAround(const FrameSettings& settings);
  Result<void> makeSceneTriangles(const FrameSettings& settings, FrameUniforms& frame);
  Result<void> drawBackFaces(const FrameSettings& settings, FrameUniforms& frame);
  bool someSeeScreenRoughly(const FrameSettings& settings) const;
  Result<void> copyScreen(const gl::Framebuffer& target, const EnvironmentLight& light, FrameUniforms& frame,
                          const FrameSettings& settings);
  Result<void> drawLayers(const gl::Framebuffer& target, const EnvironmentLight& light, FrameUniforms frame,
                          const FrameSettings& settings, const std::vector<ScreenLayer>& layers);
  Result<void> drawReliefHits(const FrameSettings& settings, FrameUniforms& frame);
  std::vector<int> byDistance(const FrameUniforms& frame, bool is_blended) const;
  void drawInstances(const std::vector<int>& instances, const FrameUniforms& frame, const FrameSettings& settings);
  void drawInstance(int instance, const FrameUniforms& frame, const FrameSettings& settings);
  void chooseCulling(int instance, const FrameUniforms& frame) const;
  void drawBlended(const FrameUniforms& frame, const FrameSettings& settings);

  std::future<Result<Image>> brdf_table_;
  std::optional<SurfacePrograms> surfaces_;  ///< made for the first frame
  Background background_;
  Scene scene_;
  SceneBuffers buffers_;
  Box box_;
  std::vector<Box> boxes_;  ///< of the instances, found for the first frame whose surfaces see the screen
  BoundingSphere bounds_;
  /// What each sample asks of an instance: side by side, since scenes of thousands wait for memory.
  struct Traits {
    int material;
    bool is_blended;
    bool is_double_sided;
    bool is_body;
  };
  std::vector<Traits> traits_;
  std::vector<glm::vec3> centers_;              ///< of the meshes, each in its own frame
  std::optional<BodyTree> body_tree_;           ///< of the scene, made when it is first traced
  std::optional<gl::Texture> bodies_;           ///< its words
  std::set<std::size_t> knows_ior_around_;      ///< instances whose surroundings the buffers know
  std::optional<gl::Texture> scene_triangles_;  ///< sceneTree(), made for the first frame that reflects it
  std::vector<int> unseen_by_itself_;           ///< its instances
  std::optional<BackFaces> back_faces_;         ///< made when a frame first needs them
  std::optional<ReliefHits> relief_hits_;
  std::optional<GroundMirror> ground_mirror_;
  std::optional<NearnessPicture> nearness_;
  std::optional<OpaquePicture> opaque_picture_;
  std::optional<DepthPass> depth_pass_;
  int version_ = 0;
};

}  // namespace mirrorball
