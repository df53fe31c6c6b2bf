#pragma once

#include <string_view>

#include "mirrorball/base/result.h"
#include "mirrorball/codec/color/display.h"
#include "mirrorball/gl/program.h"

namespace mirrorball {

/// A program that covers a picture and knows one tone map alone: a software driver runs all curves that a program has
/// for each pixel, and they are most of what it compiles.
///
/// fragment   of shaders/, one that reads TONE_MAP
/// errors     unsupported (the driver does not compile a shader)
Result<gl::Program> loadDisplayProgram(gl::Api api, std::string_view fragment, ToneMap tone_map);

}  // namespace mirrorball
