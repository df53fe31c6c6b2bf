#include "mirrorball/study/subject.h"

#include <set>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "mirrorball/scene/load_model.h"

namespace mirrorball {
namespace {

TEST(Subjects, EverySettingIsOneThatThereIs) {
  std::set<std::string_view> ids;
  for (const Subject& subject : subjects()) {
    EXPECT_TRUE(ids.insert(subject.id).second) << subject.id << " is there twice";
    EXPECT_FALSE(subject.techniques.empty()) << subject.id;
    FrameSettings frame;
    TraceSettings trace;
    EXPECT_TRUE(applySettings(subject.view, frame)) << subject.view;
    EXPECT_TRUE(applySettings(subject.shows, frame)) << subject.shows;
    EXPECT_TRUE(applySettings(subject.reference, trace)) << subject.reference;
    Scene built_in = *loadModel(std::string(subject.models.front()));
    EXPECT_TRUE(applyParameters(subject.parameters, built_in)) << subject.parameters;
    for (const Technique& technique : subject.techniques) {
      Scene scene = *loadModel("sphere");
      const auto set = technique.maker == Technique::Maker::renderer ? applySettings(technique.settings, frame)
                                                                     : applySettings(technique.settings, trace);
      EXPECT_TRUE(set) << technique.settings;
      EXPECT_TRUE(applyParameters(technique.parameters, scene)) << technique.parameters;
    }
  }
}

TEST(Subjects, AWrongSettingIsRefused) {
  FrameSettings frame;
  TraceSettings trace;
  EXPECT_FALSE(applySettings("mapping=cubic", frame));
  EXPECT_FALSE(applySettings("mapping", frame));
  EXPECT_FALSE(applySettings("bounces=1 mapping=sphere", trace));
  ASSERT_TRUE(applySettings("mapping=sphere  blur=mip", frame));
  EXPECT_EQ(frame.mapping, Mapping::sphere);
  EXPECT_EQ(frame.blur, BlurKind::mip);
}

TEST(Subjects, TheBuiltInScenesAreThereAndASeriesChangesThem) {
  for (const Subject& subject : subjects()) {
    ASSERT_FALSE(subject.models.empty()) << subject.id;
    for (const std::string_view model : subject.models) {
      const auto scene = loadModel(std::string(model));
      ASSERT_TRUE(scene) << scene.error().message;
      if (!subject.series) continue;
      const auto radiusAfter = [&](double value) {
        Scene changed = *scene;
        FrameSettings frame;
        subject.series->change(value, changed, frame);
        return std::tuple(boundingSphere(changed).radius, frame.camera.fov_deg, frame.camera.elevation_deg,
                          changed.materials[0].perceptual_roughness, changed.meshes[0]->vertices.size());
      };
      // A path tracer sorts triangles anew only for a series that says so.
      const auto verticesAfter = [&](double value) {
        Scene changed = *scene;
        FrameSettings frame;
        subject.series->change(value, changed, frame);
        return std::pair(changed.meshes[0]->vertices.size(), changed.instances.back().world_from_object);
      };
      const auto& values = subject.series->values;
      EXPECT_EQ(verticesAfter(values.front()) != verticesAfter(values.back()), subject.series->changes_shapes)
          << subject.id;
      ASSERT_GE(subject.series->values.size(), 3u) << subject.id;
      EXPECT_NE(radiusAfter(subject.series->values.front()), radiusAfter(subject.series->values.back())) << subject.id;
    }
  }
}

TEST(Subjects, OcclusionMapsAreStudiedWhereThereIsOne) {
  for (const Subject& subject : subjects())
    if (subject.id == "occlusion-map") {
      EXPECT_TRUE(subject.applies(*loadModel("bowl")));
      EXPECT_FALSE(subject.applies(*loadModel("sphere")));
    }
}

}  // namespace
}  // namespace mirrorball
