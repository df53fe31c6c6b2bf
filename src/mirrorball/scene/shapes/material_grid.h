#pragma once

#include <span>
#include <string_view>

#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Spheres in rows and columns that show one material with two of its parameters in steps, as Khronos' test models for
/// glTF's extensions do: what a renderer does with a parameter is seen at a glance.
struct MaterialGrid {
  std::string_view name;
  std::string_view material;  ///< as materialNamed() knows it
  std::string_view set;       ///< assignments that hold for all spheres, as setParameter() takes them, after spaces
  std::string_view column;    ///< the parameter that changes from left to right
  std::string_view columns;   ///< its values, between spaces
  std::string_view row;       ///< and from top to bottom
  std::string_view rows;
};

/// The table of them.
std::span<const MaterialGrid> materialGrids();

/// The spheres of a grid, of radius 0.9 and 2 apart, facing a viewer at azimuth 30°.
Scene materialGridScene(const MaterialGrid& grid);

}  // namespace mirrorball
