#include "mirrorball/render/surface/sphere_map.h"

#include <algorithm>

#include "formula/projection.h"
#include "mirrorball/base/parallel.h"

namespace mirrorball {

Image sphereMapTexture(const Environment& environment, const glm::mat3& environment_from_view, int size) {
  Image image(size, size, 3);
  parallelFor(std::size_t(size), 8, [&](std::size_t begin, std::size_t end) {
    for (auto y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      for (int x = 0; x < size; ++x) {
        const glm::vec2 st = (glm::vec2(x, y) + 0.5f) / static_cast<float>(size);
        const glm::vec3 light = environment.radiance(environment_from_view * formula::sphereMapDirection(st));
        std::copy_n(&light.x, 3, image.texel(x, y));
      }
  });
  return image;
}

}  // namespace mirrorball
