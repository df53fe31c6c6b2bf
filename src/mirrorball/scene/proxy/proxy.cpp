#include "mirrorball/scene/proxy/proxy.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "mirrorball/base/option.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/model_origin.h"
#include "mirrorball/scene/place_text.h"

namespace mirrorball {
namespace {

/// The default radius of a dome, and height of a camera in model radii.
constexpr float kHeightsOfDome = 10.0f;
constexpr float kRadiiOfHeight = 2.0f;

tl::unexpected<Error> misusedProxy(std::string_view option, std::string_view written, std::string_view wants) {
  return fail(ErrorCode::usage, std::string(option) + " " + excerpt(written) + ": " + std::string(wants));
}

/// Between so many numbers.
Result<std::vector<double>> numbersOf(std::string_view option, std::string_view written, int min, int max) {
  return parseExactNumbers({.name = option, .min_count = min, .max_count = max}, written);
}

Result<ProxyOptions> parseBox(std::string_view option, std::string_view written, std::string_view numbers) {
  MIRRORBALL_TRY(n, numbersOf(option, numbers, 6, 6));
  ProxyOptions proxy{.kind = ProxyKind::box, .low = {n[0], n[1], n[2]}, .high = {n[3], n[4], n[5]}};
  if (glm::any(glm::greaterThanEqual(proxy.low, proxy.high)))
    return misusedProxy(option, written, "a box goes from its lower to its higher corner: box:X0,Y0,Z0,X1,Y1,Z1");
  return proxy;
}

Result<ProxyOptions> parseSphere(std::string_view option, std::string_view written, std::string_view numbers) {
  MIRRORBALL_TRY(n, numbersOf(option, numbers, 4, 4));
  if (n[3] <= 0.0) return misusedProxy(option, written, "a sphere has a radius above 0: sphere:X,Y,Z,RADIUS");
  return ProxyOptions{.kind = ProxyKind::sphere, .center = {n[0], n[1], n[2]}, .radius = static_cast<float>(n[3])};
}

Result<ProxyOptions> parseGround(std::string_view option, std::string_view written, std::string_view numbers) {
  ProxyOptions proxy{.kind = ProxyKind::ground};
  if (numbers.empty()) return proxy;
  MIRRORBALL_TRY(n, numbersOf(option, numbers, 1, 2));
  proxy.height = static_cast<float>(n[0]);
  if (proxy.height <= 0.0f)
    return misusedProxy(option, written, "the panorama's camera is above the ground: ground:HEIGHT[,RADIUS]");
  if (n.size() == 1) return proxy;
  proxy.radius = static_cast<float>(n[1]);
  if (proxy.radius <= proxy.height)
    return misusedProxy(option, written, "the dome's radius is larger than the height: ground:HEIGHT[,RADIUS]");
  return proxy;
}

Result<Proxy> placedGround(const ProxyOptions& options, const Scene& scene) {
  const Box box = boundingBox(scene);
  const glm::vec3 middle = box.isEmpty() ? glm::vec3(0.0f) : box.center();
  const float height = options.height > 0.0f ? options.height : kRadiiOfHeight * boundingSphere(scene).radius;
  Proxy proxy{.kind = ProxyKind::ground,
              .ground = box.isEmpty() ? 0.0f : box.low.y,
              .ground_roughness = options.ground_roughness};
  proxy.captured_at = options.captured_at ? glm::vec3(*options.captured_at - scene.origin)
                                          : glm::vec3(middle.x, proxy.ground + height, middle.z);
  proxy.center = proxy.captured_at;
  const float above = proxy.center.y - proxy.ground;
  proxy.radius = options.radius > 0.0f ? options.radius : kHeightsOfDome * above;
  return proxy;
}

/// origin   of the scene that it encloses
Result<Proxy> placedMesh(const ProxyOptions& options, glm::dvec3 origin) {
  MIRRORBALL_TRY(scene, loadModel(options.file, options.load));
  MIRRORBALL_TRY_VOID(withName(options.file, moveOrigin(scene, origin)));
  MIRRORBALL_TRY(tree, withName(options.file, triangleTree(scene)));
  if (!tree) return fail(ErrorCode::usage, options.file + ": has no triangles, and so encloses nothing");
  Proxy proxy{.kind = ProxyKind::mesh};
  proxy.captured_at = options.captured_at ? glm::vec3(*options.captured_at - origin) : boundingBox(scene).center();
  proxy.mesh = std::make_shared<const BodyTree>(std::move(*tree));
  return proxy;
}

}  // namespace

Result<ProxyOptions> parseProxy(std::string_view option, std::string_view written) {
  const std::size_t colon = written.find(':');
  const std::string_view shape = written.substr(0, colon);
  const std::string_view numbers = colon == std::string_view::npos ? "" : written.substr(colon + 1);
  if (written == "none") return ProxyOptions();
  if (shape == "box") return parseBox(option, written, numbers);
  if (shape == "sphere" && colon != std::string_view::npos) return parseSphere(option, written, numbers);
  if (shape == "ground") return parseGround(option, written, numbers);
  if (written.empty()) return misusedProxy(option, written, "takes box:…, sphere:…, ground or a model's file");
  return ProxyOptions{.kind = ProxyKind::mesh, .file = std::string(written)};
}

std::string writtenProxy(const ProxyOptions& proxy) {
  switch (proxy.kind) {
    case ProxyKind::none:
      return "none";
    case ProxyKind::box:
      return "box:" + writtenPlace(proxy.low) + "," + writtenPlace(proxy.high);
    case ProxyKind::sphere:
      return "sphere:" + writtenPlace(proxy.center) + "," + formatNumber(proxy.radius);
    case ProxyKind::ground:
      return "ground" + (proxy.height > 0.0f ? ":" + formatNumber(proxy.height) : "") +
             (proxy.radius > 0.0f ? "," + formatNumber(proxy.radius) : "");
    case ProxyKind::mesh:
      break;
  }
  return proxy.file;
}

glm::vec3 Proxy::within(glm::vec3 place) const {
  switch (kind) {
    case ProxyKind::box:
      return formula::withinBox(low, high, place);
    case ProxyKind::sphere:
      return formula::withinSphere(center, radius, place);
    case ProxyKind::ground:
      return formula::withinDome(center, radius, ground, place);
    case ProxyKind::none:
    case ProxyKind::mesh:
      break;
  }
  return place;
}

Result<Proxy> placedProxy(const ProxyOptions& options, const Scene& scene) {
  const auto inScene = [&](glm::dvec3 place) { return glm::vec3(place - scene.origin); };
  Proxy proxy{.kind = options.kind,
              .low = inScene(options.low),
              .high = inScene(options.high),
              .center = inScene(options.center),
              .radius = options.radius};
  if (options.kind == ProxyKind::box) proxy.captured_at = (proxy.low + proxy.high) / 2.0f;
  if (options.kind == ProxyKind::sphere) proxy.captured_at = proxy.center;
  if (options.captured_at) proxy.captured_at = inScene(*options.captured_at);
  if (options.kind == ProxyKind::ground) {
    MIRRORBALL_TRY(placed, placedGround(options, scene));
    proxy = std::move(placed);
    if (proxy.center.y <= proxy.ground || proxy.radius <= proxy.center.y - proxy.ground)
      return fail(ErrorCode::usage,
                  "the panorama's camera at " + writtenPlace(placeInFile(proxy.captured_at, scene.origin)) +
                      " is not above the ground, which is at " + formatNumber(proxy.ground + scene.origin.y) +
                      ", within the dome of radius " + formatNumber(proxy.radius));
  }
  if (options.kind == ProxyKind::mesh) {
    MIRRORBALL_TRY(placed, placedMesh(options, scene.origin));
    proxy = std::move(placed);
  }
  if (!proxy.holds(proxy.captured_at))
    return fail(ErrorCode::usage, "the map's place " + writtenPlace(placeInFile(proxy.captured_at, scene.origin)) +
                                      " is not within its proxy " + writtenProxy(options));
  return proxy;
}

formula::ProxyHit hitOf(const Proxy& proxy, glm::vec3 origin, glm::vec3 direction) {
  switch (proxy.kind) {
    case ProxyKind::box:
      return formula::hitOfBox(proxy.low, proxy.high, origin, direction);
    case ProxyKind::sphere:
      return formula::hitOfSphere(proxy.center, proxy.radius, origin, direction);
    case ProxyKind::ground:
      return formula::hitOfGround(proxy.center, proxy.radius, proxy.ground, origin, direction);
    case ProxyKind::mesh:
      return formula::hitOfMesh(*proxy.mesh, origin, direction);
    case ProxyKind::none:
      break;
  }
  return {origin, glm::vec3(0.0f), 0.0f, false};
}

formula::ProxySight sightFrom(const Proxy& proxy, glm::vec3 origin, glm::vec3 direction) {
  return formula::sightOfProxy(hitOf(proxy, origin, direction), proxy.captured_at, direction);
}

}  // namespace mirrorball
