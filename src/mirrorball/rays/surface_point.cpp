#include "mirrorball/rays/surface_point.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "formula/color.h"
#include "formula/surface.h"
#include "mirrorball/scene/relief/relief_surface.h"

namespace mirrorball {
namespace {

/// The vertices of a triangle, interpolated.
struct Corners {
  std::array<const Vertex*, 3> vertices;
  glm::vec3 weights;

  template <typename Value>
  Value at(Value Vertex::*member) const {
    return weights.x * vertices[0]->*member + weights.y * vertices[1]->*member + weights.z * vertices[2]->*member;
  }
  glm::vec2 uv(int set) const {
    const auto index = static_cast<std::size_t>(set);
    return weights.x * vertices[0]->uv[index] + weights.y * vertices[1]->uv[index] + weights.z * vertices[2]->uv[index];
  }
};

Corners cornersOf(const Scene& scene, const Hit& hit) {
  const Mesh& mesh = scene.meshes[std::size_t(scene.instances[hit.instance].mesh)];
  const std::uint32_t* const corner = mesh.indices.data() + std::size_t{3} * hit.triangle;
  const glm::vec2 b = hit.barycentric;
  return {{&mesh.vertices[corner[0]], &mesh.vertices[corner[1]], &mesh.vertices[corner[2]]}, {1.0f - b.x - b.y, b}};
}

/// A texture as a formula reads it: linear, and without mip levels, since the paths of a pixel are what averages it.
struct TextureMap {
  const Texture& texture;
};
glm::ivec2 mapSize(const TextureMap& map, int) { return {map.texture.image.width(), map.texture.image.height()}; }
glm::vec4 fetchMap(const TextureMap& map, glm::ivec2 texel, int) {
  const glm::vec4 stored = map.texture.image.at(texel.x, texel.y);
  return map.texture.srgb ? glm::vec4(formula::linearFromSrgb(glm::vec3(stored)), stored.w) : stored;
}

/// A map of slopes as a formula reads it.
struct SlopeMap {
  const Image& slopes;
};
glm::ivec2 mapSize(const SlopeMap& map, int) { return {map.slopes.width(), map.slopes.height()}; }
glm::vec4 fetchMap(const SlopeMap& map, glm::ivec2 texel, int) {
  return glm::vec4(rgbAt(map.slopes, texel.x, texel.y), 1.0f);
}

/// What a slot's texture holds there.
///
/// absent   where there is none
glm::vec4 sampleSlot(const Scene& scene, const TextureSlot& slot, const Corners& corners,
                     glm::vec4 absent = glm::vec4(1.0f)) {
  if (slot.texture < 0) return absent;
  const glm::vec2 moved = uvMatrix(slot) * corners.uv(slot.uv_set) + slot.offset;
  const Texture& texture = scene.textures[std::size_t(slot.texture)];
  return formula::filteredMap(TextureMap{texture}, moved, 0.0f,
                              {static_cast<int>(texture.wrap_s), static_cast<int>(texture.wrap_t), texture.nearest});
}

/// base colour and opacity
glm::vec4 colorAt(const Scene& scene, const Material& material, const Corners& corners) {
  return glm::vec4(material.base_color, material.opacity) * corners.at(&Vertex::color) *
         sampleSlot(scene, material.base_color_map, corners);
}

float opacityOf(const Material& material, float alpha) {
  if (material.alpha_mode == AlphaMode::opaque) return 1.0f;
  if (material.alpha_mode == AlphaMode::mask) return alpha < material.alpha_cutoff ? 0.0f : 1.0f;
  return std::clamp(alpha, 0.0f, 1.0f);
}

/// The normal of a mesh with its heights, in its own space.
glm::vec3 normalOfHeights(const Scene& scene, const Hit& hit, const Corners& corners, ReliefKind relief) {
  const Material& material = materialOf(scene, hit.instance);
  const glm::vec3 vertex = corners.at(&Vertex::normal);
  if (!showsHeights(material, relief)) return vertex;
  if (material.height_texture >= 0) {
    const Mesh& mesh = scene.meshes[std::size_t(scene.instances[hit.instance].mesh)];
    const HeightTexture& heights = scene.height_textures[std::size_t(material.height_texture)];
    return reliefNormal(heights, reliefPrism(mesh, std::size_t{3} * hit.triangle, material, heights),
                        material.height_scale, hit.barycentric);
  }
  return formula::orangeNormal(corners.at(&Vertex::position), glm::normalize(vertex), material.height_scale,
                               material.height_frequency, 1.0f);
}

/// How the place changes with texture coordinates on a triangle, each from a unit of the other fixed.
struct Change {
  glm::vec3 along_u{0.0f};
  glm::vec3 along_v{0.0f};
};

Change changeOf(const Corners& corners) {
  const auto [a, b, c] = corners.vertices;
  const glm::vec2 first = b->uv[0] - a->uv[0], second = c->uv[0] - a->uv[0];
  const glm::vec3 along_first = b->position - a->position, along_second = c->position - a->position;
  const float area = first.x * second.y - first.y * second.x;
  if (area == 0.0f) return {};
  return {(along_first * second.y - along_second * first.y) / area,
          (along_second * first.x - along_first * second.x) / area};
}

/// A world's normal bent by the material's map of slopes.
glm::vec3 sloped(const Scene& scene, const Material& material, const Corners& corners, const glm::mat3& world_from_mesh,
                 glm::vec3 n) {
  const Change change = changeOf(corners);
  const glm::vec4 slope =
      formula::filteredMap(SlopeMap{scene.slope_textures[std::size_t(material.slope_texture)]}, corners.uv(0), 0.0f,
                           {formula::kWrapRepeat, formula::kWrapRepeat, false});
  return formula::slopedNormal(world_from_mesh * change.along_u, world_from_mesh * change.along_v, n,
                               material.derivative_scale * glm::vec2(slope.x, slope.z));
}

/// Which way normals are turned from the mesh into the world.
struct Turned {
  glm::mat3 world_from_mesh;
  glm::mat3 world_from_normal;
};

/// The world's normals: of the surface with bumps, slopes and normal map, and of a clear coat, which has its own map.
void setNormals(const Scene& scene, const Hit& hit, const Corners& corners, const Turned& turned, ReliefKind relief,
                SurfacePoint& point) {
  const Material& material = materialOf(scene, hit.instance);
  const auto bent = [&](glm::vec3 n, const TextureSlot& slot, float zero, float scale, NormalSpace space) {
    if (slot.texture < 0) return n;
    const glm::vec3 mapped = formula::decodedNormal(glm::vec3(sampleSlot(scene, slot, corners)), zero);
    return space == NormalSpace::object ? formula::objectMappedNormal(turned.world_from_normal, n, mapped, scale)
                                        : formula::mappedNormal(point.tangent, n, mapped, scale);
  };
  glm::vec3 n = glm::normalize(turned.world_from_normal * normalOfHeights(scene, hit, corners, relief));
  if (material.slope_texture >= 0 && !showsHeights(material, relief))
    n = sloped(scene, material, corners, turned.world_from_mesh, n);
  point.normal = bent(n, material.normal_map, material.normal_zero, material.normal_scale, material.normal_space);
  if (material.clearcoat <= 0.0f) return;
  point.coat_normal =
      bent(glm::normalize(turned.world_from_normal * corners.at(&Vertex::normal)), material.clearcoat_normal_map,
           material.clearcoat_normal_zero, material.clearcoat_normal_scale, NormalSpace::tangent);
}

/// What glTF's extensions lay on the surface.
void setLayers(const Scene& scene, const Material& material, const Corners& corners, SurfacePoint& point) {
  const auto sample = [&](const TextureSlot& slot) { return sampleSlot(scene, slot, corners); };
  formula::Material& m = point.material;
  if (m.clearcoat > 0.0f) {
    m.clearcoat *= sample(material.clearcoat_map).x;
    m.clearcoat_roughness *= sample(material.clearcoat_roughness_map).y;
  }
  if (m.sheen_color != glm::vec3(0.0f)) {
    m.sheen_color *= glm::vec3(sample(material.sheen_color_map));
    m.sheen_roughness *= sample(material.sheen_roughness_map).w;
  }
  if (m.iridescence > 0.0f) {
    m.iridescence *= sample(material.iridescence_map).x;
    m.iridescence_thickness = glm::mix(m.iridescence_thickness_minimum, m.iridescence_thickness,
                                       sample(material.iridescence_thickness_map).y);
  }
  if (m.anisotropy > 0.0f) {
    const glm::vec4 stretched = sampleSlot(scene, material.anisotropy_map, corners, kAbsentAnisotropyMap);
    m.anisotropy *= stretched.z;
    point.stretched = formula::anisotropyTurn(glm::vec2(stretched) * 2.0f - 1.0f, m.anisotropy_rotation);
  }
}

}  // namespace

float opacityAt(const Scene& scene, const Hit& hit) {
  const Material& material = materialOf(scene, hit.instance);
  if (material.alpha_mode == AlphaMode::opaque) return 1.0f;
  return opacityOf(material, colorAt(scene, material, cornersOf(scene, hit)).w);
}

std::vector<glm::mat3> normalMatrices(const Scene& scene) {
  std::vector<glm::mat3> matrices;
  for (const Instance& instance : scene.instances)
    matrices.push_back(glm::transpose(glm::inverse(glm::mat3(instance.world_from_object))));
  return matrices;
}

SurfacePoint surfacePointAt(const Scene& scene, const glm::mat3& world_from_normal, const Hit& hit, ReliefKind relief) {
  const Material& material = materialOf(scene, hit.instance);
  const Corners corners = cornersOf(scene, hit);
  SurfacePoint point;
  const glm::mat3 linear(scene.instances[hit.instance].world_from_object);
  point.tangent = glm::vec4(linear * glm::vec3(corners.at(&Vertex::tangent)), corners.vertices[0]->tangent.w);
  setNormals(scene, hit, corners, {linear, world_from_normal}, relief, point);
  // Degenerate vertices and maps have no normal.
  for (glm::vec3* normal : {&point.normal, &point.coat_normal})
    if (glm::any(glm::isnan(*normal))) *normal = hit.geometric_normal;
  point.material = material;
  point.material.base_color = glm::vec3(colorAt(scene, material, corners));
  point.material.perceptual_roughness *= sampleSlot(scene, material.roughness_map, corners).y;
  point.material.metallic *= sampleSlot(scene, material.metallic_map, corners).z;
  point.material.specular *= sampleSlot(scene, material.specular_map, corners).w;
  point.material.specular_color *= glm::vec3(sampleSlot(scene, material.specular_color_map, corners));
  point.material.transmission *= sampleSlot(scene, material.transmission_map, corners).x;
  point.material.emission *= glm::vec3(sampleSlot(scene, material.emission_map, corners));
  setLayers(scene, material, corners, point);
  if (material.unlit) point.material = formula::unlitMaterial(point.material, point.material.base_color);
  return point;
}

}  // namespace mirrorball
