// Every pair of answers to two questions of the surface's shader is drawn, as users would ask for it: by a covering
// array of whole variants, each of which holds many pairs (Kuhn, Wallace & Gallo 2004, "Software fault interactions").

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/render/frame/surface_choices_testing.h"

namespace mirrorball {
namespace {

using testing::AnswerPair;
using testing::ChosenSurface;
using testing::surfaceChoices;

int choiceCount() { return static_cast<int>(surfaceChoices().size()); }

/// One or two choices, which may be the same.
ChosenSurface two(int a, int b) {
  ChosenSurface chosen = testing::nothingChosen();
  testing::choose(chosen, a);
  testing::choose(chosen, b);
  return chosen;
}

bool isWhite(const ChosenSurface& chosen) {
  return std::all_of(chosen.begin(), chosen.end(),
                     [](int choice) { return choice < 0 || surfaceChoices()[std::size_t(choice)].is_white; });
}

/// Which two choices bring about a pair of answers, for each pair that some two do; of those that some white ones do,
/// these.
using PairsAskedFor = std::map<AnswerPair, ChosenSurface>;
PairsAskedFor allPairs() {
  PairsAskedFor pairs;
  for (const bool white : {true, false})
    for (int a = 0; a < choiceCount(); ++a)
      for (int b = 0; b <= a; ++b)
        if (const ChosenSurface chosen = two(a, b); isWhite(chosen) == white)
          for (const AnswerPair& pair : testing::pairsOf(chosen)) pairs.emplace(pair, chosen);
  return pairs;
}

std::size_t countOf(const std::set<AnswerPair>& pairs, const PairsAskedFor& missing) {
  return std::size_t(
      std::count_if(pairs.begin(), pairs.end(), [&](const auto& pair) { return missing.contains(pair); }));
}

/// Begins with two choices that bring a missing pair about, and takes of each other question the choice that adds most
/// pairs; white ones to white ones.
ChosenSurface variantWith(const AnswerPair& first, const PairsAskedFor& missing) {
  const ChosenSurface begun = missing.at(first);
  ChosenSurface best = begun;
  std::size_t most = countOf(testing::pairsOf(best), missing);
  for (int choice = 0; choice < choiceCount(); ++choice) {
    if (begun[std::size_t(surfaceChoices()[std::size_t(choice)].part)] >= 0) continue;
    ChosenSurface other = best;
    testing::choose(other, choice);
    if (isWhite(begun) && !isWhite(other)) continue;
    const std::set<AnswerPair> pairs = testing::pairsOf(other);
    const std::size_t count = countOf(pairs, missing);
    if (count <= most || !pairs.contains(first)) continue;
    best = other;
    most = count;
  }
  return best;
}

/// Far fewer variants than there are pairs, that hold them all.
std::vector<ChosenSurface> coveringArray() {
  PairsAskedFor missing = allPairs();
  std::vector<ChosenSurface> array;
  for (const bool white : {true, false})
    while (true) {
      const auto next =
          std::find_if(missing.begin(), missing.end(), [&](const auto& pair) { return isWhite(pair.second) == white; });
      if (next == missing.end()) break;
      array.push_back(variantWith(next->first, missing));
      for (const AnswerPair& pair : testing::pairsOf(array.back())) missing.erase(pair);
    }
  return array;
}

/// What is in the middle of a picture, where the ball is: the least, mean and greatest of its light.
struct Middle {
  float least = INFINITY, mean = 0.0f, greatest = 0.0f;
  bool is_finite = true;

  bool isBlack() const { return mean < 0.02f; }
  bool isWhite() const { return std::abs(least - 1.0f) < 0.01f && std::abs(greatest - 1.0f) < 0.01f; }
};

Middle middleOf(const Image& image) {
  Middle middle;
  for (int y = 5; y < 11; ++y)
    for (int x = 5; x < 11; ++x)
      for (int channel = 0; channel < 3; ++channel) {
        const float light = rgbaAt(image, x, y)[channel];
        middle.least = std::min(middle.least, light);
        middle.greatest = std::max(middle.greatest, light);
        middle.mean += light / 108.0f;
      }
  for (const float sample : image.samples()) middle.is_finite = middle.is_finite && std::isfinite(sample);
  return middle;
}

class AnswerPairs : public gl::GlTest {
 protected:
  void SetUp() override {
    // Mesa's software driver then leaves out LLVM's optimisations, which take longer than such small pictures.
    setenv("GALLIVM_PERF", "nopt", 0);
    GlTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    renderer_.emplace(testing::rendererFor(sceneOfCase(testing::caseOf(testing::nothingChosen())), uneven_));
    even_light_ = *testing::prepareOnce(even_);
    uneven_light_ = *testing::prepareOnce(uneven_);
    sunny_light_ = uneven_light_;
    sunny_light_.sun = SunKind::split;
    sunny_light_.suns = {{.towards = glm::normalize(glm::vec3(0.5f, 0.4f, 0.8f)), .irradiance = glm::vec3(1.0f)}};
  }

  /// In the same light from everywhere, or in light that is nowhere dark.
  Middle draw(const ChosenSurface& chosen, bool is_even) {
    const testing::SurfaceCase asked = testing::caseOf(chosen);
    Scene scene = testing::sceneOfCase(asked);
    EXPECT_TRUE(prepareRelief(scene, asked.settings.relief)) << testing::choicesWritten(chosen);
    EXPECT_TRUE(renderer_->setScene(std::move(scene))) << testing::choicesWritten(chosen);
    const PreparedEnvironment& uneven = testing::hasSuns(asked.settings) ? sunny_light_ : uneven_light_;
    EXPECT_TRUE(renderer_->setEnvironment(is_even ? even_ : uneven_, is_even ? even_light_ : uneven));
    return middleOf(testing::drawn(*renderer_, asked.settings));
  }

  /// What is wrong with a variant; empty: nothing.
  std::string faultOf(const ChosenSurface& chosen) {
    const Middle lit = draw(chosen, false);
    if (!lit.is_finite) return "not finite";
    if (lit.isBlack()) return "black";
    if (!isWhite(chosen)) return "";
    const Middle white = draw(chosen, true);
    return white.isWhite() ? ""
                           : "in the furnace " + std::to_string(white.least) + " to " + std::to_string(white.greatest);
  }

  /// Two of its choices that are wrong without the others.
  std::string guiltyOf(const ChosenSurface& chosen) {
    for (const int a : chosen)
      for (const int b : chosen)
        if (a >= 0 && b > a && !faultOf(two(a, b)).empty()) return testing::choicesWritten(two(a, b));
    return "no two alone";
  }

  void expectRight(const ChosenSurface& chosen) {
    const std::string fault = faultOf(chosen);
    EXPECT_EQ(fault, "") << testing::choicesWritten(chosen) << "; by: " << guiltyOf(chosen);
  }

 private:
  const Environment even_ = Environment([](glm::vec3) { return glm::vec3(1.0f); }, 32);
  const Environment uneven_ = Environment([](glm::vec3 d) { return 0.6f + 0.3f * d; }, 32);
  PreparedEnvironment even_light_;
  PreparedEnvironment uneven_light_;
  PreparedEnvironment sunny_light_;  ///< that and a sun
  std::optional<Renderer> renderer_;
};
MIRRORBALL_WITH_BOTH_APIS(AnswerPairs);

/// Most of the time goes into the driver's compiler: of the array each API draws one half.
TEST_P(AnswerPairs, AreFiniteAndNotBlackAndWhiteInTheFurnace) {
  const std::vector<ChosenSurface> array = coveringArray();
  for (std::size_t i = GetParam() == gl::Api::es30 ? 1 : 0; i < array.size(); i += 2) expectRight(array[i]);
}

/// Only ./test --long runs these.
class AllAnswerPairs : public AnswerPairs {};
MIRRORBALL_WITH_BOTH_APIS(AllAnswerPairs);

TEST_P(AllAnswerPairs, AreFiniteAndNotBlackAndWhiteInTheFurnace) {
  for (const ChosenSurface& chosen : coveringArray()) expectRight(chosen);
}

}  // namespace
}  // namespace mirrorball
