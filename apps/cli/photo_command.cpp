#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/map_output.h"
#include "cli/standard_streams.h"
#include "cli/terminal.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/option.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/photo/find_ball.h"
#include "mirrorball/photo/merge.h"
#include "mirrorball/photo/outline_picture.h"
#include "mirrorball/photo/unwrap.h"

namespace mirrorball::cli {
namespace {

/// What `photo` is told beside its photographs.
struct PhotoOptions {
  std::string to = "equirect";
  int size = 0;
  std::vector<float> circle;
  std::string debug;
  float distance = 0.0f;
  float fov_deg = 0.0f;
  std::string exposures;
  int response = 0;  ///< 0: recovered, or sRGB of a single photograph; then ResponseKind + 1
  std::vector<std::string> second;
  float second_rotation_deg = 90.0f;
  std::vector<float> second_circle;
  std::string second_exposures;
  std::string max_memory;
};

const std::string kProjectionsHelp = "projection of the map: " + join(projectionNames(), ", ", " or ");

const std::string kOutlineHelp =
    "also write the photograph with the ball's rim drawn over it, as " + writtenExtensions(Holds::picture, " or ");

const auto kPhotoOptions = std::to_array<Option<PhotoOptions>>({
    {{.name = "to", .value = "PROJECTION", .help = kProjectionsHelp, .group = "Output", .names = projectionNames},
     &PhotoOptions::to},
    {{.name = "size",
      .value = "N",
      .unit = "texels",
      .minimum = 0,
      .maximum = 32768,
      .help = "size of the map: the side of a cube face or of a square map, the diameter of a disc, or the height of a "
              "panorama; 0 keeps the photograph's detail",
      .group = "Output"},
     &PhotoOptions::size},
    {{.name = "debug", .value = "FILE", .help = kOutlineHelp, .group = "Output", .takes_path = true},
     &PhotoOptions::debug},
    {{.name = "circle",
      .value = "X,Y,R",
      .unit = "pixels",
      .min_count = 3,
      .max_count = 3,
      .help = "the ball's centre (from the upright photograph's top left corner) and radius; without it, the ball is "
              "searched for",
      .group = "Ball and camera"},
     &PhotoOptions::circle},
    {{.name = "distance",
      .value = "D",
      .unit = "ball radii",
      .minimum = 0,
      .maximum = 1e6,
      .help = "distance from the camera to the ball's centre; 0: taken from --fov or EXIF, or else infinite",
      .group = "Ball and camera"},
     &PhotoOptions::distance},
    {{.name = "fov",
      .value = "DEG",
      .unit = "degrees",
      .minimum = 0,
      .maximum = 170,
      .help = "vertical field of view of the whole photograph, from which the distance follows; 0: unknown",
      .group = "Ball and camera"},
     &PhotoOptions::fov_deg},
    {{.name = "exposures",
      .value = "T,T,…",
      .unit = "seconds",
      .help =
          "exposure times of a series, in the order of its photographs, as in 1/60,1/15,1/4; without it, those in EXIF",
      .group = "Light"},
     &PhotoOptions::exposures},
    {{.name = "response",
      .choices = "auto|srgb|gamma|linear",
      .help = "the camera's response curve; auto recovers it from a series, and assumes sRGB for a single photograph",
      .group = "Light"},
     choiceField<&PhotoOptions::response>},
    {{.name = "second",
      .value = "FILE",
      .help = "a photograph from another side, which shows what the first one cannot; may be repeated for a series",
      .group = "Second side",
      .takes_path = true},
     &PhotoOptions::second},
    {{.name = "second-rotation",
      .value = "DEG",
      .unit = "degrees",
      .minimum = -360,
      .maximum = 360,
      .help = "how far the camera was moved to the right around the ball, about the vertical; at 90 it stood on +X",
      .group = "Second side"},
     &PhotoOptions::second_rotation_deg},
    {{.name = "second-circle",
      .value = "X,Y,R",
      .unit = "pixels",
      .min_count = 3,
      .max_count = 3,
      .help = "the ball's centre and radius in the second photograph",
      .group = "Second side"},
     &PhotoOptions::second_circle},
    {{.name = "second-exposures",
      .value = "T,T,…",
      .unit = "seconds",
      .help = "exposure times of the second photographs; without it, those of --exposures",
      .group = "Second side"},
     &PhotoOptions::second_exposures},
    {kMaxMemoryText, &PhotoOptions::max_memory},
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

/// One side of the ball as the command line gives it.
struct BallSide {
  std::vector<std::string> files;
  std::vector<float> circle;
  std::string circle_option;
  std::string exposures;
  double turn_deg = 0.0;
  std::string debug;
};

/// A line of what was found out, with numbers as printf takes them.
template <typename... Values>
void tellf(const char* format, Values... values) {
  std::array<char, 512> line{};
  std::snprintf(line.data(), line.size(), format, values...);
  tell(line.data());
}

/// "30475 pixels are white even in the shortest exposure"
std::string pixelsAre(std::size_t count, const std::string& what, bool is_series, const std::string& exposure) {
  return countedAre(count, "pixel") + " " + what + (is_series ? " even in the " + exposure + " exposure" : "");
}

/// Reads and merges a series, and says what there is to say about it.
///
/// curve    the camera's response once a series has shown it: used for later single photographs, set by a series
Result<Image> readLight(const BallSide& side, const PhotoOptions& options, Exif& exif, std::optional<Response>& curve) {
  std::vector<Photograph> photographs;
  for (const std::string& file : side.files) {
    MIRRORBALL_TRY(photograph, readPhotograph(file));
    photographs.push_back(std::move(photograph));
  }
  MergeOptions how;
  MIRRORBALL_TRY(exposures, parseExposures(side.exposures));
  how.exposures = std::move(exposures);
  if (options.response > 0) how.response = static_cast<ResponseKind>(options.response - 1);
  if (photographs.size() == 1 && !how.response) how.known = curve;
  MIRRORBALL_TRY(merged, mergePhotographs(photographs, how));
  if (merged.curve) curve = merged.curve;
  exif = photographs[merged.reference].exif;
  const bool is_series = photographs.size() > 1;
  tell(is_series ? "light      " + std::to_string(photographs.size()) + " photographs merged as aligned, response " +
                       merged.response + ", scale of " + photographs[merged.reference].name
                 : "light      one photograph, response " + merged.response);
  if (merged.clipped > 0)
    remark(pixelsAre(merged.clipped, "white", is_series, "shortest") +
           ": light there is brighter than recorded; add a shorter exposure");
  if (merged.black > 0)
    remark(pixelsAre(merged.black, "black", is_series, "longest") +
           ": what light there is was not recorded; add a longer exposure");
  for (std::size_t i = 0; i < photographs.size(); ++i)
    if (const double stops = merged.contradicts_stops[i]; std::abs(stops) > kContradiction_stops)
      remark(photographs[i].name + " contradicts the others by " + formatNumber(std::round(std::abs(stops) * 10) / 10) +
             " stops: it is too " + (stops > 0 ? "bright" : "dark") +
             " for its exposure; is that right, and did nothing move?");
  return std::move(merged.light);
}

/// errors   usage: what can be told before anything is read
Result<void> checkPerspective(const PhotoOptions& options) {
  if (options.distance > 0.0f && options.fov_deg > 0.0f)
    return fail(ErrorCode::usage, "--distance and --fov say the same: give one, the other follows from the rim");
  if (options.distance > 0.0f && options.distance <= 1.0f)
    return fail(ErrorCode::usage,
                "--distance is from the camera to the ball's centre in radii of the ball, so more than "
                "1; it was given " +
                    formatNumber(double(options.distance)));
  return {};
}

Perspective perspectiveOf(const PhotoOptions& options, const Exif& exif, const Image& light) {
  if (options.distance > 0.0f) return Perspective{.distance = double(options.distance), .focal_px = 0.0};
  if (options.fov_deg > 0.0f)
    return Perspective{.distance = 0.0, .focal_px = focalLengthFromFov(double(options.fov_deg), light.height())};
  return Perspective{.distance = 0.0, .focal_px = focalLengthFromExif(exif, light.width(), light.height())};
}

void tellBall(const FoundBall& ball, const Image& light, bool is_given) {
  const BallView& view = ball.view;
  const Circle circle = circleInPicture(view);
  std::array<char, 160> how{};
  std::snprintf(how.data(), how.size(), ", found: an edge along %.0f %% of its rim, %.2f px RMS off it%s",
                100.0 * ball.share, ball.rms_px, ball.visible < 1.0 ? "; cut by the picture's border" : "");
  tellf("ball       circle %.2f,%.2f,%.2f px%s", circle.center_px.x, circle.center_px.y, circle.radius_px,
        is_given ? ", as given" : how.data());
  if (view.pinhole().isOrthographic()) {
    tell("camera     taken as infinitely far away; --distance or --fov would say how far it is");
    return;
  }
  const double fov = 2.0 * std::atan(light.height() / 2.0 / view.pinhole().focal_px);
  tellf("camera     %.2f ball radii from the ball's centre, vertical field of view %.2f degrees", view.distance(),
        glm::degrees(fov));
}

/// Says so where another circle may be the ball's.
void tellDoubt(const FoundBall& ball, const BallSide& side) {
  if (ball.isSure()) return;
  std::array<char, 128> rival{};
  if (ball.rival)
    std::snprintf(rival.data(), rival.size(), "; the next likely one is about %.0f,%.0f,%.0f", ball.rival->center_px.x,
                  ball.rival->center_px.y, ball.rival->radius_px);
  remark(side.files.front() + ": this circle may not be the ball's (confidence " +
         std::to_string(std::lround(100.0 * ball.confidence)) + " %" + rival.data() +
         "): look at it with --debug found.png, and if it is wrong give the right one with " + side.circle_option +
         " X,Y,R");
}

double capSolidAngle(double half_angle_rad) { return 2.0 * glm::radians(180.0) * (1.0 - std::cos(half_angle_rad)); }

void tellBlindCone(const BallView& view) {
  const double blind = view.blindHalfAngle_rad();
  const double unseen = view.unseenHalfAngle_rad(rimMargin_px(view));
  tellf(
      "blind      a cone of half-angle %.2f degrees behind the ball (%.4f sr); with %.1f px along the rim left out "
      "%.2f degrees (%.4f sr)",
      glm::degrees(blind), capSolidAngle(blind), rimMargin_px(view), glm::degrees(unseen), capSolidAngle(unseen));
}

/// An error that names the option of its own side of the ball.
Error ofSide(const BallSide& side, Error error) {
  if (error.remedy != Remedy::give_circle) return error;
  return {error.code, error.message + "; give it with " + side.circle_option + " X,Y,R in pixels"};
}

Result<BallPhotograph> readBallSide(const BallSide& side, const PhotoOptions& options, std::optional<Response>& curve) {
  Exif exif;
  MIRRORBALL_TRY(light, readLight(side, options, exif, curve));
  const Perspective perspective = perspectiveOf(options, exif, light);
  const bool is_given = !side.circle.empty();
  const auto findOrTake = [&]() -> Result<FoundBall> {
    if (!is_given) return withName(side.files.front(), findBall(light, perspective));
    return withName(side.circle_option, ballOfCircle({{side.circle[0], side.circle[1]}, side.circle[2]},
                                                     {light.width(), light.height()}, perspective));
  };
  auto found = findOrTake();
  if (!found) return tl::unexpected<Error>(ofSide(side, std::move(found).error()));
  const FoundBall ball = *found;
  tellBall(ball, light, is_given);
  tellDoubt(ball, side);
  tellBlindCone(ball.view);
  if (!side.debug.empty()) MIRRORBALL_TRY_VOID(savePicture(side.debug, outlinePicture(light, ball.view)));
  return BallPhotograph{std::move(light), ball.view, side.turn_deg};
}

Result<void> checkPhotoFiles(const std::vector<std::string>& inputs, const PhotoOptions& options,
                             std::vector<std::string> outputs) {
  if (!options.debug.empty()) {
    MIRRORBALL_TRY_VOID(checkFolder(options.debug));
    MIRRORBALL_TRY_VOID(formatToWrite(options.debug, {Holds::picture}));
    outputs.push_back(options.debug);
  }
  MIRRORBALL_TRY_VOID(refuseOverwriting(inputs, outputs));
  return refuseOverwriting(options.second, outputs);
}

Result<void> photo(const std::vector<std::string>& inputs, const PhotoOptions& options,
                   const MapOutputOptions& output_options) {
  if (output_options.output.empty()) {
    MIRRORBALL_TRY_VOID(refuseUnnamedOutput(inputs, isOutputName));
    return fail(ErrorCode::usage, "photo needs an output: -o FILE");
  }
  MIRRORBALL_TRY_VOID(useMemoryLimit(options.max_memory));
  MIRRORBALL_TRY_VOID(checkPerspective(options));
  MIRRORBALL_TRY(to, projectionToWrite(options.to));
  MIRRORBALL_TRY_VOID(checkFolder(output_options.output));
  MIRRORBALL_TRY(output, mapFileFor(output_options, output_options.output, to));
  MIRRORBALL_TRY_VOID(checkPhotoFiles(inputs, options, output.paths()));
  std::vector<BallPhotograph> sides;
  std::optional<Response> curve;
  MIRRORBALL_TRY(
      first, readBallSide({inputs, options.circle, "--circle", options.exposures, 0.0, options.debug}, options, curve));
  sides.push_back(std::move(first));
  if (!options.second.empty()) {
    const std::string& exposures = options.second_exposures.empty() ? options.exposures : options.second_exposures;
    const std::string debug = options.debug.empty() ? "" : suffixed(options.debug, "_second");
    MIRRORBALL_TRY(second, readBallSide({options.second, options.second_circle, "--second-circle", exposures,
                                         double(options.second_rotation_deg), debug},
                                        options, curve));
    sides.push_back(std::move(second));
  }
  MIRRORBALL_TRY(unwrapped, unwrapBall(std::move(sides)));
  if (unwrapped.gains.size() > 1) tellf("second     its light times %.3f agrees with the first", unwrapped.gains[1]);
  tellf("filled     %.4f sr (%.2f %% of all directions) continued smoothly", unwrapped.filled_sr,
        unwrapped.filled_sr / (4.0 * glm::radians(180.0)) * 100.0);
  const int size = options.size > 0 ? options.size : unwrapped.environment.naturalSize(to);
  MIRRORBALL_TRY(map, convert(unwrapped.environment, to, size, {}, progressBar("unwrap")));
  tellLimited(inputs.front(), limitLight(map, output_options.file.light), terminalObserver());
  return output.write(std::move(map));
}

}  // namespace

Command photoCommand() {
  struct Request {
    std::vector<std::string> inputs;
    PhotoOptions options;
    MapOutputOptions output;
  };
  auto request = std::make_shared<Request>();
  const std::string of_pictures = readExtensions(Holds::picture);
  const std::string of_light = readExtensions(Holds::light);
  Command command{.name = "photo",
                  .help = "Unwraps a photograph of a mirror ball, or a series of exposures, into a map",
                  .about = "PHOTO is a photograph of a mirror ball that holds integers (" + of_pictures +
                           ") or linear light (" + of_light +
                           "), or several that hold integers, as one exposure series. `--output` is required.",
                  .examples = {{"photo ball.jpg --fov 40 --debug rim.png -o room.exr",
                                "one photograph as a panorama, and a picture of the rim that was found"},
                               {"photo dark.jpg middle.jpg bright.jpg --exposures 1/250,1/60,1/15 -o room.exr",
                                "a series of exposures, which recovers the light of lamps"}}};
  addArgument(command,
              {.name = "PHOTO",
               .help = "photographs of one exposure series (" + of_pictures + "), or one that holds light (" +
                       of_light + "); - is standard input",
               .missing = "name a photograph",
               .takes_path = true},
              request->inputs);
  addMapOutput(command, request->output);
  addOptions(command, kPhotoOptions, request->options);
  command.action = [request] {
    std::vector<std::string*> inputs = pointersTo(request->inputs);
    for (std::string* second : pointersTo(request->options.second)) inputs.push_back(second);
    return withStandardStreams(inputs, request->output.output,
                               [&] { return photo(request->inputs, request->options, request->output); });
  };
  return command;
}

}  // namespace mirrorball::cli
