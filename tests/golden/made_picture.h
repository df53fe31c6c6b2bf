#pragma once

#include <string>

#include "mirrorball/base/file.h"
#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"

namespace mirrorball::golden {

/// Runs the real program, `mirrorball COMMAND -o picture.png`, in a fresh folder where pictures/ has the golden ones.
///
/// command  words with single spaces between them
/// returns  the picture's file as it was written
/// errors   io: the program failed (with what it complained about); not_found: it wrote nothing
Result<Bytes> pictureMadeBy(const std::string& command);

/// The same, decoded.
Result<Image> imageMadeBy(const std::string& command);

/// How near a picture is to the truth, as `mirrorball compare` says it.
double psnrOf_db(const Image& drawn, const Image& traced);

}  // namespace mirrorball::golden
