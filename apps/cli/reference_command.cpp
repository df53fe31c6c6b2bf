#include <cstdio>

#include "cli/bake_command.h"
#include "cli/capture_command.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/convert_command.h"
#include "cli/info_command.h"
#include "cli/map_output.h"
#include "cli/photo_command.h"
#include "cli/render_command.h"
#include "cli/scene_inputs.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/builtin.h"
#include "mirrorball/render/render_options.h"
#include "mirrorball/scene/material.h"

namespace mirrorball::cli {
namespace {

/// "a|b" would end a cell of a Markdown table.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '|') result += '\\';
    result += letter;
  }
  return result;
}

void printHeading(const char* title, const std::string& prefix_meaning) {
  std::printf("\n## %s\n\n%s\n\n| name | value | unit | range | default | meaning |\n|---|---|---|---|---|---|\n",
              title, prefix_meaning.c_str());
}

template <typename Target>
void printRows(std::span<const Option<Target>> table, const char* prefix) {
  const Target defaults{};
  for (const Option<Target>& option : table) {
    const OptionText& text = option.text;
    const std::string_view value = text.value.empty() ? text.choices : text.value;
    const std::string letter = text.letter.empty() ? "" : " -" + std::string(text.letter);
    std::printf("| `%s%s`%s | %s | %s | %s | %s | %s |\n", prefix, std::string(text.name).c_str(), letter.c_str(),
                escaped(value).c_str(), std::string(text.unit).c_str(), rangeText(text).c_str(),
                escaped(written(option, defaults)).c_str(), escaped(text.help).c_str());
  }
}

std::string_view contentsOf(Holds what) {
  switch (what) {
    case Holds::light:
      return "linear light";
    case Holds::picture:
      return "integers, sRGB";
    case Holds::either:
      return "integers, sRGB; or floats, linear light";
    case Holds::texture:
      return "textures: cubes, arrays, mip levels";
  }
  return {};
}

void printFormats() {
  std::printf(
      "\n## Formats of pictures\n\nTold by their first bytes when they are read, by the extension when they are "
      "written.\n\n| format | extensions | holds | written | read |\n|---|---|---|---|---|\n");
  for (const ImageFormat& format : kImageFormats) {
    std::string extensions;
    for (const std::string& extension : split(format.extensions, ' '))
      extensions += (extensions.empty() ? "`." : " `.") + extension + "`";
    std::printf("| %s | %s | %s | %s | %s |\n", std::string(format.name).c_str(), extensions.c_str(),
                std::string(contentsOf(format.holds)).c_str(), format.is_written ? "yes" : "",
                std::string(format.what).c_str());
  }
}

Result<void> printReference() {
  std::printf(
      "# Options\n\nMade by `mirrorball reference` from the tables that the command line itself is made from; "
      "a test holds this page to them.\n");
  printHeading("mirrorball render [MODEL]", "MODEL is a file (.glb .gltf .obj .ply .stl) or a built-in.");
  printRows(sceneOptions(), "--");
  printRows(renderFileOptions(), "--");
  printRows(renderOptions(), "--");
  printHeading("mirrorball convert IN…",
               "IN is a map (" + std::string(readExtensions()) +
                   "), one of a cube's six files or their folder, or a built-in environment. `--to` and `--output` "
                   "are needed.");
  printRows(convertOptions(), "--");
  printRows(mapOutputOptions(), "--");
  printHeading("mirrorball bake ENV", "ENV is a map or a built-in environment. OUT is a folder, for all maps, or a " +
                                          writtenExtensions(Holds::texture, " or ") +
                                          " file, for the specular chain only.");
  printRows(bakeOptions(), "--");
  printRows(textureOutputOptions(), "--");
  printHeading("mirrorball capture [SCENE]",
               "SCENE is a file (.glb .gltf .obj .ply .stl) or a built-in. `--at` and `--output` are needed.");
  printRows(sceneOptions(), "--");
  printRows(captureOptions(), "--");
  printRows(mapOutputOptions(), "--");
  printRows(captureLookOptions(), "--");
  printHeading("mirrorball info FILE", "FILE is a map or a built-in environment.");
  printRows(infoOptions(), "--");
  printHeading("mirrorball photo PHOTO…",
               "PHOTO is a photograph of a mirror ball with integers (" + readExtensions(Holds::picture) +
                   ") or light (" + readExtensions(Holds::light) +
                   "), or several with integers, of one exposure series. `--output` is needed.");
  printRows(mapOutputOptions(), "--");
  printRows(photoOptions(), "--");
  printFormats();
  printHeading("Material parameters", "For `--set key=value`.");
  printRows(materialParameters(), "");
  printHeading("Parameters of the sky", "For `sky:key=value,key=value`.");
  printRows(skyParameters(), "");
  return {};
}

}  // namespace

Action addReferenceCommand(CLI::App& program) {
  addCommand(program, "reference", "Prints all options and parameters as Markdown");
  return printReference;
}

}  // namespace mirrorball::cli
