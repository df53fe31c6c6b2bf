#pragma once

#include <string>

#include "mirrorball/base/file.h"
#include "mirrorball/base/result.h"

namespace mirrorball::golden {

/// Runs the real program, `mirrorball COMMAND -o picture.png`, in a fresh folder where pictures/ has the golden ones.
///
/// command  words with single spaces between them
/// returns  the picture's file as it was written
/// errors   io: the program failed (with what it complained about); not_found: it wrote nothing
Result<Bytes> pictureMadeBy(const std::string& command);

}  // namespace mirrorball::golden
