#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/context.h"

namespace mirrorball::gl {

/// One shader as the compiler gets it, and the files that its #line numbers mean.
struct ShaderSource {
  std::string text;
  std::vector<std::string> files;  ///< files[k] is source string number k of `#line n k`
};

/// Finds the text of a file by its name ("optics.glsl").
using FindText = std::function<std::optional<std::string_view>(std::string_view name)>;

/// Joins an entry file of /shaders with the files that it includes into one shader.
///
/// The text starts with the version and precision that `api` asks for, the names that the formula files are written
/// with (FN, CUBE_SAMPLER, sampleLod), and the defines. Each line `#include "name"` gives way to that file, once
/// however often it is named; files of /shaders may include others, those of /formula include nothing.
///
/// entry    for example "surface.frag"
/// defines  each "NAME" or "NAME value"
/// find     where the texts come from: those that were embedded when the program was built, unless a test has its own
/// errors   not_found: the entry, or an included file (with the line that asks for it)
Result<ShaderSource> shaderSource(Api api, std::string_view entry, std::span<const std::string_view> defines = {},
                                  const FindText& find = {});

/// Puts file names for the numbers in a GLSL compiler's log: "0:12(5): error" becomes
/// "surface.frag:12: error".
std::string namedLog(std::string_view log, std::span<const std::string> files);

}  // namespace mirrorball::gl
