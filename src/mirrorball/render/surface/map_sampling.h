#pragma once

#include "mirrorball/gl/sampler.h"
#include "mirrorball/height_field/height_field.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// How the edges of a map of heights are read.
gl::Sampling wrapOf(MapEdges edges);

/// How a texture's edges are read, and its texels close up.
gl::Sampling wrapOf(const Texture& texture);

/// That with the filter of a frame, as the driver reads a texture of a unit of its own.
///
/// anisotropy   gl::Sampling::anisotropy of TextureFilter::anisotropic
gl::Sampling samplingOf(gl::Sampling sampling, TextureFilter filter, float anisotropy);

}  // namespace mirrorball
