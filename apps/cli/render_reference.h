#pragma once

#include <string>

#include "cli/command.h"
#include "cli/scene_inputs.h"
#include "cli/stage_clock.h"
#include "mirrorball/render/frame/frame_settings.h"
#include "mirrorball/trace/path_tracer.h"

namespace mirrorball::cli {

/// What `render --reference` is told beside what `render` is.
struct ReferenceOptions {
  bool is_wanted = false;
  TraceSettings trace;
};

/// Adds them.
void addReference(Command& command, ReferenceOptions& options, GivenOptions& given);

/// Refuses options that only the renderer has, or only the reference.
///
/// errors   usage
Result<void> checkReference(const ReferenceOptions& options, const FrameSettings& frame, const GivenOptions& given);

/// All that a path tracer is told, of its own options and of those that the renderer has too.
TraceSettings traceSettings(const ReferenceOptions& options, const FrameSettings& frame, const GivenOptions& given);

/// A path tracer of them.
///
/// errors   as PathTracer::make's
Result<PathTracer> tracerOf(SceneInputs inputs, StageClock& clock);

/// A progress bar with the noise so far. From the first whole pass on, an interruption waits for the picture so far to
/// be written.
///
/// first_pass   the paths of one pass
TraceObserver observerUntilInterrupted(std::size_t first_pass);

/// Says how good a picture is that was written.
///
/// errors   interrupted, if it was
Result<void> tellTraced(const TracedPicture& picture, const std::string& output);

/// Path-traces a picture, and writes it. Ctrl-C writes what there is.
///
/// errors   as loadInputs', PathTracer's and writeImage's
Result<void> renderReference(const SceneRequest& scene, const MaterialChanges& materials, const FrameSettings& frame,
                             const ReferenceOptions& options, const GivenOptions& given, const std::string& output);

}  // namespace mirrorball::cli
