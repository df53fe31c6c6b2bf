#include "mirrorball/view/viewer/map_loading.h"

#include <algorithm>
#include <utility>

#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/image/resize.h"
#include "mirrorball/photo/unwrap.h"

namespace mirrorball {
namespace {

// More of a photograph is hardly seen beside its map [pixels].
constexpr int kLargestShown_px = 2048;

/// A ball, and what is to be said of it.
struct TakenBall {
  FoundBall ball;
  std::string remark = {};
};

/// From where a hand can bring it to the ball.
Circle suggestedCircle(glm::ivec2 size) {
  return {glm::dvec2(size) / 2.0, 0.35 * static_cast<double>(std::min(size.x, size.y))};
}

Result<TakenBall> takenBall(const BallLight& photographed, const BallPhotoSettings& settings, bool suggests_circle) {
  auto ball = ballIn(photographed, settings);
  if (ball) {
    std::string remark = doubtAbout(*ball, photographed.name);
    if (!remark.empty())
      remark += "; if it is wrong, drag it beside the map (M)";
    else if (ball->view.pinhole().isOrthographic())
      remark =
          photographed.name + ": the camera is taken as infinitely far away; distance or fov would say how far it is";
    return TakenBall{std::move(*ball), std::move(remark)};
  }
  Error error = std::move(ball).error();
  if (!settings.circle.empty()) error = withName(photographed.name + ": circle", std::move(error));
  if (error.fix_hint != FixHint::give_circle) return tl::unexpected<Error>(std::move(error));
  error.message += "; drag the circle to it beside the map (M), or give circle";
  if (!suggests_circle) return tl::unexpected<Error>(std::move(error));
  const glm::ivec2 size(photographed.light.width(), photographed.light.height());
  MIRRORBALL_TRY(suggested,
                 ballOfCircle(suggestedCircle(size), size, perspectiveOf(settings, photographed.exif, size)));
  return TakenBall{std::move(suggested), std::move(error.message)};
}

/// As large as it is worth to be shown.
Image shownPhotograph(const Image& light) {
  const glm::ivec2 size(light.width(), light.height());
  const int largest = std::max(size.x, size.y);
  if (largest <= kLargestShown_px) return light;
  return resized(light, glm::max(size * kLargestShown_px / largest, glm::ivec2(1)));
}

Result<LoadedMap> loadPhotograph(const std::string& name, const GivenTexts& given, bool suggests_circle,
                                 const ProgressFunction& progress) {
  MIRRORBALL_TRY(settings, ballPhotoOf(given));
  MIRRORBALL_TRY(photographed, readBallLight({&name, 1}, settings));
  MIRRORBALL_TRY(taken, takenBall(photographed, settings, suggests_circle));
  PhotographedBall ball{.light = std::make_shared<const Image>(shownPhotograph(photographed.light)),
                        .size_px = {photographed.light.width(), photographed.light.height()},
                        .exif = photographed.exif,
                        .view = taken.ball.view};
  std::vector<BallPhotograph> sides;
  sides.push_back({std::move(photographed.light), taken.ball.view});
  MIRRORBALL_TRY(unwrapped, withName(name, unwrapBall(std::move(sides))));
  const int height = unwrapped.environment.naturalSize(Projection::equirect);
  MIRRORBALL_TRY(panorama, convert(unwrapped.environment, Projection::equirect, height, {}, progress));
  LoadedEnvironment loaded{.environment = Environment(std::move(panorama)), .name = name, .files = {name}};
  return LoadedMap{std::move(loaded), std::move(ball), std::move(taken.remark)};
}

}  // namespace

Result<LoadedMap> loadMap(const AskedMap& source, const MapLoadOptions& options, const ProgressFunction& progress) {
  if (source.photo) return loadPhotograph(source.name, *source.photo, options.suggests_circle, progress);
  MIRRORBALL_TRY(loaded, loadEnvironment(source.name, options.environment, progress));
  return LoadedMap{std::move(loaded)};
}

Result<ViewedMap> viewedMap(const AskedMap& source, const std::optional<CacheFolder>& cache,
                            const ProgressFunction& progress) {
  MIRRORBALL_TRY(loaded, loadMap(source, {.environment = {.keep_bad = true}, .suggests_circle = true}, progress));
  MIRRORBALL_TRY(map, prepareMap(std::move(loaded.loaded.environment), cache, progress));
  if (loaded.ball) map.photograph = loaded.ball->light;
  return ViewedMap{std::move(map), std::move(loaded.ball), std::move(loaded.remark)};
}

}  // namespace mirrorball
