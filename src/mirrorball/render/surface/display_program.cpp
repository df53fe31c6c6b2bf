#include "mirrorball/render/surface/display_program.h"

#include <array>
#include <string>

namespace mirrorball {

Result<gl::Program> loadDisplayProgram(gl::Api api, std::string_view fragment, ToneMap tone_map) {
  const std::string curve = "TONE_MAP " + std::to_string(static_cast<int>(tone_map));
  return gl::Program::load(api, "screen.vert", fragment, std::array<std::string_view, 1>{curve});
}

}  // namespace mirrorball
