#include "mirrorball/render/surface/scene_buffers.h"

#include <array>
#include <cstddef>

#include "mirrorball/base/parallel.h"
#include "mirrorball/image/halve.h"

namespace mirrorball {
namespace {

/// As shaders/mesh.vert reads a Vertex.
constexpr std::array<gl::Attribute, 6> kAttributes{{
    {0, 3, offsetof(Vertex, position)},
    {1, 3, offsetof(Vertex, normal)},
    {2, 4, offsetof(Vertex, tangent)},
    {3, 2, offsetof(Vertex, uv)},
    {4, 2, offsetof(Vertex, uv) + sizeof(glm::vec2)},
    {5, 4, offsetof(Vertex, color)},
}};

gl::Sampling::Wrap samplingWrap(Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat:
      return gl::Sampling::Wrap::repeat;
    case Wrap::mirrored_repeat:
      return gl::Sampling::Wrap::mirrored_repeat;
    case Wrap::clamp_to_edge:
      break;
  }
  return gl::Sampling::Wrap::clamp_to_edge;
}

/// The mip levels of a texture after the first.
using MipLevels = std::vector<Image8>;

/// Made on all cores: a software driver would take a multiple of the time.
std::vector<MipLevels> makeMipLevels(const std::vector<Texture>& textures) {
  std::vector<MipLevels> levels(textures.size());
  parallelFor(textures.size(), 1, [&](std::size_t index, std::size_t) {
    const Texture& texture = textures[index];
    const Image8* last = &texture.image;
    while (last->width() > 1 || last->height() > 1) {
      Image8 next = halved(*last, texture.srgb);
      last = &levels[index].emplace_back(std::move(next));
    }
  });
  return levels;
}

Result<gl::Texture> makeTexture(const Texture& texture, const MipLevels& levels) {
  const gl::Format format = texture.srgb ? gl::Format::srgb8_alpha8 : gl::Format::rgba8;
  MIRRORBALL_TRY(made,
                 gl::Texture::make2d(format, texture.image.width(), texture.image.height(), gl::Texture::kAllLevels));
  made.upload(texture.image);
  for (std::size_t level = 0; level < levels.size(); ++level)
    made.upload(static_cast<int>(level) + 1, 0, levels[level]);
  made.setSampling({.filter = gl::Sampling::Filter::trilinear,
                    .magnify_nearest = texture.nearest,
                    .wrap_s = samplingWrap(texture.wrap_s),
                    .wrap_t = samplingWrap(texture.wrap_t)});
  return Result<gl::Texture>(std::move(made));
}

}  // namespace

Result<SceneBuffers> SceneBuffers::make(const Scene& scene) {
  SceneBuffers buffers;
  for (const Mesh& mesh : scene.meshes)
    buffers.meshes_.push_back({gl::VertexArray(gl::Buffer(std::span(mesh.vertices)), sizeof(Vertex), kAttributes,
                                               gl::Buffer(std::span(mesh.indices))),
                               mesh.indices.size()});
  const std::vector<MipLevels> levels = makeMipLevels(scene.textures);
  for (std::size_t index = 0; index < scene.textures.size(); ++index) {
    MIRRORBALL_TRY(made, makeTexture(scene.textures[index], levels[index]));
    buffers.textures_.push_back(std::move(made));
  }
  return Result<SceneBuffers>(std::move(buffers));
}

void SceneBuffers::drawMesh(int index) const {
  const MeshBuffers& mesh = meshes_[std::size_t(index)];
  mesh.vertices.drawIndexed(mesh.index_count);
}

}  // namespace mirrorball
