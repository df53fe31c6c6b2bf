#pragma once

#include <string>

#include "mirrorball/scene/gltf/gltf_document.h"
#include "mirrorball/scene/gltf/gltf_file.h"
#include "mirrorball/scene/gltf/gltf_remarks.h"

namespace mirrorball::gltf {

/// Marks integers as normalized where they are colours of vertices. glTF 2.0 has no others there (section 3.7.2.1), and
/// some programs write the codes alone (glTF-Blender-IO issue 1911, gltf-pipeline issue 368).
///
/// remarks  name the accessors
void normalizeColors(Document& document, Remarks& remarks);

/// How colours of vertices are read that are not in [0, 1], where glTF has all of them (section 3.7.2.1).
enum class ColorOddity {
  none,
  codes,  ///< whole numbers up to 255: in parts of 255
  cut     ///< to [0, 1]
};

/// Brings colours of three or four components into [0, 1]. Alpha counts as codes by itself, and only beside such
/// colours. NaN and infinity stay.
ColorOddity bringIntoRange(Numbers& colors);

/// "holds numbers up to 255 and is read in parts of 255": what to tell of it, which is odd; for Remarks::tellOnce.
std::string remarkOn(ColorOddity oddity);

}  // namespace mirrorball::gltf
