#include "mirrorball/render/surface/map_sources.h"

#include <cstddef>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using ::testing::ElementsAre;

/// Linear, and of that size.
Texture textureOf(int width, int height) {
  Texture texture;
  texture.image = Image8(width, height, 4);
  return texture;
}

/// A material whose first maps have those textures.
Material materialOf(const std::vector<int>& textures) {
  Material material;
  for (std::size_t row = 0; row < textures.size(); ++row) (material.*materialMaps()[row].slot).texture = textures[row];
  return material;
}

/// Each source as "unit" or "unit.layer", of as many rows as are asked for.
std::vector<std::string> places(const std::vector<MapSource>& sources, std::size_t rows) {
  EXPECT_EQ(sources.size(), materialMaps().size());
  std::vector<std::string> texts;
  for (std::size_t row = 0; row < rows; ++row)
    texts.push_back(std::to_string(sources[row].unit) +
                    (sources[row].layer < 0 ? "" : "." + std::to_string(sources[row].layer)));
  return texts;
}

TEST(MapSources, EveryTextureHasAUnitWhileThereAreEnough) {
  const std::vector<Texture> textures(5, textureOf(2, 2));
  EXPECT_THAT(places(mapSources(materialOf({}), textures, 3), 6), ElementsAre("-1", "-1", "-1", "-1", "-1", "-1"));
  EXPECT_THAT(places(mapSources(materialOf({4, -1, 2, 0}), textures, 3), 6),
              ElementsAre("0", "-1", "1", "2", "-1", "-1"));
}

TEST(MapSources, RowsWithOneTextureShareItsUnit) {
  const std::vector<Texture> textures(5, textureOf(2, 2));
  const auto sources = mapSources(materialOf({1, 3, 3, 0, 3, 1}), textures, 3);
  EXPECT_THAT(places(sources, 6), ElementsAre("0", "1", "1", "2", "1", "0"));
  EXPECT_EQ(samplerName(sources, 0), "base_color_map");
  EXPECT_EQ(samplerName(sources, 2), "metallic_map");
  EXPECT_EQ(samplerName(sources, 3), "normal_map");
  EXPECT_EQ(samplerName(sources, 5), "base_color_map");
}

TEST(MapSources, TheSmallestTexturesAreLayersWhereUnitsRunOut) {
  const std::vector<Texture> textures{textureOf(1, 1), textureOf(8, 2), textureOf(4, 5), textureOf(3, 3),
                                      textureOf(9, 1)};
  const auto sources = mapSources(materialOf({0, 1, 2, 3, 4, 0}), textures, 3);
  EXPECT_THAT(places(sources, 6), ElementsAre("2.2", "1", "0", "2.0", "2.1", "2.2"));
  EXPECT_EQ(samplerName(sources, 0), "map_layers");
  EXPECT_EQ(samplerName(sources, 1), "metallic_map");
  EXPECT_THAT(places(mapSources(materialOf({0, 1, 2}), textures, 1), 3), ElementsAre("0.2", "0.1", "0.0"));
}

// So that what a hardware sampler knows does not make another program of it.
TEST(MapSources, OnlyALayerSaysHowItIsRead) {
  Texture texture = textureOf(1, 1);
  texture.srgb = texture.nearest = true;
  texture.wrap_s = Wrap::clamp_to_edge;
  texture.wrap_t = Wrap::mirrored_repeat;
  const std::vector<Texture> textures{texture, textureOf(2, 2)};
  EXPECT_EQ(mapSources(materialOf({0, 1}), textures, 2)[0], MapSource{.unit = 0});
  EXPECT_EQ(mapSources(materialOf({0, 1}), textures, 1)[0],
            (MapSource{0, 1, true, true, Wrap::clamp_to_edge, Wrap::mirrored_repeat}));
}

}  // namespace
}  // namespace mirrorball
