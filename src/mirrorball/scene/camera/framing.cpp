#include "mirrorball/scene/camera/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/place_text.h"

namespace mirrorball {
namespace {

/// The share of the picture that the model may take of each side.
constexpr double kFilled = 15.0 / 16.0;

/// How near to the model's foremost point a camera may come, in radii: a line that points at the camera fills nothing.
constexpr double kMinDistance = 0.01;

/// The greatest of a linear function of the model's points, and the depth of the point that has it.
struct Reach {
  double value = -std::numeric_limits<double>::infinity();
  double depth = 0.0;

  void take(double other, double other_depth) {
    if (other > value) *this = {other, other_depth};
  }
};

/// A circle on the ground about the middle of a box.
void addCircle(const Box& box, double radius, std::vector<glm::dvec3>& places) {
  const glm::dvec3 low(box.low), middle = 0.5 * (low + glm::dvec3(box.high));
  constexpr int kPlaces = 32;
  for (int i = 0; i < kPlaces; ++i) {
    const double angle = 2.0 * glm::pi<double>() * i / kPlaces;
    places.emplace_back(middle.x + radius * std::sin(angle), low.y, middle.z + radius * std::cos(angle));
  }
}

/// How far from the middle of a model's foot a shadow is held that reaches so far.
///
/// reach, most   world units
/// light         towards it, above the ground, unit
double heldReach(double reach, double most, glm::dvec3 light) {
  const double whole_from = std::sin(glm::radians(double(kWholeShadow_deg)));
  return std::min(reach, most) * glm::smoothstep(0.0, whole_from, light.y);
}

/// Where the corners of a box throw their shadows on the ground, as far as they are held.
void addShadow(const Box& box, double most, glm::dvec3 light, std::vector<glm::dvec3>& places) {
  const glm::dvec3 low(box.low), high(box.high);
  const glm::dvec2 middle(0.5 * (low.x + high.x), 0.5 * (low.z + high.z));
  for (int corner = 0; corner < 4; ++corner) {
    const glm::dvec2 foot((corner & 1) == 0 ? low.x : high.x, (corner & 2) == 0 ? low.z : high.z);
    const glm::dvec2 along = foot - middle - glm::dvec2(light.x, light.z) / light.y * (high.y - low.y);
    const double reach = std::max(glm::length(along), 1e-30);
    const glm::dvec2 place = middle + along * (heldReach(reach, most, light) / reach);
    places.emplace_back(place.x, low.y, place.y);
  }
}

/// Places on the ground below a scene that a camera is to hold.
///
/// model_radius   of the scene's bounding sphere
std::vector<glm::dvec3> groundAround(const Scene& scene, double model_radius, const CameraOptions& options) {
  const Box box = boundingBox(scene);
  if (box.isEmpty()) return {};
  const glm::dvec3 low(box.low), high(box.high), light(options.ground_light);
  const double half_foot = 0.5 * std::hypot(high.x - low.x, high.z - low.z);
  const double most = double(kShadowReach) * model_radius;
  double radius = half_foot + 0.5 * double(options.ground_reach) * glm::distance(low, high);
  std::vector<glm::dvec3> places;
  if (light.y > 0.0 && options.ground_light_turns) {
    // Once the light shines along the foot's diagonal, a corner's shadow lies on from it.
    const double length = (high.y - low.y) * std::hypot(light.x, light.z) / light.y;
    radius = std::max(radius, heldReach(half_foot + length, most, light));
  } else if (light.y > 0.0) {
    addShadow(box, most, light, places);
  }
  addCircle(box, radius, places);
  return places;
}

/// The model as seen along a direction: x to the right, y up, z towards the camera, from the target.
class View {
 public:
  View(const Scene& scene, double model_radius, const CameraOptions& options, glm::dvec3 target, FramingOf what,
       std::span<const std::vector<PositionRun>> runs)
      : scene_(scene),
        runs_(runs),
        is_whole_turn_(what == FramingOf::whole_turn),
        sine_(std::sin(glm::radians(double(options.elevation_deg)))),
        cosine_(std::cos(glm::radians(double(options.elevation_deg)))) {
    // Turned about the upright axis, the camera stands over +Z; for a whole turn its azimuth does not matter.
    const double azimuth = glm::radians(double(options.azimuth_deg));
    turned_ = glm::rotate(glm::dmat4(1.0), -azimuth, glm::dvec3(0, 1, 0)) * glm::translate(glm::dmat4(1.0), -target);
    if (options.ground_reach > 0.0f) ground_ = groundAround(scene, model_radius, options);
  }

  /// Towards one side of the picture and the other, 0 right and left, 1 up and down: the greatest of
  /// across · (±x or ±y) + slope · z.
  struct Sides {
    Reach plus;
    Reach minus;
  };
  Sides reach(int axis, double across, double slope) const {
    Sides sides;
    const auto take = [&](glm::dvec3 p) {
      if (is_whole_turn_)
        takeCircle(axis, across, slope, std::hypot(p.x, p.z), p.y, sides);
      else
        takePoint(axis, across, slope, p, sides);
    };
    if (is_whole_turn_ || runs_.empty())
      forEachPosition(scene_, turned_, take);
    else
      takeRuns(axis, across, slope, sides);
    for (const glm::dvec3& place : ground_) take(glm::dvec3(turned_ * glm::dvec4(place, 1.0)));
    return sides;
  }

  /// A point that a camera at (x, y) looks at, seen from the target: at the target's depth, or for a whole turn on its
  /// axis, which stays where it is while the camera goes round.
  glm::dvec3 lookedAt(glm::dvec2 camera) const {
    if (!is_whole_turn_) return {camera, 0.0};
    return isAxisSeen() ? glm::dvec3(0.0, camera.y, camera.y * sine_ / cosine_) : glm::dvec3(0.0);
  }

  /// The world's direction and length of what is seen as (x, y, z).
  glm::dvec3 inWorld(glm::dvec3 seen) const {
    const glm::dvec3 upright(seen.x, seen.y * cosine_ + seen.z * sine_, seen.z * cosine_ - seen.y * sine_);
    // A rotation's inverse from the left.
    return upright * glm::dmat3(turned_);
  }

 private:
  /// From straight above the axis is a point, and the model turns about the picture's middle.
  bool isAxisSeen() const { return std::abs(cosine_) > 1e-4; }

  void takePoint(int axis, double across, double slope, glm::dvec3 p, Sides& sides) const {
    const double z = p.y * sine_ + p.z * cosine_;
    const double aside = across * (axis == 0 ? p.x : p.y * cosine_ - p.z * sine_);
    sides.plus.take(aside + slope * z, z);
    sides.minus.take(slope * z - aside, z);
  }

  /// Those points that may be farther than those before.
  void takeRuns(int axis, double across, double slope, Sides& sides) const {
    const glm::dvec3 towards(0.0, sine_, cosine_);
    const glm::dvec3 aside = axis == 0 ? glm::dvec3(1, 0, 0) : glm::dvec3(0.0, cosine_, -sine_);
    for (const Instance& instance : scene_.instances) {
      const glm::dmat4 seen_from_object = turned_ * glm::dmat4(instance.world_from_object);
      const std::vector<Vertex>& vertices = scene_.meshes[std::size_t(instance.mesh)]->vertices;
      for (const PositionRun& run : runs_[std::size_t(instance.mesh)]) {
        const bool is_nearer =
            reachOf(run.box, seen_from_object, slope * towards + across * aside) < sides.plus.value &&
            reachOf(run.box, seen_from_object, slope * towards - across * aside) < sides.minus.value;
        if (is_nearer) continue;
        for (const Vertex& vertex : std::span(vertices).subspan(run.first, run.count))
          takePoint(axis, across, slope, glm::dvec3(seen_from_object * glm::dvec4(glm::dvec3(vertex.position), 1.0)),
                    sides);
      }
    }
  }

  /// What a linear function is at most in a box, and a little more than rounding can add.
  static double reachOf(const Box& box, const glm::dmat4& seen_from_object, glm::dvec3 function) {
    const glm::dvec3 middle = 0.5 * (glm::dvec3(box.low) + glm::dvec3(box.high));
    const glm::dvec3 half = 0.5 * (glm::dvec3(box.high) - glm::dvec3(box.low));
    const double at_middle = glm::dot(function, glm::dvec3(seen_from_object * glm::dvec4(middle, 1.0)));
    double reach = 0.0;
    for (int axis = 0; axis < 3; ++axis)
      reach += std::abs(glm::dot(function, glm::dvec3(seen_from_object[axis]))) * half[axis];
    return at_middle + reach + 1e-9 * (std::abs(at_middle) + reach);
  }

  /// The circle of a radius and a height, whose point at an angle a is x = ρ sin a, y = h cos e − ρ cos a sin e,
  /// z = h sin e + ρ cos a cos e: a function A cos a + B sin a is √(A² + B²) at most.
  void takeCircle(int axis, double across, double slope, double radius, double height, Sides& sides) const {
    const auto take = [&](Reach& reach, double sign) {
      const double along_sine = axis == 0 ? across : 0.0;
      const double along_cosine = slope * cosine_ - (axis == 0 ? 0.0 : sign * across * sine_);
      const double length = std::hypot(along_sine, along_cosine);
      const double cosine = length > 0.0 ? along_cosine / length : 1.0;
      const double of_height = slope * sine_ + (axis == 0 ? 0.0 : sign * across * cosine_);
      reach.take(height * of_height + radius * length, height * sine_ + radius * cosine * cosine_);
    };
    take(sides.plus, 1.0);
    take(sides.minus, -1.0);
  }

  const Scene& scene_;
  std::span<const std::vector<PositionRun>> runs_;
  bool is_whole_turn_;
  double sine_;
  double cosine_;
  glm::dmat4 turned_{1.0};
  std::vector<glm::dvec3> ground_;  // world
};

/// Where a camera at a depth stands on one axis, so that the model reaches as far to one side as to the other: the
/// least slope t of a border with reach+(t) + reach−(t) ≤ 2 t depth, by Newton's steps from below, where a convex
/// function is never overshot.
double centered(const View& view, int axis, double depth) {
  View::Sides sides;
  double slope = 0.0;
  for (int step = 0; step < 8; ++step) {
    sides = view.reach(axis, 1.0, slope);
    const double excess = sides.plus.value + sides.minus.value - 2.0 * slope * depth;
    const double fall = 2.0 * depth - sides.plus.depth - sides.minus.depth;
    if (excess <= 1e-7 * depth) break;
    slope += excess / fall;
  }
  return (sides.plus.value - sides.minus.value) / 2.0;
}

Result<const ModelCamera*> cameraNamed(const Scene& scene, const std::string& name) {
  std::vector<std::string_view> names;
  for (const ModelCamera& camera : scene.cameras) names.emplace_back(camera.name);
  if (names.empty())
    return fail(ErrorCode::usage, "the model has no cameras of its own, so none is named '" + excerpt(name) + "'",
                FixHint::give_angles);
  const auto index = indexOfName(name, names);
  if (!index) {
    Error error = unknownName("camera", name, names);
    error.fix_hint = FixHint::give_angles;
    return tl::unexpected<Error>(std::move(error));
  }
  return &scene.cameras[*index];
}

/// errors   usage: nothing of the model would be seen, and depths would all be the same float
Result<Camera> withinReach(Camera camera, const Scene& scene, const BoundingSphere& bounds) {
  constexpr double kMostRadii = 1e6;  // a pixel of the largest picture with the narrowest view
  const double radii = glm::distance(glm::dvec3(camera.position), glm::dvec3(bounds.center)) / double(bounds.radius);
  if (scene.empty() || radii <= kMostRadii) return camera;
  return fail(ErrorCode::usage, "the camera is " + formatNumber(radii) +
                                    " model radii away from the model, too far to see it; bring it and its target to "
                                    "within " +
                                    formatNumber(kMostRadii) + " radii");
}

/// Slopes of the borders to the right and upwards.
glm::dvec2 borderSlopes(const CameraOptions& options, double aspect) {
  const double up = std::tan(glm::radians(double(options.fov_deg)) / 2.0) * kFilled;
  return {up * aspect, up};
}

}  // namespace

CameraOptions framed(const Scene& scene, const BoundingSphere& bounds, const CameraOptions& options, float aspect,
                     FramingOf what, std::span<const std::vector<PositionRun>> runs) {
  const bool is_parallel = options.orthographic_height.has_value();
  if (is_parallel ? *options.orthographic_height > 0.0f : options.distance.has_value()) return options;
  if (scene.empty()) return options;

  const glm::dvec3 target = options.target ? bounds.inScene(*options.target) : bounds.center;
  const double radius = bounds.radius;
  const View view(scene, radius, options, target, what, runs);
  CameraOptions chosen = options;
  glm::dvec3 camera(0.0);
  const bool is_free = !options.target.has_value();
  const glm::dvec2 slopes = is_parallel ? glm::dvec2(0.0) : borderSlopes(options, aspect);
  const View::Sides x = view.reach(0, 1.0, slopes.x);
  const View::Sides y = view.reach(1, 1.0, slopes.y);
  const auto needed = [&](const View::Sides& sides) {
    return is_free ? (sides.plus.value + sides.minus.value) / 2.0 : std::max(sides.plus.value, sides.minus.value);
  };
  if (is_parallel) {
    const double half_height = std::max({needed(x) / aspect, needed(y), kMinDistance * radius});
    chosen.orthographic_height = static_cast<float>(2.0 * half_height / (kFilled * radius));
    if (is_free) camera = {(x.plus.value - x.minus.value) / 2.0, (y.plus.value - y.minus.value) / 2.0, 0.0};
  } else {
    const double foremost = view.reach(0, 0.0, 1.0).plus.value;
    camera.z = std::max({needed(x) / slopes.x, needed(y) / slopes.y, std::max(foremost, 0.0) + kMinDistance * radius});
    if (is_free) {
      camera.x = centered(view, 0, camera.z);
      camera.y = centered(view, 1, camera.z);
    }
  }
  const glm::dvec3 looked_at = view.lookedAt(camera);
  chosen.target = placeInFile(glm::vec3(target + view.inWorld(looked_at)), bounds.origin);
  if (!is_parallel) chosen.distance = static_cast<float>((camera.z - looked_at.z) / radius);
  return chosen;
}

Result<Camera> framedCamera(const Scene& scene, const BoundingSphere& bounds, const CameraOptions& options,
                            glm::ivec2 size, std::span<const std::vector<PositionRun>> runs) {
  const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
  if (!options.name.empty()) {
    MIRRORBALL_TRY(own, cameraNamed(scene, options.name));
    return withinReach(cameraOf(*own, bounds, aspect), scene, bounds);
  }
  return withinReach(makeCamera(framed(scene, bounds, options, aspect, FramingOf::still, runs), bounds, aspect), scene,
                     bounds);
}

}  // namespace mirrorball
