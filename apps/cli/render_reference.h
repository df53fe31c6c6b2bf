#pragma once

#include <string>

#include "cli/command.h"
#include "cli/scene_inputs.h"
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

/// Path-traces a picture, and writes it. Ctrl-C writes what there is.
///
/// errors   as loadInputs', PathTracer's and writeImage's
Result<void> renderReference(const SceneRequest& scene, const MaterialChanges& materials, const FrameSettings& frame,
                             const ReferenceOptions& options, const GivenOptions& given, const std::string& output);

}  // namespace mirrorball::cli
