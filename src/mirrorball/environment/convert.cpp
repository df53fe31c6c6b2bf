#include "mirrorball/environment/convert.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

/// Points along each side of a target texel, so that they lie no farther apart than the source's texels.
int pointsPerSide(const Environment& source, Projection to, int size) {
  const float ratio = source.texelDensity() / texelDensity(to, size);
  return std::clamp(static_cast<int>(std::ceil(ratio - 0.01f)), 1, 16);
}

/// The mean radiance over the points of a texel that lie where there is light.
glm::vec3 meanOverTexel(const Environment& source, Projection to, int face, glm::vec2 corner, glm::vec2 extent,
                        int points) {
  glm::vec3 sum(0.0f);
  int count = 0;
  for (int j = 0; j < points; ++j)
    for (int i = 0; i < points; ++i) {
      const glm::vec2 inside = (glm::vec2(i, j) + 0.5f) / static_cast<float>(points);
      const glm::vec2 uv = (corner + inside) / extent;
      if (!covers(to, uv)) continue;
      sum += source.radiance(directionAt(to, {face, uv}));
      ++count;
    }
  return sum / static_cast<float>(std::max(count, 1));
}

void fillRow(const Environment& source, Projection to, int face, Image& image, int y, int points) {
  const glm::vec2 extent(image.width(), image.height());
  for (int x = 0; x < image.width(); ++x) {
    const glm::vec2 corner(x, y);
    if (!covers(to, (corner + 0.5f) / extent)) continue;
    const glm::vec3 light = meanOverTexel(source, to, face, corner, extent, points);
    float* texel = image.texel(x, y);
    texel[0] = light.x;
    texel[1] = light.y;
    texel[2] = light.z;
    if (image.channels() == 4) texel[3] = 1.0f;
  }
}

}  // namespace

Result<EnvironmentMap> convert(const Environment& source, Projection to, int size, const ProgressFunction& progress) {
  const glm::ivec2 extent = imageSize(to, size);
  MIRRORBALL_TRY_VOID(checkDimensions("the converted map", extent.x, extent.y));
  ImageSet images(1, faceCount(to));
  for (int face = 0; face < images.faces(); ++face) images.at(0, face) = Image(extent.x, extent.y, hasDisc(to) ? 4 : 3);

  const int points = pointsPerSide(source, to, size);
  const std::size_t rows = std::size_t(images.faces()) * std::size_t(extent.y);
  std::atomic<std::size_t> rows_done = 0;
  std::atomic<bool> stopped = false;
  parallelFor(rows, 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end && !stopped; ++row) {
      const int face = static_cast<int>(row) / extent.y;
      fillRow(source, to, face, images.at(0, face), static_cast<int>(row) % extent.y, points);
    }
    const std::size_t done = rows_done += end - begin;
    if (progress && !progress(done, rows)) stopped = true;
  });
  if (stopped) return fail(ErrorCode::interrupted, "interrupted; nothing was written");
  return EnvironmentMap(to, std::move(images));
}

}  // namespace mirrorball
