#include "mirrorball/view/workspace/workspace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/scene/load_model.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

Workspace with(Workspace workspace, OptionTable table, std::string_view name, std::string_view text) {
  auto changed = withOption(std::move(workspace), table, name, text);
  EXPECT_TRUE(changed) << changed.error().message;
  return changed ? std::move(*changed) : Workspace();
}

TEST(Workspace, HoldsOptionsAsTheyAreWritten) {
  Workspace workspace = with({}, OptionTable::frame, "exposure", "2.5");
  workspace = with(workspace, OptionTable::frame, "camera", "40,5,3");
  const FrameSettings settings = *frameOf(workspace, 0);
  EXPECT_FLOAT_EQ(settings.display.exposure_ev, 2.5f);
  EXPECT_FLOAT_EQ(settings.camera.azimuth_deg, 40.0f);
  EXPECT_EQ(*frameOf(withoutOption(workspace, OptionTable::frame, "exposure"), 1),
            *frameOf(with({}, OptionTable::frame, "camera", "40,5,3"), 1));
}

TEST(Workspace, RefusesWhatAnOptionRefuses) {
  const auto wrong = withOption({}, OptionTable::frame, "samples", "many");
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().message, HasSubstr("samples"));
  EXPECT_FALSE(withOption({}, OptionTable::frame, "no-such", "1"));
  EXPECT_FALSE(withOption({}, OptionTable::material, "material", "unobtainium"));
  EXPECT_FALSE(withOption({}, OptionTable::parameter, "metallic", "1")) << "no material is selected";
  Workspace lamps;
  for (std::size_t i = 0; i < FrameSettings::kMaxLights; ++i)
    lamps = with(lamps, OptionTable::frame, "light", "1,2,3,4,5,6");
  EXPECT_FALSE(withOption(lamps, OptionTable::frame, "light", "1,2,3,4,5,6")) << "one too many";
}

TEST(Workspace, AHalfDoesOtherwiseWhatItSays) {
  Workspace workspace = with({}, OptionTable::frame, "samples", "9");
  workspace.compare_by = CompareBy::slider;
  workspace.edited_side = 1;
  workspace = with(workspace, OptionTable::frame, "samples", "1");
  workspace = with(workspace, OptionTable::frame, "blur", "mip");
  workspace = with(workspace, OptionTable::frame, "fov", "50");
  EXPECT_EQ(frameOf(workspace, 0)->samples, 9);
  EXPECT_EQ(frameOf(workspace, 0)->blur, BlurKind::exact);
  EXPECT_EQ(frameOf(workspace, 1)->samples, 1);
  EXPECT_EQ(frameOf(workspace, 1)->blur, BlurKind::mip);
  EXPECT_FLOAT_EQ(frameOf(workspace, 0)->camera.fov_deg, 50.0f) << "both show the same view";
  EXPECT_TRUE(workspace.sides[0].frame.empty());
  workspace = withoutOption(workspace, OptionTable::frame, "samples");
  EXPECT_EQ(frameOf(workspace, 1)->samples, 9) << "what both have";
}

TEST(Workspace, StepsThroughItsMapsRoundAndRound) {
  Workspace workspace = withMap(withMap({}, "a.hdr"), "b.hdr");
  EXPECT_EQ(workspace.maps.size(), 3u);
  EXPECT_EQ(workspace.shown_map, 2u);
  EXPECT_EQ(withMapStepped(workspace, 1).shown_map, 0u);
  EXPECT_EQ(withMapStepped(workspace, -3).shown_map, 2u);
  EXPECT_EQ(withMapStepped(workspace, -1).shown_map, 1u);
  EXPECT_EQ(withMap(workspace, "a.hdr").shown_map, 1u) << "which is there already";
  EXPECT_EQ(withMap(workspace, "a.hdr").maps, workspace.maps);
}

TEST(Workspace, AHalfHasAPanoramaOfItsOwn) {
  Workspace workspace = withMap({}, "a.hdr");
  workspace.compare_by = CompareBy::slider;
  workspace.edited_side = 1;
  workspace = withMapStepped(std::move(workspace), 1);
  EXPECT_EQ(mapOf(workspace, 0), "a.hdr");
  EXPECT_EQ(mapOf(workspace, 1), "studio");
  workspace = withMap(std::move(workspace), "b.hdr");
  EXPECT_EQ(mapOf(workspace, 1), "b.hdr");
  EXPECT_EQ(workspace.shown_map, 1u);
}

TEST(Workspace, ACameraIsToldByItsOptions) {
  FrameSettings wanted;
  wanted.camera = {.azimuth_deg = -33.25f, .elevation_deg = 61.5f, .distance = 2.75f, .target = glm::vec3(0.1f, 2, -3)};
  wanted.camera.fov_deg = 28.0f;
  const Workspace moved = withCamera({}, wanted.camera);
  EXPECT_EQ(frameOf(moved, 0)->camera, wanted.camera) << "bit by bit";
  EXPECT_EQ(withCamera(moved, CameraOptions()), Workspace()) << "the default is no text";
}

TEST(Workspace, ChangesTheMaterialsOfAScene) {
  Workspace workspace = with({}, OptionTable::material, "material", "gold");
  workspace.selected_material = 0;
  workspace = with(workspace, OptionTable::parameter, "perceptual_roughness", "0.625");
  workspace.parameters[7] = {{"metallic", {"0"}}};
  Scene scene = *loadModel("sphere");
  ASSERT_TRUE(changeMaterials(scene, *materialsOf(workspace.materials)));
  ASSERT_TRUE(changeParameters(scene, workspace)) << "there is no eighth, which is left alone";
  EXPECT_FLOAT_EQ(scene.materials[0].perceptual_roughness, 0.625f);
  EXPECT_FLOAT_EQ(scene.materials[0].metallic, 1.0f);
}

TEST(Workspace, AnotherModelStartsAnew) {
  Workspace workspace = with({}, OptionTable::frame, "camera", "40,5,3");
  workspace = with(workspace, OptionTable::frame, "target", "1,2,3");
  workspace = with(workspace, OptionTable::frame, "exposure", "1");
  workspace.selected_material = 2;
  workspace = with(workspace, OptionTable::parameter, "metallic", "1");
  workspace = withModel(workspace, "knot");
  EXPECT_EQ(workspace.model, "knot");
  EXPECT_TRUE(workspace.parameters.empty());
  EXPECT_FALSE(workspace.selected_material);
  EXPECT_FALSE(frameOf(workspace, 0)->camera.target || frameOf(workspace, 0)->camera.distance);
  EXPECT_FLOAT_EQ(frameOf(workspace, 0)->camera.azimuth_deg, 40.0f) << "from the same side";
  EXPECT_FLOAT_EQ(frameOf(workspace, 0)->display.exposure_ev, 1.0f);
}

TEST(Workspace, TheLightOfAHalfTurnsOnFromWhereItIs) {
  Workspace workspace = with({}, OptionTable::frame, "env-rotation", "30");
  workspace.compare_by = CompareBy::slider;
  workspace.edited_side = 1;
  workspace = withLightTurned(workspace, {0, 0, 0});
  EXPECT_FLOAT_EQ(frameOf(workspace, 1)->env_rotation_deg.x, 0.0f) << "the default, which both halves have not";
  EXPECT_FLOAT_EQ(frameOf(workspace, 0)->env_rotation_deg.x, 30.0f);
}

}  // namespace
}  // namespace mirrorball
