#pragma once

#include "mirrorball/base/option.h"
#include "mirrorball/render/settings/frame_settings.h"

namespace mirrorball::frame_fields {

/// What the options of frameOptions() set whose text is more than a number or a choice: how it is read, and written.
using Field = ParsedField<FrameSettings>;

extern const Field kSize;
extern const Field kBackground;
extern const Field kOrbit;  ///< of --camera: where it stands, or the name of one of the model's own
extern const Field kTarget;
extern const Field kOrthographic;
extern const Field kRotation;
extern const Field kProxy;
extern const Field kGroundRoughness;
extern const Field kCapturedAt;
extern const Field kProbes;
extern const Field kTextureMatrix;
extern const Field kWavelength;
extern const Field kLight;

}  // namespace mirrorball::frame_fields
