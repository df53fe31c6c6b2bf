#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/texture.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/stage/derived.h"
#include "mirrorball/render/stage/scene_rays.h"
#include "mirrorball/render/surface/scene_buffers.h"
#include "mirrorball/scene/bodies/body_tree.h"
#include "mirrorball/scene/box.h"
#include "mirrorball/scene/coarse_mesh.h"
#include "mirrorball/scene/mesh_file/positions.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// What each sample asks of an instance: side by side, since scenes of thousands wait for memory.
struct InstanceTraits {
  int material;
  bool is_blended;
  bool is_double_sided;
  bool is_body;
};

/// A scene on the GPU, whose parts change one by one, and what is computed from it for all views.
class StagedScene {
 public:
  /// scene    of which no other parts change than those that are told below
  /// alike    of another scene: what both share is shared on the GPU, too; optional
  /// levels   of textures, where they were made before
  /// errors   too_large (a texture for this driver)
  static Result<std::shared_ptr<StagedScene>> make(std::shared_ptr<const Scene> scene, const StagedScene* alike = {},
                                                   const LevelsOfMaps& levels = {});

  /// Shows another scene in its place. What both share stays on the GPU, and what is computed from parts that are as
  /// before stays, too.
  ///
  /// changed  differingParts() of the two
  /// alike    another form of it, with which it shares likewise; optional
  /// levels   of textures, where they were made before
  /// errors   too_large (a texture for this driver); then it is as before
  Result<void> become(std::shared_ptr<const Scene> scene, unsigned changed, const StagedScene* alike = {},
                      const LevelsOfMaps& levels = {});

  // Must be called when a part of the scene has become another one.
  void transformChanged(std::size_t instance);
  /// Of its numbers alone (haveSameBuffers).
  void materialChanged(std::size_t index, const Material& before);
  void lightsChanged() { versions_.change(StagePart::lights); }

  const Scene& scene() const { return *scene_; }
  SceneBuffers& buffers() { return buffers_; }
  /// StageVersions::of these parts of StagePart::scene.
  std::uint64_t version(unsigned parts) const { return versions_.of(parts); }

  const BoundingSphere& bounds() const;
  const Box& box() const;
  const std::vector<Box>& boxes() const;                      ///< of the instances
  const std::vector<InstanceTraits>& traits() const;          ///< likewise
  const std::vector<std::vector<PositionRun>>& runs() const;  ///< of the meshes
  const std::vector<glm::vec3>& centers() const;              ///< of the meshes, each in its own frame

  /// Of its bodies; nothing if there are none.
  ///
  /// errors   as bodyTree's
  Result<const std::optional<BodyTree>*> bodies();
  /// The words of that tree, which is not nothing.
  ///
  /// errors   too_large (for this driver)
  Result<const gl::Texture*> bodyWords();
  /// What is reflected of the scene by rays.
  struct Triangles {
    gl::Texture words;                  ///< sceneTree()
    std::vector<int> unseen_by_itself;  ///< BodyTree's of that tree
  };
  /// Nothing where none is known to reflect.
  ///
  /// errors   as sceneTree's; too_large (for this driver)
  Result<const std::optional<Triangles>*> triangles();
  /// errors   as SceneRays::make's
  Result<const SceneRays*> rays();
  /// What throws a shadow on a ground: shadowCasters().
  const std::vector<CoarseMesh>& casters();
  /// Tells the buffers what bodies are met from that lie in others.
  ///
  /// errors   as bodyTree's
  Result<void> findIorAround();
  /// Rows that take long (Made).
  struct Rows {
    bool bodies = false;
    bool triangles = false;  ///< or their tree alone, which is still to be sent
    bool rays = false;
    bool casters = false;
    std::set<int> prisms = {};  ///< of meshes
  };
  /// Those that are there.
  Rows rows() const;
  /// What of this scene was made elsewhere.
  struct Made {
    std::optional<std::optional<BodyTree>> bodies = {};     ///< bodyTree()
    std::optional<std::optional<BodyTree>> triangles = {};  ///< sceneTree()
    std::map<int, std::vector<glm::uvec4>> prisms = {};     ///< prismList() of meshes
    std::optional<SceneRays> rays = {};
    std::optional<std::vector<CoarseMesh>> casters = {};  ///< shadowCasters()
  };
  /// errors   too_large (for this driver)
  Result<void> take(Made made);
  /// Makes the prisms of all meshes whose relief is found exactly.
  ///
  /// errors   too_large
  Result<void> makePrisms();

 private:
  StagedScene(std::shared_ptr<const Scene> scene, SceneBuffers buffers)
      : scene_(std::move(scene)), buffers_(std::move(buffers)) {
    versions_.change(StagePart::scene);
  }
  bool liesInBody(std::size_t instance) const;

  std::shared_ptr<const Scene> scene_;
  SceneBuffers buffers_;
  StageVersions versions_;
  mutable Derived<BoundingSphere> bounds_{StagePart::meshes | StagePart::transforms};
  mutable Derived<Box> box_{StagePart::meshes | StagePart::transforms};
  mutable Derived<std::vector<Box>> boxes_{StagePart::meshes | StagePart::transforms};
  mutable Derived<std::vector<InstanceTraits>> traits_{StagePart::meshes | StagePart::shapes};
  mutable Derived<std::vector<std::vector<PositionRun>>> runs_{StagePart::meshes};
  mutable Derived<std::vector<glm::vec3>> centers_{StagePart::meshes};
  Derived<std::optional<BodyTree>> bodies_{StagePart::meshes | StagePart::transforms | StagePart::shapes};
  Derived<gl::Texture> body_words_{StagePart::meshes | StagePart::transforms | StagePart::shapes};
  /// Made elsewhere, and not yet sent.
  Derived<std::optional<BodyTree>> scene_tree_{StagePart::meshes | StagePart::transforms | StagePart::occlusion |
                                               StagePart::materials};
  Derived<std::optional<Triangles>> triangles_{StagePart::meshes | StagePart::transforms | StagePart::occlusion |
                                               StagePart::materials};
  Derived<SceneRays> rays_{StagePart::meshes | StagePart::transforms | StagePart::shapes};
  Derived<std::vector<CoarseMesh>> casters_{StagePart::meshes};
  /// Instances whose surroundings the buffers know.
  Derived<std::set<std::size_t>> knows_ior_around_{StagePart::meshes | StagePart::transforms | StagePart::shapes};
};

}  // namespace mirrorball
