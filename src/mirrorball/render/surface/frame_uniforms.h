#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "formula/bodies.h"
#include "formula/sun.h"
#include "formula/surface.h"
#include "mirrorball/gl/texture.h"
#include "mirrorball/render/light/flat_light.h"
#include "mirrorball/render/light/proxy_uniforms.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/surface/back_faces.h"
#include "mirrorball/render/surface/pixel_mask.h"
#include "mirrorball/render/surface/texture_coordinates.h"
#include "mirrorball/scene/box.h"
#include "mirrorball/scene/camera/camera.h"

namespace mirrorball {

/// A chain of prefiltered cubes, of which a texture holds the levels from `first_level` on.
struct PrefilteredChain {
  const gl::Texture* texture = nullptr;
  int first_level = 0;

  /// That of roughness 1.
  int lastLevel() const { return first_level + texture->levels() - 1; }
  /// The side of its level 0, in the texture or not.
  int size() const { return texture->width() << first_level; }
};

/// The light that some surfaces of a frame read: cubes as EnvironmentLight has them.
struct SurfaceLight {
  const gl::Texture* environment = nullptr;
  const gl::Sampler* environment_sampler = nullptr;  ///< how it is read; null: as it says itself
  const gl::Texture* prefiltered = nullptr;
  const gl::Texture* irradiance = nullptr;
  formula::Blur blur = {};
  float intensity = 1.0f;  ///< radiance for which a 1 in the textures stands
  glm::mat3 environment_from_world{1.0f};
  glm::vec3 captured_from{0.0f};  ///< of light that has `nearness`: world, as its unit of length
  float nearness_unit = 1.0f;
  const gl::Texture* nearness = nullptr;  ///< formula/proxy/captured_sight.glsl; null: light comes from far away
};

/// The probes' light of a frame, and which instances read it in place of the environment's.
struct ProbeUniforms {
  std::vector<SurfaceLight> lights;
  std::vector<int> light_of_instance;  ///< index; −1: the environment's. Empty: of all
};

/// One drawing of a frame.
struct SampleUniforms {
  Camera camera;
  int number = 0;             ///< of the sample of the frame
  PixelMask* mask = nullptr;  ///< of the pixels that are drawn; null: of all
  // Of pictures that a frame's surfaces reflect. Drivers make a program anew for another test of the stencil, and a
  // surface that sees the screen through itself has another program than one that does not: so these pictures are drawn
  // by the frame's programs.
  bool tests_stencil = false;        ///< without a mask: draws make a mask's test, which all pixels pass
  bool has_empty_screen = false;     ///< where the frame's surfaces see the screen through themselves, they see
                                     ///< what they would without it
  std::span<const int> hidden = {};  ///< instances that are not drawn

  /// Whether draws test the stencil.
  bool limitsPixels() const { return mask || tests_stencil; }
};

/// A sample of a picture that the surfaces of such a frame reflect. What is beside it, it does not show: so nothing is
/// seen there through a surface.
inline SampleUniforms reflectedSample(SampleUniforms sample, const FrameSettings& settings) {
  sample.tests_stencil = sample.mask != nullptr;
  sample.mask = nullptr;
  sample.has_empty_screen = settings.behind == BehindKind::screen;
  return sample;
}

/// What a picture has beside its colours that a sample without a mask is drawn into.
inline gl::Depths depthsFor(const SampleUniforms& sample) {
  return sample.tests_stencil ? gl::Depths::with_stencil : gl::Depths::alone;
}

/// Suns that stand apart from the environment's cubes.
struct SunUniforms {
  std::vector<formula::Sun> suns = {};          ///< in the world, as bright as the frame shows them
  const gl::Texture* shadows = nullptr;         ///< SunShadows::picture; null: there are no suns
  std::span<const glm::vec4> shadow_rows = {};  ///< SunShadows::rows
  bool are_seen = true;                         ///< behind the scene

  /// As shaders/surface/sun_list.glsl reads them.
  std::vector<glm::vec4> rows() const {
    std::vector<glm::vec4> rows;
    for (const formula::Sun& sun : suns) {
      rows.emplace_back(sun.towards, sun.radius);
      rows.emplace_back(sun.irradiance, 0.0f);
    }
    return rows;
  }
};

/// The environment's light as a frame reads it (FrameLight::begin).
struct LightUniforms {
  PrefilteredChain prefiltered;
  glm::mat3 environment_from_world{1.0f};
  ProxyUniforms* proxy = nullptr;           ///< placed as the settings say; must be set
  const FlatLight* flat = nullptr;          ///< where FrameSettings::look_up reads it
  const gl::Texture* sphere_map = nullptr;  ///< of the frame's camera; null: no coordinates are places of it
  SunUniforms suns = {};
};

/// What rays and texture coordinates of a frame need of the scene (SceneDrawing::begin).
struct SceneUniforms {
  CoordinateMatrices coordinates;
  const gl::Texture* bodies = nullptr;     ///< bodyTree() of the scene; null: it has no bodies, or they are not traced
  const gl::Texture* triangles = nullptr;  ///< sceneTree(); null: none are reflected
  std::span<const int> unseen_by_itself = {};  ///< of instances: BodyTree's of that tree
  formula::Media eye_media;                    ///< of traced bodies, those that the camera is inside of
};

/// What surfaces read of pictures of the same drawing (SceneDrawing::draw).
struct ScreenUniforms {
  const BackFaces* back_faces = nullptr;        ///< null: the frame's refraction does without
  const gl::Texture* relief_hits = nullptr;     ///< ReliefHits; null: none is found exactly
  const gl::Texture* opaque_picture = nullptr;  ///< OpaquePicture; null: nothing reads it
  float unit = 1.0f;                            ///< of its distances [world units]
  Box shown = {};                               ///< around all that it shows
};

/// What all surfaces of a drawing share.
struct FrameUniforms {
  SampleUniforms sample;
  LightUniforms light;
  const ProbeUniforms* probes = nullptr;  ///< Probes::begin; null: there are none
  SceneUniforms scene;
  ScreenUniforms screen;
};

}  // namespace mirrorball
