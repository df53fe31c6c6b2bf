#include "mirrorball/render/settings/idle_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::StartsWith;

const std::set<std::string_view> kAll{"light-intensity", "refraction",   "behind",     "inner-bounces", "dispersion",
                                      "wavelengths",     "relief-steps", "probe-size", "probe-bounces", "lobe-taps"};

TEST(IdleOptions, SayWhyTheyChangeNothing) {
  FrameSettings settings;
  settings.blur = BlurKind::mip;
  EXPECT_THAT(
      idleOptions(*loadModel("sphere"), settings, kAll),
      ElementsAre(
          StartsWith("{option:light-intensity} changes nothing: the model has no lights"),
          StartsWith("{option:refraction} changes nothing: "), StartsWith("{option:behind} changes nothing: "),
          StartsWith("{option:inner-bounces} changes nothing: "), StartsWith("{option:dispersion} changes nothing: "),
          StartsWith("{option:wavelengths} changes nothing: "), StartsWith("{option:lobe-taps} changes nothing: "),
          StartsWith("{option:relief-steps} changes nothing: "), StartsWith("{option:probe-size} changes nothing: "),
          StartsWith("{option:probe-bounces} changes nothing: ")));
}

TEST(IdleOptions, SayNothingWhereTheyAct) {
  FrameSettings settings;
  settings.refraction = RefractionKind::traced;
  settings.dispersion = DispersionKind::spectral;
  settings.relief = ReliefKind::cone;
  settings.probes = 2;
  Scene scene = *loadModel("brilliant");
  scene.materials[0] = *materialNamed("diamond");
  scene.lights.emplace_back();
  EXPECT_THAT(idleOptions(scene, settings, kAll), IsEmpty());
}

TEST(IdleOptions, NothingIsSaidOfWhatWasNotGivenNorWithoutAModel) {
  EXPECT_THAT(idleOptions(*loadModel("sphere"), {}, {}), IsEmpty());
  EXPECT_THAT(idleOptions(Scene(), {}, kAll), IsEmpty());
}

TEST(IdleOptions, AbsorptionThatIsNotDrawnIsSaid) {
  Scene scene = *loadModel("sphere");
  scene.materials[0].transmission = 1.0f;
  scene.materials[0].attenuation_distance = 0.5f;
  scene.materials[0].attenuation_color = glm::vec3(0.2f, 0.8f, 0.3f);
  EXPECT_THAT(idleOptions(scene, {}, {}), ElementsAre(StartsWith("{option:refraction} single knows of no way")));
  FrameSettings settings;
  settings.refraction = RefractionKind::image_space;
  EXPECT_THAT(idleOptions(scene, settings, {}), IsEmpty());
}

}  // namespace
}  // namespace mirrorball
