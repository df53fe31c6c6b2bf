#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "mirrorball/base/range.h"
#include "mirrorball/base/result.h"
#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/sampler.h"
#include "mirrorball/gl/texture.h"
#include "mirrorball/render/frame/frame_settings.h"
#include "mirrorball/render/surface/map_sources.h"
#include "mirrorball/render/surface/scene_blocks.h"
#include "mirrorball/render/surface/texture_units.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Whether a list has an instance.
inline bool isAmong(std::span<const int> instances, std::size_t instance) {
  return contains(instances, static_cast<int>(instance));
}

/// A scene's meshes, textures and uniform blocks on the GPU.
class SceneBuffers {
 public:
  /// units    texture units that each material has
  /// alike    of another form of the same scene, whose textures are taken where they are read alike; optional
  /// errors   too_large: a texture is larger than the driver takes
  static Result<SceneBuffers> make(const Scene& scene, int units, const SceneBuffers* alike = nullptr);

  SceneBlocks& blocks() { return blocks_; }

  void drawMesh(int index) const;
  /// Of an instance whose occlusion is known.
  void drawMeshWithOcclusion(const Scene& scene, int instance);

  /// Sets what an instance's surface is met from (iorAround); empty: it lies in air.
  void setIorAround(std::size_t instance, std::span<const float> ior);
  /// Makes the next drawing of an instance's mesh know that.
  void readIorAround(const Scene& scene, int instance);

  /// Makes what drawPrisms needs, once.
  ///
  /// mesh     its material has a height texture
  /// errors   too_large: the mesh has too many triangles for this driver's textures
  Result<void> makePrisms(const Scene& scene, int mesh);
  /// Binds the list of a mesh's prisms to a unit, and draws the boxes around them.
  void bindPrisms(int mesh, int unit) const;
  void drawPrisms(int mesh, int unit) const;

  /// OpenGL's name of a texture that has a unit of its own; 0: it has none.
  unsigned textureName(std::size_t texture) const { return textures_[texture] ? textures_[texture]->name() : 0; }
  /// mapSources() of a material.
  const std::vector<MapSource>& mapsOf(int material) const { return materials_[std::size_t(material)].sources; }
  /// What a surface is searched for in that heights move.
  struct SearchedHeights {
    gl::Texture heights;   ///< HeightTexture::picture, cones in green
    gl::Texture horizons;  ///< HorizonMap::slopes as layers
  };
  /// A material's heights: gives its map to the shader, and its slopes.
  struct Heights {
    gl::Texture slopes;  ///< SlopeMoments::levels
    float slope_unit;
    std::optional<SearchedHeights> searched = {};  ///< where the heights have horizons
  };
  /// Of a material; null: it has none.
  const Heights* heightsOf(const Scene& scene, int material) const;
  /// A material's map of slopes, where no heights are shown.
  struct Slopes {
    gl::Texture texture;  ///< SlopeMoments::levels
    float unit;
  };
  /// Of a material; null: it has none.
  const Slopes* slopesOf(const Scene& scene, int material) const;
  /// Says how the textures that have a unit of their own are read; those in layers are filtered by the shader.
  ///
  /// filter       at first trilinear
  /// anisotropy   gl::Sampling::anisotropy of TextureFilter::anisotropic
  void filterMaps(const Scene& scene, TextureFilter filter, float anisotropy);
  /// Binds a material's textures to the units of the program that draws it.
  void bindMaps(const Scene& scene, int material, const TextureUnits& units) const;

 private:
  struct Prisms {
    gl::Texture words;
    gl::VertexArray boxes;
    std::size_t index_count;
  };
  struct MeshBuffers {
    gl::VertexArray vertices;
    std::size_t index_count;
    std::optional<Prisms> prisms = {};
  };
  struct MaterialMaps {
    std::vector<MapSource> sources;
    std::optional<gl::Texture> layers;
  };
  SceneBlocks blocks_;
  void addMeshes(const Scene& scene);
  Result<void> addMaps(const Scene& scene, const SceneBuffers* alike);
  const gl::Sampler* samplerOf(const gl::Sampling& sampling);

  std::vector<MeshBuffers> meshes_;
  std::vector<std::optional<gl::Buffer>> occlusions_;   // of instances
  std::vector<std::optional<gl::Buffer>> ior_around_;   // of instances, less 1
  std::vector<std::shared_ptr<gl::Texture>> textures_;  // those that have a unit of their own
  std::vector<bool> holds_normals_;                     // of each texture: nothing else is read of it
  std::vector<MaterialMaps> materials_;
  std::vector<Heights> heights_;  // of Scene::height_textures
  std::vector<Slopes> slopes_;    // of Scene::slope_textures
  int units_ = 0;
  std::map<gl::Sampling, gl::Sampler> samplers_;
  // How they are read now, each of samplers_.
  std::optional<std::pair<TextureFilter, float>> filtered_;
  std::vector<const gl::Sampler*> texture_samplers_;
  std::vector<const gl::Sampler*> height_samplers_;
  const gl::Sampler* slope_sampler_ = nullptr;
};

}  // namespace mirrorball
