#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mirrorball::parity {

/// A file of formula/ as its shaders see it.
struct FormulaFile {
  std::string name;                    ///< "optics.glsl"
  std::vector<std::string> needs;      ///< the files that its comment "Needs: constants, color." names
  std::vector<std::string> functions;  ///< every `FN type name(`, in order
};

/// All of them, by name.
std::vector<FormulaFile> allFormulaFiles();

/// The #include lines of a formula file and, before it, all that it needs, directly or not.
std::string includesOf(const std::vector<FormulaFile>& files, std::string_view name);

/// A text of formula/ or of this folder, for gl::shaderSource.
std::optional<std::string_view> findParityText(std::string_view name);

}  // namespace mirrorball::parity
