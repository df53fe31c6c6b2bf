#include "mirrorball/view/map/faulty_texels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/file/light_limits.h"

namespace mirrorball {
namespace {

constexpr float kBrightestSummed = 1e36f;  // as ValueCounts::too_bright has it
constexpr int kPartsAcross = 64;           // of the sphere, whose parts are squares of an equal-area map
constexpr std::size_t kParts = std::size_t(kPartsAcross) * kPartsAcross;
constexpr std::size_t kNoTexel = std::numeric_limits<std::size_t>::max();

/// What is known of some rows of a map.
struct FaultsOfRows {
  std::array<std::size_t, 4> counts{};  ///< by TexelFault
  std::vector<std::size_t> first;       ///< texel of each part of the sphere; empty: none has any
};

glm::vec3 directionOfTexel(const EnvironmentMap& map, std::size_t texel) {
  const glm::ivec2 extent = map.extent();
  const auto width = static_cast<std::size_t>(extent.x);
  const std::size_t row = texel / width;
  const auto height = static_cast<std::size_t>(extent.y);
  const glm::vec2 center = glm::vec2(texel % width, row % height) + 0.5f;
  return directionAt(map.projection(), {static_cast<int>(row / height), center / glm::vec2(extent)});
}

std::size_t partOfSphere(glm::vec3 direction) {
  const glm::vec2 place = positionOf(Projection::equal_area, direction).uv * float(kPartsAcross);
  const glm::ivec2 part = glm::clamp(glm::ivec2(place), glm::ivec2(0), glm::ivec2(kPartsAcross - 1));
  return std::size_t(part.y) * kPartsAcross + std::size_t(part.x);
}

/// row      over all faces
void addFaultsOfRow(const EnvironmentMap& map, std::size_t row, FaultsOfRows& faults) {
  const glm::ivec2 extent = map.extent();
  const Image& image = map.face(static_cast<int>(row / std::size_t(extent.y)));
  const auto y = static_cast<int>(row % std::size_t(extent.y));
  for (int x = 0; x < extent.x; ++x) {
    const TexelFault fault = faultOf(rgbAt(image, x, y));
    if (fault == TexelFault::none) continue;
    if (!covers(map.projection(), (glm::vec2(x, y) + 0.5f) / glm::vec2(extent))) continue;
    ++faults.counts[static_cast<std::size_t>(fault)];
    if (faults.first.empty()) faults.first.assign(kParts, kNoTexel);
    const std::size_t texel = row * std::size_t(extent.x) + std::size_t(x);
    std::size_t& first = faults.first[partOfSphere(directionOfTexel(map, texel))];
    first = std::min(first, texel);
  }
}

}  // namespace

std::string_view nameOf(TexelFault fault) {
  constexpr std::array<std::string_view, 4> kFaultNames{"no", "NaN or infinite", "negative", "too bright"};
  return kFaultNames[static_cast<std::size_t>(fault)];
}

TexelFault faultOf(glm::vec3 radiance) {
  if (!std::isfinite(radiance.x) || !std::isfinite(radiance.y) || !std::isfinite(radiance.z))
    return TexelFault::not_finite;
  if (std::min({radiance.x, radiance.y, radiance.z}) < 0.0f) return TexelFault::negative;
  if (std::max({radiance.x, radiance.y, radiance.z}) > kBrightestSummed) return TexelFault::too_bright;
  return TexelFault::none;
}

FaultyTexels faultyTexels(const EnvironmentMap& map) {
  constexpr std::size_t kMostPieces = 64;  // each has a list of all parts
  const std::size_t rows = std::size_t(map.extent().y) * std::size_t(map.faces());
  const std::size_t grain = std::max<std::size_t>((rows + kMostPieces - 1) / kMostPieces, 1);
  std::vector<FaultsOfRows> pieces((rows + grain - 1) / grain);
  parallelFor(rows, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) addFaultsOfRow(map, row, pieces[begin / grain]);
  });
  FaultsOfRows all{{}, std::vector<std::size_t>(kParts, kNoTexel)};
  for (const FaultsOfRows& piece : pieces) {
    for (std::size_t fault = 0; fault < all.counts.size(); ++fault) all.counts[fault] += piece.counts[fault];
    for (std::size_t part = 0; part < piece.first.size(); ++part)
      all.first[part] = std::min(all.first[part], piece.first[part]);
  }
  FaultyTexels faulty{all.counts[1], all.counts[2], all.counts[3]};
  for (const std::size_t texel : all.first)
    if (texel != kNoTexel) faulty.directions.push_back(directionOfTexel(map, texel));
  return faulty;
}

void mendFaults(EnvironmentMap& map) {
  for (int face = 0; face < map.faces(); ++face) {
    Image& image = map.face(face);
    const bool has_light = findNonFinite(image).count < image.texelCount();
    if (!has_light || !repairNonFinite(image)) std::fill(image.samples().begin(), image.samples().end(), 0.0f);
  }
  raiseNegativeLight(map);
  limitLight(map, {.max = kBrightestSummed});
}

}  // namespace mirrorball
