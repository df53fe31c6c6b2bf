#include "mirrorball/environment/projection/projection.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "formula/constants.h"
#include "formula/projection.h"
#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

/// What the kinds differ in beside their formulas.
struct ProjectionRow {
  Projection::Kind kind;
  std::string_view name;
  int images = 1;
  bool has_disc = false;       ///< the light of an image fills a disc, and not all of it
  int aspect = 1;              ///< of an image: width / height
  int panorama_rows = 1;       ///< of a panorama of about equal detail, for each unit of size
  bool is_hemisphere = false;  ///< only directions with z ≥ 0 have a place
};

/// In the order of the kinds.
constexpr auto kRows = std::to_array<ProjectionRow>({
    {.kind = Projection::equirect, .name = "equirect", .aspect = 2},
    {.kind = Projection::sphere, .name = "sphere", .has_disc = true},
    {.kind = Projection::angular, .name = "angular", .has_disc = true},
    {.kind = Projection::cube, .name = "cube", .images = 6, .panorama_rows = 2},
    {.kind = Projection::ball, .name = "ball", .has_disc = true},
    {.kind = Projection::paraboloid, .name = "paraboloid", .images = 2, .has_disc = true},
    {.kind = Projection::octahedral, .name = "octahedral"},
    {.kind = Projection::hemioctahedral, .name = "hemioctahedral", .is_hemisphere = true},
    {.kind = Projection::equal_area, .name = "equal-area"},
    {.kind = Projection::eac, .name = "eac", .images = 6, .panorama_rows = 2},
});
static_assert(
    [] {
      for (std::size_t row = 0; row < kRows.size(); ++row)
        if (kRows[row].kind != static_cast<Projection::Kind>(row)) return false;
      return kRows.size() == Projection::kKinds;
    }(),
    "each kind has its row, in the order of the kinds");

constexpr const ProjectionRow& rowOf(Projection projection) { return kRows[projection.kind]; }

constexpr auto kNames = [] {
  std::array<std::string_view, kRows.size()> names;
  for (std::size_t row = 0; row < names.size(); ++row) names[row] = kRows[row].name;
  return names;
}();

constexpr auto kAliases = std::to_array<Alias>({{"equirectangular", "equirect"},
                                                {"latlong", "equirect"},
                                                {"lat-long", "equirect"},
                                                {"panorama", "equirect"},
                                                {"cubemap", "cube"},
                                                {"mirror-ball", "ball"},
                                                {"dual-paraboloid", "paraboloid"},
                                                {"octahedron", "octahedral"},
                                                {"equiangular", "eac"}});

constexpr std::string_view kBallParameter = "distance=";

/// The image's v grows downwards, OpenGL's t of a sphere map upwards.
glm::vec2 flipped(glm::vec2 st) { return {st.x, 1.0f - st.y}; }

/// The k of formula/projection/mirror_ball.glsl.
float nearness(Projection projection) { return 1.0f / projection.ball_distance; }

}  // namespace

std::span<const std::string_view> projectionNames() { return kNames; }

std::span<const Alias> projectionAliases() { return kAliases; }

std::string_view nameOf(Projection projection) { return rowOf(projection).name; }

std::string textOf(Projection projection) {
  std::string text(nameOf(projection));
  if (projection == Projection::ball)
    text += ":" + std::string(kBallParameter) + formatNumber(double(projection.ball_distance));
  return text;
}

Result<Projection> ballAtDistance(std::string_view written) {
  const auto distance = parseNumber(written);
  if (!distance || *distance < double(Projection::kMinBallDistance))
    return fail(ErrorCode::usage, "the distance of a ball's camera is '" + excerpt(written) +
                                      "'; it takes a number of ball radii, at least " +
                                      formatNumber(double(Projection::kMinBallDistance)));
  return Projection::ballFrom(static_cast<float>(*distance));
}

Result<Projection> projectionNamed(std::string_view name) {
  const std::size_t colon = name.find(':');
  const auto found = indexOfName(name.substr(0, colon), kNames, kAliases);
  if (!found) return tl::unexpected<Error>(unknownName("projection", name, kNames, kAliases));
  const auto kind = static_cast<Projection::Kind>(*found);
  if (colon == std::string_view::npos) return kind;
  const std::string_view parameter = name.substr(colon + 1);
  if (kind == Projection::ball && !parameter.starts_with(kBallParameter))
    return fail(ErrorCode::usage, "'" + excerpt(name) + "': a ball's parameter is distance, as in ball:distance=20");
  if (kind != Projection::ball)
    return fail(ErrorCode::usage, "'" + excerpt(name) + "': only a ball takes a parameter, as in ball:distance=20");
  return ballAtDistance(parameter.substr(kBallParameter.size()));
}

MapPosition positionOf(Projection projection, glm::vec3 direction) {
  switch (projection) {
    case Projection::equirect:
      return {0, formula::equirectPosition(direction)};
    case Projection::sphere:
      return {0, flipped(formula::sphereMapCoordinates(direction))};
    case Projection::angular:
      return {0, formula::angularPosition(direction)};
    case Projection::cube: {
      const int face = formula::cubeFace(direction);
      return {face, formula::cubeCoordinates(face, direction)};
    }
    case Projection::ball:
      return {0, formula::mirrorBallPosition(direction, nearness(projection))};
    case Projection::paraboloid: {
      const int face = formula::paraboloidFace(direction);
      return {face, formula::paraboloidPosition(face, direction)};
    }
    case Projection::octahedral:
      return {0, formula::octahedralPosition(direction)};
    case Projection::hemioctahedral:
      return {0, formula::hemioctahedralPosition(direction)};
    case Projection::equal_area:
      return {0, formula::equalAreaPosition(direction)};
    case Projection::eac: {
      const int face = formula::cubeFace(direction);
      return {face, formula::equiangularCubeCoordinates(face, direction)};
    }
  }
  return {};
}

glm::vec3 directionAt(Projection projection, MapPosition position) {
  switch (projection) {
    case Projection::equirect:
      return formula::equirectDirection(position.uv);
    case Projection::sphere:
      return formula::sphereMapDirection(flipped(position.uv));
    case Projection::angular:
      return formula::angularDirection(position.uv);
    case Projection::cube:
      return formula::cubeDirection(position.face, position.uv);
    case Projection::ball:
      return formula::mirrorBallDirection(position.uv, nearness(projection));
    case Projection::paraboloid:
      return formula::paraboloidDirection(position.face, position.uv);
    case Projection::octahedral:
      return formula::octahedralDirection(position.uv);
    case Projection::hemioctahedral:
      return formula::hemioctahedralDirection(position.uv);
    case Projection::equal_area:
      return formula::equalAreaDirection(position.uv);
    case Projection::eac:
      return formula::equiangularCubeDirection(position.face, position.uv);
  }
  return {};
}

bool covers(Projection projection, glm::vec2 uv) { return !hasDisc(projection) || formula::insideDisc(uv); }

bool covers(Projection projection, glm::vec3 direction) {
  if (projection == Projection::ball) return formula::mirrorBallCovers(direction, nearness(projection));
  return !rowOf(projection).is_hemisphere || direction.z >= 0.0f;
}

float coveredSolidAngle(Projection projection) {
  const float sphere = 2.0f * formula::kTwoPi;
  if (projection == Projection::ball) return sphere - formula::mirrorBallBlindSolidAngle(nearness(projection));
  return rowOf(projection).is_hemisphere ? sphere / 2.0f : sphere;
}

bool hasDisc(Projection projection) { return rowOf(projection).has_disc; }

int faceCount(Projection projection) { return rowOf(projection).images; }

glm::ivec2 imageSize(Projection projection, int size) { return {rowOf(projection).aspect * size, size}; }

int equivalentSize(Projection from, int size, Projection to) {
  return std::max(size * rowOf(from).panorama_rows / rowOf(to).panorama_rows, 1);
}

}  // namespace mirrorball
