#include "mirrorball/render/stage/scene_difference.h"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <vector>

#include "mirrorball/render/stage/derived.h"

namespace mirrorball {
namespace {

/// Of values that are nothing but numbers of four bytes.
template <typename Value>
bool haveSameBytes(const Value& a, const Value& b) {
  static_assert(std::is_trivially_copyable_v<Value> && alignof(Value) == sizeof(float));
  return std::memcmp(&a, &b, sizeof a) == 0;
}

template <typename Value, typename AreSame>
bool areAll(const std::vector<Value>& a, const std::vector<Value>& b, const AreSame& are_same) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), are_same);
}

template <typename Value>
bool areShared(const std::vector<Shared<Value>>& a, const std::vector<Shared<Value>>& b) {
  return areAll(a, b, [](const auto& left, const auto& right) { return left.isSameAs(right); });
}

bool haveSameHeights(const Material& a, const Material& b) {
  return a.height == b.height && a.height_texture == b.height_texture && a.height_scale == b.height_scale &&
         a.height_frequency == b.height_frequency;
}

bool areSameTextures(const Texture& a, const Texture& b) {
  return a.image.isSameAs(b.image) && a.srgb == b.srgb && a.wrap_s == b.wrap_s && a.wrap_t == b.wrap_t &&
         a.nearest == b.nearest;
}

/// What an instance knows of the scene around it.
bool knowSame(const Instance& a, const Instance& b) {
  return areAll(a.occlusion, b.occlusion, haveSameBytes<VertexOcclusion>) &&
         areAll(a.vertex_materials, b.vertex_materials, haveSameBytes<VertexMaterial>) &&
         areAll(a.holes, b.holes, [](const TriangleHoles& left, const TriangleHoles& right) {
           return left.rows == right.rows && left.bits == right.bits;
         });
}

}  // namespace

bool haveSameBuffers(const Material& a, const Material& b) {
  for (const MaterialMap& map : materialMaps())
    if ((a.*map.slot).texture != (b.*map.slot).texture) return false;
  return a.slope_texture == b.slope_texture && haveSameHeights(a, b);
}

bool changesShape(const Material& a, const Material& b) {
  // `b` with all of `a` that is only light on its surface.
  formula::Material lit_alike = b;
  for (float formula::Material::*const number :
       {&formula::Material::metallic, &formula::Material::perceptual_roughness, &formula::Material::specular})
    lit_alike.*number = a.*number;
  for (glm::vec3 formula::Material::*const color : {&formula::Material::base_color, &formula::Material::specular_color,
                                                    &formula::Material::emission, &formula::Material::sheen_color})
    lit_alike.*color = a.*color;
  return !haveSameBytes<formula::Material>(lit_alike, a) || a.alpha_mode != b.alpha_mode ||
         a.double_sided != b.double_sided || a.unlit != b.unlit || a.thin_walled != b.thin_walled ||
         a.priority != b.priority;
}

bool areSameMaterials(const Material& a, const Material& b) {
  const auto has_same_slot = [&](const MaterialMap& map) { return a.*map.slot == b.*map.slot; };
  const auto maps = materialMaps();
  return haveSameBytes<formula::Material>(a, b) && !changesShape(a, b) && haveSameBuffers(a, b) &&
         a.normal_space == b.normal_space && std::all_of(maps.begin(), maps.end(), has_same_slot);
}

bool haveSameRelief(const Scene& a, const Scene& b) {
  return areShared(a.meshes, b.meshes) && areShared(a.height_textures, b.height_textures) &&
         areAll(a.materials, b.materials, haveSameHeights);
}

unsigned differingParts(const Scene& a, const Scene& b) {
  unsigned parts = 0;
  const auto note = [&parts](bool are_same, unsigned part) { parts |= are_same ? 0u : part; };
  const auto place_same = [](const Instance& left, const Instance& right) {
    return left.world_from_object == right.world_from_object;
  };
  const auto shine_same = [](const ModelLight& left, const ModelLight& right) {
    return haveSameBytes<formula::Lamp>(left, right);
  };
  const auto are_alike = [](const Material& left, const Material& right) {
    return haveSameBuffers(left, right) && !changesShape(left, right);
  };
  const auto show_same = [](const Instance& left, const Instance& right) { return left.mesh == right.mesh; };
  note(areShared(a.meshes, b.meshes) && areAll(a.instances, b.instances, show_same), StagePart::meshes);
  note(areAll(a.instances, b.instances, place_same) && a.cameras == b.cameras, StagePart::transforms);
  note(areAll(a.instances, b.instances, knowSame), StagePart::occlusion);
  note(areAll(a.lights, b.lights, shine_same), StagePart::lights);
  note(areAll(a.materials, b.materials, areSameMaterials), StagePart::materials);
  // Alpha masks and reliefs are of textures.
  note(areAll(a.materials, b.materials, are_alike) && areAll(a.textures, b.textures, areSameTextures) &&
           areShared(a.height_textures, b.height_textures) && areShared(a.slope_textures, b.slope_textures),
       StagePart::materials | StagePart::shapes);
  return parts;
}

}  // namespace mirrorball
