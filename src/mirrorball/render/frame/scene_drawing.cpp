#include "mirrorball/render/frame/scene_drawing.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <string>
#include <utility>

#include "formula/surface.h"
#include "mirrorball/base/range.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/render/light/probe_places.h"
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

/// Whether the shadow on the ground is all that is seen of it.
bool showsShadowAlone(const FrameSettings& settings) {
  return !settings.showsEnvironment() && settings.proxy.kind == ProxyKind::ground;
}

/// Whether the ground behind the scene is seen, and polished.
bool showsGroundMirror(const FrameSettings& settings) {
  return settings.background == BackgroundKind::environment && settings.proxy.mirrorsScene();
}

}  // namespace

Result<void> SceneDrawing::setScene(Scene scene) {
  MIRRORBALL_TRY(buffers, SceneBuffers::make(scene, TextureUnit::of_material));
  ++version_;
  scene_ = std::move(scene);
  buffers_ = std::move(buffers);
  box_ = boundingBox(scene_);
  boxes_.clear();
  bounds_ = boundingSphere(scene_);
  centers_.clear();
  for (const Mesh& mesh : scene_.meshes) centers_.push_back(centerOf(mesh));
  traits_.clear();
  for (const Instance& instance : scene_.instances) {
    const int index = scene_.meshes[std::size_t(instance.mesh)].material;
    const Material& material = scene_.materials[std::size_t(index)];
    traits_.push_back({index, material.alpha_mode == AlphaMode::blend, material.double_sided, isBody(material)});
  }
  body_tree_.reset();
  bodies_.reset();
  knows_ior_around_.clear();
  scene_triangles_.reset();
  if (surfaces_) surfaces_->forgetScene();
  return {};
}

Result<const gl::Texture*> SceneDrawing::drawNearness(const gl::Framebuffer& picture, const FrameUniforms& frame) {
  if (!nearness_) {
    MIRRORBALL_TRY(made, NearnessPicture::make(surfaces_->api()));
    nearness_ = std::move(made);
  }
  MIRRORBALL_TRY_VOID(nearness_->draw(surfaces_->api(), picture, frame, bounds_.radius));
  return &nearness_->picture();
}

/// Whether mip levels of what is seen through surfaces are read.
bool SceneDrawing::someSeeScreenRoughly(const FrameSettings& settings) const {
  return std::any_of(scene_.materials.begin(), scene_.materials.end(), [&](const Material& each) {
    return seesScreen(each, settings) && (each.perceptual_roughness > 0.0f || hasBumps(each, settings));
  });
}

/// What has been drawn until now, for the surfaces that see it through themselves.
Result<void> SceneDrawing::copyScreen(const gl::Framebuffer& target, const EnvironmentLight& light,
                                      FrameUniforms& frame, const FrameSettings& settings) {
  frame.screen_unit = bounds_.radius;
  if (!opaque_picture_) {
    MIRRORBALL_TRY(made, OpaquePicture::make(surfaces_->api()));
    opaque_picture_ = std::move(made);
  }
  const int levels = someSeeScreenRoughly(settings) ? gl::Texture::kAllLevels : 1;
  MIRRORBALL_TRY_VOID(opaque_picture_->take(target, frame.camera, frame.screen_unit, levels));
  frame.opaque_picture = &opaque_picture_->picture();
  target.bind();
  glEnable(GL_DEPTH_TEST);
  return surfaces_->begin(scene_, buffers_, light, frame, settings);
}

/// Draws what sees the screen, on what has been drawn.
Result<void> SceneDrawing::drawLayers(const gl::Framebuffer& target, const EnvironmentLight& light, FrameUniforms frame,
                                      const FrameSettings& settings, const std::vector<ScreenLayer>& layers) {
  const std::span<const int> hidden = frame.hidden;
  for (const ScreenLayer& layer : layers) {
    if (layers.size() > 1) {
      // The nearest back face is to be of the layer's bodies.
      std::vector<int> others(hidden.begin(), hidden.end());
      for (const ScreenLayer& other : layers)
        if (&other != &layer) others.insert(others.end(), other.instances.begin(), other.instances.end());
      frame.hidden = others;
      MIRRORBALL_TRY_VOID(drawBackFaces(settings, frame));
      frame.hidden = hidden;
    }
    frame.shown = layer.shown;
    MIRRORBALL_TRY_VOID(copyScreen(target, light, frame, settings));
    drawInstances(layer.instances, frame, settings);
  }
  return {};
}

void SceneDrawing::moveInstances(const std::vector<Instance>& instances) {
  assert(instances.size() == scene_.instances.size());
  ++version_;
  scene_.instances = instances;
  box_ = boundingBox(scene_);
  boxes_.clear();
  bounds_ = boundingSphere(scene_);
  scene_triangles_.reset();
  body_tree_.reset();
  bodies_.reset();
  knows_ior_around_.clear();
  if (surfaces_) surfaces_->forgetScene();
}

Result<void> SceneDrawing::begin(const gl::Context& context, const FrameSettings& settings, FrameUniforms& frame) {
  MIRRORBALL_TRY_VOID(makeSurfaces(context.api()));
  MIRRORBALL_TRY_VOID(makePrisms(settings.relief));
  MIRRORBALL_TRY_VOID(background_.make(context.api(), *frame.proxy));
  MIRRORBALL_TRY_VOID(filterMaps(context, settings.texture_filter));
  MIRRORBALL_TRY_VOID(makeBodies(settings, frame));
  MIRRORBALL_TRY_VOID(findIorAround(settings));
  MIRRORBALL_TRY_VOID(makeSceneTriangles(settings, frame));
  MIRRORBALL_TRY(coordinates, coordinateMatrices(scene_, bounds_, frame.camera, settings));
  frame.coordinates = coordinates;
  return {};
}

Result<void> SceneDrawing::makeSurfaces(gl::Api api) {
  if (surfaces_) return {};
  MIRRORBALL_TRY(table, brdf_table_.get());
  MIRRORBALL_TRY(made, SurfacePrograms::make(api, table));
  MIRRORBALL_TRY(depth_pass, DepthPass::make(api));
  surfaces_ = std::move(made);
  depth_pass_ = std::move(depth_pass);
  return {};
}

/// Tells the textures how they are read; the rest the shaders know.
Result<void> SceneDrawing::filterMaps(const gl::Context& context, TextureFilter filter) {
  const float anisotropy = std::min(context.largestAnisotropy(), static_cast<float>(formula::kMostReads));
  if (filter == TextureFilter::anisotropic && anisotropy <= 1.0f)
    return fail(ErrorCode::unsupported, "the graphics driver (" + context.renderer() +
                                            ") has no anisotropic filter (EXT_texture_filter_anisotropic); choose the "
                                            "trilinear one");
  buffers_.filterMaps(scene_, filter, anisotropy);
  return {};
}

/// Of the meshes whose relief is found exactly.
Result<void> SceneDrawing::makePrisms(ReliefKind relief) {
  if (relief != ReliefKind::exact) return {};
  for (const Mesh& mesh : scene_.meshes)
    if (showsHeightTexture(scene_.materials[std::size_t(mesh.material)], relief))
      MIRRORBALL_TRY_VOID(buffers_.makePrisms(scene_, static_cast<int>(&mesh - scene_.meshes.data())));
  return {};
}

/// Whether light passes so through some body.
bool SceneDrawing::someRefract(RefractionKind kind, RefractionKind chosen) const {
  for (std::size_t i = 0; i < scene_.materials.size(); ++i)
    if (isBody(scene_.materials[i]) && refractionOf(scene_, static_cast<int>(i), chosen) == kind) return true;
  return false;
}

Result<void> SceneDrawing::makeBodyTree() {
  if (body_tree_) return {};
  MIRRORBALL_TRY(tree, bodyTree(scene_));
  body_tree_ = std::move(tree);
  return {};
}

/// The bodies for a frame that traces them, and those that its camera is in.
Result<void> SceneDrawing::makeBodies(const FrameSettings& settings, FrameUniforms& frame) {
  frame.bodies = nullptr;
  frame.eye_media = {};
  if (!someRefract(RefractionKind::traced, settings.refraction)) return {};
  MIRRORBALL_TRY_VOID(makeBodyTree());
  if (!body_tree_) return {};
  if (!bodies_) {
    MIRRORBALL_TRY(made, withName("the triangles of glass", gl::Texture::fromWords(body_tree_->words)));
    bodies_ = std::move(made);
  }
  frame.bodies = &*bodies_;
  // The rays of an orthographic camera begin far away.
  if (!frame.camera.orthographic) frame.eye_media = surroundingMedia(scene_, frame.camera.position, *body_tree_);
  for (const int hidden : frame.hidden)
    while (formula::timesEntered(frame.eye_media, hidden) > 0) frame.eye_media = formula::left(frame.eye_media, hidden);
  return {};
}

/// Whether an instance lies in a body.
bool SceneDrawing::liesInBody(std::size_t instance) const {
  for (std::size_t other = 0; other < boxes_.size(); ++other)
    if (isBody(materialOf(scene_, other)) && liesInside(boxes_[instance], boxes_[other])) return true;
  return false;
}

/// What bodies are met from that lie in others, where back faces are looked for in a picture.
Result<void> SceneDrawing::findIorAround(const FrameSettings& settings) {
  if (!someRefract(RefractionKind::image_space, settings.refraction)) return {};
  if (boxes_.empty()) boxes_ = boxesOf(scene_);
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    if (!isBody(materialOf(scene_, i)) || !knows_ior_around_.insert(i).second) continue;
    const bool lies_in_body = liesInBody(i);  // which it may have left
    if (lies_in_body) MIRRORBALL_TRY_VOID(makeBodyTree());
    buffers_.setIorAround(i, lies_in_body && body_tree_ ? iorAround(scene_, i, *body_tree_) : std::vector<float>());
  }
  return {};
}

/// The scene for a frame that reflects it.
Result<void> SceneDrawing::makeSceneTriangles(const FrameSettings& settings, FrameUniforms& frame) {
  frame.scene_triangles = nullptr;
  if (!settings.self_reflection) return {};
  if (!scene_triangles_) {
    MIRRORBALL_TRY(tree, sceneTree(scene_));
    if (!tree) return {};
    MIRRORBALL_TRY(made, withName("the triangles that reflections show", gl::Texture::fromWords(tree->words)));
    scene_triangles_ = std::move(made);
    unseen_by_itself_ = std::move(tree->unseen_by_itself);
  }
  frame.scene_triangles = &*scene_triangles_;
  frame.unseen_by_itself = unseen_by_itself_;
  return {};
}

Result<void> SceneDrawing::drawBackFaces(const FrameSettings& settings, FrameUniforms& frame) {
  frame.back_faces = nullptr;
  if (!someRefract(RefractionKind::image_space, settings.refraction)) return {};
  if (!back_faces_) {
    MIRRORBALL_TRY(made, BackFaces::make(surfaces_->api()));
    back_faces_ = std::move(made);
  }
  frame.back_faces = &*back_faces_;
  return back_faces_->draw(scene_, buffers_, frame.camera, settings.size, frame.hidden);
}

Result<void> SceneDrawing::drawReliefHits(const FrameSettings& settings, FrameUniforms& frame) {
  frame.relief_hits = nullptr;
  if (settings.relief != ReliefKind::exact || scene_.height_textures.empty()) return {};
  if (!relief_hits_) {
    MIRRORBALL_TRY(made, ReliefHits::make(surfaces_->api()));
    relief_hits_ = std::move(made);
  }
  frame.relief_hits = &relief_hits_->picture();
  return relief_hits_->draw(scene_, buffers_, frame.camera, settings.size, frame.hidden);
}

Result<void> SceneDrawing::draw(const gl::Framebuffer& target, const EnvironmentLight& light,
                                const FrameUniforms& frame, const FrameSettings& settings) {
  if (showsGroundMirror(settings)) MIRRORBALL_TRY_VOID(drawMirrored(light, frame, settings));
  return drawOnce(target, light, frame, settings);
}

/// The picture that a polished ground reads.
Result<void> SceneDrawing::drawMirrored(const EnvironmentLight& light, FrameUniforms frame, FrameSettings settings) {
  if (!ground_mirror_) {
    MIRRORBALL_TRY(made, GroundMirror::make(surfaces_->api(), *frame.proxy));
    ground_mirror_ = std::move(made);
  }
  // A rough ground blurs the picture: that of the first sample does for all others, with fewer pixels.
  constexpr float kRough = 0.1f;
  const bool is_blurred = settings.proxy.ground_roughness >= kRough;
  if (is_blurred && frame.sample > 0) return {};
  if (is_blurred) settings.size = (settings.size + 1) / 2;
  const float ground = frame.proxy->proxy().ground;
  MIRRORBALL_TRY(picture, ground_mirror_->begin(frame.camera, ground, bounds_, settings.size));
  frame.camera = ground_mirror_->below();
  frame.eye_media = {};
  settings.background = BackgroundKind::transparent;
  if (settings.behind == BehindKind::screen) settings.behind = BehindKind::probes;  // which is another camera's
  MIRRORBALL_TRY_VOID(drawOnce(*picture, light, frame, settings));
  return ground_mirror_->finish(is_blurred);
}

Result<void> SceneDrawing::drawOnce(const gl::Framebuffer& target, const EnvironmentLight& light, FrameUniforms frame,
                                    const FrameSettings& settings) {
  const bool is_mirrored = glm::determinant(glm::mat3(frame.camera.view_from_world)) < 0.0f;
  glFrontFace(is_mirrored ? GL_CW : GL_CCW);
  const std::vector<int> order = byDistance(frame, false);
  std::vector<ScreenLayer> layers;
  if (settings.behind == BehindKind::screen) {
    if (boxes_.empty()) boxes_ = boxesOf(scene_);
    layers = screenLayers(scene_, boxes_, bounds_.radius, order, settings);
  }
  if (layers.size() <= 1) MIRRORBALL_TRY_VOID(drawBackFaces(settings, frame));
  MIRRORBALL_TRY_VOID(drawReliefHits(settings, frame));
  MIRRORBALL_TRY_VOID(surfaces_->begin(scene_, buffers_, light, frame, settings));
  target.bind();
  const glm::vec4 page = pageOf(settings);
  glClearColor(page.x, page.y, page.z, page.w);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDisable(GL_BLEND);
  // The background covers what is farthest, so it is drawn last of the opaque, and only where nothing else is.
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  std::vector<bool> sees;  // of each material
  for (const Material& material : scene_.materials) sees.push_back(seesScreen(material, settings));
  std::vector<int> seeing_nothing;
  std::copy_if(order.begin(), order.end(), std::back_inserter(seeing_nothing),
               [&](int instance) { return !sees[std::size_t(traits_[std::size_t(instance)].material)]; });
  drawInstances(seeing_nothing, frame, settings);
  if (settings.showsEnvironment() || (!is_mirrored && showsShadowAlone(settings)))
    background_.draw(light, frame, settings);
  if (showsGroundMirror(settings)) ground_mirror_->draw(frame, settings, box_);
  MIRRORBALL_TRY_VOID(drawLayers(target, light, frame, settings, layers));
  drawBlended(frame, settings);
  return {};
}

/// Draws opaque ones; of those whose light is costly, the depths first.
void SceneDrawing::drawInstances(const std::vector<int>& instances, const FrameUniforms& frame,
                                 const FrameSettings& settings) {
  for (const int instance : instances) {
    if (!surfaces_->isCostly(instance)) continue;
    chooseCulling(instance, frame);
    depth_pass_->draw(scene_, instance, buffers_, frame.camera);
  }
  for (const int instance : instances) drawInstance(instance, frame, settings);
}

void SceneDrawing::drawInstance(int instance, const FrameUniforms& frame, const FrameSettings& settings) {
  chooseCulling(instance, frame);
  surfaces_->draw(scene_, instance, buffers_, settings);
}

void SceneDrawing::chooseCulling(int instance, const FrameUniforms& frame) const {
  const Traits& traits = traits_[std::size_t(instance)];
  const bool shows_inside = frame.eye_media.count > 0 && traits.is_body;
  if (traits.is_double_sided || shows_inside)
    glDisable(GL_CULL_FACE);
  else
    glEnable(GL_CULL_FACE);
}

/// The instances of opaque surfaces, the nearest first, since what is near hides what is behind it, which then need not
/// be lit; or of those that shine through, the farthest first, since they are drawn over each other.
///
/// The distance from the eye is the same whichever way it looks: neighbouring faces of a cube show the same order.
std::vector<int> SceneDrawing::byDistance(const FrameUniforms& frame, bool is_blended) const {
  const Camera& camera = frame.camera;
  std::vector<std::pair<float, int>> order;
  for (int index = 0; index < static_cast<int>(scene_.instances.size()); ++index) {
    if (traits_[std::size_t(index)].is_blended != is_blended) continue;
    if (isAmong(frame.hidden, std::size_t(index))) continue;
    const Instance& instance = scene_.instances[std::size_t(index)];
    const glm::vec4 center(centers_[std::size_t(instance.mesh)], 1.0f);
    const glm::vec3 from_eye = glm::vec3(instance.world_from_object * center) - camera.position;
    const float distance = camera.orthographic ? glm::dot(from_eye, camera.forward) : glm::length(from_eye);
    order.emplace_back(is_blended ? -distance : distance, index);
  }
  sortUpBy(order, &std::pair<float, int>::first);
  std::vector<int> instances;
  for (const auto& [distance, index] : order) instances.push_back(index);
  return instances;
}

void SceneDrawing::drawBlended(const FrameUniforms& frame, const FrameSettings& settings) {
  const std::vector<int> blended = byDistance(frame, true);
  if (blended.empty()) return;
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
  for (const int instance : blended) drawInstance(instance, frame, settings);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

}  // namespace mirrorball
