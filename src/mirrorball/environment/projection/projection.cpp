#include "mirrorball/environment/projection/projection.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "formula/constants.h"
#include "formula/projection.h"
#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

constexpr std::array<std::string_view, 10> kNames{"equirect",   "sphere",     "angular",        "cube",       "ball",
                                                  "paraboloid", "octahedral", "hemioctahedral", "equal-area", "eac"};

constexpr std::array<Alias, 9> kAliases{{{"equirectangular", "equirect"},
                                         {"latlong", "equirect"},
                                         {"lat-long", "equirect"},
                                         {"panorama", "equirect"},
                                         {"cubemap", "cube"},
                                         {"mirror-ball", "ball"},
                                         {"dual-paraboloid", "paraboloid"},
                                         {"octahedron", "octahedral"},
                                         {"equiangular", "eac"}}};

constexpr std::string_view kBallParameter = "distance=";

/// The image's v grows downwards, OpenGL's t of a sphere map upwards.
glm::vec2 flipped(glm::vec2 st) { return {st.x, 1.0f - st.y}; }

/// The k of formula/projection/mirror_ball.glsl.
float nearness(Projection projection) { return 1.0f / projection.ball_distance; }

}  // namespace

std::span<const std::string_view> projectionNames() { return kNames; }

std::string_view nameOf(Projection projection) { return kNames[static_cast<std::size_t>(projection.kind)]; }

std::string textOf(Projection projection) {
  std::string text(nameOf(projection));
  if (projection == Projection::ball)
    text += ":" + std::string(kBallParameter) + formatNumber(double(projection.ball_distance));
  return text;
}

Result<Projection> ballAtDistance(std::string_view written) {
  const auto distance = parseNumber(written);
  if (!distance || *distance < double(Projection::kMinBallDistance))
    return fail(ErrorCode::usage, "the distance of a ball's camera is '" + std::string(written) +
                                      "'; it takes a number of ball radii, at least " +
                                      formatNumber(double(Projection::kMinBallDistance)));
  return Projection::ballFrom(static_cast<float>(*distance));
}

Result<Projection> projectionNamed(std::string_view name) {
  const std::size_t colon = name.find(':');
  const auto found = indexOfName(name.substr(0, colon), kNames, kAliases);
  if (!found) return tl::unexpected<Error>(unknownName("projection", name, kNames));
  const auto kind = static_cast<Projection::Kind>(*found);
  if (colon == std::string_view::npos) return kind;
  const std::string_view parameter = name.substr(colon + 1);
  if (kind == Projection::ball && !parameter.starts_with(kBallParameter))
    return fail(ErrorCode::usage,
                "'" + std::string(name) + "': a ball's parameter is distance, as in ball:distance=20");
  if (kind != Projection::ball)
    return fail(ErrorCode::usage, "'" + std::string(name) + "': only a ball takes a parameter, as in ball:distance=20");
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
  return projection != Projection::hemioctahedral || direction.z >= 0.0f;
}

float coveredSolidAngle(Projection projection) {
  const float sphere = 2.0f * formula::kTwoPi;
  if (projection == Projection::ball) return sphere - formula::mirrorBallBlindSolidAngle(nearness(projection));
  return projection == Projection::hemioctahedral ? formula::kTwoPi : sphere;
}

bool hasDisc(Projection projection) {
  switch (projection) {
    case Projection::sphere:
    case Projection::angular:
    case Projection::ball:
    case Projection::paraboloid:
      return true;
    default:
      return false;
  }
}

int faceCount(Projection projection) {
  switch (projection) {
    case Projection::cube:
    case Projection::eac:
      return 6;
    case Projection::paraboloid:
      return 2;
    default:
      return 1;
  }
}

glm::ivec2 imageSize(Projection projection, int size) {
  return {projection == Projection::equirect ? 2 * size : size, size};
}

int equivalentSize(Projection from, int size, Projection to) {
  const int panorama_height = faceCount(from) == 6 ? 2 * size : size;
  return faceCount(to) == 6 ? std::max(panorama_height / 2, 1) : panorama_height;
}

}  // namespace mirrorball
