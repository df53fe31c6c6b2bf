#pragma once

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"
#include "mirrorball/scene/scene.h"
#include "mirrorball/transfer/mapped_surface.h"

namespace mirrorball {

/// Turns a normal map of a model from the axes of its mesh into the frames of its tangents, or back.
///
/// normals  3 or more channels, of which 3 are read: signed, of any length but 0
/// model    first texture coordinates and tangents as they are: by MikkTSpace's rule where its file has none
/// to       from the other of the two
/// returns  3 channels, unit. A texel's frame is that at its centre; one that no triangle covers has that of the
///          nearest texel that one does. Where triangles overlap, the first counts
/// errors   bad_shape (no texture coordinates); out_of_range (a normal without a direction, of which the texel is
///          named); too_large; interrupted
/// cost     0.1 µs a texel
Result<Image> normalsInSpace(const Image& normals, const Scene& model, NormalSpace to,
                             const ProgressFunction& progress = {});

}  // namespace mirrorball
