#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/interruption.h"
#include "cli/map_info.h"
#include "cli/map_inputs.h"
#include "cli/standard_streams.h"
#include "cli/terminal.h"
#include "formula/constants.h"
#include "mirrorball/base/option.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/codec/metadata.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/photo/heading_in_file.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball::cli {
namespace {

/// What `info` is told beside its inputs.
struct InfoOptions {
  std::vector<float> direction;
  bool json = false;
  std::string from;
  bool inside_only = false;
  bool north = false;
};

const auto kInfoOptions = std::to_array<Option<InfoOptions>>({
    {{.name = "direction",
      .value = "X,Y,Z",
      .min_count = 3,
      .max_count = 3,
      .help = "print where this direction is: its cube face, (s, t) and texel, and its texel in each projection"},
     &InfoOptions::direction},
    {{.name = "north",
      .help = "print where north is in a panorama, by the compass heading that its file states; an error where it "
              "states none"},
     &InfoOptions::north},
    {{.name = "json", .help = "print JSON: an object for one file, an array for several"}, &InfoOptions::json},
    {formText("form of the map, if it is not recognised (see convert --from)"), &InfoOptions::from},
    {kInsideOnlyText, &InfoOptions::inside_only},
    {kMaxMemoryText, kMemoryLimitField<InfoOptions>},
});

constexpr std::array<Projection::Kind, 10> kListed{
    Projection::cube,       Projection::equirect,   Projection::sphere,     Projection::angular,
    Projection::ball,       Projection::paraboloid, Projection::octahedral, Projection::hemioctahedral,
    Projection::equal_area, Projection::eac};
static_assert(kListed.size() == Projection::kKinds, "a direction is told in every projection");

DirectionPlace findPlace(const Environment& environment, Projection projection, glm::vec3 direction) {
  DirectionPlace found{projection, imageSize(projection, environment.naturalSize(projection)), std::nullopt, {}};
  if (!covers(projection, direction)) return found;
  found.place = positionOf(projection, direction);
  found.texel = glm::min(glm::ivec2(found.place->uv * glm::vec2(found.size)), found.size - 1);
  return found;
}

DirectionInfo directionInfo(const Environment& environment, glm::vec3 unit, const std::vector<float>& written) {
  DirectionInfo info{.given = {written[0], written[1], written[2]}, .unit = unit};
  for (const Projection projection : kListed) info.places.push_back(findPlace(environment, projection, info.unit));
  info.radiance = environment.radiance(info.unit);
  return info;
}

Result<RadianceStatistics> measureLight(const Environment& environment) {
  if (const EnvironmentMap* map = environment.map()) return radianceStatistics(*map);
  // A function has no texels of its own: it is read where a cube of its natural size has some.
  MIRRORBALL_TRY(map, convert(environment, Projection::cube, environment.naturalSize(Projection::cube)));
  return radianceStatistics(map);
}

/// Where north is in a panorama, where that is what is asked for.
///
/// errors   of findNorth and requiredHeading
Result<NorthInfo> requiredNorth(const LoadedEnvironment& loaded) {
  MIRRORBALL_TRY_VOID(checkTakesHeading(loaded));
  MIRRORBALL_TRY(heading, requiredHeading(loaded.files.front()));
  return findNorth(heading, loaded);
}

/// Where north is in a panorama whose file states it. A heading that cannot be read is remarked.
std::optional<NorthInfo> statedNorth(const LoadedEnvironment& loaded, const std::string& name) {
  if (!checkTakesHeading(loaded)) return std::nullopt;
  const auto heading = headingInFile(loaded.files.front());
  // What keeps a panorama from being levelled was reported when it was loaded.
  const auto& reported = loaded.oddities;
  if (!heading && std::find(reported.begin(), reported.end(), heading.error().message) == reported.end())
    remark(name + ": " + heading.error().message);
  if (!heading || !*heading) return std::nullopt;
  const auto north = findNorth(**heading, loaded);
  return north ? std::optional(*north) : std::nullopt;
}

/// What is known of an input.
///
/// direction  that is asked for, of length 1; with --json all is printed, while another reader who asks for one wants
///            no more
Result<InputInfo> infoOf(const std::string& input, const EnvironmentLoadOptions& how,
                         std::optional<glm::vec3> direction, const InfoOptions& options) {
  MIRRORBALL_TRY(table, brdfTableIn(input));
  if (table) return InputInfo{shown(input), std::move(*table)};
  MIRRORBALL_TRY(rows, lobeRowsIn(input));
  if (rows) return InputInfo{shown(input), std::move(*rows)};
  if (const auto format = modelFormatOf(input); format && !direction && !options.north) {
    MIRRORBALL_TRY(scene, loadModel(input, {.inside_only = options.inside_only}));
    return InputInfo{shown(input), ModelInfo{std::string(*format).substr(format->find(' ') + 1), std::move(scene)}};
  }
  // A heading that cannot be read is the error, and no remark of the panorama that it tilts.
  if (options.north) MIRRORBALL_TRY_VOID(withName(shown(input), headingInFile(input)));
  MIRRORBALL_TRY(loaded, loadMap(input, how));
  MapInfo map{.loaded = std::move(loaded)};
  if (auto& recognition = map.loaded.recognition) {
    map.covered = coveredSolidAngle(recognition->form.projection) / (2.0f * formula::kTwoPi);
    if (recognition->form.projection == Projection::equirect && map.loaded.window)
      map.covered = static_cast<float>(shareOfSphere(*map.loaded.window, map.loaded.window_goes_round));
    if (recognition->told_by.empty()) recognition->told_by = "--from";
  }
  const Metadata& said = map.loaded.metadata;
  if (const auto text = said.find(kFilamentHarmonicsKey); text != said.end())
    map.harmonics = filamentHarmonicsIn(text->second);
  if (options.north) {
    MIRRORBALL_TRY(north, withName(shown(input), requiredNorth(map.loaded)));
    map.north = north;
  } else {
    map.north = statedNorth(map.loaded, shown(input));
  }
  map.is_north_alone = options.north;
  if (direction) map.direction = directionInfo(map.loaded.environment, *direction, options.direction);
  if ((!direction && !options.north) || options.json) {
    MIRRORBALL_TRY(statistics, measureLight(map.loaded.environment));
    map.statistics = statistics;
  }
  return InputInfo{shown(input), std::move(map)};
}

Result<void> info(const std::vector<std::string>& inputs, const InfoOptions& options) {
  EnvironmentLoadOptions how{.keep_bad = true};
  if (!options.from.empty()) {
    MIRRORBALL_TRY(hint, formHintNamed(options.from));
    how.from = hint;
  }
  std::optional<glm::vec3> direction;
  if (!options.direction.empty()) {
    MIRRORBALL_TRY(unit, unitVector("--direction", options.direction));
    direction = unit;
  }
  whenInterrupted(interruptedAmongMany(""));
  const bool is_one = inputs.size() == 1;
  std::vector<InputInfo> known;
  std::size_t failed = 0;
  for (const std::string& input : inputs) {
    if (interrupted()) break;
    auto found = infoOf(input, how, direction, options);
    if (!found && is_one) return fail(std::move(found));
    if (!found) {
      ++failed;
      complain(found.error());
      found = InputInfo{shown(input), Error{found.error().code, shown(lineOf(found.error()))}};
    } else if (!options.json) {
      const bool is_named = !is_one && (options.north || !options.direction.empty());
      print((is_one || &input == &inputs.front() ? "" : "\n") + (is_named ? printable(found->name) + "\n" : "") +
            textOf(*found));
    }
    // A map may be large: of what is printed already only the name is kept.
    if (options.json) {
      if (auto* map = std::get_if<MapInfo>(&found->what)) map->loaded.environment = Environment({}, 1);
      if (auto* model = std::get_if<ModelInfo>(&found->what)) model->scene.textures.clear();
      known.push_back(std::move(*found));
    }
  }
  if (options.json) print(jsonOf(known));
  return is_one ? Result<void>() : outcomeOfMany(failed, inputs.size(), "read", "");
}

}  // namespace

Command infoCommand() {
  struct Request {
    std::vector<std::string> inputs;
    InfoOptions options;
  };
  auto request = std::make_shared<Request>();
  Command command{
      .name = "info",
      .help = "Describes environment maps and models, or tells where a direction is in a map",
      .about = "FILE is a map, a table of `bake`, a built-in environment, a model (" + modelExtensions() +
               "), or - for standard input.",
      .examples = {{"info room.hdr", "format, size, projection and what told it, range and mean of the light"},
                   {"info shoe.glb",
                    "its variants, cameras, lights and animations by their names, and what of it is left out"}}};
  addArgument(command,
              {.name = "FILE",
               .help = "maps (" + std::string(readExtensions()) +
                       "), a built-in: " + join(builtinEnvironmentNames(), " ") + ", or - for standard input",
               .missing = "name an input map",
               .names = builtinEnvironmentNames,
               .takes_path = true},
              request->inputs);
  addOptions(command, kInfoOptions, request->options);
  command.action = [request]() -> Result<void> {
    MIRRORBALL_TRY_VOID(readStandardInput(pointersTo(request->inputs)));
    return info(request->inputs, request->options);
  };
  return command;
}

}  // namespace mirrorball::cli
