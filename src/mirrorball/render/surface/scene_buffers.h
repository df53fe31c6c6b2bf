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
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/surface/height_buffers.h"
#include "mirrorball/render/surface/map_levels.h"
#include "mirrorball/render/surface/map_sources.h"
#include "mirrorball/render/surface/scene_blocks.h"
#include "mirrorball/render/surface/texture_units.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Whether a list has an instance.
inline bool isAmong(std::span<const int> instances, std::size_t instance) {
  return contains(instances, static_cast<int>(instance));
}

/// What was sent to the GPU of something that scenes share.
template <typename Source, typename Made>
struct Sent {
  Shared<Source> source;
  Made made;
};
template <typename Source, typename Made>
using SentPointer = std::shared_ptr<Sent<Source, Made>>;

/// A scene's meshes, textures and uniform blocks on the GPU.
class SceneBuffers {
 public:
  /// units    texture units that each material has
  /// alike    of other scenes, whose meshes and textures are taken where this one shares them
  /// levels   of textures, where they were made before
  /// errors   too_large: a texture is larger than the driver takes
  static Result<SceneBuffers> make(const Scene& scene, int units, std::span<const SceneBuffers* const> alike = {},
                                   const LevelsOfMaps& levels = {});

  // What is known of a scene before this one is also of this one.
  void keepBlocks(SceneBuffers& before) { blocks_ = std::move(before.blocks_); }
  void keepAround(SceneBuffers& before) { ior_around_ = std::move(before.ior_around_); }  ///< setIorAround()
  void keepPrisms(SceneBuffers& before) { prisms_ = std::move(before.prisms_); }

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
  /// list     prismList() of it; empty: it is made here
  /// errors   too_large: the mesh has too many triangles for this driver's textures
  Result<void> makePrisms(const Scene& scene, int mesh, std::vector<glm::uvec4> list = {});
  bool hasPrisms(int mesh) const { return prisms_[std::size_t(mesh)].has_value(); }
  /// Binds the list of a mesh's prisms to a unit, and draws the boxes around them.
  void bindPrisms(int mesh, int unit) const;
  void drawPrisms(int mesh, int unit) const;

  /// OpenGL's name of a texture that has a unit of its own; 0: it has none.
  unsigned textureName(std::size_t texture) const {
    return textures_[texture] ? textures_[texture]->texture.name() : 0;
  }
  /// Binds a texture that has a unit of its own; false: it has none.
  bool bindTexture(std::size_t texture, int unit) const;
  /// mapSources() of a material.
  const std::vector<MapSource>& mapsOf(int material) const { return materials_[std::size_t(material)].sources; }
  /// Whether some of a material's textures are layers of an array.
  bool hasLayers(int material) const { return materials_[std::size_t(material)].layers != nullptr; }
  /// A material's heights: gives its map to the shader, and its slopes; null: it has none.
  const HeightBuffers* heightsOf(const Scene& scene, int material) const;
  /// A material's map of slopes, where no heights are shown; null: it has none.
  const SlopeBuffer* slopesOf(const Scene& scene, int material) const;
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
  };
  struct MapTexture {
    MapContent content;
    SharedPicture picture;  ///< the content's
    gl::Texture texture;
  };
  struct LayersOfMaps {
    std::vector<MapContent> contents;
    std::vector<SharedPicture> pictures;  ///< the contents'
    gl::Texture array;
  };
  struct MaterialMaps {
    std::vector<MapSource> sources;
    std::shared_ptr<LayersOfMaps> layers;  ///< null: it has none
    std::vector<std::size_t> rows;         ///< of materialMaps() that have a texture
  };
  void addOcclusion(const Scene& scene);
  /// The textures that were sent, by what they hold.
  struct SentMaps {
    std::map<MapContent, std::shared_ptr<MapTexture>> textures;
    std::map<std::vector<MapContent>, std::shared_ptr<LayersOfMaps>> layers;
  };
  std::vector<bool> addSources(const Scene& scene, const SentMaps& sent);
  Result<void> addMaps(const Scene& scene, std::span<const SceneBuffers* const> alike, const LevelsOfMaps& known);
  Result<void> addMapsOf(const Scene& scene, std::size_t material, const LevelsOfMaps& levels, SentMaps& sent);
  const gl::Sampler* samplerOf(const gl::Sampling& sampling);

  SceneBlocks blocks_;
  std::vector<SentPointer<Mesh, MeshBuffers>> meshes_;
  std::vector<std::optional<Prisms>> prisms_;          // of meshes
  std::vector<std::optional<gl::Buffer>> occlusions_;  // of instances
  std::vector<std::optional<gl::Buffer>> ior_around_;  // of instances, less 1
  std::vector<MapContent> contents_;                   // of textures
  std::vector<std::shared_ptr<MapTexture>> textures_;  // those that have a unit of their own
  std::vector<MaterialMaps> materials_;
  std::vector<SentPointer<HeightTexture, HeightBuffers>> heights_;  // of Scene::height_textures
  std::vector<SentPointer<Image, SlopeBuffer>> slopes_;             // of Scene::slope_textures
  int units_ = 0;
  std::map<gl::Sampling, gl::Sampler> samplers_;
  // How they are read now, each of samplers_.
  std::optional<std::pair<TextureFilter, float>> filtered_;
  std::vector<const gl::Sampler*> texture_samplers_;
  std::vector<const gl::Sampler*> height_samplers_;
  const gl::Sampler* slope_sampler_ = nullptr;
};

}  // namespace mirrorball
