// A build without Embree: all that traces rays fails by one line.
#include <string>

#include "cli/commands.h"
#include "cli/rays.h"
#include "cli/render_reference.h"
#include "cli/surface_ladder.h"
#include "mirrorball/base/left_out.h"

namespace mirrorball::cli {
namespace {

tl::unexpected<Error> noRays(const std::string& what) {
  return leftOut("traces no rays, which " + what + " needs", "MIRRORBALL_EMBREE");
}

Command commandOfRays(std::string_view name) {
  return {.name = name,
          .help = "Is not in this build, which traces no rays",
          .left_out = noRays(std::string(name)).value()};
}

}  // namespace

bool tracesRays() { return false; }

Command fresnelCommand() { return commandOfRays("fresnel"); }
Command studyCommand() { return commandOfRays("study"); }
Command transferCommand() { return commandOfRays("transfer"); }

Result<bool> sceneHidesItself(const Scene&) { return false; }

Result<void> findSceneOcclusion(Scene&, const FrameSettings&, const std::optional<CacheFolder>&) {
  return noRays("--occlusion vertex");
}

Result<MadeMap> normalsOfModel(Image, const std::string&, const SurfaceOptions&) {
  return noRays("a model's normal map");
}

void addReference(Command& command, ReferenceOptions& options, GivenOptions&) {
  addOptions(command, referenceOption(), options);
}

Result<void> checkReference(const ReferenceOptions& options, const FrameSettings&, const GivenOptions&) {
  if (options.is_wanted) return noRays("--reference");
  return {};
}

Result<void> renderReference(const SceneRequest&, const MaterialChanges&, const FrameSettings&, const ReferenceOptions&,
                             const GivenOptions&, const std::string&) {
  return noRays("--reference");
}

Result<TracedMap> traceCapture(SceneInputs, const TracedCapture&, const FrameSettings&, const ReferenceOptions&,
                               const GivenOptions&, StageClock&) {
  return noRays("--reference");
}

Result<void> tellTraced(const TracedPicture&, const std::string&) { return noRays("--reference"); }

void addLadder(Command& command, LadderOptions& options) { addOptions(command, ladderOption(), options); }

Result<void> checkLadder(const LadderOptions& options) {
  if (options.is_wanted) return noRays("--ladder");
  return {};
}

Result<void> drawLadder(const std::string&, float, LadderOptions, const std::string&) { return noRays("--ladder"); }

}  // namespace mirrorball::cli
