#include "mirrorball/output/baked/babylon_environment.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "formula/constants.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/environment/environment_testing.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;

constexpr int kEnvSide = 32;

BakedMaps mapsFor(RadianceFunction light) {
  return *bake(
      Environment(std::move(light), 64),
      {.size = kEnvSide, .levels = maxLevels(kEnvSide), .mip_mapping = MipMapping::babylon, .irradiance_size = 8});
}

/// A .env file taken apart, as GetEnvInfo of environmentTextureTools.ts does it.
struct EnvFile {
  nlohmann::json info;
  Bytes pictures;

  explicit EnvFile(const Bytes& bytes) {
    const auto end = std::find(bytes.begin() + 8, bytes.end(), 0);
    info = nlohmann::json::parse(bytes.begin() + 8, end);
    pictures.assign(end + 1, bytes.end());
  }

  Image8 picture(const nlohmann::json& place) const {
    return *decodeTexture(std::span(pictures).subspan(place["position"], place["length"]));
  }
};

float redIn(const Image8& codes, int x, int y) {
  const std::uint8_t* texel = codes.texel(x, y);
  return std::pow(static_cast<float>(texel[0]) / 255.0f, 2.2f) * 255.0f / static_cast<float>(texel[3]);
}

TEST(BabylonEnvironment, HasAllLevelsAndTheIrradiance) {
  const Result<PackedLight> packed = babylonEnvironment(mapsFor(testing::smoothRadiance));
  ASSERT_TRUE(packed) << packed.error().message;
  EXPECT_EQ(packed->lost.share(), 0.0);
  EXPECT_THAT(Bytes(packed->bytes.begin(), packed->bytes.begin() + 8),
              ElementsAre(0x86, 0x16, 0x87, 0x96, 0xf6, 0xd6, 0x96, 0x36));
  const EnvFile file(packed->bytes);
  EXPECT_EQ(file.info["version"], 2);
  EXPECT_EQ(file.info["width"], kEnvSide);
  EXPECT_EQ(file.info["specular"]["lodGenerationScale"], 0.8);
  const nlohmann::json& mipmaps = file.info["specular"]["mipmaps"];
  ASSERT_EQ(mipmaps.size(), 6u * 6u) << "the reader refuses any other number";
  for (std::size_t i = 0; i < mipmaps.size(); ++i) EXPECT_EQ(file.picture(mipmaps[i]).width(), kEnvSide >> (i / 6));
  EXPECT_EQ(file.info["irradiance"]["irradianceTexture"]["size"], 8);
  ASSERT_EQ(file.info["irradiance"]["irradianceTexture"]["faces"].size(), 6u);
  EXPECT_EQ(file.picture(file.info["irradiance"]["irradianceTexture"]["faces"][5]).width(), 8);
}

// The reader uploads images upside down and looks OpenGL's faces up in axes whose x is our −x.
TEST(BabylonEnvironment, FacesLieAsItsReaderTurnsThem) {
  const EnvFile file(babylonEnvironment(mapsFor(testing::smoothRadiance))->bytes);
  const float edge = 1.0f - 1.0f / kEnvSide;
  const auto expectRed = [&](int face, int x, int y, glm::vec3 babylon) {
    const glm::vec3 ours = glm::normalize(glm::vec3(-babylon.x, babylon.y, babylon.z));
    EXPECT_NEAR(redIn(file.picture(file.info["specular"]["mipmaps"][face]), x, y), testing::smoothRadiance(ours).x,
                0.02f)
        << "face " << face;
  };
  expectRed(0, 0, 0, {1.0f, -edge, edge});
  expectRed(1, 0, 0, {-1.0f, -edge, -edge});
  expectRed(2, 0, 0, {-edge, 1.0f, edge});
  expectRed(3, kEnvSide - 1, 0, {edge, -1.0f, -edge});
  expectRed(4, 0, kEnvSide - 1, {-edge, edge, 1.0f});
  expectRed(5, 0, 0, {edge, -edge, -1.0f});
}

// Its materials make harmonics of the polynomial (FromPolynomial), and these are irradiance / π.
TEST(BabylonEnvironment, ThePolynomialBecomesTheIrradiance) {
  const BakedMaps maps = mapsFor(testing::smoothRadiance);
  const std::array<glm::vec3, 9> p = babylonPolynomial(maps.radiance);
  const float pi = formula::kPi;
  for (const glm::vec3 d : testing::manyDirections(50)) {
    const glm::vec3 n(-d.x, d.y, d.z);
    const glm::vec3 l00 = pi * 0.376127f * (p[3] + p[4] + p[5]);
    const glm::vec3 l20 = pi * (1.34567f * p[5] - 0.672834f * (p[3] + p[4]));
    const glm::vec3 l22 = pi * 1.16538f * (p[3] - p[4]);
    const glm::vec3 seen = 0.282095f * l00 + pi * 0.977204f * 0.488603f * (p[0] * n.x + p[1] * n.y + p[2] * n.z) +
                           pi * 1.16538f * 1.092548f * (p[6] * n.y * n.z + p[7] * n.z * n.x + p[8] * n.x * n.y) +
                           0.315392f * (3.0f * n.z * n.z - 1.0f) * l20 + 0.546274f * (n.x * n.x - n.y * n.y) * l22;
    EXPECT_LT(glm::length(seen - maps.irradiance.radiance(d)), 0.01f);
  }
}

TEST(BabylonEnvironment, ASunIsLoweredAndItsShareTold) {
  const glm::vec3 towards = glm::normalize(glm::vec3(1.0f, 2.0f, 3.0f));
  const BakedMaps maps =
      mapsFor([towards](glm::vec3 d) { return glm::vec3(glm::dot(d, towards) > 0.99f ? 1e5f : 1.0f); });
  const Result<PackedLight> packed = babylonEnvironment(maps);
  ASSERT_TRUE(packed);
  EXPECT_EQ(packed->brightest, 255.0f);
  EXPECT_GT(packed->lost.share(), 0.95);
}

}  // namespace
}  // namespace mirrorball
