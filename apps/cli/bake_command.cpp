#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/interruption.h"
#include "cli/map_inputs.h"
#include "cli/stage_clock.h"
#include "cli/standard_streams.h"
#include "cli/terminal.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/output/baked/baked_set.h"
#include "mirrorball/output/baked/engine_set.h"

namespace mirrorball::cli {
namespace {

/// What `bake` is told beside its inputs and the set that it makes (BakedSetSettings).
struct BakeOptions {
  std::string output;
  std::string from;
  bool repair = false;
  bool timings = false;
};

const std::string kBakedHelp =
    "required: a folder for all maps and a manifest (with several environments, one folder in it for each), or a " +
    writtenExtensions(Holds::texture, " or ") +
    " file for the specular mip chain only, or for the cube of --only (-.ktx2 is standard output); with --for babylon, "
    "playcanvas and gltf also a "
    ".env, .png or .glb file";

const Option<BakeOptions> kBakeOutput{
    {.name = "output", .value = "OUT", .help = kBakedHelp, .letter = "o", .takes_path = true}, &BakeOptions::output};

const auto kBakeOptions = std::to_array<Option<BakeOptions>>({
    {formText("form of the environment map, if it is not recognised (see convert --from)"), &BakeOptions::from},
    {{.name = "repair", .help = "replace NaN and infinite texels by the mean of their neighbours"},
     &BakeOptions::repair},
    {{.name = "timings", .help = "print how long each stage took"}, &BakeOptions::timings},
    {kMaxMemoryText, kMemoryLimitField<BakeOptions>},
});

const Option<BakedSetSettings> kBakeRotate{kRotateText, &BakedSetSettings::rotate_deg};

/// All that `bake` was told of one environment.
struct BakeRequest {
  std::string environment;
  BakeOptions options;
  BakedSetSettings settings;
  GivenOptions stated;
};

using OptionNames = std::span<const std::string_view>;

/// Refuses options that say something about what there is not.
///
/// why      what to say before and after the option's name
/// errors   usage
Result<void> refuseGiven(const GivenOptions& stated, OptionNames names, const std::array<std::string, 2>& why) {
  for (const std::string_view name : names)
    if (stated.contains(name)) return fail(ErrorCode::usage, why[0] + "--" + std::string(name) + why[1]);
  return {};
}

// Options by what they say something about.
constexpr std::array<std::string_view, 5> kOfOurMaps{"sh-degree", "brdf-size", "brdf-channels", "brdf-axes",
                                                     "brdf-extension"};
constexpr std::array<std::string_view, 1> kOfLobeRows{"lobe-rows"};
constexpr std::array<std::string_view, 1> kOfIrradiance{"irradiance-size"};
constexpr std::array<std::string_view, 2> kOfSkybox{"skybox", "skybox-size"};
constexpr std::array<std::string_view, 1> kOfNames{"extension"};
constexpr std::array<std::string_view, 1> kOfSplit{"split"};
constexpr std::array<std::string_view, 2> kOfLamps{"min-share", "max-size"};
constexpr std::array<std::string_view, 2> kOfTextures{"format", "zstd"};

/// Refuses options that describe only parts that are not asked for.
///
/// errors   usage
Result<void> refuseOfOtherParts(const BakeRequest& request) {
  const std::vector<BakedPart>& only = request.settings.only;
  if (only.empty()) return {};
  for (const std::string_view option : request.stated) {
    const std::span<const BakedPart> parts = partsDescribedBy(option);
    if (!parts.empty() && std::ranges::none_of(only, [&](BakedPart part) { return contains(parts, part); }))
      return fail(ErrorCode::usage, "--" + std::string(option) + " describes what --only leaves out; leave it out");
  }
  return {};
}

/// Refuses options that a program's own files have no use for.
///
/// errors   usage
Result<void> refuseUnread(const BakeRequest& request, const EngineSet& set) {
  const GivenOptions& stated = request.stated;
  const std::array<std::string, 2> has_no_use{"", ": " + std::string(set.needs_no_others) + "; leave it out"};
  if (set.files != SetFiles::ours) MIRRORBALL_TRY_VOID(refuseGiven(stated, kOfOurMaps, has_no_use));
  if (!set.hasLobeRows()) MIRRORBALL_TRY_VOID(refuseGiven(stated, kOfLobeRows, has_no_use));
  if (!set.has_irradiance_cube) MIRRORBALL_TRY_VOID(refuseGiven(stated, kOfIrradiance, has_no_use));
  if (set.files != SetFiles::packed) return {};
  MIRRORBALL_TRY_VOID(refuseGiven(stated, kOfSkybox, has_no_use));
  const std::string packed = "." + std::string(set.extension);
  const std::string written = packed + (set.beside.empty() ? "" : " and ." + std::string(set.beside));
  MIRRORBALL_TRY_VOID(refuseGiven(
      stated, kOfNames, {"", ": {option:for} " + std::string(set.program) + " writes " + written + "; leave it out"}));
  if (!set.beside.empty() && !isOneFile(request.options.output)) return {};
  return refuseGiven(stated, kOfTextures, {"", " is for textures, and " + packed + " is none; leave it out"});
}

/// Refuses options of maps that the output has no place for.
///
/// errors   usage
Result<void> refuseIdleBakeOptions(const BakeRequest& request) {
  const GivenOptions& stated = request.stated;
  const std::string& output = request.options.output;
  MIRRORBALL_TRY_VOID(refuseOfOtherParts(request));
  MIRRORBALL_TRY(set, engineSetFor(request.settings.file.program, request.settings.mip_mapping));
  const bool is_texture = isOneFile(output) && isTexturePath(output);
  if (!is_texture) MIRRORBALL_TRY_VOID(refuseUnread(request, set));
  if (isOneFile(output)) {
    const std::string only = request.settings.only.empty() ? "the specular chain" : "the cube of --only";
    const std::string what = is_texture ? ": holds " + only + " only" : ": is one file with all in it";
    const std::array<std::string, 2> why{output + what + ", and ",
                                         " is for what lies beside it; name a folder, without an extension"};
    if (is_texture && request.settings.only.empty())
      for (const OptionNames names :
           {OptionNames(kOfOurMaps), OptionNames(kOfLobeRows), OptionNames(kOfIrradiance), OptionNames(kOfSkybox)})
        MIRRORBALL_TRY_VOID(refuseGiven(stated, names, why));
    if (is_texture) MIRRORBALL_TRY_VOID(refuseGiven(stated, kOfNames, why));
    MIRRORBALL_TRY_VOID(refuseGiven(stated, kOfSplit, why));
    return refuseGiven(stated, kOfLamps, why);
  }
  if (request.settings.split) return {};
  return refuseGiven(stated, kOfLamps, {"", " says which lamps are taken out of the maps; add --split"});
}

/// terminalObserver, which also says what an interruption leaves in a folder that was there before.
Observer observerFor(const std::string& output) {
  Observer observer = terminalObserver();
  std::error_code status;
  if (isOneFile(output) || !std::filesystem::exists(output, status)) return observer;
  observer.progress = [output](std::string_view stage) {
    if (stage == "write")
      whenInterrupted("interrupted; " + output + " has only some of the new files, and no manifest of them");
    return progressBar(std::string(stage));
  };
  return observer;
}

/// errors   usage: what can be refused before anything is made
Result<BakedSet> resolveSet(const BakeRequest& request, StageClock& clock) {
  const std::string& output = request.options.output;
  if (isOneFile(output)) MIRRORBALL_TRY_VOID(refuseOverwriting({&request.environment, 1}, {&output, 1}));
  MIRRORBALL_TRY(set, BakedSet::resolve(output, request.settings, clock.observing(observerFor(output))));
  // Only of an output that can be made it makes sense to say what it has no place for.
  MIRRORBALL_TRY_VOID(refuseIdleBakeOptions(request));
  if (isOneFile(output)) MIRRORBALL_TRY_VOID(checkFolder(output));
  return set;
}

Result<void> bakeInto(BakedSet set, const BakeRequest& request, StageClock& clock) {
  MIRRORBALL_TRY(hint, formHintNamed(request.options.from));
  MIRRORBALL_TRY_VOID(set.begin());
  MIRRORBALL_TRY(loaded, clock.time("environment: read", [&] {
    return loadMap(request.environment,
                   {.from = hint, .repair = request.options.repair, .light = request.settings.file.light},
                   progressBar("read"));
  }));
  MIRRORBALL_TRY_VOID(refuseOverwriting(loaded.files, set.paths()));
  return set.save(std::move(loaded));
}

Result<void> bakeOne(BakeRequest request) {
  request.settings.source = shown(request.environment);
  StageClock clock;
  MIRRORBALL_TRY(set, resolveSet(request, clock));
  const Result<void> done = bakeInto(std::move(set), request, clock);
  if (request.options.timings) clock.print();
  return done;
}

/// One after the other, since each keeps all cores busy and may need all memory.
Result<void> bakeMany(const std::vector<std::string>& inputs, BakeRequest request) {
  const std::string parent = request.options.output;
  if (isOneFile(parent)) return tl::unexpected<Error>(manyForOneFile(parent, inputs));
  // The '/' makes it a folder's name: of hall.v2.hdr, "hall.v2" alone would be that of a file with an extension.
  MIRRORBALL_TRY(folders, namesInFolder(inputs, parent, [](const auto&) { return Result<std::string>("/"); }));
  request.options.output = folders.front();
  // What is wrong with the options is told once, before anything is made.
  StageClock unused;
  MIRRORBALL_TRY_VOID(resolveSet(request, unused));
  MIRRORBALL_TRY_VOID(makeFolder(parent));
  std::size_t failed = 0;
  for (std::size_t index = 0; index < inputs.size() && !interrupted(); ++index) {
    whenInterrupted(interruptedAmongMany(parent));
    request.environment = inputs[index];
    request.options.output = folders[index];
    const Result<void> done = bakeOne(request);
    if (done || done.error().code == ErrorCode::interrupted) continue;
    ++failed;
    complain(done.error());
  }
  return outcomeOfMany(failed, inputs.size(), "baked", parent);
}

Result<void> bakeInputs(const std::vector<std::string>& inputs, BakeRequest request) {
  const std::string& output = request.options.output;
  if (output.empty()) {
    MIRRORBALL_TRY_VOID(refuseUnnamedOutput(inputs, [](const std::string& name) {
      return isTexturePath(name) || name.ends_with('/') || !std::filesystem::path(name).has_extension();
    }));
    return fail(ErrorCode::usage,
                "bake needs an output: -o FOLDER, or a " + writtenExtensions(Holds::texture, " or ") + " file");
  }
  if (inputs.size() > 1) return bakeMany(inputs, std::move(request));
  request.environment = inputs.front();
  // Of a folder that is new nothing stays, whichever of its files are finished.
  if (!isOneFile(output)) whenInterrupted("interrupted; nothing was written");
  return bakeOne(std::move(request));
}

}  // namespace

Command bakeCommand() {
  struct Request {
    std::vector<std::string> inputs;
    BakeRequest bake;
  };
  auto request = std::make_shared<Request>();
  Command command{
      .name = "bake",
      .help = "Prefilters environments for an engine: rough reflections, irradiance, harmonics, BRDF table",
      .about =
          "ENV is a map, a built-in environment, or - for standard input. OUT is a folder for all maps (with several "
          "environments, one folder in it for each), or a " +
          writtenExtensions(Holds::texture, " or ") +
          " file for the specular mip chain only, or for the cube that --only names.",
      .examples = {{"bake room.hdr -o room/", "all maps of an environment, and a manifest that says what is what"},
                   {"bake maps/*.hdr --for unreal --size 512 -o baked/",
                    "a folder for each panorama, with Unreal's faces and levels"}}};
  addArgument(command,
              {.name = "ENV",
               .help = "maps, as convert takes them, a built-in: " + join(builtinEnvironmentNames(), " ") +
                       ", or - for standard input",
               .missing = "name an input map",
               .names = builtinEnvironmentNames,
               .takes_path = true},
              request->inputs);
  BakeRequest& bake = request->bake;
  bake.settings.made_by = std::string("mirrorball ") + MIRRORBALL_VERSION + " bake";
  addOptions(command, std::span(&kBakeOutput, 1), bake.options);
  addOptions(command, bakedSetOptions(), bake.settings, &bake.stated);
  static const std::vector<Option<LampSettings>> of_lamps =
      rowsNamed(lampOptions(), std::array<std::string_view, 2>{"min-share", "max-size"});
  addOptions(command, of_lamps, bake.settings.lamps, &bake.stated);
  addOptions(command, std::span(kBakeOptions).first(1), bake.options);
  addOptions(command, std::span(&kBakeRotate, 1), bake.settings, &bake.stated);
  addOptions(command, std::span(kBakeOptions).subspan(1), bake.options);
  addOptions(command, textureFileOptions(), bake.settings.file, &bake.stated);
  command.action = [request] {
    return withStandardStreams(pointersTo(request->inputs), request->bake.options.output,
                               [&] { return bakeInputs(request->inputs, request->bake); });
  };
  return command;
}

}  // namespace mirrorball::cli
