#include "mirrorball/render/surface/scene_buffers.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include <glm/glm.hpp>

#include "mirrorball/base/parallel.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/height_field/normal_levels.h"
#include "mirrorball/height_field/slope_moments.h"
#include "mirrorball/image/halve.h"
#include "mirrorball/scene/relief/prism_list.h"

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

constexpr std::array<gl::Attribute, 4> kOcclusionAttributes{{
    {6, 4, offsetof(VertexOcclusion, occluded)},  // and `open` after it
    {7, 3, offsetof(VertexOcclusion, interreflected)},
    {8, 3, offsetof(VertexOcclusion, lit_from)},
    {9, 3, offsetof(VertexOcclusion, emitted)},
}};
constexpr std::array<gl::Attribute, 1> kIorAroundAttribute{{{10, 1, 0}}};
static_assert(offsetof(VertexOcclusion, open) == offsetof(VertexOcclusion, occluded) + sizeof(glm::vec3));

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

/// Of a map of heights.
gl::Sampling wrapOf(MapEdges edges) {
  const auto wrap = edges == MapEdges::tiled ? gl::Sampling::Wrap::repeat : gl::Sampling::Wrap::clamp_to_edge;
  return {.wrap_s = wrap, .wrap_t = wrap};
}

gl::Sampling wrapOf(const Texture& texture) {
  return {.magnify_nearest = texture.nearest,
          .wrap_s = samplingWrap(texture.wrap_s),
          .wrap_t = samplingWrap(texture.wrap_t)};
}

/// How the driver reads a texture of a unit of its own.
gl::Sampling samplingOf(gl::Sampling sampling, TextureFilter filter, float anisotropy) {
  sampling.filter = gl::Sampling::Filter::trilinear;
  switch (filter) {
    case TextureFilter::nearest:
      sampling.filter = gl::Sampling::Filter::nearest;
      break;
    case TextureFilter::bilinear:
      sampling.filter = gl::Sampling::Filter::linear;
      break;
    case TextureFilter::anisotropic:
      sampling.anisotropy = anisotropy;
      break;
    case TextureFilter::trilinear:
      break;
  }
  return sampling;
}

/// The mip levels of a texture.
struct MipLevels {
  std::vector<Image8> made;  ///< the last of them: all but the texture's own image, or with spreads all
  bool has_spread = false;   ///< normalLevels()
};

/// Of each texture: whether nothing but normals is read of it.
std::vector<bool> holdNormals(const Scene& scene) {
  std::vector<bool> normals(scene.textures.size(), false);
  for (const bool is_of_normals : {true, false})
    for (const Material& material : scene.materials)
      for (const MaterialMap& map : materialMaps())
        if (const int texture = (material.*map.slot).texture; texture >= 0 && isNormalMap(map) == is_of_normals)
          normals[static_cast<std::size_t>(texture)] = is_of_normals;
  return normals;
}

/// Which texture a material has in a row of materialMaps().
std::size_t textureOf(const Material& material, std::size_t row) {
  return static_cast<std::size_t>((material.*materialMaps()[row].slot).texture);
}

/// The mip levels of colours and numbers after the first.
std::vector<Image8> halvedLevels(const Texture& texture) {
  std::vector<Image8> levels;
  const Image8& first = texture.image;
  const Image8* last = &first;
  while (last->width() > 1 || last->height() > 1) {
    Image8 next = halved(*last, texture.srgb);
    last = &levels.emplace_back(std::move(next));
  }
  return levels;
}

/// Made on all cores: a software driver would take a multiple of the time.
///
/// needed   of each texture: whether its levels are
std::vector<MipLevels> makeMipLevels(const Scene& scene, const std::vector<bool>& normals,
                                     const std::vector<bool>& needed) {
  std::vector<MipLevels> levels(scene.textures.size());
  parallelFor(levels.size(), 1, [&](std::size_t index, std::size_t) {
    if (!needed[index]) return;
    const Texture& texture = scene.textures[index];
    levels[index] = normals[index] ? MipLevels{normalLevels(texture.image), true} : MipLevels{halvedLevels(texture)};
  });
  return levels;
}

/// upload(level, image) for each of a texture's levels.
template <typename Upload>
void forEachLevel(const Texture& texture, const MipLevels& levels, const Upload& upload) {
  int level = 0;
  if (!levels.has_spread) upload(level++, texture.image);
  for (const Image8& image : levels.made) upload(level++, image);
}

Result<gl::Texture> makeTexture(const Texture& texture, const MipLevels& levels) {
  const gl::Format format = texture.srgb ? gl::Format::srgb8_alpha8 : gl::Format::rgba8;
  MIRRORBALL_TRY(made,
                 gl::Texture::make2d(format, texture.image.width(), texture.image.height(), gl::Texture::kAllLevels));
  forEachLevel(texture, levels, [&made](int level, const Image8& image) { made.upload(level, 0, image); });
  return Result<gl::Texture>(std::move(made));
}

/// The array of those textures of a material that are layers, if some are.
Result<std::optional<gl::Texture>> makeLayers(const Scene& scene, const Material& material,
                                              std::span<const MapSource> sources,
                                              const std::vector<MipLevels>& levels) {
  std::map<int, std::size_t> textures;  // layer → texture
  glm::ivec2 size(0);
  for (std::size_t row = 0; row < sources.size(); ++row) {
    if (sources[row].layer < 0) continue;
    const auto texture = static_cast<std::size_t>((material.*materialMaps()[row].slot).texture);
    const Image8& image = scene.textures[texture].image;
    textures[sources[row].layer] = texture;
    size = glm::max(size, glm::ivec2(image.width(), image.height()));
  }
  if (textures.empty()) return std::optional<gl::Texture>();
  MIRRORBALL_TRY(array, gl::Texture::makeArray(gl::Format::rgba8, size.x, size.y, static_cast<int>(textures.size()),
                                               gl::Texture::kAllLevels));
  for (const auto& place : textures)
    forEachLevel(scene.textures[place.second], levels[place.second],
                 [&](int level, const Image8& image) { array.upload(level, place.first, image); });
  return std::optional<gl::Texture>(std::move(array));
}

/// The units that are left to a material's other maps: heights take five (FrameTexture), a map of slopes one.
int unitsOfMaps(const Material& material, int units) {
  if (material.height_texture >= 0) return units - 5;
  return material.slope_texture >= 0 ? units - 1 : units;
}

/// The picture of heights with cones in the second channel.
Image withCones(const HeightTexture& texture) {
  Image both(texture.picture.width(), texture.picture.height(), 2);
  for (int y = 0; y < both.height(); ++y)
    for (int x = 0; x < both.width(); ++x) both.texel(x, y)[0] = texture.picture.texel(x, y)[0];
  for (int y = 0; y < texture.cones.height(); ++y)
    for (int x = 0; x < texture.cones.width(); ++x) both.texel(x, y)[1] = texture.cones.texel(x, y)[0];
  return both;
}

Result<gl::Texture> makeHorizons(const ImageSet& slopes, MapEdges edges) {
  const Image& largest = slopes.at(0, 0);
  MIRRORBALL_TRY(array, gl::Texture::makeArray(gl::Format::rgba16f, largest.width(), largest.height(), slopes.layers(),
                                               slopes.levels()));
  for (int level = 0; level < slopes.levels(); ++level)
    for (int layer = 0; layer < slopes.layers(); ++layer) array.upload(level, layer, slopes.at(level, 0, layer));
  array.setSampling(samplingOf(wrapOf(edges), TextureFilter::trilinear, 1.0f));
  return Result<gl::Texture>(std::move(array));
}

/// For searches, which read single texels.
Result<gl::Texture> makeSearched(const HeightTexture& texture) {
  const Image& picture = texture.picture;
  const gl::Format format = texture.cones.empty() ? gl::Format::r32f : gl::Format::rg32f;
  MIRRORBALL_TRY(made, gl::Texture::make2d(format, picture.width(), picture.height()));
  if (texture.cones.empty())
    made.upload(0, 0, picture);
  else
    made.upload(0, 0, withCones(texture));
  return Result<gl::Texture>(std::move(made));
}

/// A texture for slopes, empty yet, and how many of their finest levels it has no place for.
struct RoomForSlopes {
  gl::Texture texture;
  int finest;
};

/// Room for the slopes of a map of that size. What the driver does not take is left to the lobes, which its variance
/// widens: so a surface looks the same until a texel of the map is nearly as large as a pixel.
///
/// errors   too_large
Result<RoomForSlopes> roomForSlopes(glm::ivec2 size) {
  for (int finest = 0;; ++finest) {
    const glm::ivec2 sides(levelSide(size.x, finest), levelSide(size.y, finest));
    auto texture = gl::Texture::make2d(gl::Format::rgba16f, sides.x, sides.y, gl::Texture::kAllLevels);
    if (!texture && (texture.error().code != ErrorCode::too_large || std::max(sides.x, sides.y) == 1))
      return fail(std::move(texture));
    if (!texture) continue;
    return RoomForSlopes{std::move(*texture), finest};
  }
}

Result<SceneBuffers::Heights> makeHeights(const HeightTexture& texture) {
  std::optional<SceneBuffers::SearchedHeights> searched;
  if (!texture.horizons.slopes.empty()) {
    MIRRORBALL_TRY(heights, makeSearched(texture));
    MIRRORBALL_TRY(horizons, makeHorizons(texture.horizons.slopes, texture.edges));
    searched.emplace(SceneBuffers::SearchedHeights{std::move(heights), std::move(horizons)});
  }
  MIRRORBALL_TRY(room, roomForSlopes({texture.heights.width(), texture.heights.height()}));
  MIRRORBALL_TRY(moments, slopeMoments(texture.heights, texture.edges, room.finest));
  room.texture.upload(moments.levels);
  return SceneBuffers::Heights{std::move(room.texture), moments.unit, std::move(searched)};
}

Result<SceneBuffers::Slopes> makeSlopes(const Image& slopes) {
  MIRRORBALL_TRY(room, roomForSlopes({slopes.width(), slopes.height()}));
  MIRRORBALL_TRY(moments, momentsOfSlopes(slopes, room.finest));
  room.texture.upload(moments.levels);
  return SceneBuffers::Slopes{std::move(room.texture), moments.unit};
}

/// The triangles of boxes as numbers of corners, eight a box, whose bits are x, y, z: outwards counter-clockwise.
std::vector<std::uint32_t> boxCorners(std::size_t boxes) {
  constexpr auto kOfBox = std::to_array<std::uint32_t>(
      {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6});
  std::vector<std::uint32_t> corners;
  corners.reserve(boxes * kOfBox.size());
  for (std::uint32_t box = 0; box < boxes; ++box)
    for (const std::uint32_t corner : kOfBox) corners.push_back(8 * box + corner);
  return corners;
}

}  // namespace

Result<SceneBuffers> SceneBuffers::make(const Scene& scene, int units, const SceneBuffers* alike) {
  SceneBuffers buffers;
  buffers.units_ = units;
  buffers.addMeshes(scene);
  MIRRORBALL_TRY_VOID(buffers.addMaps(scene, alike));
  for (const HeightTexture& texture : scene.height_textures) {
    MIRRORBALL_TRY(heights, withName("heights", makeHeights(texture)));
    buffers.heights_.push_back(std::move(heights));
  }
  for (const Image& image : scene.slope_textures) {
    MIRRORBALL_TRY(slopes, withName("slopes", makeSlopes(image)));
    buffers.slopes_.push_back(std::move(slopes));
  }
  buffers.filterMaps(scene, TextureFilter::trilinear, 1.0f);
  return Result<SceneBuffers>(std::move(buffers));
}

void SceneBuffers::addMeshes(const Scene& scene) {
  for (const Mesh& mesh : scene.meshes)
    meshes_.push_back({gl::VertexArray(gl::Buffer(std::span(mesh.vertices)), sizeof(Vertex), kAttributes,
                                       gl::Buffer(std::span(mesh.indices))),
                       mesh.indices.size()});
  for (const Instance& instance : scene.instances) {
    [[maybe_unused]] const std::size_t vertices = scene.meshes[std::size_t(instance.mesh)].vertices.size();
    assert(instance.occlusion.empty() || instance.occlusion.size() == vertices ||
           instance.occlusion.size() == 2 * vertices);
    auto& occlusion = occlusions_.emplace_back();
    if (!instance.occlusion.empty()) occlusion.emplace(instance.occlusion);
    ior_around_.emplace_back();
  }
}

Result<void> SceneBuffers::addMaps(const Scene& scene, const SceneBuffers* alike) {
  holds_normals_ = holdNormals(scene);
  if (alike && alike->holds_normals_ == holds_normals_) textures_ = alike->textures_;
  textures_.resize(scene.textures.size());
  std::vector<bool> needs_levels(scene.textures.size(), false);
  for (const Material& material : scene.materials) {
    std::vector<MapSource> sources = mapSources(material, scene.textures, unitsOfMaps(material, units_));
    for (std::size_t row = 0; row < sources.size(); ++row) {
      if (sources[row].unit < 0) continue;
      const auto index = textureOf(material, row);
      sources[row].has_spread = isNormalMap(materialMaps()[row]) && holds_normals_[index];
      if (sources[row].layer >= 0 || !textures_[index]) needs_levels[index] = true;
    }
    materials_.push_back({std::move(sources), {}});
  }
  const std::vector<MipLevels> levels = makeMipLevels(scene, holds_normals_, needs_levels);
  for (std::size_t i = 0; i < materials_.size(); ++i) {
    const Material& material = scene.materials[i];
    const std::vector<MapSource>& sources = materials_[i].sources;
    for (std::size_t row = 0; row < sources.size(); ++row) {
      if (sources[row].unit < 0 || sources[row].layer >= 0) continue;
      const auto index = textureOf(material, row);
      if (textures_[index]) continue;
      MIRRORBALL_TRY(made, makeTexture(scene.textures[index], levels[index]));
      textures_[index] = std::make_shared<gl::Texture>(std::move(made));
    }
    MIRRORBALL_TRY(layers, makeLayers(scene, material, sources, levels));
    materials_[i].layers = std::move(layers);
  }
  return {};
}

const SceneBuffers::Heights* SceneBuffers::heightsOf(const Scene& scene, int material) const {
  const int texture = scene.materials[std::size_t(material)].height_texture;
  return texture < 0 ? nullptr : &heights_[std::size_t(texture)];
}

const SceneBuffers::Slopes* SceneBuffers::slopesOf(const Scene& scene, int material) const {
  const int texture = scene.materials[std::size_t(material)].slope_texture;
  return texture < 0 ? nullptr : &slopes_[std::size_t(texture)];
}

const gl::Sampler* SceneBuffers::samplerOf(const gl::Sampling& sampling) {
  return &samplers_.try_emplace(sampling, sampling).first->second;
}

void SceneBuffers::filterMaps(const Scene& scene, TextureFilter filter, float anisotropy) {
  if (filtered_ == std::pair(filter, anisotropy)) return;
  filtered_ = {filter, anisotropy};
  texture_samplers_.clear();
  for (const Texture& texture : scene.textures)
    texture_samplers_.push_back(samplerOf(samplingOf(wrapOf(texture), filter, anisotropy)));
  height_samplers_.clear();
  for (const HeightTexture& texture : scene.height_textures)
    height_samplers_.push_back(samplerOf(samplingOf(wrapOf(texture.edges), filter, anisotropy)));
  if (!scene.slope_textures.empty())
    slope_sampler_ = samplerOf(samplingOf(wrapOf(MapEdges::tiled), filter, anisotropy));
}

void SceneBuffers::bindMaps(const Scene& scene, int material, const TextureUnits& units) const {
  const MaterialMaps& maps = materials_[std::size_t(material)];
  for (std::size_t row = 0; row < maps.sources.size(); ++row) {
    const MapSource& source = maps.sources[row];
    if (source.unit < 0) continue;
    const std::size_t index = textureOf(scene.materials[std::size_t(material)], row);
    const int unit = units.firstOfMaps() + source.unit;
    if (source.layer < 0)
      textures_[index]->bind(unit, texture_samplers_[index]);
    else
      maps.layers->bind(unit);
  }
  if (units.reads(FrameTexture::heights)) {
    const Heights& heights = *heightsOf(scene, material);
    const auto texture = std::size_t(scene.materials[std::size_t(material)].height_texture);
    heights.slopes.bind(units.of(FrameTexture::slopes), height_samplers_[texture]);
    if (heights.searched) heights.searched->heights.bind(units.of(FrameTexture::heights));
    if (heights.searched && units.reads(FrameTexture::horizons))
      heights.searched->horizons.bind(units.of(FrameTexture::horizons));
  } else if (units.reads(FrameTexture::slopes)) {
    slopesOf(scene, material)->texture.bind(units.of(FrameTexture::slopes), slope_sampler_);
  }
}

void SceneBuffers::setIorAround(std::size_t instance, std::span<const float> ior) {
  std::vector<float> less_one(ior.begin(), ior.end());
  for (float& each : less_one) each -= 1.0f;
  std::optional<gl::Buffer>& buffer = ior_around_[instance];
  buffer.reset();
  if (!less_one.empty()) buffer.emplace(less_one);
}

void SceneBuffers::readIorAround(const Scene& scene, int instance) {
  const std::optional<gl::Buffer>& buffer = ior_around_[std::size_t(instance)];
  gl::VertexArray& vertices = meshes_[std::size_t(scene.instances[std::size_t(instance)].mesh)].vertices;
  if (buffer)
    vertices.read(*buffer, sizeof(float), kIorAroundAttribute);
  else
    vertices.stopReading(kIorAroundAttribute[0].location);
}

Result<void> SceneBuffers::makePrisms(const Scene& scene, int mesh) {
  MeshBuffers& buffers = meshes_[std::size_t(mesh)];
  if (buffers.prisms || buffers.index_count == 0) return {};
  const Mesh& base = scene.meshes[std::size_t(mesh)];
  const Material& material = scene.materials[std::size_t(base.material)];
  const HeightTexture& heights = scene.height_textures[std::size_t(material.height_texture)];
  MIRRORBALL_TRY(words, withName("the mesh of a relief", gl::Texture::fromWords(prismList(base, material, heights))));
  const std::vector<std::uint32_t> corners = boxCorners(buffers.index_count / 3);
  buffers.prisms = Prisms{std::move(words), gl::VertexArray(gl::Buffer(std::span(corners))), corners.size()};
  return {};
}

void SceneBuffers::bindPrisms(int mesh, int unit) const {
  if (const auto& prisms = meshes_[std::size_t(mesh)].prisms) prisms->words.bind(unit);
}

void SceneBuffers::drawPrisms(int mesh, int unit) const {
  const std::optional<Prisms>& prisms = meshes_[std::size_t(mesh)].prisms;
  if (!prisms) return;
  prisms->words.bind(unit);
  prisms->boxes.drawIndexed(prisms->index_count);
}

void SceneBuffers::drawMesh(int index) const {
  const MeshBuffers& mesh = meshes_[std::size_t(index)];
  mesh.vertices.drawIndexed(mesh.index_count);
}

void SceneBuffers::drawMeshWithOcclusion(const Scene& scene, int instance) {
  const int mesh = scene.instances[std::size_t(instance)].mesh;
  const auto drawSide = [&](std::size_t first_vertex) {
    std::array<gl::Attribute, kOcclusionAttributes.size()> attributes = kOcclusionAttributes;
    for (gl::Attribute& attribute : attributes) attribute.offset += first_vertex * sizeof(VertexOcclusion);
    meshes_[std::size_t(mesh)].vertices.read(*occlusions_[std::size_t(instance)], sizeof(VertexOcclusion), attributes);
    drawMesh(mesh);
  };
  if (!knowsBacks(scene, std::size_t(instance))) return drawSide(0);
  // What is seen from both sides is drawn a side at a time, each with what is known of it.
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT);
  drawSide(scene.meshes[std::size_t(mesh)].vertices.size());
  glCullFace(GL_BACK);
  drawSide(0);
  glDisable(GL_CULL_FACE);
}

}  // namespace mirrorball
