#include <array>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/lights_text.h"
#include "cli/map_inputs.h"
#include "cli/standard_streams.h"
#include "cli/terminal.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/light_edit/lamp_picture.h"
#include "mirrorball/light_edit/lamp_scale.h"
#include "mirrorball/light_edit/lamp_search.h"
#include "mirrorball/output/convert_file.h"
#include "mirrorball/output/lamps/lamp_files.h"
#include "mirrorball/output/map_file.h"

namespace mirrorball::cli {
namespace {

/// What `lights` is told beside its map and the lamps that are wanted of it (LampSettings).
struct LightsOptions {
  std::string picture;
  std::string split;
  float scale = 1.0f;
  std::vector<std::string> lamp_files;
  bool json = false;
  Display display{.tone_map = ToneMap::neutral};
  std::string from;
  bool repair = false;
};

const std::string kPictureHelp =
    "also write the map as a panorama with the outlines of its lamps, as " + writtenExtensions(Holds::picture, " or ") +
    "; with --scale, the map itself, in the form that it has, as " + writtenExtensions(" or ") +
    "; -.png is standard output, likewise with the other extensions";
const std::string kLampFilesHelp =
    "with --split, write the lamps that are taken out to FILE, which ends in " + lampFileEndings() +
    "; may be repeated; without it, REST_lamps.glb, REST_lamps.json and a snippet for the program of --for, if one is "
    "known";

const auto kOutputs = std::to_array<Option<LightsOptions>>({
    {{.name = "output", .value = "FILE", .help = kPictureHelp, .letter = "o", .group = "Output", .takes_path = true},
     &LightsOptions::picture},
    {{.name = "split",
      .value = "REST",
      .help = "take the small lamps out of the map and write what is left to REST, a map such as rest.exr",
      .group = "Output",
      .takes_path = true},
     &LightsOptions::split},
    {{.name = "scale",
      .value = "K",
      .minimum = 0,
      .maximum = 1000,
      .help = "multiply the light of the lamps by K and write the map to --output; 0 puts their surroundings in their "
              "place. With --max-size, only of lamps of up to that size"},
     &LightsOptions::scale},
    {{.name = "lamps", .value = "FILE", .help = kLampFilesHelp, .group = "Output", .takes_path = true},
     &LightsOptions::lamp_files},
    {{.name = "json", .help = "print JSON: an array `lights`, the strongest first", .group = "Output"},
     &LightsOptions::json},
    {exposureText(), numberField<&LightsOptions::display, &Display::exposure_ev>},
    {toneMapText(), choiceField<&LightsOptions::display, &Display::tone_map>},
});

const auto kInputs = std::to_array<Option<LightsOptions>>({
    {formText("form of the map, if it is not recognised (see convert --from)"), &LightsOptions::from},
    {{.name = "repair", .help = "replace NaN and infinite texels by the mean of their neighbours"},
     &LightsOptions::repair},
    {kMaxMemoryText, kMemoryLimitField<LightsOptions>},
});

/// All that `lights` was told.
struct LightsRequest {
  std::string input;
  LampSettings lamps;
  LightsOptions options;
  MapFileOptions file;  ///< of what is written of the map
  GivenOptions stated;  ///< of those that mean something with --split or --scale alone, and others

  bool isScaled() const { return stated.contains("scale"); }
};

/// Refuses what can be refused with --scale before the map is read.
///
/// errors   usage; io: the folder does not exist
Result<void> settleScaled(LightsRequest& request) {
  const LightsOptions& options = request.options;
  if (options.picture.empty())
    return fail(ErrorCode::usage, "--scale writes the map with other lamps; name it: -o FILE.exr");
  for (const std::string_view name : {"split", "lamps"})
    if (request.stated.contains(name))
      return fail(ErrorCode::usage, "--" + std::string(name) +
                                        " takes the lamps out of the map, and --scale leaves them in; leave one of the "
                                        "two out");
  MIRRORBALL_TRY_VOID(refusePictureOptions(request.stated, options.picture, ""));
  if (!request.stated.contains("max-size")) request.lamps.max_size_deg = 360.0f;
  // Outlines are drawn over a tone-mapped picture, and a map has the options that it is asked for.
  request.file.display.exposure_ev = options.display.exposure_ev;
  if (request.stated.contains("tone-map")) request.file.display.tone_map = options.display.tone_map;
  request.file.is_one_file = isStandardOutputTaken();
  MIRRORBALL_TRY_VOID(formatToWrite(options.picture, {Holds::light, Holds::texture, Holds::picture}));
  return checkFolder(options.picture);
}

/// Refuses what can be refused before the map is read, and names the lamps' files.
///
/// errors   usage; io: the folder does not exist
Result<void> settle(LightsRequest& request) {
  LightsOptions& options = request.options;
  if (request.isScaled()) return settleScaled(request);
  if (!options.picture.empty()) {
    if (!formatToWrite(options.picture, {Holds::picture}))
      return fail(ErrorCode::usage, options.picture + ": outlines are drawn into a picture; name a " +
                                        writtenExtensions(Holds::picture, " or ") +
                                        " file, or say --split for a map without its lamps, or "
                                        "--scale 2 for one with brighter ones");
    MIRRORBALL_TRY_VOID(checkFolder(options.picture));
  }
  if (options.split.empty()) {
    for (const std::string_view name : {"lamps", "max-size", "for", "format", "layout", "mips"})
      if (request.stated.contains(name))
        return fail(ErrorCode::usage, "--" + std::string(name) +
                                          " says how small lamps and the rest of a map are written apart; add --split "
                                          "REST.exr, or --scale K for a map with other lamps");
    return {};
  }
  MIRRORBALL_TRY_VOID(checkFolder(options.split));
  if (options.lamp_files.empty()) {
    const std::filesystem::path rest(options.split);
    options.lamp_files = lampFilesFor((rest.parent_path() / rest.stem()).string() + "_lamps", request.file.program);
  }
  for (const std::string& file : options.lamp_files) {
    MIRRORBALL_TRY_VOID(checkLampFile(file));
    MIRRORBALL_TRY_VOID(checkFolder(file));
  }
  return {};
}

/// Writes a map apart from its lamps.
Result<void> writeSplit(SplitMap split, const MapFile& rest, const std::vector<std::string>& lamp_files) {
  const std::vector<MapLamp> lamps = takenLamps(split);
  MIRRORBALL_TRY_VOID(rest.write(std::move(split.rest)));
  for (const std::string& file : lamp_files) {
    MIRRORBALL_TRY_VOID(writeLamps(file, lamps));
    announce(file);
  }
  return {};
}

/// With --split: takes the small lamps out, tells how well that went, and writes both.
///
/// inputs   the map's files
Result<void> splitInto(EnvironmentMap map, std::span<const std::string> inputs, const LightsRequest& request,
                       FoundLights& found) {
  const LightsOptions& options = request.options;
  MIRRORBALL_TRY(rest, MapFile::resolve(options.split, request.file, map.projection(), terminalObserver()));
  std::vector<std::string> outputs = rest.paths();
  outputs.insert(outputs.end(), options.lamp_files.begin(), options.lamp_files.end());
  if (!options.picture.empty()) outputs.push_back(options.picture);
  MIRRORBALL_TRY_VOID(refuseSharedNames(outputs));
  MIRRORBALL_TRY_VOID(refuseOverwriting(inputs, outputs));
  SplitMap split = splitMap(std::move(map), request.lamps);
  MIRRORBALL_TRY(errors, lampErrors(split, progressBar("measure")));
  found.is_split = true;
  found.lamps = split.kept;
  found.taken = takenLamps(split);
  found.errors = std::move(errors);
  return writeSplit(std::move(split), rest, options.lamp_files);
}

Result<void> drawLamps(const Environment& map, const LightsOptions& options, const FoundLights& found) {
  std::vector<MapLamp> lamps = found.taken;
  lamps.insert(lamps.end(), found.lamps.begin(), found.lamps.end());
  MIRRORBALL_TRY(picture, lampPicture(map, lamps, options.display, progressBar("draw")));
  MIRRORBALL_TRY_VOID(savePicture(options.picture, picture));
  announce(options.picture);
  return {};
}

/// With --scale: writes the map with other lamps, in the form that it has.
Result<void> scaleInto(LoadedEnvironment loaded, const LightsRequest& request, FoundLights& found) {
  const std::string& path = request.options.picture;
  const EnvironmentMap* const map = loaded.environment.map();
  const Projection projection = map != nullptr ? map->projection() : Projection(Projection::equirect);
  MIRRORBALL_TRY(output,
                 MapFile::resolve(path, keepingLayout(loaded, path, request.file), projection, terminalObserver()));
  MIRRORBALL_TRY_VOID(refuseOverwriting(loaded.files, output.paths()));
  if (loaded.levels > 1 && output.leavesLevelsOut())
    terminalObserver().tell(RemarkKind::levels_left_out, found.name + ": of its " + std::to_string(loaded.levels) +
                                                             " mip levels only the first is taken");
  MIRRORBALL_TRY(scaled, withName(found.name, scaleLamps(std::move(loaded.environment), request.options.scale,
                                                         request.lamps, terminalObserver().named(found.name))));
  if (scaled.lamps.empty()) remark(found.name + ": has no lamp to scale; its light is written as it is");
  found.lamps = std::move(scaled.lamps);
  found.scale = request.options.scale;
  return output.write(std::move(scaled.map));
}

Result<void> findLights(LightsRequest& request) {
  MIRRORBALL_TRY_VOID(settle(request));
  const LightsOptions& options = request.options;
  MIRRORBALL_TRY(hint, formHintNamed(options.from));
  MIRRORBALL_TRY(loaded, loadMap(request.input, {.from = hint, .repair = options.repair}, progressBar("read")));
  if (!options.picture.empty()) MIRRORBALL_TRY_VOID(refuseOverwriting(loaded.files, {&options.picture, 1}));
  FoundLights found{.name = shown(request.input), .min_share = request.lamps.min_share};
  if (request.isScaled()) {
    MIRRORBALL_TRY_VOID(scaleInto(std::move(loaded), request, found));
    print(options.json ? jsonOf(found) : textOf(found));
    return {};
  }
  MIRRORBALL_TRY(map, searchedMap(std::move(loaded.environment), progressBar("convert")));
  MIRRORBALL_TRY_VOID(withName(found.name, checkLight(map, terminalObserver().named(found.name))));
  Environment drawn({}, 1);
  if (!options.picture.empty()) drawn = Environment(map);
  if (options.split.empty())
    found.lamps = findLamps(map, wholeLight(map), request.lamps);
  else
    MIRRORBALL_TRY_VOID(splitInto(std::move(map), loaded.files, request, found));
  if (!options.picture.empty()) MIRRORBALL_TRY_VOID(drawLamps(drawn, options, found));
  print(options.json ? jsonOf(found) : textOf(found));
  return {};
}

}  // namespace

Command lightsCommand() {
  auto request = std::make_shared<LightsRequest>();
  Command command{
      .name = "lights",
      .help = "Finds the lamps of an environment map (suns, windows, soft boxes), and takes suns out of it",
      .about =
          "MAP is a map, a built-in environment, or - for standard input. Irradiance and illuminance, its "
          "luminance, are those of a surface that faces the lamp, in the map's own unit: lx where its radiance is "
          "in cd/m².",
      .examples = {{"lights room.hdr -o lamps.png", "where its lamps are, how large, and how much light they give"},
                   {"lights garden.hdr --split rest.exr --for three",
                    "the map without its sun, and the sun as glTF, JSON and code of three.js"}}};
  addArgument(command,
              {.name = "MAP",
               .help = "a map (" + std::string(readExtensions()) +
                       "), a built-in: " + join(builtinEnvironmentNames(), " ") + ", or - for standard input",
               .missing = "name an input map",
               .names = builtinEnvironmentNames,
               .takes_path = true},
              request->input);
  addOptions(command, lampOptions(), request->lamps, &request->stated);
  addOptions(command, kOutputs, request->options, &request->stated);
  static const std::vector<Option<MapFileOptions>> of_rest =
      rowsNamed(mapFileOptions(), std::array<std::string_view, 4>{"for", "format", "layout", "mips"});
  addOptions(command, of_rest, request->file, &request->stated);
  addOptions(command, kInputs, request->options);
  command.action = [request] {
    return withStandardStreams({&request->input}, request->options.picture, [&] { return findLights(*request); });
  };
  return command;
}

}  // namespace mirrorball::cli
