#include "mirrorball/scene/shapes/material_grid.h"

#include <string>

#include <gtest/gtest.h>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball {
namespace {

/// What a material has of a parameter, as it would be written.
std::string valueOf(const Material& material, std::string_view name) {
  for (const MaterialParameter& parameter : materialParameters())
    if (parameter.text.name == name) return written(parameter, material);
  return "there is no such parameter";
}

TEST(MaterialGrid, EachSphereHasTheParametersOfItsPlace) {
  for (const MaterialGrid& grid : materialGrids()) {
    const auto scene = loadModel(std::string(grid.name));
    ASSERT_TRUE(scene) << grid.name;
    const auto columns = split(grid.columns, ' '), rows = split(grid.rows, ' ');
    ASSERT_EQ(scene->materials.size(), columns.size() * rows.size()) << grid.name;
    for (std::size_t i = 0; i < scene->materials.size(); ++i) {
      Material wanted;
      ASSERT_TRUE(setParameter(wanted, std::string(grid.column) + "=" + columns[i % columns.size()]));
      ASSERT_TRUE(setParameter(wanted, std::string(grid.row) + "=" + rows[i / columns.size()]));
      for (const std::string_view name : {grid.column, grid.row})
        EXPECT_EQ(valueOf(scene->materials[i], name), valueOf(wanted, name)) << grid.name << ", sphere " << i;
    }
  }
}

}  // namespace
}  // namespace mirrorball
