#include "mirrorball/photo/ball_photo.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/picture_layers.h"
#include "mirrorball/photo/merge.h"

namespace mirrorball {
namespace {

const auto kBallPhotoOptions = std::to_array<Option<BallPhotoSettings>>({
    {{.name = "circle",
      .value = "X,Y,R",
      .unit = "pixels",
      .min_count = 3,
      .max_count = 3,
      .help = "the ball's centre (from the upright photograph's top left corner) and radius; without it, the ball is "
              "searched for",
      .group = "Ball and camera",
      .step = 0.5},
     &BallPhotoSettings::circle},
    {{.name = "distance",
      .value = "D",
      .unit = "ball radii",
      .minimum = 0,
      .maximum = 1e6,
      .help = "distance from the camera to the ball's centre; 0: taken from {option:fov} or EXIF, or else infinite",
      .group = "Ball and camera",
      .soft_maximum = 40,
      .step = 0.1},
     &BallPhotoSettings::distance},
    {{.name = "fov",
      .value = "DEG",
      .unit = "degrees",
      .minimum = 0,
      .maximum = 170,
      .help = "vertical field of view of the whole photograph, from which the distance follows; 0: unknown",
      .group = "Ball and camera",
      .step = 1},
     &BallPhotoSettings::fov_deg},
    {{.name = "exposures",
      .value = "T,T,…",
      .unit = "seconds",
      .help =
          "exposure times of a series, in the order of its photographs, as in 1/60,1/15,1/4; without it, those in EXIF",
      .group = "Light"},
     &BallPhotoSettings::exposures},
    {{.name = "response",
      .choices = "auto|srgb|gamma|linear",
      .help = "the camera's response curve; auto recovers it from a series, assumes sRGB for a single photograph, and "
              "takes linear codes for light",
      .group = "Light"},
     choiceField<&BallPhotoSettings::response>},
    {layerText("Light"), &BallPhotoSettings::layer},
});

/// "1/60,1/15,0.25"
Result<std::vector<double>> parseExposures(const std::string& written) {
  std::vector<double> exposures;
  if (written.empty()) return exposures;
  for (const std::string& part : split(written, ',')) {
    const auto terms = split(part, '/');
    const auto numerator = parseNumber(terms[0]);
    const auto denominator = terms.size() == 2 ? parseNumber(terms[1]) : std::optional<double>(1.0);
    if (terms.size() > 2 || !numerator || !denominator || !(*numerator > 0.0) || !(*denominator > 0.0))
      return fail(ErrorCode::usage, "exposures are seconds with commas between, as in 1/60,1/15,1/4; '" + part +
                                        "' of '" + written + "' is none");
    exposures.push_back(*numerator / *denominator);
  }
  return exposures;
}

/// "30475 pixels are white even in the shortest exposure"
std::string pixelsAre(std::size_t count, const std::string& what, bool is_series, const std::string& exposure) {
  return countedAre(count, "pixel") + " " + what + (is_series ? " even in the " + exposure + " exposure" : "");
}

std::vector<std::string> remarksOn(const MergedPhotographs& merged, std::span<const Photograph> photographs) {
  const bool is_series = photographs.size() > 1;
  std::vector<std::string> remarks;
  for (const Photograph& photograph : photographs)
    for (const std::string& oddity : photograph.oddities) remarks.push_back(photograph.name + ": " + oddity);
  if (merged.clipped > 0)
    remarks.push_back(pixelsAre(merged.clipped, "white", is_series, "shortest") +
                      ": light there is brighter than recorded; add a shorter exposure");
  if (merged.black > 0)
    remarks.push_back(pixelsAre(merged.black, "black", is_series, "longest") +
                      ": what light there is was not recorded; add a longer exposure");
  for (std::size_t i = 0; i < photographs.size(); ++i)
    if (const double stops = merged.contradicts_stops[i]; std::abs(stops) > kContradiction_stops)
      remarks.push_back(photographs[i].name + " contradicts the others by " +
                        formatNumber(std::round(std::abs(stops) * 10) / 10) + " stops: it is too " +
                        (stops > 0 ? "bright" : "dark") + " for its exposure; is that right, and did nothing move?");
  return remarks;
}

}  // namespace

std::span<const Option<BallPhotoSettings>> ballPhotoOptions() { return kBallPhotoOptions; }

Result<void> checkBallPhoto(const BallPhotoSettings& settings) {
  if (settings.distance > 0.0f && settings.fov_deg > 0.0f)
    return fail(ErrorCode::usage,
                "{option:distance} and {option:fov} say the same: give one, the other follows from the rim");
  if (settings.distance > 0.0f && settings.distance <= 1.0f)
    return fail(ErrorCode::usage,
                "{option:distance} is from the camera to the ball's centre in radii of the ball, so more than "
                "1; it was given " +
                    formatNumber(double(settings.distance)));
  return {};
}

Result<BallLight> readBallLight(std::span<const std::string> files, const BallPhotoSettings& settings,
                                const std::optional<Response>& known) {
  MemoryBudget memory;
  std::vector<Photograph> photographs;
  for (const std::string& file : files) {
    MemoryShare share(memory);
    MIRRORBALL_TRY(photograph, readPhotograph(file, settings.layer));
    MIRRORBALL_TRY_VOID(withName(file, share.keep(photograph.bytes())));
    photographs.push_back(std::move(photograph));
  }
  MergeOptions how;
  MIRRORBALL_TRY(exposures, parseExposures(settings.exposures));
  how.exposures = std::move(exposures);
  if (settings.response > 0) how.response = static_cast<ResponseKind>(settings.response - 1);
  if (photographs.size() == 1 && !how.response) how.known = known;
  const MemoryShare share(memory);
  MIRRORBALL_TRY(merged, mergePhotographs(photographs, how));
  const Photograph& reference = photographs[merged.reference];
  return BallLight{.light = std::move(merged.light),
                   .name = files.front(),
                   .exif = reference.exif,
                   .told = photographs.size() > 1
                               ? std::to_string(photographs.size()) + " photographs merged as aligned, response " +
                                     merged.response + ", scale of " + reference.name
                               : "one photograph, response " + merged.response,
                   .remarks = remarksOn(merged, photographs),
                   .curve = std::move(merged.curve)};
}

Perspective perspectiveOf(const BallPhotoSettings& settings, const Exif& exif, glm::ivec2 size) {
  if (settings.distance > 0.0f) return {.distance = double(settings.distance), .focal_px = 0.0};
  if (settings.fov_deg > 0.0f)
    return {.distance = 0.0, .focal_px = focalLengthFromFov(double(settings.fov_deg), size.y)};
  return {.distance = 0.0, .focal_px = focalLengthFromExif(exif, size.x, size.y)};
}

Result<FoundBall> ballIn(const BallLight& photographed, const BallPhotoSettings& settings) {
  const glm::ivec2 size(photographed.light.width(), photographed.light.height());
  const Perspective perspective = perspectiveOf(settings, photographed.exif, size);
  const std::vector<float>& circle = settings.circle;
  if (circle.empty()) return withName(photographed.name, findBall(photographed.light, perspective));
  return ballOfCircle({{circle[0], circle[1]}, circle[2]}, size, perspective);
}

std::string doubtAbout(const FoundBall& ball, const std::string& name) {
  if (ball.isSure()) return "";
  std::array<char, 128> rival{};
  if (ball.rival)
    std::snprintf(rival.data(), rival.size(), "; the next likely one is about %.0f,%.0f,%.0f", ball.rival->center_px.x,
                  ball.rival->center_px.y, ball.rival->radius_px);
  return name + ": this circle may not be the ball's (confidence " +
         std::to_string(std::lround(100.0 * ball.confidence)) + " %" + rival.data() + ")";
}

}  // namespace mirrorball
