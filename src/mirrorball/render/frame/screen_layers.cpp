#include "mirrorball/render/frame/screen_layers.h"

#include <algorithm>
#include <map>

#include "mirrorball/render/light/probe_places.h"
#include "mirrorball/render/surface/surface_variant.h"

namespace mirrorball {
namespace {

/// Whether what is seen through a body is looked for in the picture, and not traced.
bool showsInside(const Scene& scene, int instance, const FrameSettings& settings) {
  const int material = scene.meshes[std::size_t(scene.instances[std::size_t(instance)].mesh)].material;
  const Material& of_body = scene.materials[std::size_t(material)];
  return isBody(of_body) && seesScreen(of_body, settings) &&
         refractionOf(scene, material, settings.refraction) != RefractionKind::traced;
}

}  // namespace

std::vector<ScreenLayer> screenLayers(const Scene& scene, std::span<const Box> boxes, std::span<const int> order,
                                      const FrameSettings& settings) {
  Box opaque;
  std::map<std::ptrdiff_t, ScreenLayer> by_depth;  // the innermost first
  for (const int instance : order) {
    const Box& box = boxes[std::size_t(instance)];
    if (!seesScreen(materialOf(scene, std::size_t(instance)), settings)) {
      opaque.include(box);
      continue;
    }
    const auto depth = std::ranges::count_if(order, [&](int other) {
      const Box& whole = boxes[std::size_t(other)];
      return liesIn(box, whole) && !liesIn(whole, box) && showsInside(scene, other, settings);
    });
    by_depth[-depth].instances.push_back(instance);
  }
  std::vector<ScreenLayer> layers;
  for (auto& [depth, layer] : by_depth) {
    layer.shown = opaque;
    for (const int instance : layer.instances) opaque.include(boxes[std::size_t(instance)]);
    layers.push_back(std::move(layer));
  }
  return layers;
}

}  // namespace mirrorball
