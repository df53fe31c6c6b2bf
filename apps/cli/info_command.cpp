#include "cli/info_command.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "formula/constants.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/convert.h"
#include "mirrorball/environment/load.h"
#include "mirrorball/environment/statistics.h"

namespace mirrorball::cli {
namespace {

const std::array<Option<InfoOptions>, 3> kInfoOptions{{
    {{.name = "direction",
      .value = "X,Y,Z",
      .fewest = 3,
      .most = 3,
      .help = "print where that direction is found: cube face, (s, t) and texel, and the texel of each projection"},
     &InfoOptions::direction},
    {{.name = "from", .value = "FORM", .help = "the form, where it is not recognised, as for convert"},
     &InfoOptions::from},
    {kMaxMemoryText, &InfoOptions::max_memory},
}};

constexpr std::array<const char*, 6> kFaceNames{"+X", "-X", "+Y", "-Y", "+Z", "-Z"};

std::string text(glm::vec3 v) {
  char buffer[96];
  std::snprintf(buffer, sizeof buffer, "%.5g %.5g %.5g", double(v.x), double(v.y), double(v.z));
  return buffer;
}

void printFile(const LoadedEnvironment& loaded) {
  std::printf("%s\n  format       %s\n", loaded.name.c_str(), loaded.format.c_str());
  std::printf("  colour       %s\n", loaded.color.c_str());
  if (loaded.recognition) {
    std::printf("  size         %dx%d\n", loaded.file_size.x, loaded.file_size.y);
    std::printf("  projection   %s (told by %s)\n", textOf(loaded.recognition->form).c_str(),
                loaded.recognition->told_by.c_str());
    const float covered = coveredSolidAngle(loaded.recognition->form.projection) / (2.0f * formula::kTwoPi);
    if (covered < 1.0f)
      std::printf("  covers       %.5g %% of the sphere: none of %s\n", 100.0 * double(covered),
                  loaded.recognition->form.projection == Projection::ball
                      ? "the cone that the ball hides behind it, around -Z"
                      : "the half with z < 0");
  } else {
    std::printf("  projection   none: a function of the direction\n");
  }
  std::printf("  bad texels   %s\n", loaded.bad_texels.count > 0 ? textOf(loaded.bad_texels).c_str() : "none");
}

void printStatistics(const RadianceStatistics& statistics) {
  std::printf("  range        %s to %s\n", text(statistics.least).c_str(), text(statistics.greatest).c_str());
  std::printf("  mean         %s over the sphere\n", text(statistics.mean).c_str());
  std::printf("  brightest    %s from direction %s\n", text(statistics.brightest).c_str(),
              text(statistics.brightest_direction).c_str());
}

/// What the two numbers are, after the image that they lie in: "face -X, (s, t)", "front, (u, v)", "(u, v)".
std::string coordinateText(Projection projection, int face) {
  switch (faceCount(projection)) {
    case 6:
      return std::string("face ") + kFaceNames[static_cast<std::size_t>(face)] + ", (s, t)";
    case 2:
      return face == 0 ? "front, (u, v)" : "back, (u, v)";
    default:
      return projection == Projection::sphere ? "(s, t)" : "(u, v)";
  }
}

void printPosition(const Environment& environment, Projection projection, glm::vec3 direction) {
  const std::string name(nameOf(projection));
  if (!covers(projection, direction)) {
    std::printf("  %-12s not in the map\n", name.c_str());
    return;
  }
  const glm::ivec2 size = imageSize(projection, environment.naturalSize(projection));
  const MapPosition place = positionOf(projection, direction);
  const glm::ivec2 texel = glm::min(glm::ivec2(place.uv * glm::vec2(size)), size - 1);
  // OpenGL's t of a sphere map grows upwards, a cube's and an image's v downwards.
  const bool t_up = projection == Projection::sphere;
  std::printf("  %-12s %s = (%.4f, %.4f), texel (%d, %d) of %dx%d\n", name.c_str(),
              coordinateText(projection, place.face).c_str(), double(place.uv.x),
              double(t_up ? 1.0f - place.uv.y : place.uv.y), texel.x, texel.y, size.x, size.y);
}

Result<void> printDirection(const Environment& environment, const std::vector<float>& numbers) {
  const glm::vec3 given(numbers[0], numbers[1], numbers[2]);
  if (glm::length(given) == 0.0f || !std::isfinite(glm::length(given)))
    return fail(ErrorCode::usage, "--direction takes a vector that has a length; it was given " + text(given));
  const glm::vec3 direction = glm::normalize(given);
  std::printf("direction %s, unit %s\n", text(given).c_str(), text(direction).c_str());
  for (const Projection projection : {Projection::cube, Projection::equirect, Projection::sphere, Projection::angular,
                                      Projection::ball, Projection::paraboloid, Projection::octahedral,
                                      Projection::hemioctahedral, Projection::equal_area, Projection::eac})
    printPosition(environment, projection, direction);
  std::printf("  radiance     %s\n", text(environment.radiance(direction)).c_str());
  return {};
}

Result<void> info(const std::string& input, const InfoOptions& options) {
  MIRRORBALL_TRY_VOID(useMemoryLimit(options.max_memory));
  EnvironmentLoadOptions how{.keep_bad = true};
  if (!options.from.empty()) {
    MIRRORBALL_TRY(hint, formHintNamed(options.from));
    how.from = hint;
  }
  MIRRORBALL_TRY(loaded, loadEnvironment(input, how));
  if (!options.direction.empty()) return printDirection(loaded.environment, options.direction);
  printFile(loaded);
  if (const EnvironmentMap* map = loaded.environment.map()) {
    printStatistics(radianceStatistics(*map));
    return {};
  }
  // A function has no texels of its own: it is read where a cube of its natural size has some.
  const int size = loaded.environment.naturalSize(Projection::cube);
  MIRRORBALL_TRY(map, convert(loaded.environment, Projection::cube, size));
  printStatistics(radianceStatistics(map));
  return {};
}

}  // namespace

std::span<const Option<InfoOptions>> infoOptions() { return kInfoOptions; }

Action addInfoCommand(CLI::App& program) {
  struct Request {
    std::string input;
    InfoOptions options;
  };
  auto request = std::make_shared<Request>();
  CLI::App& command = addCommand(program, "info", "Says what an environment map is, or where a direction lies in it");
  addArgument(command, "FILE", request->input,
              "a map (" + std::string(readExtensions()) + ") or a built-in: studio sky uv white");
  addOptions(command, infoOptions(), request->options);
  return [request] { return info(request->input, request->options); };
}

}  // namespace mirrorball::cli
