#include "mirrorball/render/stage/staged_scene.h"

#include <algorithm>
#include <span>
#include <utility>

#include "mirrorball/render/light/ground_shadow.h"
#include "mirrorball/render/light/probe_places.h"
#include "mirrorball/render/stage/scene_difference.h"
#include "mirrorball/render/stage/scene_preparation.h"
#include "mirrorball/render/surface/texture_units.h"
#include "mirrorball/scene/bodies/surrounding_media.h"

namespace mirrorball {
namespace {

/// The middle of the box around a mesh, in its own frame.
glm::vec3 centerOf(const Mesh& mesh) {
  if (mesh.vertices.empty()) return glm::vec3(0.0f);
  Box box;
  for (const Vertex& vertex : mesh.vertices) box.include({vertex.position, vertex.position});
  return box.center();
}

InstanceTraits traitsOfInstance(const Scene& scene, const Instance& instance) {
  const int index = scene.meshes[std::size_t(instance.mesh)]->material;
  const Material& material = scene.materials[std::size_t(index)];
  return {index, material.alpha_mode == AlphaMode::blend, material.double_sided, isBody(material)};
}

/// The words of a tree as a texture.
Result<gl::Texture> wordsOf(const BodyTree& tree, const char* what) {
  return withName(what, gl::Texture::fromWords(tree.words));
}

}  // namespace

Result<std::shared_ptr<StagedScene>> StagedScene::make(std::shared_ptr<const Scene> scene, const StagedScene* alike,
                                                       const LevelsOfMaps& levels) {
  std::vector<const SceneBuffers*> all;
  if (alike) all.push_back(&alike->buffers_);
  MIRRORBALL_TRY(buffers, SceneBuffers::make(*scene, kUnitsOfMaterial, all, levels));
  return std::shared_ptr<StagedScene>(new StagedScene(std::move(scene), std::move(buffers)));
}

Result<void> StagedScene::become(std::shared_ptr<const Scene> scene, unsigned changed, const StagedScene* alike,
                                 const LevelsOfMaps& levels) {
  std::vector<const SceneBuffers*> all{&buffers_};
  if (alike) all.push_back(&alike->buffers_);
  MIRRORBALL_TRY(buffers, SceneBuffers::make(*scene, kUnitsOfMaterial, all, levels));
  const std::shared_ptr<const Scene> before = std::exchange(scene_, std::move(scene));
  const bool has_same_meshes = (changed & StagePart::meshes) == 0;
  if (has_same_meshes && (changed & (StagePart::transforms | StagePart::shapes)) == 0) buffers.keepAround(buffers_);
  if (has_same_meshes && (changed & StagePart::shapes) == 0) buffers.keepPrisms(buffers_);
  if (has_same_meshes && before->materials.size() == scene_->materials.size()) {
    buffers.keepBlocks(buffers_);
    for (std::size_t i = 0; i < scene_->instances.size(); ++i)
      if (before->instances[i].world_from_object != scene_->instances[i].world_from_object ||
          knowsBacks(*before, i) != knowsBacks(*scene_, i))
        buffers.blocks().instanceChanged(*scene_, i);
    for (std::size_t i = 0; i < scene_->materials.size(); ++i)
      if (!areSameMaterials(before->materials[i], scene_->materials[i])) buffers.blocks().materialChanged(*scene_, i);
  }
  buffers_ = std::move(buffers);
  versions_.change(changed);
  return {};
}

void StagedScene::transformChanged(std::size_t instance) {
  buffers_.blocks().instanceChanged(scene(), instance);
  versions_.change(StagePart::transforms);
}

void StagedScene::materialChanged(std::size_t index, const Material& before) {
  buffers_.blocks().materialChanged(scene(), index);
  versions_.change(changesShape(before, scene().materials[index]) ? StagePart::materials | StagePart::shapes
                                                                  : StagePart::materials);
}

const BoundingSphere& StagedScene::bounds() const {
  return bounds_.get(versions_, [&] { return boundingSphere(scene()); });
}

const Box& StagedScene::box() const {
  return box_.get(versions_, [&] { return boundingBox(scene()); });
}

const std::vector<Box>& StagedScene::boxes() const {
  return boxes_.get(versions_, [&] { return boxesOf(scene()); });
}

const std::vector<InstanceTraits>& StagedScene::traits() const {
  return traits_.get(versions_, [&] {
    std::vector<InstanceTraits> traits;
    for (const Instance& instance : scene().instances) traits.push_back(traitsOfInstance(scene(), instance));
    return traits;
  });
}

const std::vector<std::vector<PositionRun>>& StagedScene::runs() const {
  return runs_.get(versions_, [&] { return positionRuns(scene()); });
}

const std::vector<glm::vec3>& StagedScene::centers() const {
  return centers_.get(versions_, [&] {
    std::vector<glm::vec3> centers;
    for (const Mesh& mesh : scene().meshes) centers.push_back(centerOf(mesh));
    return centers;
  });
}

Result<const std::optional<BodyTree>*> StagedScene::bodies() {
  MIRRORBALL_TRY(tree, bodies_.tryGet(versions_, [&] { return bodyTree(scene()); }));
  return tree;
}

Result<const gl::Texture*> StagedScene::bodyWords() {
  MIRRORBALL_TRY(tree, bodies());
  MIRRORBALL_TRY(words, body_words_.tryGet(versions_, [&] { return wordsOf(**tree, "the triangles of glass"); }));
  return words;
}

Result<const std::optional<StagedScene::Triangles>*> StagedScene::triangles() {
  const auto make = [&]() -> Result<std::optional<Triangles>> {
    std::optional<std::optional<BodyTree>> offered = scene_tree_.take(versions_);
    if (!offered) {
      MIRRORBALL_TRY(made, sceneTree(scene()));
      offered = std::move(made);
    }
    std::optional<BodyTree>& tree = *offered;
    if (!tree) return std::optional<Triangles>();
    MIRRORBALL_TRY(words, wordsOf(*tree, "the triangles that reflections show"));
    return std::optional<Triangles>(Triangles{std::move(words), std::move(tree->unseen_by_itself)});
  };
  MIRRORBALL_TRY(triangles, triangles_.tryGet(versions_, make));
  return triangles;
}

Result<const SceneRays*> StagedScene::rays() {
  MIRRORBALL_TRY(rays, rays_.tryGet(versions_, [&] { return SceneRays::make(scene_); }));
  return rays;
}

const std::vector<CoarseMesh>& StagedScene::casters() {
  return casters_.get(versions_, [&] { return shadowCasters(scene()); });
}

StagedScene::Rows StagedScene::rows() const {
  Rows rows{.bodies = bodies_.has(versions_),
            .triangles = triangles_.has(versions_) || scene_tree_.has(versions_),
            .rays = rays_.has(versions_),
            .casters = casters_.has(versions_)};
  for (int mesh = 0; mesh < static_cast<int>(scene().meshes.size()); ++mesh)
    if (buffers_.hasPrisms(mesh)) rows.prisms.insert(mesh);
  return rows;
}

Result<void> StagedScene::take(Made made) {
  if (made.bodies) bodies_.offer(versions_, std::move(*made.bodies));
  if (made.triangles) scene_tree_.offer(versions_, std::move(*made.triangles));
  if (made.rays) rays_.offer(versions_, std::move(*made.rays));
  if (made.casters) casters_.offer(versions_, std::move(*made.casters));
  for (auto& [mesh, list] : made.prisms) MIRRORBALL_TRY_VOID(buffers_.makePrisms(scene(), mesh, std::move(list)));
  return {};
}

bool StagedScene::liesInBody(std::size_t instance) const {
  const std::vector<Box>& all = boxes();
  for (std::size_t other = 0; other < all.size(); ++other)
    if (isBody(materialOf(scene(), other)) && liesInside(all[instance], all[other])) return true;
  return false;
}

Result<void> StagedScene::findIorAround() {
  std::set<std::size_t>& known = knows_ior_around_.get(versions_, [] { return std::set<std::size_t>(); });
  for (std::size_t i = 0; i < scene().instances.size(); ++i) {
    if (!isBody(materialOf(scene(), i)) || known.contains(i)) continue;
    std::vector<float> ior;
    if (liesInBody(i)) {  // which it may have left
      MIRRORBALL_TRY(tree, bodies());
      if (*tree) ior = iorAround(scene(), i, **tree);
    }
    buffers_.setIorAround(i, ior);
    known.insert(i);
  }
  return {};
}

Result<void> StagedScene::makePrisms() {
  for (const int mesh : meshesWithPrisms(scene())) MIRRORBALL_TRY_VOID(buffers_.makePrisms(scene(), mesh));
  return {};
}

}  // namespace mirrorball
