#include "mirrorball/render/surface/scene_buffers.h"

#include <array>
#include <cassert>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include <glm/glm.hpp>

#include "mirrorball/gl/gl_api.h"
#include "mirrorball/render/surface/map_sampling.h"
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

/// Which texture a material has in a row of materialMaps().
std::size_t textureOf(const Material& material, std::size_t row) {
  return static_cast<std::size_t>((material.*materialMaps()[row].slot).texture);
}

Result<gl::Texture> makeTexture(const Texture& texture, const MapLevels& levels) {
  const gl::Format format = texture.image.hasNumbers() ? gl::Format::rgba16f
                            : texture.srgb             ? gl::Format::srgb8_alpha8
                                                       : gl::Format::rgba8;
  MIRRORBALL_TRY(made,
                 gl::Texture::make2d(format, texture.image.width(), texture.image.height(), gl::Texture::kAllLevels));
  levels.forEach([&made](int level, const auto& image) { made.upload(level, 0, image); });
  return Result<gl::Texture>(std::move(made));
}

/// The array of some textures: of half floats if one of them holds numbers.
///
/// contents   of its layers
/// levels     of these
Result<gl::Texture> makeLayers(const std::vector<MapContent>& contents, const LevelsOfMaps& levels) {
  glm::ivec2 size(0);
  bool has_numbers = false;
  for (const MapContent& each : contents) {
    const SharedPicture& picture = levels.at(each)->picture;
    size = glm::max(size, glm::ivec2(picture.width(), picture.height()));
    has_numbers = has_numbers || picture.hasNumbers();
  }
  MIRRORBALL_TRY(array, gl::Texture::makeArray(has_numbers ? gl::Format::rgba16f : gl::Format::rgba8, size.x, size.y,
                                               static_cast<int>(contents.size()), gl::Texture::kAllLevels));
  for (std::size_t layer = 0; layer < contents.size(); ++layer)
    levels.at(contents[layer])->forEach([&](int level, const auto& image) {
      if constexpr (std::is_same_v<decltype(image), const Image8&>) {
        if (has_numbers) return array.upload(level, static_cast<int>(layer), fractionsFromCodes(image));
      }
      array.upload(level, static_cast<int>(layer), image);
    });
  return Result<gl::Texture>(std::move(array));
}

/// Of a material's textures those that are layers of its array, by their layer.
std::vector<MapContent> layersOf(const Material& material, std::span<const MapSource> sources,
                                 const std::vector<MapContent>& contents) {
  std::vector<MapContent> layers;
  for (std::size_t row = 0; row < sources.size(); ++row) {
    if (sources[row].layer < 0) continue;
    const auto layer = static_cast<std::size_t>(sources[row].layer);
    if (layers.size() <= layer) layers.resize(layer + 1);
    layers[layer] = contents[textureOf(material, row)];
  }
  return layers;
}

/// The units that are left to a material's other maps: heights take five (FrameTexture), a map of slopes one.
int unitsOfMaps(const Material& material, int units) {
  if (material.height_texture >= 0) return units - 5;
  return material.slope_texture >= 0 ? units - 1 : units;
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

/// Sends each of those that `known` has not yet.
///
/// make     (source) → Result<Made>
template <typename Source, typename Made, typename Make>
Result<void> send(const std::vector<Shared<Source>>& sources,
                  const std::vector<const std::vector<SentPointer<Source, Made>>*>& known,
                  std::vector<SentPointer<Source, Made>>& sent, const Make& make) {
  std::map<const Source*, SentPointer<Source, Made>> all;
  for (const auto* of_scene : known)
    for (const auto& each : *of_scene) all.emplace(&*each->source, each);
  for (const Shared<Source>& source : sources) {
    SentPointer<Source, Made>& place = all[&*source];
    if (!place) {
      MIRRORBALL_TRY(made, make(*source));
      place = std::make_shared<Sent<Source, Made>>(Sent<Source, Made>{source, std::move(made)});
    }
    sent.push_back(place);
  }
  return {};
}

/// The same list of each of them.
template <typename List>
std::vector<const List*> allOf(std::span<const SceneBuffers* const> all, List SceneBuffers::*list) {
  std::vector<const List*> lists;
  for (const SceneBuffers* each : all) lists.push_back(&(each->*list));
  return lists;
}

}  // namespace

Result<SceneBuffers> SceneBuffers::make(const Scene& scene, int units, std::span<const SceneBuffers* const> alike,
                                        const LevelsOfMaps& levels) {
  SceneBuffers buffers;
  buffers.units_ = units;
  const auto meshes = [](const Mesh& mesh) -> Result<MeshBuffers> {
    return MeshBuffers{gl::VertexArray(gl::Buffer(std::span(mesh.vertices)), sizeof(Vertex), kAttributes,
                                       gl::Buffer(std::span(mesh.indices))),
                       mesh.indices.size()};
  };
  MIRRORBALL_TRY_VOID(send(scene.meshes, allOf(alike, &SceneBuffers::meshes_), buffers.meshes_, meshes));
  buffers.prisms_.resize(scene.meshes.size());
  buffers.addOcclusion(scene);
  MIRRORBALL_TRY_VOID(buffers.addMaps(scene, alike, levels));
  const auto heights = [](const HeightTexture& each) { return withName("heights", HeightBuffers::make(each)); };
  MIRRORBALL_TRY_VOID(send(scene.height_textures, allOf(alike, &SceneBuffers::heights_), buffers.heights_, heights));
  const auto slopes = [](const Image& each) { return withName("slopes", SlopeBuffer::make(each)); };
  MIRRORBALL_TRY_VOID(send(scene.slope_textures, allOf(alike, &SceneBuffers::slopes_), buffers.slopes_, slopes));
  buffers.filterMaps(scene, TextureFilter::trilinear, 1.0f);
  return Result<SceneBuffers>(std::move(buffers));
}

void SceneBuffers::addOcclusion(const Scene& scene) {
  for (const Instance& instance : scene.instances) {
    [[maybe_unused]] const std::size_t vertices = scene.meshes[std::size_t(instance.mesh)]->vertices.size();
    assert(instance.occlusion.empty() || instance.occlusion.size() == vertices ||
           instance.occlusion.size() == 2 * vertices);
    auto& occlusion = occlusions_.emplace_back();
    if (!instance.occlusion.empty()) occlusion.emplace(instance.occlusion);
    ior_around_.emplace_back();
  }
}

/// Deals out each material's textures.
///
/// returns  of each texture whether its levels are needed
std::vector<bool> SceneBuffers::addSources(const Scene& scene, const SentMaps& sent) {
  std::vector<bool> needs_levels(scene.textures.size(), false);
  for (const Material& material : scene.materials) {
    std::vector<MapSource> sources = mapSources(material, scene.textures, unitsOfMaps(material, units_));
    const bool has_layers = sent.layers.contains(layersOf(material, sources, contents_));
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < sources.size(); ++row) {
      if (sources[row].unit < 0) continue;
      rows.push_back(row);
      const auto index = textureOf(material, row);
      sources[row].has_spread = materialMaps()[row].holdsNormals() && contents_[index].holds_normals;
      sources[row].is_decoded = sources[row].has_spread && scene.textures[index].image.hasNumbers();
      const bool is_sent = sources[row].layer >= 0 ? has_layers : sent.textures.contains(contents_[index]);
      if (!is_sent) needs_levels[index] = true;
    }
    materials_.push_back({std::move(sources), {}, std::move(rows)});
  }
  return needs_levels;
}

Result<void> SceneBuffers::addMaps(const Scene& scene, std::span<const SceneBuffers* const> alike,
                                   const LevelsOfMaps& known) {
  contents_ = contentsOfMaps(scene);
  SentMaps sent;
  for (const SceneBuffers* other : alike) {
    for (const auto& each : other->textures_)
      if (each) sent.textures.emplace(each->content, each);
    for (const MaterialMaps& each : other->materials_)
      if (each.layers) sent.layers.emplace(each.layers->contents, each.layers);
  }
  const std::vector<bool> needs_levels = addSources(scene, sent);
  MIRRORBALL_TRY(levels, makeMapLevels(scene, contents_, needs_levels, known));
  textures_.resize(scene.textures.size());
  for (std::size_t i = 0; i < materials_.size(); ++i) MIRRORBALL_TRY_VOID(addMapsOf(scene, i, levels, sent));
  return {};
}

Result<void> SceneBuffers::addMapsOf(const Scene& scene, std::size_t index, const LevelsOfMaps& levels,
                                     SentMaps& sent) {
  const Material& material = scene.materials[index];
  const std::vector<MapSource>& sources = materials_[index].sources;
  std::vector<SharedPicture> pictures;
  for (const std::size_t row : materials_[index].rows) {
    const auto texture = textureOf(material, row);
    const SharedPicture& picture = scene.textures[texture].image;
    if (sources[row].layer >= 0) {
      pictures.push_back(picture);
      continue;
    }
    std::shared_ptr<MapTexture>& place = sent.textures[contents_[texture]];
    if (!place) {
      MIRRORBALL_TRY(made, makeTexture(scene.textures[texture], *levels.at(contents_[texture])));
      place = std::make_shared<MapTexture>(MapTexture{contents_[texture], picture, std::move(made)});
    }
    textures_[texture] = place;
  }
  const std::vector<MapContent> layers = layersOf(material, sources, contents_);
  if (layers.empty()) return {};
  std::shared_ptr<LayersOfMaps>& place = sent.layers[layers];
  if (!place) {
    MIRRORBALL_TRY(array, makeLayers(layers, levels));
    place = std::make_shared<LayersOfMaps>(LayersOfMaps{layers, std::move(pictures), std::move(array)});
  }
  materials_[index].layers = place;
  return {};
}

const HeightBuffers* SceneBuffers::heightsOf(const Scene& scene, int material) const {
  const int texture = scene.materials[std::size_t(material)].height_texture;
  return texture < 0 ? nullptr : &heights_[std::size_t(texture)]->made;
}

const SlopeBuffer* SceneBuffers::slopesOf(const Scene& scene, int material) const {
  const int texture = scene.materials[std::size_t(material)].slope_texture;
  return texture < 0 ? nullptr : &slopes_[std::size_t(texture)]->made;
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
  for (const std::size_t row : maps.rows) {
    const MapSource& source = maps.sources[row];
    const std::size_t index = textureOf(scene.materials[std::size_t(material)], row);
    const int unit = units.firstOfMaps() + source.unit;
    if (source.layer < 0)
      textures_[index]->texture.bind(unit, texture_samplers_[index]);
    else
      maps.layers->array.bind(unit);
  }
  if (units.reads(FrameTexture::heights)) {
    const HeightBuffers& heights = *heightsOf(scene, material);
    const auto texture = std::size_t(scene.materials[std::size_t(material)].height_texture);
    heights.slopes.bind(units.of(FrameTexture::slopes), height_samplers_[texture]);
    if (heights.searched) heights.searched->heights.bind(units.of(FrameTexture::heights));
    if (heights.searched && units.reads(FrameTexture::horizons))
      heights.searched->horizons.bind(units.of(FrameTexture::horizons));
  } else if (units.reads(FrameTexture::slopes)) {
    slopesOf(scene, material)->texture.bind(units.of(FrameTexture::slopes), slope_sampler_);
  }
}

bool SceneBuffers::bindTexture(std::size_t texture, int unit) const {
  if (!textures_[texture]) return false;
  textures_[texture]->texture.bind(unit, texture_samplers_[texture]);
  return true;
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
  gl::VertexArray& vertices = meshes_[std::size_t(scene.instances[std::size_t(instance)].mesh)]->made.vertices;
  if (buffer)
    vertices.read(*buffer, sizeof(float), kIorAroundAttribute);
  else
    vertices.stopReading(kIorAroundAttribute[0].location);
}

Result<void> SceneBuffers::makePrisms(const Scene& scene, int mesh, std::vector<glm::uvec4> list) {
  std::optional<Prisms>& prisms = prisms_[std::size_t(mesh)];
  const Mesh& base = scene.meshes[std::size_t(mesh)];
  if (prisms || base.indices.empty()) return {};
  if (list.empty()) list = prismList(scene, mesh);
  MIRRORBALL_TRY(words, withName("the mesh of a relief", gl::Texture::fromWords(list)));
  const std::vector<std::uint32_t> corners = boxCorners(base.indices.size() / 3);
  prisms = Prisms{std::move(words), gl::VertexArray(gl::Buffer(std::span(corners))), corners.size()};
  return {};
}

void SceneBuffers::bindPrisms(int mesh, int unit) const {
  if (const auto& prisms = prisms_[std::size_t(mesh)]) prisms->words.bind(unit);
}

void SceneBuffers::drawPrisms(int mesh, int unit) const {
  const std::optional<Prisms>& prisms = prisms_[std::size_t(mesh)];
  if (!prisms) return;
  prisms->words.bind(unit);
  prisms->boxes.drawIndexed(prisms->index_count);
}

void SceneBuffers::drawMesh(int index) const {
  const MeshBuffers& mesh = meshes_[std::size_t(index)]->made;
  mesh.vertices.drawIndexed(mesh.index_count);
}

void SceneBuffers::drawMeshWithOcclusion(const Scene& scene, int instance) {
  const int mesh = scene.instances[std::size_t(instance)].mesh;
  const auto drawSide = [&](std::size_t first_vertex) {
    std::array<gl::Attribute, kOcclusionAttributes.size()> attributes = kOcclusionAttributes;
    for (gl::Attribute& attribute : attributes) attribute.offset += first_vertex * sizeof(VertexOcclusion);
    meshes_[std::size_t(mesh)]->made.vertices.read(*occlusions_[std::size_t(instance)], sizeof(VertexOcclusion),
                                                   attributes);
    drawMesh(mesh);
  };
  if (!knowsBacks(scene, std::size_t(instance))) return drawSide(0);
  // What is seen from both sides is drawn a side at a time, each with what is known of it.
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT);
  drawSide(scene.meshes[std::size_t(mesh)]->vertices.size());
  glCullFace(GL_BACK);
  drawSide(0);
  glDisable(GL_CULL_FACE);
}

}  // namespace mirrorball
