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
#include "mirrorball/photo/ball_photo.h"
#include "mirrorball/photo/outline_picture.h"
#include "mirrorball/photo/unwrap.h"

namespace mirrorball::cli {
namespace {

/// What `photo` is told beside its photographs and what is said of the first side.
struct PhotoOptions {
  std::string to = "equirect";
  int size = 0;
  std::string debug;
  std::vector<std::string> second;
  float second_rotation_deg = 90.0f;
  std::vector<float> second_circle;
  std::string second_exposures;
};

const std::string kProjectionsHelp = "projection of the map: " + join(projectionNames(), ", ", " or ");

const std::string kOutlineHelp =
    "also write the photograph with the ball's rim drawn over it, as " + writtenExtensions(Holds::picture, " or ");

const auto kMapOptions = std::to_array<Option<PhotoOptions>>({
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
});

const auto kOtherOptions = std::to_array<Option<PhotoOptions>>({
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
    {kMaxMemoryText, kMemoryLimitField<PhotoOptions>},
});

/// One side of the ball as the command line gives it.
struct BallSide {
  std::vector<std::string> files;
  BallPhotoSettings settings;
  std::string circle_option;
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
  if (const std::string doubt = doubtAbout(ball, side.files.front()); !doubt.empty())
    remark(doubt + ": look at it with --debug found.png, and if it is wrong give the right one with " +
           side.circle_option + " X,Y,R");
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
  if (error.fix_hint != FixHint::give_circle) return error;
  return {error.code, error.message + "; give it with " + side.circle_option + " X,Y,R in pixels"};
}

/// Reads a side, and says what there is to say about it.
///
/// curve    the camera's response once a series has shown it: used for later single photographs, set by a series
Result<BallPhotograph> readBallSide(const BallSide& side, std::optional<Response>& curve) {
  MIRRORBALL_TRY(photographed, readBallLight(side.files, side.settings, curve));
  if (photographed.curve) curve = photographed.curve;
  tell("light      " + photographed.told);
  for (const std::string& each : photographed.remarks) remark(each);
  const bool is_given = !side.settings.circle.empty();
  auto found = ballIn(photographed, side.settings);
  if (is_given) found = withName(side.circle_option, std::move(found));
  if (!found) return tl::unexpected<Error>(ofSide(side, std::move(found).error()));
  tellBall(*found, photographed.light, is_given);
  tellDoubt(*found, side);
  tellBlindCone(found->view);
  if (!side.debug.empty())
    MIRRORBALL_TRY_VOID(savePicture(side.debug, outlinePicture(photographed.light, found->view)));
  return BallPhotograph{std::move(photographed.light), found->view, side.turn_deg};
}

/// The second side, whose camera is the first one's.
BallSide secondSide(const PhotoOptions& options, const BallPhotoSettings& first) {
  BallPhotoSettings settings = first;
  settings.circle = options.second_circle;
  if (!options.second_exposures.empty()) settings.exposures = options.second_exposures;
  return {options.second, std::move(settings), "--second-circle", double(options.second_rotation_deg),
          options.debug.empty() ? "" : suffixed(options.debug, "_second")};
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

Result<void> photo(const std::vector<std::string>& inputs, const BallPhotoSettings& first_side,
                   const PhotoOptions& options, const MapOutputOptions& output_options) {
  if (output_options.output.empty()) {
    MIRRORBALL_TRY_VOID(refuseUnnamedOutput(inputs, isOutputName));
    return fail(ErrorCode::usage, "photo needs an output: -o FILE");
  }
  MIRRORBALL_TRY_VOID(checkBallPhoto(first_side));
  MIRRORBALL_TRY(to, projectionToWrite(options.to));
  MIRRORBALL_TRY_VOID(checkFolder(output_options.output));
  MIRRORBALL_TRY(output, mapFileFor(output_options, output_options.output, to));
  MIRRORBALL_TRY_VOID(checkPhotoFiles(inputs, options, output.paths()));
  std::vector<BallPhotograph> sides;
  std::optional<Response> curve;
  MIRRORBALL_TRY(first, readBallSide({inputs, first_side, "--circle", 0.0, options.debug}, curve));
  sides.push_back(std::move(first));
  if (!options.second.empty()) {
    MIRRORBALL_TRY(second, readBallSide(secondSide(options, first_side), curve));
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
    BallPhotoSettings first_side;
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
  addOptions(command, kMapOptions, request->options);
  addOptions(command, ballPhotoOptions(), request->first_side);
  addOptions(command, kOtherOptions, request->options);
  command.action = [request] {
    std::vector<std::string*> inputs = pointersTo(request->inputs);
    for (std::string* second : pointersTo(request->options.second)) inputs.push_back(second);
    return withStandardStreams(inputs, request->output.output, [&] {
      return photo(request->inputs, request->first_side, request->options, request->output);
    });
  };
  return command;
}

}  // namespace mirrorball::cli
