#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/formatted.h"
#include "cli/json_values.h"
#include "cli/map_inputs.h"
#include "cli/standard_streams.h"
#include "cli/terminal.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/light_edit/lamp_search.h"
#include "mirrorball/output/lamps/lamp_json.h"

namespace mirrorball::cli {
namespace {

/// What `lights` is told beside its map and the lamps that are wanted of it (LampSettings).
struct LightsOptions {
  bool json = false;
  std::string from;
  bool repair = false;
  std::string max_memory;
};

const auto kLightsOptions = std::to_array<Option<LightsOptions>>({
    {{.name = "json", .help = "print JSON: an array `lights`, the strongest first"}, &LightsOptions::json},
    {{.name = "from",
      .value = "FORM",
      .help = "form of the map, if it is not recognised (see convert --from)",
      .names = projectionNames},
     &LightsOptions::from},
    {{.name = "repair", .help = "replace NaN and infinite texels by the mean of their neighbours"},
     &LightsOptions::repair},
    {kMaxMemoryText, &LightsOptions::max_memory},
});

/// All that `lights` was told.
struct LightsRequest {
  std::string input;
  LampSettings lamps;
  LightsOptions options;
};

std::string columnsOfDirection(glm::vec3 d) {
  return formatted("%6.3f %6.3f %6.3f", double(d.x), double(d.y), double(d.z));
}

/// The table: a row for each lamp.
std::string tableOf(std::span<const MapLamp> lamps) {
  std::string text = "     share  direction to it      size    illuminance  irradiance (red green blue)\n";
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    const MapLamp& lamp = lamps[i];
    text += formatted("%2zu  %5.1f %%  ", i + 1, 100.0 * double(lamp.share)) + columnsOfDirection(lamp.direction) +
            formatted("  %5.2f deg  %s%9s  ", double(glm::degrees(lamp.angular_size_rad)),
                      lamp.is_clipped ? ">=" : "  ", shortText(double(lamp.illuminance())).c_str()) +
            shortText(lamp.irradiance) + "\n";
  }
  return text;
}

void print(const std::string& name, std::span<const MapLamp> lamps, const LightsRequest& request) {
  if (request.options.json) {
    Json json{{"file", name}};
    json.update(lampJson(lamps));
    std::fputs(printedJson(json).c_str(), stdout);
    return;
  }
  if (lamps.empty()) {
    std::printf("%s: no lamp outshines the rest with %s %% of the light or more\n", name.c_str(),
                shortText(100.0 * double(request.lamps.min_share)).c_str());
    return;
  }
  double share = 0.0;
  for (const MapLamp& lamp : lamps) share += double(lamp.share);
  std::printf("%s: %s with %s %% of the light\n%s", name.c_str(), counted(lamps.size(), "lamp").c_str(),
              formatted("%.3g", 100.0 * share).c_str(), tableOf(lamps).c_str());
  for (const MapLamp& lamp : lamps)
    if (lamp.is_clipped) {
      std::printf(
          ">= the brightest texels are all alike, as where a camera or a format clips: it is at least so much\n");
      break;
    }
}

Result<void> findLights(const LightsRequest& request) {
  MIRRORBALL_TRY_VOID(useMemoryLimit(request.options.max_memory));
  MIRRORBALL_TRY(hint, formHintNamed(request.options.from));
  MIRRORBALL_TRY(loaded, loadMap(request.input, {.from = hint, .repair = request.options.repair}, progressBar("read")));
  const std::string name = shown(request.input);
  MIRRORBALL_TRY(map, searchedMap(std::move(loaded.environment), progressBar("convert")));
  MIRRORBALL_TRY_VOID(withName(name, checkLight(map, terminalObserver().named(name))));
  print(name, findLamps(map, wholeLight(map), request.lamps), request);
  return {};
}

}  // namespace

Command lightsCommand() {
  auto request = std::make_shared<LightsRequest>();
  Command command{.name = "lights",
                  .help = "Finds the lamps of an environment map: suns, windows, soft boxes",
                  .about = "MAP is a map, a built-in environment, or - for standard input.",
                  .examples = {{"lights room.hdr", "where its lamps are, how large, and how much light they give"}}};
  addArgument(command,
              {.name = "MAP",
               .help = "a map (" + std::string(readExtensions()) +
                       "), a built-in: " + join(builtinEnvironmentNames(), " ") + ", or - for standard input",
               .missing = "name an input map",
               .names = builtinEnvironmentNames,
               .takes_path = true},
              request->input);
  addOptions(command, lampOptions(), request->lamps);
  addOptions(command, kLightsOptions, request->options);
  command.action = [request]() -> Result<void> {
    MIRRORBALL_TRY_VOID(readStandardInput({&request->input}));
    return findLights(*request);
  };
  return command;
}

}  // namespace mirrorball::cli
