#pragma once

#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "formula/bodies.h"
#include "formula/surface.h"
#include "mirrorball/base/result.h"
#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/gl/texture.h"
#include "mirrorball/gl/uniform_block.h"
#include "mirrorball/image/image.h"
#include "mirrorball/render/frame/frame_settings.h"
#include "mirrorball/render/light/environment_light.h"
#include "mirrorball/render/light/flat_light.h"
#include "mirrorball/render/light/proxy_uniforms.h"
#include "mirrorball/render/surface/back_faces.h"
#include "mirrorball/render/surface/scene_buffers.h"
#include "mirrorball/render/surface/surface_variant.h"
#include "mirrorball/scene/box.h"
#include "mirrorball/scene/camera/camera.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// The texture units that the shaders read from. Of those with one number a shader reads at most one: who draws binds
/// it.
struct TextureUnit {
  static constexpr int environment = 0;
  static constexpr int sphere_map = 1;  ///< which shows what is infinitely far away: no proxy, and no nearness
  static constexpr int proxy = 1;
  static constexpr int nearness = 1;  ///< a probe's, which no proxy lies behind
  static constexpr int picture = 2;
  static constexpr int background = 2;  ///< no shader reads two of these
  static constexpr int bodies = 2;
  static constexpr int back_faces = 2;
  static constexpr int scene_triangles = 2;
  static constexpr int brdf_table = 3;
  static constexpr int prefiltered = 4;
  static constexpr int irradiance = 5;
  static constexpr int mirror_picture = 6;  ///< read when no material is bound
  static constexpr int mirror_depths = 7;
  static constexpr int first_of_material = 6;
  static constexpr int opaque_picture = first_of_material + kUnitsBesideScreen;
  static constexpr int scene_triangles_of_glass = opaque_picture + 1;  ///< which reads its bodies as well
  static constexpr int of_material = gl::Texture::kUnits - first_of_material;
  static constexpr int relief_hits = gl::Texture::kUnits - 5;
  static constexpr int horizons = gl::Texture::kUnits - 4;
  static constexpr int prisms = gl::Texture::kUnits - 3;
  static constexpr int heights = gl::Texture::kUnits - 2;  ///< of a material that has them
  static constexpr int slopes = gl::Texture::kUnits - 1;   ///< of heights, or a map of slopes
};

/// A chain of prefiltered cubes, of which a texture holds the levels from `first_level` on.
struct PrefilteredChain {
  const gl::Texture* texture = nullptr;
  int first_level = 0;

  /// That of roughness 1.
  int lastLevel() const { return first_level + texture->levels() - 1; }
  /// The side of its level 0, in the texture or not.
  int size() const { return texture->width() << first_level; }
};

/// The light that some surfaces of a frame read: cubes as EnvironmentLight has them.
struct SurfaceLight {
  const gl::Texture* environment = nullptr;
  const gl::Texture* prefiltered = nullptr;
  const gl::Texture* irradiance = nullptr;
  formula::Blur blur = {};
  float intensity = 1.0f;  ///< radiance for which a 1 in the textures stands
  glm::mat3 environment_from_world{1.0f};
  glm::vec3 captured_from{0.0f};  ///< of light that has `nearness`: world, as its unit of length
  float nearness_unit = 1.0f;
  const gl::Texture* nearness = nullptr;  ///< formula/proxy/captured_sight.glsl; null: light comes from far away
};

/// The probes' light of a frame, and which instances read it in place of the environment's.
struct ProbeUniforms {
  std::vector<SurfaceLight> lights;
  std::vector<int> light_of_instance;  ///< index; −1: the environment's. Empty: of all
};

/// What all surfaces of a frame share.
struct FrameUniforms {
  PrefilteredChain prefiltered;
  Camera camera;
  glm::mat3 environment_from_world{1.0f};
  CoordinateMatrices coordinates;
  const FlatLight* flat = nullptr;          ///< where FrameSettings::look_up reads it
  const gl::Texture* sphere_map = nullptr;  ///< of this camera; null: no coordinates are places of it
  const gl::Texture* bodies = nullptr;      ///< bodyTree() of the scene; null: it has no bodies, or they are not traced
  const gl::Texture* scene_triangles = nullptr;  ///< sceneTree(); null: none are reflected
  std::span<const int> unseen_by_itself = {};    ///< of instances: BodyTree's of that tree
  formula::Media eye_media;                      ///< of traced bodies, those that the camera is inside of
  const BackFaces* back_faces = nullptr;         ///< drawn with this camera; null: the frame's refraction does without
  const gl::Texture* relief_hits = nullptr;      ///< ReliefHits of this camera; null: none is found exactly
  int sample = 0;                                ///< number of the sample of the frame
  ProxyUniforms* proxy = nullptr;                ///< placed as the settings say; must be set
  const gl::Texture* opaque_picture = nullptr;   ///< OpaquePicture of this camera; null: nothing reads it
  float screen_unit = 1.0f;                      ///< of its distances [world units]
  Box shown = {};                                ///< around all that it shows
  const ProbeUniforms* probes = nullptr;         ///< null: there are none
  std::span<const int> hidden = {};              ///< instances that are not drawn
};

/// The BRDF table as shaders/surface/ looks it up, on warped axes: in its first two channels Surface::environment_brdf
/// of formula/surface/shading.glsl, in its third 0. Needs no GL context.
///
/// cost     about 20 ms on 2 cores; made once
Result<Image> surfaceBrdfTable();

/// The same with the albedo of white cloth in its third channel.
///
/// cost     about 60 ms more; made once
Result<Image> surfaceBrdfTableWithCloth();

/// The shader programs for surfaces, one for each variant that some material needs, made when first needed, and the
/// uniform blocks that they read.
class SurfacePrograms {
 public:
  /// brdf_table   surfaceBrdfTable(): cloth is added where a material needs it
  /// errors       too_large (for this driver)
  static Result<SurfacePrograms> make(gl::Api api, const Image& brdf_table);

  /// Makes the programs that a frame needs and sets what all surfaces share. Each sample begins with it; `draw` must be
  /// called with the same scene, buffers and settings. What each instance needs is worked out once and kept, for the
  /// last few kinds of frame.
  ///
  /// errors   unsupported (the driver does not compile a shader)
  Result<void> begin(const Scene& scene, const SceneBuffers& buffers, const EnvironmentLight& light,
                     const FrameUniforms& frame, const FrameSettings& settings);

  gl::Api api() const { return api_; }

  /// Whether an instance's light is searched for along rays, at each fragment, and its place is the mesh's. To be asked
  /// after `begin`.
  bool isCostly(int instance) const { return draws()[std::size_t(instance)].is_costly; }

  /// Must be called when the scene is another one, or its materials or instances have changed.
  void forgetScene();

  /// Draws an instance of the scene.
  void draw(const Scene& scene, int instance, SceneBuffers& buffers, const FrameSettings& settings);

 private:
  /// The binding points of the uniform blocks.
  enum BlockPoint : unsigned { frame_point, instance_point, material_point, light_point, block_points };

  /// How an instance is drawn.
  struct Draw {
    int mesh;
    int material;
    const SurfaceVariant* variant;  ///< a key of programs_
    gl::Program* program;
    int light;  ///< lightRead()
    bool is_costly;
  };
  /// Of a kind of frame: all that draws depend on but the scene, which forgets them.
  struct DrawList {
    FrameSettings settings = {};
    CoordinateChoice coordinates = {};
    bool eye_is_inside = false;
    bool has_scene_triangles = false;
    std::vector<int> light_of_instance = {};
    std::vector<bool> captured = {};  ///< of each light: whether it has `nearness`
    std::vector<Draw> draws = {};     ///< of each instance

    bool isFor(const DrawList& frame) const;
  };

  SurfacePrograms(gl::Api api, gl::Texture brdf_table) : api_(api), brdf_table_(std::move(brdf_table)) {}

  const std::vector<Draw>& draws() const { return draw_lists_[drawn_].draws; }
  Result<void> findDraws(const Scene& scene, const SceneBuffers& buffers, ProxyUniforms& proxy,
                         const FrameSettings& settings);
  Result<Draw> drawOf(const Scene& scene, int instance, const SceneBuffers& buffers, ProxyUniforms& proxy,
                      const FrameSettings& settings);
  void setPrograms(const Scene& scene, const FrameUniforms& frame, const FrameSettings& settings);
  Result<void> addClothToBrdfTable();
  SurfaceVariant variantOf(const Scene& scene, int instance, const SceneBuffers& buffers,
                           const FrameSettings& settings) const;
  using Programs = std::map<SurfaceVariant, gl::Program>;
  Result<Programs::iterator> programFor(const SurfaceVariant& variant, ProxyUniforms& proxy);
  void connect(gl::Program& program, const SurfaceVariant& variant, ProxyUniforms& proxy);
  void setFrame(const FrameUniforms& frame, const FrameSettings& settings);
  void setLights(const EnvironmentLight& light, const FrameUniforms& frame, const FrameSettings& settings);
  /// Which of the lights: 0 is the environment's.
  int lightRead(const SurfaceVariant& variant, int instance) const;
  void bindLight(int light);
  void bindFrameTextures(const SurfaceVariant& variant, const SurfaceLight& light);
  void makeBlocks(const Scene& scene);

  gl::Api api_;
  gl::Texture brdf_table_;
  bool brdf_table_has_cloth_ = false;
  Programs programs_;
  std::vector<DrawList> draw_lists_;
  std::size_t drawn_ = 0;         ///< which of them the sample has
  CoordinateChoice coordinates_;  ///< of the frame
  bool eye_is_inside_ = false;    ///< of it: of bodies that are traced
  const gl::Texture* scene_triangles_ = nullptr;
  std::span<const int> unseen_by_itself_;
  const gl::Texture* sphere_map_ = nullptr;
  ProxyUniforms* proxy_ = nullptr;
  const gl::Texture* bodies_ = nullptr;       ///< null: the scene has none
  const BackFaces* back_faces_ = nullptr;     ///< of the sample
  const gl::Texture* relief_hits_ = nullptr;  ///< likewise
  const gl::Texture* opaque_picture_ = nullptr;
  std::array<std::shared_ptr<const gl::BlockLayout>, block_points> layouts_;
  std::optional<gl::UniformBlock> frame_;
  std::vector<SurfaceLight> lights_;            ///< of the sample: the environment's, then those of probes
  std::vector<gl::UniformBlock> light_blocks_;  ///< of these
  std::vector<int> light_of_instance_;          ///< of the frame's probes
  int bound_light_ = -1;
  std::optional<gl::UniformBlock> instances_;  ///< of the scene, a block each; made for its first frame
  std::optional<gl::UniformBlock> materials_;  ///< likewise
  gl::VertexArray screen_;
};

}  // namespace mirrorball
