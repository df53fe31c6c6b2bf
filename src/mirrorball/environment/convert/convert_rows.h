#pragma once

#include <cstddef>

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/codec/row_reader.h"
#include "mirrorball/environment/convert/convert.h"

namespace mirrorball {

/// Lays a panorama out in another projection while it is read: only a window of its rows, which moves down, is in
/// memory. Texels come as from convertByStrips, bit by bit.
///
/// source   an equirectangular panorama, none of whose rows has been read
/// memory   for the window [bytes]. It takes what the widest strip of the target needs, and 256 MB where that is more
/// errors   interrupted; too_large (the window does not fit); non_finite (the first bad texel is named); what `source`
///          or `take` returns
/// cost     decoding and converting one after the other, each on all cores
Result<void> convertRows(RowReader& source, std::size_t memory, Projection to, int size, const Resampling& resampling,
                         const TakeTexels& take, const ProgressFunction& progress = {});

}  // namespace mirrorball
