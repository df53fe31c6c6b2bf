#pragma once

#include <span>
#include <string>
#include <string_view>

#include "mirrorball/base/result.h"
#include "mirrorball/light_edit/map_lamp.h"

namespace mirrorball {

/// A program for which lamps can be written as a piece of its own code, with its axes and units, and where those are
/// told.
struct LampSnippet {
  std::string_view name;     ///< "three"
  std::string_view program;  ///< "three.js"
  std::string_view ending;   ///< of a file's name: ".three.js"
  std::string (*write)(std::span<const MapLamp> lamps);
};

/// three, babylon, godot, blender
std::span<const LampSnippet> lampSnippets();

/// Of a program by its name; null: none is known.
const LampSnippet* lampSnippetFor(std::string_view name);

}  // namespace mirrorball
