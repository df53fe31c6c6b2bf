#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mirrorball/base/result.h"

namespace mirrorball::testing {

/// A frame whose programs are counted: a picture that `mirrorball render` draws.
struct ProgramFrame {
  std::string_view name;
  std::string_view model;             ///< a built-in; "showcase" stands as `render` without arguments shows it
  std::string_view material = {};     ///< of all its surfaces; empty: each keeps its own
  std::vector<std::string> set = {};  ///< parameters of that: "normal_map=…"
  std::vector<std::pair<std::string_view, std::string_view>> options = {};  ///< "refraction", "traced"
};

/// The showcase; a sphere of rough metal, of traced glass, of brushed metal, with a clear coat, with a normal map and
/// with a probe; a mirror that reflects itself.
std::span<const ProgramFrame> programFrames();

/// The shader that draws a surface.
struct SurfaceProgram {
  std::string name;      ///< the frame's, and where it has several programs, those of its materials
  std::string fragment;  ///< its text for desktop OpenGL
};

/// The programs of a frame's surfaces and of the faces of its probes, none twice. No driver compiles them but the
/// latter.
///
/// errors   no_gl; as loadRenderInputs' and those of views
Result<std::vector<SurfaceProgram>> findPrograms(const ProgramFrame& frame);

}  // namespace mirrorball::testing
