/// The shaders that docs/prefiltering.md shows to engines: they are taken from the page as it is.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "formula/bsdf.h"
#include "mirrorball/bake/brdf/brdf_table.h"
#include "mirrorball/bake/lobe_row/lobe_row_table.h"
#include "mirrorball/base/file.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/gl/texture.h"
#include "mirrorball/image/filter.h"
#include "parity/evaluation.h"

namespace mirrorball::parity {
namespace {

constexpr float kLastLevel = 6.0f;

/// What the two cubes hold in place of light: their brightness times the direction, which is smooth, and beside it the
/// level. An engine's own cubes would show how a driver filters, too.
constexpr std::string_view kCubes =
    "struct Cube { float brightness; };\n"
    "vec4 read(Cube cube, vec3 d, float level) {\n"
    "  return vec4(cube.brightness * (d.xz * 0.5 + 0.5), cube.brightness * level, 1.0);\n"
    "}\n"
    "const Cube specular = Cube(2.0);\n"
    "const Cube irradiance = Cube(0.5);\n";

glm::vec3 readCube(float brightness, glm::vec3 d, float level) {
  return brightness * glm::vec3(d.x * 0.5f + 0.5f, d.z * 0.5f + 0.5f, level);
}

/// The shaders of the page, in their order.
std::vector<std::string> shadersOfPage() {
  constexpr std::string_view kBegin = "```glsl\n";
  const auto bytes = readFile(std::filesystem::path(MIRRORBALL_SOURCE_DIR) / "docs/prefiltering.md");
  if (!bytes) return {};
  const std::string page(bytes->begin(), bytes->end());
  std::vector<std::string> shaders;
  for (std::size_t begin = page.find(kBegin); begin != std::string::npos; begin = page.find(kBegin, begin)) {
    begin += kBegin.size();
    shaders.push_back(page.substr(begin, page.find("```", begin) - begin));
  }
  return shaders;
}

/// Replaces a text that must be there.
void replace(std::string& text, std::string_view from, std::string_view to) {
  const std::size_t begin = text.find(from);
  ASSERT_NE(begin, std::string::npos) << from;
  text.replace(begin, from.size(), to);
}

/// A shader of the page that reads kCubes.
std::string withCubes(std::string shader) {
  replace(shader, "uniform samplerCube specular;", "");
  replace(shader, "uniform samplerCube irradiance;", "");
  replace(shader, "textureLod(specular, ", "read(specular, ");
  replace(shader, "texture(irradiance, normal)", "read(irradiance, normal, 0.0)");
  return std::string(kCubes) + shader;
}

/// As a texture is read, clamped to its edges.
glm::vec4 texelBetween(const Image& image, glm::vec2 place) {
  const auto clamped = [&](int x, int y) {
    return rgbaAt(image, std::clamp(x, 0, image.width() - 1), std::clamp(y, 0, image.height() - 1));
  };
  const glm::vec4 rgb = bilinear(place, [&](int x, int y) { return glm::vec4(glm::vec3(clamped(x, y)), 1.0f); });
  const glm::vec4 alpha = bilinear(place, [&](int x, int y) { return glm::vec4(glm::vec3(clamped(x, y).w), 1.0f); });
  return {glm::vec3(rgb), alpha.x};
}

/// A surface and its eye, and what it is made of.
struct Scene {
  glm::vec3 to_eye, normal, albedo, f0;
  float roughness;
};

/// The engine's tables. Half floats, as GLSL ES filters no more, hold them to 5e-4 of each number.
struct Tables {
  Image brdf = *brdfTable({.size = 128, .channels = 3});
  Image rows;
};

/// Light by one look-up: the first shader of the page.
glm::vec3 lightOfOne(const Scene& scene) {
  const float level = kLastLevel * scene.roughness * (2.0f - scene.roughness);
  return readCube(2.0f, glm::reflect(-scene.to_eye, scene.normal), level);
}

/// Light by a row of lobes, as the renderer finds it (shaders/surface/row_of_lobes.glsl).
glm::vec3 lightOfRow(const Scene& scene, const Image& rows, glm::vec3 grazing) {
  const glm::vec3 r = glm::reflect(-scene.to_eye, scene.normal);
  const float cosine = std::clamp(glm::dot(scene.normal, r), 0.0f, 1.0f);
  glm::vec3 light(0.0f);
  glm::vec3 weights(0.0f);
  for (int i = 0; i < rows.width() / rows.height(); ++i) {
    const glm::vec4 texel = texelBetween(rows, formula::placeInLobeRows(i, scene.roughness, cosine));
    const formula::RoundLobe lobe = formula::lobeOfRow(texel, scene.roughness, scene.normal, r);
    const glm::vec3 weight = glm::mix(glm::vec3(lobe.weight), glm::vec3(lobe.grazing_weight), grazing);
    const float level = kLastLevel * lobe.perceptual_roughness * (2.0f - lobe.perceptual_roughness);
    light += weight * readCube(2.0f, lobe.direction, level);
    weights += weight;
  }
  return light / weights;
}

/// What environmentLight of the page should return.
glm::vec3 expectedLight(const Scene& scene, const Tables& tables) {
  const float size = static_cast<float>(tables.brdf.width());
  const float cosine = std::max(glm::dot(scene.normal, scene.to_eye), 0.0f);
  const glm::vec4 share = texelBetween(tables.brdf, size * glm::vec2(cosine, scene.roughness));
  const glm::vec3 reflected = scene.f0 * share.x + share.y;
  // Facets that send away `mean` of what a white one does, in place of f0.
  const glm::vec3 mean = reflected / (share.x + share.y);
  const glm::vec3 grazing = glm::vec3(1.0f) - scene.f0 / mean;
  const glm::vec3 light = tables.rows.empty() ? lightOfOne(scene) : lightOfRow(scene, tables.rows, grazing);
  return light * reflected + readCube(0.5f, scene.normal, 0.0f) * scene.albedo * (1.0f - reflected);
}

/// The eye in front of the surface, at any angle; surfaces of all roughnesses that are not mirrors.
std::vector<Input> scenes() {
  std::vector<Input> inputs = inputsOf(Domain::direction);
  for (Input& input : inputs) {
    const glm::vec3 normal(input.q);
    glm::vec3 to_eye(input.p);
    if (glm::dot(to_eye, normal) < 0.0f) to_eye = -to_eye;
    input.p = glm::vec4(to_eye, input.r.w);
    input.q.w = 0.1f + 0.9f * input.r.x;
  }
  return inputs;
}

Scene meshScene(const Input& input) {
  return {.to_eye = glm::vec3(input.p),
          .normal = glm::vec3(input.q),
          .albedo = glm::vec3(input.r.y),
          .f0 = 0.02f + 0.98f * glm::vec3(input.r.z, input.p.w, 0.02f),
          .roughness = input.q.w};
}
constexpr const char* kSceneCall =
    "vec4(environmentLight(p.xyz, q.xyz, vec3(r.y), 0.02 + 0.98 * vec3(r.z, p.w, 0.02), q.w), 1.0)";

/// A table as an engine keeps it, in a texture unit.
Result<gl::Texture> bound(const Image& table, int unit) {
  MIRRORBALL_TRY(texture, gl::Texture::fromImages(gl::Format::rgba16f, ImageSet(table)));
  texture.setSampling({.filter = gl::Sampling::Filter::linear});
  texture.bind(unit);
  return texture;
}

class EngineShader : public gl::GlTest {
 protected:
  /// The page's shader beside expectedLight.
  void expectLight(std::string shader, const Tables& tables, float tolerance) {
    const bool has_rows = !tables.rows.empty();
    const auto brdf = bound(tables.brdf, 1);
    const auto rows = bound(has_rows ? tables.rows : tables.brdf, 2);
    ASSERT_TRUE(brdf && rows);
    const auto set = [&](gl::Program& program) {
      program.set("brdf", 1);
      if (has_rows) program.set("lobe_rows", 2);
      program.set("last_level", kLastLevel);
    };
    const std::vector<Input> inputs = scenes();
    const auto found = evaluate(GetParam(), withCubes(std::move(shader)), kSceneCall, "engine", inputs, set);
    ASSERT_TRUE(found) << found.error().message;
    float worst = 0.0f;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const Scene scene = meshScene(inputs[i]);
      const glm::vec3 off = glm::vec3(rgbaAt(*found, static_cast<int>(i), 0)) - expectedLight(scene, tables);
      ASSERT_TRUE(std::isfinite(off.x + off.y + off.z)) << i;
      worst = std::max({worst, std::abs(off.x), std::abs(off.y), std::abs(off.z)});
    }
    RecordProperty("worst", std::to_string(worst));
    EXPECT_LE(worst, tolerance);
  }
};
MIRRORBALL_WITH_BOTH_APIS(EngineShader);

/// Drivers may weigh the texels of a table by fractions of 8 bits; the light is up to 12.
constexpr float kFiltered = 0.01f;

TEST_P(EngineShader, LooksUpOnce) { expectLight(shadersOfPage().at(0), {}, kFiltered); }

TEST_P(EngineShader, LooksUpARowAsTheRendererDoes) {
  for (const int lobes : {2, 4, 6}) {
    SCOPED_TRACE(std::to_string(lobes) + " lobes");
    expectLight(shadersOfPage().at(1), {.rows = *lobeRowTable(lobes)}, kFiltered);
  }
}

// As it stands there, without any of our names.
TEST(EngineShaderPage, IsGlslEs) {
  if (!hasGlslang()) GTEST_SKIP() << kNoGlslang;
  const std::vector<std::string> shaders = shadersOfPage();
  ASSERT_EQ(shaders.size(), 2u);
  for (const std::string& shader : shaders)
    expectGlslangTakes(
        {{"engine.frag",
          "#version 300 es\nprecision highp float;\n" + shader +
              "in vec3 to_eye;\nin vec3 normal;\nout vec4 result;\nvoid main() {\n"
              "  result = vec4(environmentLight(to_eye, normal, vec3(0.5), vec3(0.04), 0.3), 1.0);\n}\n"}},
        gl::Api::es30);
}

}  // namespace
}  // namespace mirrorball::parity
