#pragma once

#include <span>
#include <string>

#include "cli/command.h"
#include "cli/render_frames.h"
#include "cli/scene_inputs.h"
#include "cli/stage_clock.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/trace/path_tracer.h"

namespace mirrorball::cli {

/// What `render --reference` is told beside what `render` is.
struct ReferenceOptions {
  bool is_wanted = false;
  TraceSettings trace;
};

/// Adds them.
void addReference(Command& command, ReferenceOptions& options, GivenOptions& given);

/// Refuses options that only the reference has where it is not wanted; where it is, says which have no meaning for it.
///
/// errors   usage
Result<void> checkReference(const ReferenceOptions& options, const FrameSettings& frame, const GivenOptions& given);

/// Says how good a picture is that was written.
///
/// errors   interrupted, if it was
Result<void> tellTraced(const TracedPicture& picture, const std::string& output);

/// Path-traces a map. From the first whole pass on, an interruption waits for the map so far to be written.
///
/// errors   as PathTracer's
Result<TracedMap> traceCapture(SceneInputs inputs, const TracedCapture& capture, const FrameSettings& frame,
                               const ReferenceOptions& options, const GivenOptions& given, StageClock& clock);

/// Path-traces a picture, and writes it. Ctrl-C writes what there is.
///
/// errors   usage: layers in other primaries than Rec.709's; as loadInputs', PathTracer's and writeImage's
Result<void> renderReference(const SceneRequest& scene, const MaterialChanges& materials, const FrameSettings& frame,
                             const ReferenceOptions& options, const GivenOptions& given, const std::string& output,
                             const PictureForm& form);

}  // namespace mirrorball::cli
