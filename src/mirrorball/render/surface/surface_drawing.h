#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/uniform_block.h"
#include "mirrorball/render/light/environment_light.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/surface/frame_uniforms.h"
#include "mirrorball/render/surface/pixel_cells.h"
#include "mirrorball/render/surface/scene_buffers.h"
#include "mirrorball/render/surface/surface_programs.h"
#include "mirrorball/render/surface/surface_shaders.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Sets the state that surfaces of a drawing are drawn with, for each of which drivers compile a program anew: the
/// tests of depths and of the stencil, and whether they are laid over each other or hide each other. Until
/// endSurfaceState().
void beginSurfaceState(const SampleUniforms& sample, bool is_blended);
void endSurfaceState();

/// How a view draws the surfaces of a scene: which program each instance needs, which light it reads, and the uniform
/// blocks of the frame and its lights.
class SurfaceDrawing {
 public:
  /// What programs are compiled for.
  struct ProgramTarget {
    const gl::Context& context;
    const gl::Framebuffer& picture;
  };

  /// Makes the programs that a frame needs and sets what all surfaces share. Each sample begins with it; `draw` must be
  /// called with the same programs, scene, buffers and settings. What each instance needs is worked out once and kept,
  /// for the last few kinds of frame.
  ///
  /// target   that the frame is drawn into
  /// version  of the scene: another number wherever its materials, meshes or what else draws depend on has changed
  /// errors   unsupported (the driver does not compile a shader)
  Result<void> begin(SurfacePrograms& programs, const ProgramTarget& target, const Scene& scene, SceneBuffers& buffers,
                     std::uint64_t version, const EnvironmentLight& light, const FrameUniforms& frame,
                     const FrameSettings& settings);

  /// Which program each instance of the scene needs in such a frame. The driver gets none of them.
  std::vector<SurfaceVariant> variants(const Scene& scene, const SceneBuffers& buffers, const EnvironmentLight& light,
                                       const FrameUniforms& frame, const FrameSettings& settings);

  /// Makes one of the programs that such a frame needs and that there are not. The driver is given the others, too, as
  /// far as it compiles them beside us; the first that is ready is made.
  ///
  /// returns  the instance that it is for, which `tryOut` then draws; nothing: all are there
  /// errors   as begin's
  struct MadeProgram {
    int instance;
    int left;  ///< that are still to be made
  };
  Result<std::optional<MadeProgram>> makeProgram(SurfacePrograms& programs, const Scene& scene, SceneBuffers& buffers,
                                                 const EnvironmentLight& light, const FrameUniforms& frame,
                                                 const FrameSettings& settings);
  /// Draws an instance with the program that was made last, without what the frame's own pictures hold.
  void tryOut(const Scene& scene, SceneBuffers& buffers, const FrameSettings& settings);

  /// Whether an instance's depths are to be drawn before its light, so that no light is found that something hides. To
  /// be asked after `begin`.
  bool depthsComeFirst(int instance) const { return draws()[std::size_t(instance)].depths_come_first; }

  /// Lets the processor fetch what drawing an instance needs to know.
  void expect(int instance) const { __builtin_prefetch(&draws()[std::size_t(instance)]); }

  /// Draws an instance of the scene.
  void draw(const Scene& scene, int instance, SceneBuffers& buffers, const FrameSettings& settings);

 private:
  /// How an instance is drawn.
  struct Draw {
    int mesh;
    int material;
    const SurfaceVariant* variant;
    SurfacePrograms::Program* program;
    int light;  ///< lightRead()
    bool depths_come_first = false;
  };
  /// Of a kind of frame: all that draws depend on.
  struct DrawList {
    FrameSettings settings = {};
    std::uint64_t version = 0;
    CoordinateChoice coordinates = {};
    bool eye_is_inside = false;
    bool has_scene_triangles = false;
    std::vector<int> light_of_instance = {};
    std::size_t sun_count = 0;
    bool has_empty_screen = false;
    std::vector<bool> captured = {};      ///< of each light: whether it has `nearness`
    std::vector<float> last_levels = {};  ///< of each light's chain
    std::vector<Draw> draws = {};         ///< of each instance

    bool isFor(const DrawList& frame) const;
  };

  /// Of bodies that are traced.
  bool eyeIsInside() const { return formula::isWithinBody(uniforms_.scene.eye_media); }
  const std::vector<Draw>& draws() const { return draw_lists_[drawn_].draws; }
  Result<void> findDraws(SurfacePrograms& programs, const ProgramTarget& target, const Scene& scene,
                         const SceneBuffers& buffers, std::uint64_t version, const FrameSettings& settings);
  /// The programs that the instances of a scene need.
  struct NeededVariants {
    std::vector<SurfaceVariant> variants = {};   ///< each once, but for those that have come to share one
    std::vector<int> first_instances = {};       ///< of each
    std::vector<std::size_t> of_instances = {};  ///< of each instance, the index of its variant
  };
  /// A program that is to be made.
  struct WaitingProgram {
    SurfaceVariant variant;
    int instance;  ///< the first that is drawn with it
    SurfaceShaders shaders;
  };
  struct Waiting {
    std::vector<WaitingProgram> programs = {};
    std::size_t taken = 0;
    std::mutex mutex = {};  ///< of this, and of all but the driver's compilation
  };
  Result<void> compileTogether(SurfacePrograms& programs, const ProgramTarget& target, const Scene& scene,
                               const SceneBuffers& buffers, const NeededVariants& needed) const;
  Result<void> compileWaiting(Waiting& waiting, SurfacePrograms& programs, const gl::Framebuffer& target,
                              const Scene& scene, const SceneBuffers& buffers) const;
  Draw drawOf(const Scene& scene, int instance, SurfacePrograms::Programs::reference entry) const;
  static void chooseDepthsFirst(const Scene& scene, glm::ivec2 size_px, std::vector<Draw>& draws);
  void noteFrame(const Scene& scene, const EnvironmentLight& light, const FrameUniforms& frame,
                 const FrameSettings& settings);
  void setBlocks(SurfacePrograms& programs, const Scene& scene, SceneBuffers& buffers, const FrameUniforms& frame,
                 const FrameSettings& settings);
  void draw(const Draw& draw, const Scene& scene, int instance, SceneBuffers& buffers, const FrameSettings& settings);
  NeededVariants findVariants(const Scene& scene, const SceneBuffers& buffers, const FrameSettings& settings) const;
  /// Those that are not made, each with its first instance.
  static std::map<SurfaceVariant, int> missing(const SurfacePrograms& programs, const NeededVariants& needed);
  SurfaceVariant variantOf(const Scene& scene, int instance, const SceneBuffers& buffers,
                           const FrameSettings& settings) const;
  void setFrame(const SurfacePrograms& programs, const FrameUniforms& frame, const FrameSettings& settings);
  void setLights(const EnvironmentLight& light, const FrameUniforms& frame, const FrameSettings& settings);
  /// Which of the lights: 0 is the environment's.
  int lightRead(const SurfaceVariant& variant, int instance) const;
  void bindLight(int light);
  void bindLightTextures(const SurfaceLight& light) const;
  void bindFrameTextures(const TextureUnits& units, const SurfaceLight& light) const;
  void bindTextures(const Draw& draw, const Scene& scene, const SceneBuffers& buffers) const;

  std::optional<Draw> made_;  ///< of makeProgram
  int made_for_ = 0;          ///< the instance
  std::vector<DrawList> draw_lists_;
  std::size_t drawn_ = 0;         ///< which of them the sample has
  CoordinateChoice coordinates_;  ///< of the frame
  FrameUniforms uniforms_;        ///< of the sample
  std::optional<gl::UniformBlock> frame_;
  std::vector<PixelCell> cells_;  ///< of the samples of a pixel
  std::shared_ptr<const gl::BlockLayout> light_layout_;
  std::vector<SurfaceLight> lights_;            ///< of the sample: the environment's, then those of probes
  std::vector<gl::UniformBlock> light_blocks_;  ///< of these
  std::vector<int> light_of_instance_;          ///< of the frame's probes
  int bound_light_ = -1;
  std::optional<gl::VertexArray> screen_;  ///< made on the first frame's device
};

}  // namespace mirrorball
