#pragma once

#include "mirrorball/base/result.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/study/study.h"

namespace mirrorball {

/// An environment whose light is the direction that it comes from: d is shown as d / 2 + 1/2. A mirror that is
/// addressed by its normal shows its normals in it.
Environment environmentOfDirections();

/// n·v of the model's smooth surface at each pixel, drawn with the renderer.
///
/// renderer  in environmentOfDirections(), with the scene; its materials become mirrors
/// frame     of which size and camera count
/// returns   one channel in [0, 1]; −1 where the model does not fill the pixel
/// errors    as Renderer::setScene's and draw's
Result<Image> cosinesOf(Renderer& renderer, Scene scene, const FrameSettings& frame);

/// The root of relMSE (metric/image_error.h) over the pixels of each step of n·v; nothing where there are fewer than
/// 16 of them.
///
/// test, reference  radiance, of the size of `cosines`
ErrorByAngle errorByAngle(const Image& test, const Image& reference, const Image& cosines);

}  // namespace mirrorball
