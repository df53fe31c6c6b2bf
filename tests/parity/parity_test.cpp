#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/text.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/render/surface/background.h"
#include "mirrorball/render/surface/nearness_picture.h"
#include "mirrorball/render/surface/surface_shaders.h"
#include "parity/evaluation.h"
#include "parity/formula_files.h"
#include "parity/parity_case.h"

namespace mirrorball::parity {
namespace {

namespace fs = std::filesystem;

/// What a case's expression needs: the formulas, and maps that are the same on both sides.
std::string textBefore(const Case& formula, const std::string& includes) {
  std::string text =
      "#include \"smooth_cube.glsl\"\n"
      "#include \"smooth_map.glsl\"\n"
      "#include \"small_tree.glsl\"\n"
      "#undef CUBE_SAMPLER\n"
      "#define CUBE_SAMPLER SmoothCube\n"
      "#undef MAP_SAMPLER\n"
      "#define MAP_SAMPLER SmoothMap\n"
      "#undef WORD_SAMPLER\n"
      "#define WORD_SAMPLER SmallTree\n" +
      includes;
  if (formula.glsl.find("testSurface") != std::string_view::npos) text += "#include \"test_surface.glsl\"\n";
  if (formula.glsl.find("testGround") != std::string_view::npos) text += "#include \"test_ground.glsl\"\n";
  if (formula.glsl.find("testPrism") != std::string_view::npos) text += "#include \"test_prism.glsl\"\n";
  if (formula.glsl.find("testMedia") != std::string_view::npos) text += "#include \"test_media.glsl\"\n";
  return text;
}

/// The difference of two results in units of max(1, |expected|); infinite if one is no number.
float difference(glm::vec4 expected, glm::vec4 actual) {
  float largest = 0.0f;
  for (int i = 0; i < 4; ++i) {
    const float share = std::abs(expected[i] - actual[i]) / std::max(1.0f, std::abs(expected[i]));
    if (!std::isfinite(share)) return INFINITY;
    largest = std::max(largest, share);
  }
  return largest;
}

/// The values of a formula in a small box around an input.
struct Range {
  glm::vec4 least;
  glm::vec4 most;
};

/// Where a formula jumps (a ray along a surface comes from above or from below) or is steep (the height of a direction
/// next to the ground), every driver's rounding decides: what is right there is what C++ gives within some roundings of
/// the input.
Range rangeAround(const Case& formula, const Input& input) {
  constexpr float kFewRoundings = 5e-7f;
  Range range{.least = formula.cpp(input.p, input.q, input.r), .most = range.least};
  for (int i = 0; i < 12; ++i)
    for (const float shift : {-kFewRoundings, kFewRoundings}) {
      Input moved = input;
      glm::vec4& vector = i < 4 ? moved.p : i < 8 ? moved.q : moved.r;
      vector[i % 4] += shift;
      const glm::vec4 value = formula.cpp(moved.p, moved.q, moved.r);
      range.least = glm::min(range.least, value);
      range.most = glm::max(range.most, value);
    }
  return range;
}

std::string show(glm::vec4 v) {
  return "(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ", " +
         std::to_string(v.w) + ")";
}

void expectParity(gl::Api api, const Case& formula, const std::string& includes) {
  const std::vector<Input> inputs = inputsOf(formula.domain);
  const auto results =
      evaluate(api, textBefore(formula, includes), std::string(formula.glsl), std::string(formula.function), inputs);
  ASSERT_TRUE(results) << results.error().message;
  float worst = 0.0f;
  std::string where;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto& [p, q, r] = inputs[i];
    const glm::vec4 expected = formula.cpp(p, q, r);
    const glm::vec4 actual = rgbaAt(*results, static_cast<int>(i), 0);
    float off = difference(expected, actual);
    if (off > formula.tolerance) {
      const Range range = rangeAround(formula, inputs[i]);
      off = difference(glm::clamp(actual, range.least, range.most), actual);
    }
    if (off > worst) {
      worst = off;
      where = "p " + show(p) + " q " + show(q) + " r " + show(r) + ": C++ " + show(expected) + ", GLSL " + show(actual);
    }
  }
  ::testing::Test::RecordProperty(std::string(formula.function), formatNumber(worst));
  EXPECT_LE(worst, formula.tolerance) << formula.function << " at " << where;
}

/// All formulas of one file, with one Api.
class ParityTest : public ::testing::TestWithParam<std::tuple<gl::Api, std::string>> {};

TEST_P(ParityTest, SameNumbersAsInCpp) {
  const auto& [api, file_name] = GetParam();
  MIRRORBALL_NEEDS_GL(context, api);
  const std::vector<FormulaFile> files = allFormulaFiles();
  const FormulaFile& file = *std::ranges::find(files, file_name, &FormulaFile::name);
  for (const Case& formula : allCases()) {
    if (std::ranges::find(file.functions, formula.function) == file.functions.end()) continue;
    expectParity(api, formula, includesOf(files, file_name));
  }
}

std::vector<std::string> filesWithFunctions() {
  std::vector<std::string> names;
  for (const FormulaFile& file : allFormulaFiles()) {
    if (!file.functions.empty()) names.push_back(file.name);
  }
  return names;
}

/// "optics_es30"
std::string parityName(const ::testing::TestParamInfo<ParityTest::ParamType>& test) {
  const auto& [api, file] = test.param;
  return fs::path(file).stem().string() + '_' + gl::shortNameOf(api);
}

INSTANTIATE_TEST_SUITE_P(Desktop, ParityTest,
                         ::testing::Combine(::testing::Values(gl::Api::desktop43),
                                            ::testing::ValuesIn(filesWithFunctions())),
                         parityName);
INSTANTIATE_TEST_SUITE_P(Es, ParityTest,
                         ::testing::Combine(::testing::Values(gl::Api::es30),
                                            ::testing::ValuesIn(filesWithFunctions())),
                         parityName);

TEST(Parity, EveryFormulaHasACase) {
  std::size_t functions = 0;
  for (const FormulaFile& file : allFormulaFiles()) {
    functions += file.functions.size();
    for (const std::string& function : file.functions) {
      EXPECT_TRUE(std::ranges::any_of(allCases(), [&](const Case& formula) { return formula.function == function; }))
          << function << " of " << file.name << " needs a row in tests/parity/cases.cpp";
    }
  }
  EXPECT_EQ(functions, allCases().size()) << "a row of cases.cpp names no formula, or one twice";
}

class GlslangTest : public ::testing::TestWithParam<gl::Api> {
 protected:
  void SetUp() override {
    if (!hasGlslang()) GTEST_SKIP() << kNoGlslang;
  }
};

TEST_P(GlslangTest, TakesEveryFormulaFile) {
  const std::vector<FormulaFile> files = allFormulaFiles();
  std::vector<GlslFile> shaders;
  for (const FormulaFile& file : files) {
    const std::string entry = includesOf(files, file.name) + "void main() {}\n";
    const auto find = [&](std::string_view name) -> std::optional<std::string_view> {
      return name == "entry" ? entry : findParityText(name);
    };
    const auto source = gl::shaderSource(GetParam(), "entry", {}, find);
    ASSERT_TRUE(source) << source.error().message;
    shaders.push_back({"formula_" + file.name + ".frag", source->text});
  }
  expectGlslangTakes(shaders, GetParam());
}

TEST_P(GlslangTest, TakesEveryShader) {
  std::vector<GlslFile> shaders;
  for (const auto& entry : fs::directory_iterator(fs::path(MIRRORBALL_SOURCE_DIR) / "shaders")) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".vert" && extension != ".frag") continue;
    const std::string name = entry.path().filename().string();
    if (name == "background.frag" || name == "nearness_of_proxy.frag") continue;  // are put together from parts
    const auto source = gl::shaderSource(GetParam(), name, std::array<std::string_view, 1>{"TONE_MAP 0"});
    ASSERT_TRUE(source) << source.error().message;
    shaders.push_back({name, source->text});
  }
  expectGlslangTakes(shaders, GetParam());
}

TEST_P(GlslangTest, TakesTheBackgroundOnEveryProxy) {
  std::vector<GlslFile> shaders;
  for (const ProxyKind kind :
       {ProxyKind::none, ProxyKind::box, ProxyKind::sphere, ProxyKind::ground, ProxyKind::mesh}) {
    const std::string suffix = "_" + std::to_string(static_cast<int>(kind)) + ".frag";
    const auto source = backgroundShader(GetParam(), kind);
    ASSERT_TRUE(source) << source.error().message;
    shaders.push_back({"background" + suffix, source->text});
    const auto nearness = nearnessShader(GetParam(), kind);
    ASSERT_TRUE(nearness) << nearness.error().message;
    shaders.push_back({"nearness_of_proxy" + suffix, nearness->text});
  }
  expectGlslangTakes(shaders, GetParam());
}

/// Maps with a unit each, or the later half of them as layers with every way to read them.
std::vector<MapSource> allMaps(bool with_layers) {
  std::vector<MapSource> maps(materialMaps().size());
  const int units = static_cast<int>(with_layers ? maps.size() / 2 : maps.size());
  for (int row = 0; row < static_cast<int>(maps.size()); ++row) {
    MapSource& source = maps[static_cast<std::size_t>(row)];
    source.unit = std::min(row, units);
    if (row < units) continue;
    source.layer = row - units;
    source.srgb = row % 2 == 0;
    source.nearest = row % 3 == 0;
    source.wrap_s = static_cast<Wrap>(row % 3);
    source.wrap_t = static_cast<Wrap>((row + 1) % 3);
  }
  return maps;
}

/// Every way to address light and pictures, at each of its places.
std::vector<SurfaceVariant> variantsOfCoordinates() {
  std::vector<SurfaceVariant> variants;
  for (int generated = 0; generated <= static_cast<int>(Generated::place); ++generated)
    for (int from = 0; from <= static_cast<int>(PictureFrom::projector); ++from) {
      SurfaceVariant variant;
      variant.maps = allMaps(from % 2 == 0);
      variant.coordinates = {.look_up = static_cast<Generated>(generated),
                             .picture_from = static_cast<PictureFrom>(from),
                             .picture = static_cast<Generated>(generated)};
      variant.choose(Part::coordinates, static_cast<CoordinatesPart>((generated + from) % 3));
      variants.push_back(std::move(variant));
    }
  return variants;
}

/// Every pair of answers to two questions of the surface's shader, the others answered as usual; and each with all
/// maps, some of them layers.
std::vector<SurfaceVariant> pairsOfParts() {
  std::set<SurfaceVariant> variants;
  const auto questions = surfaceQuestions();
  for (std::size_t a = 0; a < kParts; ++a)
    for (std::size_t b = 0; b < a; ++b)
      for (std::uint8_t i = 0; i < questions[a].answers.size(); ++i)
        for (std::uint8_t j = 0; j < questions[b].answers.size(); ++j) {
          SurfaceVariant variant;
          variant.answers[a] = i;
          variant.answers[b] = j;
          if (variant.has(Part::lamps, LampsPart::listed)) variant.lamp_count = 3;
          if (!variant.has(Part::suns, SunsPart::none)) variant.sun_count = 2;
          const bool needs_maps = !variant.has(Part::detail, DetailPart::none);
          if (needs_maps || (i + j) % 2 != 0) variant.maps = allMaps((i + j) % 3 == 0);
          variants.insert(variant);
        }
  for (SurfaceVariant variant : variantsOfCoordinates()) variants.insert(variant);
  return {variants.begin(), variants.end()};
}

/// Every answer, the other questions answered as usual, and each seventh of the pairs: a prime, so that what changes in
/// steps of two, four or eight along them is met by all its values.
std::vector<SurfaceVariant> somePairsOfParts() {
  std::set<SurfaceVariant> variants;
  const auto questions = surfaceQuestions();
  for (std::size_t question = 0; question < kParts; ++question)
    for (std::uint8_t answer = 0; answer < questions[question].answers.size(); ++answer) {
      SurfaceVariant variant;
      variant.answers[question] = answer;
      if (variant.has(Part::lamps, LampsPart::listed)) variant.lamp_count = 3;
      if (!variant.has(Part::suns, SunsPart::none)) variant.sun_count = 2;
      if (!variant.has(Part::detail, DetailPart::none)) variant.maps = allMaps(answer % 2 == 0);
      variants.insert(variant);
    }
  const std::vector<SurfaceVariant> all = pairsOfParts();
  for (std::size_t i = 0; i < all.size(); i += 7) variants.insert(all[i]);
  return {variants.begin(), variants.end()};
}

void expectGlslangTakesSurfaces(const std::vector<SurfaceVariant>& variants, gl::Api api) {
  std::vector<GlslFile> shaders;
  for (const SurfaceVariant& variant : variants) {
    const auto of_variant = surfaceShaders(api, variant);
    ASSERT_TRUE(of_variant) << of_variant.error().message;
    if (variant == SurfaceVariant{}) shaders.push_back({"surface.vert", of_variant->vertex.text});
    shaders.push_back({"surface_" + std::to_string(shaders.size()) + ".frag", of_variant->fragment.text});
  }
  expectGlslangTakes(shaders, api);
}

TEST_P(GlslangTest, TakesEveryPartOfTheSurfaceAndSomePairs) {
  expectGlslangTakesSurfaces(somePairsOfParts(), GetParam());
}

MIRRORBALL_WITH_BOTH_APIS(GlslangTest);

// All pairs take minutes, and are left to ./test --long.
class GlslangPairsTest : public GlslangTest {};

TEST_P(GlslangPairsTest, TakesEveryPairOfPartsOfTheSurface) { expectGlslangTakesSurfaces(pairsOfParts(), GetParam()); }

MIRRORBALL_WITH_BOTH_APIS(GlslangPairsTest);

}  // namespace
}  // namespace mirrorball::parity
