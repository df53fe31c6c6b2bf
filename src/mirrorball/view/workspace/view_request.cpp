#include "mirrorball/view/workspace/view_request.h"

#include <array>
#include <vector>

#include "mirrorball/base/text.h"
#include "mirrorball/view/workspace/arguments.h"

namespace mirrorball {
namespace {

const auto kWindowOptions = std::to_array<Option<WindowOptions>>({
    {{.name = "frame-time",
      .value = "MS",
      .unit = "milliseconds",
      .minimum = 1.0,
      .maximum = 1000.0,
      .help = "how long a picture may take while something moves: it becomes smaller for that, down to 640 by 360 "
              "pixels"},
     &WindowOptions::frame_ms},
    {{.name = "vsync", .help = "wait for the screen before the next picture is shown; --vsync=no does not"},
     &WindowOptions::waits_for_screen},
    {{.name = "theme", .choices = "dark|light", .help = "the colours of menus and panels"},
     choiceField<&WindowOptions::theme>},
    {{.name = "keys",
      .value = "KEYS",
      .help =
          "keys that are pressed first, with spaces between, as the page of keys writes them: \"T C\" begins with a "
          "line between the picture and the truth"},
     &WindowOptions::keys},
    {{.name = "find", .value = "LETTERS", .help = "shows the options that these letters find"}, &WindowOptions::find},
    {{.name = "screenshot",
      .value = "FILE",
      .help = "opens no window, but writes what it would show, panels too, as .png or .jpg once the picture is whole",
      .takes_path = true},
     &WindowOptions::screenshot},
    {{.name = "pointer",
      .value = "X,Y",
      .unit = "pixels",
      .min_count = 2,
      .max_count = 2,
      .help = "where the pointer is in the picture of a screenshot, from its top left corner"},
     &WindowOptions::pointer},
});

/// The option that a word names; null: it is none of the window's.
const Option<WindowOptions>* optionOf(std::string_view word) {
  if (!word.starts_with("--")) return nullptr;
  const std::string_view name = word.substr(2, word.find('=') - 2);
  for (const Option<WindowOptions>& option : kWindowOptions)
    if (option.text.name == name) return &option;
  return nullptr;
}

}  // namespace

std::span<const Option<WindowOptions>> windowOptions() { return kWindowOptions; }

Result<ViewRequest> viewRequestOf(std::span<const std::string> arguments) {
  ViewRequest request;
  std::vector<std::string> others;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    request.wants_help = request.wants_help || word == "--help" || word == "-h";
    const Option<WindowOptions>* option = optionOf(word);
    if (!option) {
      others.push_back(word);
      continue;
    }
    const std::size_t equals = word.find('=');
    std::string text = equals == std::string::npos ? "yes" : word.substr(equals + 1);
    if (equals == std::string::npos && !option->isFlag()) {
      if (i + 1 == arguments.size()) return fail(ErrorCode::usage, word + " needs a value");
      text = arguments[++i];
    }
    MIRRORBALL_TRY_VOID(assign(*option, request.window, text));
  }
  if (request.wants_help) return request;
  MIRRORBALL_TRY(workspace, workspaceOf(others));
  request.workspace = std::move(workspace);
  return request;
}

std::string viewHelp() {
  std::string help =
      "usage: mirrorball view [FILE…] [OPTIONS]\n\n"
      "Opens a window on a model in an environment. A FILE is a model, a panorama or another map of all directions, a\n"
      "photograph of a mirror ball, or a workspace; -e MAP shows another environment. All options of `mirrorball "
      "render`\n"
      "for the picture, the material and the quality are taken, and --reference compares with the truth. When it "
      "opens,\n"
      "the picture in it is as large as --size says. The key ? shows what hands and keys do.\n\n";
  const WindowOptions defaults;
  for (const Option<WindowOptions>& option : kWindowOptions) {
    const std::string_view value = option.text.choices.empty() ? option.text.value : option.text.choices;
    help += "  --" + std::string(option.text.name) + (value.empty() ? "" : " ") + std::string(value) + "\n      " +
            std::string(option.text.help);
    const std::string otherwise = written(option, defaults);
    help += otherwise.empty() ? "\n" : " (default " + otherwise + ")\n";
  }
  return help;
}

}  // namespace mirrorball
