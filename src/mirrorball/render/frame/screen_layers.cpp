#include "mirrorball/render/frame/screen_layers.h"

#include <algorithm>
#include <map>

#include "mirrorball/render/light/probe_places.h"
#include "mirrorball/render/surface/surface_variant.h"
#include "mirrorball/scene/relief/relief.h"

namespace mirrorball {
namespace {

/// Whether what is seen through a body is looked for in the picture, and not traced.
bool showsInside(const Scene& scene, int instance, const FrameSettings& settings) {
  const int material = scene.meshes[std::size_t(scene.instances[std::size_t(instance)].mesh)]->material;
  const Material& of_body = scene.materials[std::size_t(material)];
  return isBody(of_body) && seesScreen(of_body, settings) &&
         refractionOf(scene, material, settings.refraction) != RefractionKind::traced;
}

/// A box that the surfaces lie well inside of, flat ones and those that relief moves, too: a ray finds a surface
/// between a place before it and one behind it.
///
/// radius   of the scene
Box aroundShown(Box box, const Material& material, const FrameSettings& settings, float radius) {
  constexpr float kMargin = 0.02f;
  constexpr float kMarginOfRelief = 0.25f;  // of the box's diagonal
  const bool is_moved = showsHeights(material, settings.relief) && settings.relief != ReliefKind::bump;
  const float margin = kMargin * radius + (is_moved ? kMarginOfRelief * glm::distance(box.low, box.high) : 0.0f);
  return {box.low - margin, box.high + margin};
}

}  // namespace

std::vector<ScreenLayer> screenLayers(const Scene& scene, std::span<const Box> boxes, float radius,
                                      std::span<const int> order, const FrameSettings& settings) {
  Box opaque;
  std::map<std::ptrdiff_t, ScreenLayer> by_depth;  // the innermost first
  for (const int instance : order) {
    const Box& box = boxes[std::size_t(instance)];
    const Material& material = materialOf(scene, std::size_t(instance));
    if (!seesScreen(material, settings)) {
      opaque.include(aroundShown(box, material, settings, radius));
      continue;
    }
    const auto depth = std::count_if(order.begin(), order.end(), [&](int other) {
      const Box& whole = boxes[std::size_t(other)];
      return liesInside(box, whole) && showsInside(scene, other, settings);
    });
    by_depth[-depth].instances.push_back(instance);
  }
  std::vector<ScreenLayer> layers;
  for (auto& [depth, layer] : by_depth) {
    layer.shown = opaque;
    for (const int instance : layer.instances)
      opaque.include(
          aroundShown(boxes[std::size_t(instance)], materialOf(scene, std::size_t(instance)), settings, radius));
    layers.push_back(std::move(layer));
  }
  return layers;
}

}  // namespace mirrorball
