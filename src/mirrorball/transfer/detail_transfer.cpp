#include "mirrorball/transfer/detail_transfer.h"

#include <atomic>
#include <cassert>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/scene/mesh_file/corner_angle.h"
#include "mirrorball/transfer/dense_model.h"
#include "mirrorball/transfer/edge_padding.h"

namespace mirrorball {
namespace {

/// What the samples of a texel add up to; vectors in the space of the map.
struct TexelSums {
  int covered = 0;
  int found = 0;
  glm::vec3 flat{0.0f};  ///< the light surface's own normals
  glm::vec3 normal{0.0f};
  float height = 0.0f;
  float visible = 0.0f;
  glm::vec3 bent{0.0f};
};

struct SampleCounts {
  std::atomic<std::size_t> texels = 0, covered = 0, found = 0, overlapping = 0;
};

/// A unit vector along the first of two that has a direction.
glm::vec3 directionOf(glm::vec3 sum, glm::vec3 otherwise) {
  return unitOr(glm::dvec3(sum), unitOr(glm::dvec3(otherwise), glm::dvec3(0.0, 0.0, 1.0)));
}

void setTexel(Image& map, int x, int y, glm::vec3 value) {
  for (int channel = 0; channel < map.channels(); ++channel) map.texel(x, y)[channel] = value[channel];
}

/// The maps while they are filled.
class Transfer {
 public:
  Transfer(const DenseModel& dense, const MappedSurface& surface, const TexelCover& cover,
           const TransferSettings& settings, float radius)
      : dense_(dense), surface_(surface), cover_(cover), settings_(settings), cage_(settings.cage * radius) {
    const glm::ivec2 size = settings.size;
    maps_.normals = Image(size.x, size.y, 3);
    if (settings.wants_heights) maps_.heights = Image(size.x, size.y, 1);
    if (settings.wants_occlusion) {
      maps_.visible = Image(size.x, size.y, 1, 1.0f);
      maps_.bent_normals = Image(size.x, size.y, 3);
    }
    is_covered_.assign(maps_.normals.texelCount(), 0);
  }

  Result<TransferredDetail> run(const ProgressFunction& progress) {
    const auto rows = std::size_t(settings_.size.y);
    ProgressCounter counter(progress, rows);
    parallelFor(rows, 1, [&](std::size_t begin, std::size_t end) {
      std::vector<CoverSample> samples(std::size_t(settings_.size.x) * cover_.samplesPerTexel());
      for (std::size_t y = begin; y < end && !counter.stopped(); ++y) {
        fillRow(int(y), samples);
        counter.advance();
      }
    });
    MIRRORBALL_TRY_VOID(counter.result());
    if (counts_.covered == 0) return fail(ErrorCode::bad_shape, "no triangle of the light model covers a texel");
    if (counts_.found == 0)
      return fail(
          ErrorCode::bad_shape,
          "no ray from the light model met the dense one; both must be at the same place, of the same size, and "
          "face the same way");
    fillBetween();
    maps_.covered = double(counts_.texels) / double(maps_.normals.texelCount());
    maps_.missed = 1.0 - double(counts_.found) / double(counts_.covered);
    maps_.overlapping = double(counts_.overlapping) / double(counts_.covered);
    return std::move(maps_);
  }

 private:
  void fillRow(int y, std::span<CoverSample> samples) {
    counts_.overlapping += cover_.coverRow(y, samples);
    const std::size_t per_texel = cover_.samplesPerTexel();
    for (int x = 0; x < settings_.size.x; ++x) {
      const TexelSums sums = sumsOf(x, y, samples.subspan(std::size_t(x) * per_texel, per_texel));
      if (sums.covered == 0) continue;
      ++counts_.texels;
      counts_.covered += std::size_t(sums.covered);
      counts_.found += std::size_t(sums.found);
      is_covered_[std::size_t(y) * std::size_t(settings_.size.x) + std::size_t(x)] = 1;
      setMaps(x, y, sums);
    }
  }

  TexelSums sumsOf(int x, int y, std::span<const CoverSample> samples) const {
    TexelSums sums;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (samples[i].triangle == CoverSample::kNothing) continue;
      ++sums.covered;
      const MappedPlace place = surface_.at(samples[i]);
      sums.flat += inSpace(place, place.frame.normal);
      const std::optional<DensePlace> found = dense_.placeAlong(place.position, place.outwards, cage_);
      if (!found) continue;
      ++sums.found;
      sums.normal += inSpace(place, found->normal);
      sums.height += found->height;
      if (!settings_.wants_occlusion) continue;
      const auto per_texel = int(samples.size());
      const VisibleSky sky =
          dense_.skyAt(*found, SampleSequence(std::uint32_t(y * settings_.size.x + x), std::uint32_t(i)),
                       (settings_.occlusion_rays + per_texel - 1) / per_texel);
      sums.visible += sky.share;
      sums.bent += sky.share * inSpace(place, sky.direction);
    }
    return sums;
  }

  void setMaps(int x, int y, const TexelSums& sums) {
    const glm::vec3 normal = directionOf(sums.normal, sums.flat);
    setTexel(maps_.normals, x, y, normal);
    const auto found = float(std::max(sums.found, 1));
    if (settings_.wants_heights) setTexel(maps_.heights, x, y, glm::vec3(sums.height / found));
    if (!settings_.wants_occlusion) return;
    setTexel(maps_.visible, x, y, glm::vec3(sums.found > 0 ? sums.visible / found : 1.0f));
    setTexel(maps_.bent_normals, x, y, directionOf(sums.bent, normal));
  }

  glm::vec3 inSpace(const MappedPlace& place, glm::vec3 world) const {
    return settings_.space == NormalSpace::object ? surface_.objectNormal(place.instance, world)
                                                  : place.frame.toLocal(world);
  }

  /// Texels that no triangle touches: those beside an edge are as the edge, others flat.
  void fillBetween() {
    const std::vector<bool> has_value(is_covered_.begin(), is_covered_.end());
    const EdgePadding padding = edgePadding(has_value, settings_.size, settings_.padding);
    for (Image* map : {&maps_.normals, &maps_.bent_normals}) {
      if (map->empty()) continue;
      for (std::size_t texel = 0; texel < has_value.size(); ++texel)
        if (!has_value[texel]) map->samples()[3 * texel + 2] = 1.0f;
    }
    for (Image* map : {&maps_.normals, &maps_.bent_normals, &maps_.heights, &maps_.visible})
      if (!map->empty()) pad(*map, padding);
  }

  const DenseModel& dense_;
  const MappedSurface& surface_;
  const TexelCover& cover_;
  const TransferSettings& settings_;
  const float cage_;
  TransferredDetail maps_;
  std::vector<char> is_covered_;  ///< of texels; not bits, which threads would share
  SampleCounts counts_;
};

/// Of all that is in memory at a time but the models.
Result<void> checkTransferMemory(const TransferSettings& settings) {
  const std::uint64_t floats = 3u + (settings.wants_heights ? 1u : 0u) + (settings.wants_occlusion ? 4u : 0u);
  constexpr std::uint64_t kOfCover = 8;  // where it is covered, and what pads it
  const std::uint64_t texels = std::uint64_t(settings.size.x) * std::uint64_t(settings.size.y);
  return withName("the maps", checkMemory(texels * (floats * sizeof(float) + kOfCover)));
}

}  // namespace

Result<TransferredDetail> transferDetail(const Scene& high, const Scene& low, const TransferSettings& settings,
                                         const ProgressFunction& progress) {
  assert(settings.size.x >= 1 && settings.size.y >= 1 && settings.samples_side >= 1 && settings.cage >= 0.0f);
  assert(settings.padding >= 0 && settings.occlusion_rays >= 1);
  MIRRORBALL_TRY_VOID(checkDimensions(settings.size.x, settings.size.y));
  MIRRORBALL_TRY_VOID(checkTransferMemory(settings));
  if (high.empty()) return fail(ErrorCode::bad_shape, "the dense model has no triangles");
  const auto outwards =
      settings.cage > 0.0f ? MappedSurface::Outwards::mean_normal : MappedSurface::Outwards::vertex_normal;
  MIRRORBALL_TRY(surface, MappedSurface::make(low, outwards));
  MIRRORBALL_TRY(cover, TexelCover::make(surface.uvTriangles(), settings.size, settings.samples_side));
  const float radius = boundingSphere(low).radius;
  MIRRORBALL_TRY(dense, DenseModel::make(high, radius));
  return Transfer(dense, surface, cover, settings, radius).run(progress);
}

}  // namespace mirrorball
