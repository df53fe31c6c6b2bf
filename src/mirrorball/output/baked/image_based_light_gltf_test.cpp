#include "mirrorball/output/baked/image_based_light_gltf.h"

#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "formula/constants.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/environment/environment_testing.h"

namespace mirrorball {
namespace {

BakedMaps mapsOfGltf() {
  return *bake(Environment(testing::smoothRadiance, 64),
               {.size = 16, .levels = 3, .mip_mapping = MipMapping::gltf, .irradiance_size = 16});
}

std::uint32_t numberAt(const Bytes& bytes, std::size_t place) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + place, sizeof(number));
  return number;
}

TEST(ImageBasedLightGltf, HasALightWithAllFacesOfAllLevels) {
  const Result<PackedLight> packed = imageBasedLightGltf(mapsOfGltf());
  ASSERT_TRUE(packed) << packed.error().message;
  const Bytes& file = packed->bytes;
  ASSERT_EQ(numberAt(file, 8), file.size());
  const std::size_t json_size = numberAt(file, 12);
  const nlohmann::json json = nlohmann::json::parse(file.begin() + 20, file.begin() + 20 + std::ptrdiff_t(json_size));
  const nlohmann::json& light = json["extensions"]["EXT_lights_image_based"]["lights"][0];
  EXPECT_EQ(json["scenes"][0]["extensions"]["EXT_lights_image_based"]["light"], 0);
  EXPECT_EQ(light["intensity"], 1.0) << "its reader multiplies by it even where it is missing";
  EXPECT_EQ(light["specularImageSize"], 16);
  ASSERT_EQ(light["specularImages"].size(), 3u);
  const std::span<const std::uint8_t> buffer = std::span(file).subspan(28 + json_size);
  EXPECT_EQ(numberAt(file, 20 + json_size), buffer.size());
  for (std::size_t level = 0; level < 3; ++level) {
    ASSERT_EQ(light["specularImages"][level].size(), 6u);
    for (const nlohmann::json& number : light["specularImages"][level]) {
      const nlohmann::json& image = json["images"][number.get<std::size_t>()];
      EXPECT_EQ(image["mimeType"], "image/png");
      const nlohmann::json& view = json["bufferViews"][image["bufferView"].get<std::size_t>()];
      const auto picture = decodeTexture(buffer.subspan(view["byteOffset"], view["byteLength"]));
      ASSERT_TRUE(picture);
      EXPECT_EQ(picture->width(), 16 >> level);
    }
  }
}

// Babylon.js, sphericalPolynomial.ts, SH3ylmBasisConstants: signs for y, x, yz and zx, in axes whose x is our −x.
TEST(ImageBasedLightGltf, TheCoefficientsAreTheIrradiance) {
  const BakedMaps maps = mapsOfGltf();
  const std::array<glm::vec3, 9> l = irradianceCoefficients(maps.radiance);
  for (const glm::vec3 d : testing::manyDirections(50)) {
    const glm::vec3 n(-d.x, d.y, d.z);
    const glm::vec3 seen = 0.282095f * l[0] + 0.488603f * (l[2] * n.z - l[1] * n.y - l[3] * n.x) +
                           1.092548f * (l[4] * n.x * n.y - l[5] * n.y * n.z - l[7] * n.z * n.x) +
                           0.315392f * (3.0f * n.z * n.z - 1.0f) * l[6] + 0.546274f * (n.x * n.x - n.y * n.y) * l[8];
    EXPECT_LT(glm::length(seen / formula::kPi - maps.irradiance.radiance(d)), 0.01f);
  }
}

}  // namespace
}  // namespace mirrorball
