#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "golden/cases.h"
#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"

namespace mirrorball::golden {

// The path-traced picture of a case takes ten times as long as the drawn one, and is the same until its command or what
// the path tracer computes with changes. So it is traced once, and kept in tests/golden/truths with the hash of both.

/// Whether MIRRORBALL_UPDATE_TRUTHS=1 asks for truths that are traced anew.
bool isUpdatingTruths();

/// The command that does so.
inline constexpr std::string_view kUpdateTruths = "MIRRORBALL_UPDATE_TRUTHS=1 ./test --module golden";

/// tests/golden/truths/NAME.png
std::filesystem::path truthPath(const std::string& name);

/// Of what the traced picture of a case depends on: the command that traces it; the pictures and heights that it names;
/// the sources of formulas, light, images, scenes, rays and the path tracer, without the lines that are comments and
/// without indentation. What else it passes through (decoders, libraries, the compiler) is not among them:
/// GoldenTracing, of the tier long, compares the pictures themselves. In ContentHash's digits.
///
/// cost     of the first call: reading 3 MB
std::string truthHash(const Case& golden_case);

/// The hash that was kept with the truth of a case; empty: none was.
std::string keptHash(const std::string& name);

/// Traces the truth of a case and keeps it.
///
/// errors   io, and whatever makes the program fail
/// cost     about a second
Result<void> keepTruth(const Case& golden_case);

/// The truth of a case as it is kept.
///
/// errors   not_found; whatever decodeImage says
Result<Image> keptTruth(const std::string& name);

}  // namespace mirrorball::golden
