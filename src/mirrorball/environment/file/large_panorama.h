#pragma once

#include "mirrorball/environment/file/load.h"

namespace mirrorball {

/// Whether a panorama takes so much memory as a whole, 512 MB or half of memoryLimit(), that it is worth to be read by
/// rows: decoding and converting then follow each other.
bool isLarge(const PanoramaRows& panorama);

}  // namespace mirrorball
