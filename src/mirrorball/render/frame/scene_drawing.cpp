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
#include "mirrorball/render/surface/pixel_cells.h"
#include "mirrorball/scene/bodies/surrounding_media.h"

namespace mirrorball {
namespace {

/// Whether the shadow on the ground is all that is seen of it.
bool showsShadowAlone(const FrameSettings& settings) {
  return !settings.showsEnvironment() && settings.proxy.kind == ProxyKind::ground;
}

/// Whether the ground behind the scene is seen, and polished.
bool showsGroundMirror(const FrameSettings& settings) {
  return settings.background == BackgroundKind::environment && settings.proxy.mirrorsScene();
}

/// Makes a picture that is bound ready to be drawn into.
void clear(const SampleUniforms& sample, glm::vec4 page) {
  if (sample.mask) return sample.mask->clear(page);
  if (sample.tests_stencil) return PixelMask::clearUnlimited(page);
  glClearColor(page.x, page.y, page.z, page.w);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

}  // namespace

Result<const gl::Texture*> SceneDrawing::drawNearness(const gl::Framebuffer& picture, const FrameUniforms& frame) {
  if (!nearness_) {
    MIRRORBALL_TRY(made, NearnessPicture::make(api()));
    nearness_ = std::move(made);
  }
  MIRRORBALL_TRY_VOID(nearness_->draw(api(), picture, frame, staged_->bounds().radius));
  return &nearness_->picture();
}

/// Whether mip levels of what is seen through surfaces are read.
bool SceneDrawing::someSeeScreenRoughly(const FrameSettings& settings) const {
  return std::any_of(scene().materials.begin(), scene().materials.end(), [&](const Material& each) {
    return seesScreen(each, settings) && (each.perceptual_roughness > 0.0f || hasBumps(each, settings));
  });
}

/// Makes the picture of the screen, as large as the frame, if some surfaces see it.
Result<void> SceneDrawing::makeOpaquePicture(const FrameSettings& settings) {
  const std::vector<Material>& materials = scene().materials;
  const auto sees = [&](const Material& each) { return seesScreen(each, settings); };
  if (std::none_of(materials.begin(), materials.end(), sees)) return {};
  if (!opaque_picture_) {
    MIRRORBALL_TRY(made, OpaquePicture::make(api()));
    opaque_picture_ = std::move(made);
  }
  const auto made =
      opaque_picture_->resize(settings.size, someSeeScreenRoughly(settings) ? gl::Texture::kAllLevels : 1);
  if (!made) opaque_picture_.reset();
  return made;
}

/// What has been drawn until now, for the surfaces that see it through themselves.
Result<void> SceneDrawing::copyScreen(const gl::Framebuffer& target, const EnvironmentLight& light,
                                      FrameUniforms& frame, const FrameSettings& settings) {
  frame.screen.unit = staged_->bounds().radius;
  opaque_picture_->take(target, frame.sample.camera, frame.screen.unit);
  frame.screen.opaque_picture = &opaque_picture_->picture();
  target.bind();
  beginSurfaceState(frame.sample, false);
  return beginSurfaces(target, light, frame, settings);
}

/// Draws what sees the screen, on what has been drawn.
Result<void> SceneDrawing::drawLayers(const gl::Framebuffer& target, const EnvironmentLight& light, FrameUniforms frame,
                                      const FrameSettings& settings, const std::vector<ScreenLayer>& layers) {
  const std::span<const int> hidden = frame.sample.hidden;
  for (const ScreenLayer& layer : layers) {
    if (layers.size() > 1) {
      // The nearest back face is to be of the layer's bodies.
      std::vector<int> others(hidden.begin(), hidden.end());
      for (const ScreenLayer& other : layers)
        if (&other != &layer) others.insert(others.end(), other.instances.begin(), other.instances.end());
      frame.sample.hidden = others;
      MIRRORBALL_TRY_VOID(drawBackFaces(settings, frame.sample));
      frame.sample.hidden = hidden;
    }
    frame.screen.shown = layer.shown;
    MIRRORBALL_TRY_VOID(copyScreen(target, light, frame, settings));
    drawInstances(layer.instances, frame, settings);
  }
  return {};
}

Result<SceneUniforms> SceneDrawing::begin(const FrameSettings& settings, const SampleUniforms& sample,
                                          ProxyUniforms& proxy) {
  MIRRORBALL_TRY_VOID(device_->prepare());
  if (settings.relief == ReliefKind::exact) MIRRORBALL_TRY_VOID(staged_->makePrisms());
  MIRRORBALL_TRY_VOID(device_->background.make(api(), proxy));
  MIRRORBALL_TRY_VOID(filterMaps(settings.texture_filter));
  SceneUniforms uniforms;
  MIRRORBALL_TRY_VOID(makeBodies(settings, sample, uniforms));
  // Back faces are looked for in a picture, which does not tell what is around them.
  if (readsBackFaces(settings)) MIRRORBALL_TRY_VOID(staged_->findIorAround());
  MIRRORBALL_TRY_VOID(makeSceneTriangles(settings, uniforms));
  MIRRORBALL_TRY(coordinates, coordinateMatrices(scene(), staged_->bounds(), sample.camera, settings));
  uniforms.coordinates = coordinates;
  if (!sample.has_empty_screen) MIRRORBALL_TRY_VOID(makeOpaquePicture(settings));
  MIRRORBALL_TRY_VOID(makeSearchedPictures(settings));
  return uniforms;
}

/// Tells the textures how they are read; the rest the shaders know.
Result<void> SceneDrawing::filterMaps(TextureFilter filter) {
  const gl::Context& context = device_->context;
  const float anisotropy = std::min(context.largestAnisotropy(), static_cast<float>(formula::kMostReads));
  if (filter == TextureFilter::anisotropic && anisotropy <= 1.0f)
    return fail(ErrorCode::unsupported, "the graphics driver (" + context.renderer() +
                                            ") has no anisotropic filter (EXT_texture_filter_anisotropic); choose the "
                                            "trilinear one");
  staged_->buffers().filterMaps(scene(), filter, anisotropy);
  return {};
}

/// The bodies for a frame that traces them, and those that its camera is in.
Result<void> SceneDrawing::makeBodies(const FrameSettings& settings, const SampleUniforms& sample,
                                      SceneUniforms& uniforms) {
  if (!someRefract(scene(), RefractionKind::traced, settings.refraction)) return {};
  MIRRORBALL_TRY(tree, staged_->bodies());
  if (!*tree) return {};
  MIRRORBALL_TRY(words, staged_->bodyWords());
  uniforms.bodies = words;
  // The rays of an orthographic camera begin far away.
  formula::Media& media = uniforms.eye_media;
  if (!sample.camera.orthographic) media = surroundingMedia(scene(), sample.camera.position, **tree);
  for (const int hidden : sample.hidden)
    while (formula::timesEntered(media, hidden) > 0) media = formula::left(media, hidden);
  return {};
}

/// The scene for a frame that reflects it.
Result<void> SceneDrawing::makeSceneTriangles(const FrameSettings& settings, SceneUniforms& uniforms) {
  if (!settings.self_reflection) return {};
  MIRRORBALL_TRY(triangles, staged_->triangles());
  if (!*triangles) return {};
  uniforms.triangles = &(*triangles)->words;
  uniforms.unseen_by_itself = (*triangles)->unseen_by_itself;
  return {};
}

bool SceneDrawing::readsBackFaces(const FrameSettings& settings) const {
  return someRefract(scene(), RefractionKind::image_space, settings.refraction);
}

bool SceneDrawing::readsReliefHits(const FrameSettings& settings) const {
  return settings.relief == ReliefKind::exact && !scene().height_textures.empty();
}

/// Makes the pictures that surfaces search for bodies and relief, as large as the frame.
Result<void> SceneDrawing::makeSearchedPictures(const FrameSettings& settings) {
  if (readsBackFaces(settings)) {
    if (!back_faces_) {
      MIRRORBALL_TRY(made, BackFaces::make(api()));
      back_faces_ = std::move(made);
    }
    MIRRORBALL_TRY_VOID(back_faces_->resize(settings.size));
  }
  if (!readsReliefHits(settings)) return {};
  if (!relief_hits_) {
    MIRRORBALL_TRY(made, ReliefHits::make(api()));
    relief_hits_ = std::move(made);
  }
  return relief_hits_->resize(settings.size);
}

/// Chooses the pictures of the screen that surfaces read, drawn or not: drivers compile a program for the textures that
/// are bound where it is first drawn.
void SceneDrawing::chooseScreenPictures(const FrameSettings& settings, ScreenUniforms& screen) const {
  screen.opaque_picture =
      settings.behind == BehindKind::screen && opaque_picture_ ? &opaque_picture_->picture() : nullptr;
  screen.back_faces = readsBackFaces(settings) ? &*back_faces_ : nullptr;
  screen.relief_hits = readsReliefHits(settings) ? &relief_hits_->picture() : nullptr;
}

Result<void> SceneDrawing::drawBackFaces(const FrameSettings& settings, const SampleUniforms& sample) {
  if (!readsBackFaces(settings)) return {};
  return back_faces_->draw(scene(), staged_->buffers(), sample.camera, settings.size, sample.hidden);
}

Result<void> SceneDrawing::drawReliefHits(const FrameSettings& settings, const SampleUniforms& sample) {
  if (!readsReliefHits(settings)) return {};
  return relief_hits_->draw(scene(), staged_->buffers(), sample.camera, settings.size, sample.hidden);
}

Result<void> SceneDrawing::draw(const gl::Framebuffer& target, const EnvironmentLight& light,
                                const FrameUniforms& frame, const FrameSettings& settings) {
  MIRRORBALL_TRY_VOID(filterMaps(settings.texture_filter));  // which another view may have changed
  if (showsGroundMirror(settings)) MIRRORBALL_TRY_VOID(drawMirrored(light, frame, settings));
  return drawOnce(target, light, frame, settings);
}

/// The picture that a polished ground reads.
Result<void> SceneDrawing::drawMirrored(const EnvironmentLight& light, FrameUniforms frame, FrameSettings settings) {
  if (!ground_mirror_) {
    MIRRORBALL_TRY(made, GroundMirror::make(api(), *frame.light.proxy));
    ground_mirror_ = std::move(made);
  }
  // A rough ground blurs the picture: one for all samples does, with fewer pixels and one sample of them.
  constexpr float kRough = 0.1f;
  const bool is_blurred = settings.proxy.ground_roughness >= kRough;
  if (is_blurred && frame.sample.number > 0) return {};
  if (is_blurred) {
    const glm::vec2 place = placeOfSample(frame.sample.number, settings.samples);
    frame.sample.camera = shiftedInPixel(frame.sample.camera, place - 0.5f, settings.size);
    settings.size = (settings.size + 1) / 2;
    settings.samples = 1;
  }
  const float ground = frame.light.proxy->proxy().ground;
  frame.sample = reflectedSample(frame.sample, settings);
  MIRRORBALL_TRY(picture, ground_mirror_->begin(frame.sample, ground, staged_->bounds(), settings.size));
  frame.sample.camera = ground_mirror_->below();
  frame.scene.eye_media = {};
  settings.background = BackgroundKind::transparent;
  MIRRORBALL_TRY_VOID(drawOnce(*picture, light, frame, settings));
  return ground_mirror_->finish(is_blurred);
}

Result<void> SceneDrawing::drawOnce(const gl::Framebuffer& target, const EnvironmentLight& light, FrameUniforms frame,
                                    const FrameSettings& settings) {
  const bool is_mirrored = glm::determinant(glm::mat3(frame.sample.camera.view_from_world)) < 0.0f;
  glFrontFace(is_mirrored ? GL_CW : GL_CCW);
  const std::vector<int>& order = byDistance(frame, false);
  std::vector<ScreenLayer> layers;
  if (settings.behind == BehindKind::screen && !frame.sample.has_empty_screen)
    layers = screenLayers(scene(), staged_->boxes(), staged_->bounds().radius, order, settings);
  if (layers.size() <= 1) MIRRORBALL_TRY_VOID(drawBackFaces(settings, frame.sample));
  MIRRORBALL_TRY_VOID(drawReliefHits(settings, frame.sample));
  chooseScreenPictures(settings, frame.screen);
  MIRRORBALL_TRY_VOID(beginSurfaces(target, light, frame, settings));
  target.bind();
  clear(frame.sample, pageOf(settings));
  beginSurfaceState(frame.sample, false);
  // The background covers what is farthest, so it is drawn last of the opaque, and only where nothing else is.
  drawWhatSeesNothing(order, frame, settings);
  if (settings.showsEnvironment() || (!is_mirrored && showsShadowAlone(settings)))
    device_->background.draw(light, frame, settings);
  if (showsGroundMirror(settings)) ground_mirror_->draw(frame, settings, staged_->box());
  keepWhatShowsThrough(layers, frame);
  const Result<void> drawn = drawLayers(target, light, frame, settings, layers);
  if (drawn) drawBlended(frame, settings);
  endSurfaceState();
  return drawn;
}

/// Tells a frame's mask where something shows through surfaces, whose pixels take all samples.
void SceneDrawing::keepWhatShowsThrough(const std::vector<ScreenLayer>& layers, const FrameUniforms& frame) {
  if (!frame.sample.mask || !frame.sample.mask->asksForWhatShowsThrough()) return;
  frame.sample.mask->beginShowingThrough();
  const auto keep = [&](const std::vector<int>& instances) {
    for (const int instance : instances) {
      chooseCulling(instance, frame);
      device_->depthPass().draw(scene(), instance, staged_->buffers(), frame.sample.camera, DepthPass::Offset::nearer);
    }
  };
  for (const ScreenLayer& layer : layers) keep(layer.instances);
  keep(byDistance(frame, true));
  frame.sample.mask->endShowingThrough();
}

/// Draws those of some instances that do not see the screen through themselves.
void SceneDrawing::drawWhatSeesNothing(const std::vector<int>& order, const FrameUniforms& frame,
                                       const FrameSettings& settings) {
  std::vector<bool> sees;  // of each material
  for (const Material& material : scene().materials) sees.push_back(seesScreen(material, settings));
  if (frame.sample.has_empty_screen || !contains(sees, true)) return drawInstances(order, frame, settings);
  const std::vector<InstanceTraits>& traits = staged_->traits();
  std::vector<int> seeing_nothing;
  std::copy_if(order.begin(), order.end(), std::back_inserter(seeing_nothing),
               [&](int instance) { return !sees[std::size_t(traits[std::size_t(instance)].material)]; });
  drawInstances(seeing_nothing, frame, settings);
}

Result<int> SceneDrawing::makeProgram(const gl::Framebuffer& target, const EnvironmentLight& light, FrameUniforms frame,
                                      const FrameSettings& settings) {
  MIRRORBALL_TRY_VOID(filterMaps(settings.texture_filter));  // by which drivers tell programs apart, too
  chooseScreenPictures(settings, frame.screen);
  MIRRORBALL_TRY(made, surfaces_.makeProgram(device_->surfaces(), scene(), staged_->buffers(), light, frame, settings));
  if (!made) return 0;
  target.bind();
  glViewport(0, 0, 1, 1);
  const bool is_blended = staged_->traits()[std::size_t(made->instance)].is_blended;
  beginSurfaceState(frame.sample, is_blended);
  chooseCulling(made->instance, frame);
  if (!is_blended)
    device_->depthPass().draw(scene(), made->instance, staged_->buffers(), frame.sample.camera,
                              DepthPass::Offset::farther);
  surfaces_.tryOut(scene(), staged_->buffers(), settings);
  endSurfaceState();
  return made->left;
}

/// Draws opaque ones; of most, the depths first.
void SceneDrawing::drawInstances(const std::vector<int>& instances, const FrameUniforms& frame,
                                 const FrameSettings& settings) {
  for (const int instance : instances) {
    if (!surfaces_.depthsComeFirst(instance)) continue;
    chooseCulling(instance, frame);
    device_->depthPass().draw(scene(), instance, staged_->buffers(), frame.sample.camera, DepthPass::Offset::farther);
  }
  // Drivers leave nothing in the processor's caches, and the order is not that of the lists: what a draw needs to know
  // is asked for some draws before.
  constexpr std::size_t kAhead = 4;
  const std::vector<InstanceTraits>& traits = staged_->traits();
  for (std::size_t i = 0; i < instances.size(); ++i) {
    if (i + kAhead < instances.size()) {
      __builtin_prefetch(&traits[std::size_t(instances[i + kAhead])]);
      surfaces_.expect(instances[i + kAhead]);
    }
    drawInstance(instances[i], frame, settings);
  }
}

Result<void> SceneDrawing::beginSurfaces(const gl::Framebuffer& target, const EnvironmentLight& light,
                                         const FrameUniforms& frame, const FrameSettings& settings) {
  // Where the instances are makes no difference to how they are drawn.
  const std::uint64_t version = staged_->version(StagePart::scene & ~StagePart::transforms);
  return surfaces_.begin(device_->surfaces(), {device_->context, target}, scene(), staged_->buffers(), version, light,
                         frame, settings);
}

void SceneDrawing::drawInstance(int instance, const FrameUniforms& frame, const FrameSettings& settings) {
  chooseCulling(instance, frame);
  surfaces_.draw(scene(), instance, staged_->buffers(), settings);
}

void SceneDrawing::chooseCulling(int instance, const FrameUniforms& frame) const {
  const InstanceTraits& traits = staged_->traits()[std::size_t(instance)];
  const bool shows_inside = formula::isWithinBody(frame.scene.eye_media) && traits.is_body;
  if (traits.is_double_sided || shows_inside)
    glDisable(GL_CULL_FACE);
  else
    glEnable(GL_CULL_FACE);
}

bool SceneDrawing::Order::isFor(const Order& wanted) const {
  return version == wanted.version && position == wanted.position && forward == wanted.forward &&
         orthographic == wanted.orthographic && is_blended == wanted.is_blended && hidden == wanted.hidden;
}

const std::vector<int>& SceneDrawing::byDistance(const FrameUniforms& frame, bool is_blended) {
  constexpr std::size_t kMostOrders = 6;  // of a picture, its mirror image and a face of a probe
  const Camera& camera = frame.sample.camera;
  Order wanted{.version = staged_->version(StagePart::meshes | StagePart::transforms | StagePart::shapes),
               .position = camera.position,
               .forward = camera.forward,
               .orthographic = camera.orthographic,
               .is_blended = is_blended,
               .hidden = std::vector<int>(frame.sample.hidden.begin(), frame.sample.hidden.end())};
  const auto known =
      std::find_if(orders_.begin(), orders_.end(), [&](const Order& other) { return other.isFor(wanted); });
  if (known != orders_.end()) {
    orders_.splice(orders_.end(), orders_, known);
  } else {
    wanted.instances = sortedByDistance(frame, is_blended);
    orders_.push_back(std::move(wanted));
    if (orders_.size() > kMostOrders) orders_.pop_front();
  }
  return orders_.back().instances;
}

/// The instances of opaque surfaces, the nearest first, since what is near hides what is behind it, which then need not
/// be lit; or of those that shine through, the farthest first, since they are drawn over each other.
///
/// The distance from the eye is the same whichever way it looks: neighbouring faces of a cube show the same order.
std::vector<int> SceneDrawing::sortedByDistance(const FrameUniforms& frame, bool is_blended) const {
  const Camera& camera = frame.sample.camera;
  const std::vector<InstanceTraits>& traits = staged_->traits();
  const std::vector<glm::vec3>& centers = staged_->centers();
  std::vector<std::pair<float, int>> order;
  for (int index = 0; index < static_cast<int>(traits.size()); ++index) {
    if (traits[std::size_t(index)].is_blended != is_blended) continue;
    if (isAmong(frame.sample.hidden, std::size_t(index))) continue;
    const Instance& instance = scene().instances[std::size_t(index)];
    const glm::vec4 center(centers[std::size_t(instance.mesh)], 1.0f);
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
  const std::vector<int>& blended = byDistance(frame, true);
  if (blended.empty()) return;
  gl::setBlending(true);
  for (const int instance : blended) drawInstance(instance, frame, settings);
  gl::setBlending(false);
}

}  // namespace mirrorball
