#pragma once

#include <span>

#include <glm/glm.hpp>

#include "mirrorball/image/image.h"
#include "mirrorball/rays/geometry.h"
#include "mirrorball/render/light/ground_light.h"
#include "mirrorball/scene/box.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Whether light goes through bodies of a scene, which bend it.
bool hasCaustics(const Scene& scene);

/// What bodies stand in.
struct CausticsScene {
  const Scene& scene;
  const Geometry& geometry;    ///< of it
  std::span<const Box> boxes;  ///< of its instances
};

/// What shines on them.
struct GroundSky {
  const Environment& environment;
  const LightSampler& sampler;
  glm::mat3 environment_from_world;
};

/// The light that bodies of glass send on a level ground: rays of the lights that shine on it are followed through
/// them, refracted or reflected by chance in Fresnel's shares, to where they meet the ground (Arvo 1986, "Backward ray
/// tracing"). What is solid ends them. Where bodies hide the ground from a light, all of its straight light is missing:
/// what is added up here comes in its place.
///
/// ground    its height
/// area      the middle of the picture, x and z in the world, and half of its side: it holds the scene
/// size      of the picture, in texels
/// returns   red, green, blue: shares of the ground's irradiance. Row 0 is the least z
/// cost      131 072 rays: 0.3 s of a processor for a ball
Image groundCaustics(const CausticsScene& caught, const GroundSky& sky, float ground, glm::vec3 area, int size);

}  // namespace mirrorball
