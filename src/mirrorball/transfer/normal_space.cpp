#include "mirrorball/transfer/normal_space.h"

#include <cassert>
#include <cstddef>
#include <string>
#include <vector>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/scene/mesh_file/corner_angle.h"
#include "mirrorball/transfer/edge_padding.h"

namespace mirrorball {
namespace {

/// What lies at the centre of each texel.
std::vector<CoverSample> coverOfTexels(const TexelCover& cover, glm::ivec2 size) {
  const auto width = std::size_t(size.x);
  std::vector<CoverSample> samples(width * std::size_t(size.y));
  parallelFor(std::size_t(size.y), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) cover.coverRow(int(y), std::span(samples).subspan(y * width, width));
  });
  return samples;
}

/// The texel from which each takes its frame.
std::vector<std::uint32_t> frameSources(const std::vector<CoverSample>& samples, glm::ivec2 size) {
  std::vector<bool> is_covered;
  is_covered.reserve(samples.size());
  for (const CoverSample& sample : samples) is_covered.push_back(sample.triangle != CoverSample::kNothing);
  return edgePadding(is_covered, size).source;
}

glm::vec3 turned(const MappedSurface& surface, const MappedPlace& place, NormalSpace to, glm::vec3 n) {
  if (to == NormalSpace::object) return surface.objectNormal(place.instance, place.frame.toWorld(n));
  return place.frame.toLocal(surface.worldNormal(place.instance, n));
}

bool hasDirection(glm::vec3 n) { return glm::dot(n, n) > 0.0f && glm::dot(n, n) <= 1e30f; }

Result<void> checkNormals(const Image& normals) {
  for (int y = 0; y < normals.height(); ++y)
    for (int x = 0; x < normals.width(); ++x)
      if (!hasDirection(rgbAt(normals, x, y)))
        return fail(ErrorCode::out_of_range, "the texel (" + std::to_string(x) + ", " + std::to_string(y) +
                                                 ") holds no direction; a normal map is wanted");
  return {};
}

}  // namespace

Result<Image> normalsInSpace(const Image& normals, const Scene& model, NormalSpace to,
                             const ProgressFunction& progress) {
  assert(!normals.empty() && normals.channels() >= 3);
  const glm::ivec2 size(normals.width(), normals.height());
  MIRRORBALL_TRY_VOID(checkImageMemory(size.x, size.y, 4));
  MIRRORBALL_TRY_VOID(checkMemory(normals.texelCount() * (sizeof(CoverSample) + sizeof(std::uint32_t))));
  MIRRORBALL_TRY_VOID(checkNormals(normals));
  MIRRORBALL_TRY(surface, MappedSurface::make(model));
  MIRRORBALL_TRY(cover, TexelCover::make(surface.uvTriangles(), size, 1));
  const std::vector<CoverSample> samples = coverOfTexels(cover, size);
  const std::vector<std::uint32_t> sources = frameSources(samples, size);

  Image result = Image::withoutValues(size.x, size.y, 3);
  ProgressCounter counter(progress, std::size_t(size.y));
  parallelFor(std::size_t(size.y), 8, [&](std::size_t begin, std::size_t end) {
    if (counter.stopped()) return;
    for (int y = int(begin); y < int(end); ++y)
      for (int x = 0; x < size.x; ++x) {
        const std::uint32_t source = sources[std::size_t(y) * std::size_t(size.x) + std::size_t(x)];
        glm::vec3 n = unitOr(rgbAt(normals, x, y), glm::dvec3(0.0));  // checkNormals: it has a length
        if (source != EdgePadding::kNothing) n = turned(surface, surface.at(samples[source]), to, n);
        for (int channel = 0; channel < 3; ++channel) result.texel(x, y)[channel] = n[channel];
      }
    counter.advance(end - begin);
  });
  MIRRORBALL_TRY_VOID(counter.result());
  return result;
}

}  // namespace mirrorball
