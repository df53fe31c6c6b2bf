#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/interruption.h"
#include "cli/map_inputs.h"
#include "cli/scene_inputs.h"
#include "cli/standard_streams.h"
#include "cli/terminal.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/contact/contact.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball::cli {
namespace {

/// What `contact` reads from its command line beside its inputs and what the sheet looks like.
struct ContactFiles {
  std::string output;
  bool is_uncached = false;
};

const std::string kContactSheetHelp = "required: the picture file of the sheet, " +
                                      writtenExtensions(Holds::picture, " or ") + "; -.png is standard output";

const auto kContactFileOptions = std::to_array<Option<ContactFiles>>({
    {{.name = "output",
      .value = "OUT",
      .help = kContactSheetHelp,
      .letter = "o",
      .group = "Files",
      .takes_path = true,
      .is_daily = true},
     &ContactFiles::output},
    {{.name = "no-cache",
      .help = "make anew what the user's cache folder keeps of environments and models, without that folder",
      .group = "Files"},
     &ContactFiles::is_uncached},
    {kMaxMemoryText, kMemoryLimitField<ContactFiles>},
});

const Option<ContactSettings> kInsideOnly{kInsideOnlyText, &ContactSettings::inside_only};

/// Options that describe how models are shown.
constexpr std::array<std::string_view, 7> kOfModels{"env",     "samples",     "camera",  "up",
                                                    "quality", "inside-only", "no-cache"};

struct ContactRequest {
  std::vector<std::string> inputs;
  ContactFiles files;
  ContactSettings settings;
};

/// Refuses what can be refused before anything is read.
///
/// errors   usage; io (the folder)
Result<void> checkContactOutput(const ContactRequest& request) {
  const std::string& output = request.files.output;
  if (output.empty()) {
    MIRRORBALL_TRY_VOID(refuseUnnamedOutput(request.inputs, isOutputName));
    return fail(ErrorCode::usage, "contact needs an output: -o FILE, " + writtenExtensions(Holds::picture, " or "));
  }
  MIRRORBALL_TRY_VOID(checkFolder(output));
  MIRRORBALL_TRY_VOID(formatToWrite(output, {Holds::picture}));
  return refuseOverwriting(request.inputs, {&output, 1});
}

/// The maps and models, each cube once.
std::vector<ContactInput> contactInputs(const ContactRequest& request, const FormHint& from) {
  std::vector<ContactInput> inputs;
  std::vector<std::string> maps;
  for (const std::string& input : request.inputs) {
    inputs.push_back({input, shown(input), isModelInput(input)});
    if (!inputs.back().is_model) maps.push_back(input);
  }
  const std::vector<std::string> kept = withEachCubeOnce(maps, from);
  auto next = kept.begin();
  std::erase_if(inputs, [&](const ContactInput& each) {
    if (each.is_model) return false;
    const bool is_kept = next != kept.end() && *next == each.input;
    if (is_kept) ++next;
    return !is_kept;
  });
  return inputs;
}

/// Remarks on options that change nothing.
void remarkOnModelOptions(const ContactRequest& request, const std::vector<ContactInput>& inputs) {
  for (const ContactInput& each : inputs)
    if (each.is_model) return;
  std::vector<std::string> idle;
  for (const std::string_view name : kOfModels)
    if (request.settings.stated.contains(name)) idle.push_back("--" + std::string(name));
  if (!idle.empty()) remark(changesNothing(idle, "none of the inputs is a model"));
}

/// Writes a sheet of all inputs that can be shown.
///
/// errors   usage; interrupted; as makeContactSheet's; of one input alone its own; bad_file: some of several failed
Result<void> contact(const ContactRequest& request) {
  MIRRORBALL_TRY_VOID(checkContactOutput(request));
  MIRRORBALL_TRY(hint, formHintNamed(request.settings.from));
  const std::vector<ContactInput> inputs = contactInputs(request, hint);
  remarkOnModelOptions(request, inputs);
  MIRRORBALL_TRY(cache, cacheFolder(request.files.is_uncached));
  std::vector<Error> errors;
  const bool is_one = inputs.size() == 1;
  MIRRORBALL_TRY(sheet, makeContactSheet(inputs, request.settings, cache, terminalObserver(), [&](const Error& error) {
                   errors.push_back(error);
                   if (!is_one) complain(error);
                 }));
  if (is_one && !errors.empty()) return tl::unexpected<Error>(errors.front());
  for (const std::string& note : sheet.notes) remark(note);
  const std::string& output = request.files.output;
  if (errors.size() < inputs.size()) {
    MIRRORBALL_TRY_VOID(refuseOverwriting(sheet.files, {&output, 1}));
    MIRRORBALL_TRY_VOID(savePicture(output, sheet.picture));
    announce(output);
  }
  return outcomeOfMany(errors.size(), inputs.size(), "shown", "");
}

}  // namespace

Command contactCommand() {
  auto request = std::make_shared<ContactRequest>();
  const std::string formats = "maps (" + std::string(readExtensions()) + "), models (" + modelExtensions() + ")";
  Command command{.name = "contact",
                  .help = "Makes a contact sheet: a picture with a cell and a name for each of many maps and models",
                  .about =
                      "IN is a map or a model, a file or a built-in, or - for standard input; both kinds may be "
                      "on one sheet. `--output` is required.",
                  .examples = {{"contact hdris/*.hdr -o sheet.png", "an overview of a folder of panoramas"},
                               {"contact models/*.glb -e attic.hdr --columns 6 --size 240 -o models.jpg",
                                "models in the light of an attic"}}};
  addArgument(command,
              {.name = "IN",
               .help = formats + ", built-in ones: " + join(builtinEnvironmentNames(), " ") + " " +
                       join(builtinModelNames(), " ") + ", or - for standard input",
               .missing = "name maps or models",
               .takes_path = true},
              request->inputs);
  ContactSettings& settings = request->settings;
  addOptions(command, std::span(kContactFileOptions).first(1), request->files);
  addOptions(command, contactOptions(), settings, &settings.stated);
  static const auto of_frame =
      rowsNamed(frameOptions(), std::array<std::string_view, 3>{"tone-map", "samples", "camera"});
  static const auto of_stance = rowsNamed(stanceOptions(), std::array<std::string_view, 1>{"up"});
  addOptions(command, of_frame, settings.frame, &settings.stated);
  addOptions(command, of_stance, settings.stance, &settings.stated);
  addOptions(command, qualityOptions(), settings.quality, &settings.stated);
  addOptions(command, std::span(&kInsideOnly, 1), settings, &settings.stated);
  addOptions(command, std::span(kContactFileOptions).subspan(1), request->files, &settings.stated);
  command.action = [request] {
    std::vector<std::string*> inputs = pointersTo(request->inputs);
    inputs.push_back(&request->settings.environment);
    return withStandardStreams(inputs, request->files.output, [&] { return contact(*request); });
  };
  return command;
}

}  // namespace mirrorball::cli
