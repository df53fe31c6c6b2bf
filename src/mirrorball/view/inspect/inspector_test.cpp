#include "mirrorball/view/inspect/inspector.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/rays/surface_shares.h"
#include "mirrorball/view/inspect/inspect_testing.h"

namespace mirrorball {
namespace {

using testing::addPart;
using testing::addSheet;
using testing::clearGlass;
using testing::inspectorOf;
using testing::kInspectedSize;
using testing::lightAround;
using testing::lightFrom;
using testing::mirrorOf;
using testing::parallelCamera;
using testing::surfaceAt;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::string valueOf(const Inspection& inspection, const std::string& name) {
  const auto& rows = inspection.rows;
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const InspectionRow& each) { return each.name == name; });
  return row == rows.end() ? "no row" : row->value;
}

TEST(Inspector, TellsWhatTheSurfaceIs) {
  Scene scene;
  Material rough = mirrorOf(0.5f, 0.3f);
  addPart(scene, sphereMesh(), rough, glm::mat4(1.0f));
  const auto inspection =
      inspectorOf(scene).inspectedAt(parallelCamera(0.0f, 0.0f), kInspectedSize, {48.0f, 32.0f}, lightAround());
  ASSERT_TRUE(inspection && inspection->surface);
  const InspectedSurface& surface = *inspection->surface;
  const glm::vec3 normal(0.5f, 0.0f, std::sqrt(0.75f));
  EXPECT_LT(glm::distance(surface.picked.position, normal), 1e-3f);
  EXPECT_LT(glm::distance(surface.picked.normal, normal), 1e-3f);
  EXPECT_LT(glm::distance(surface.geometric_normal, normal), 0.03f);
  EXPECT_NEAR(surface.cosine, normal.z, 1e-3f);
  EXPECT_FALSE(surface.is_inside);
  EXPECT_EQ(surface.material_name, "mirror");
  EXPECT_EQ(surface.material.perceptual_roughness, 0.3f);
  EXPECT_NEAR(surface.fresnel.here.angle_deg, 30.0f, 0.1f);
  EXPECT_EQ(valueOf(*inspection, "material"), "mirror");
  EXPECT_EQ(valueOf(*inspection, "perceptual_roughness"), "0.3");
  EXPECT_EQ(valueOf(*inspection, "base_color"), "0.5, 0.5, 0.5");
  EXPECT_EQ(valueOf(*inspection, "ior"), "1.5");
  EXPECT_EQ(valueOf(*inspection, "clearcoat"), "no row") << "as in a new material";
  EXPECT_EQ(valueOf(*inspection, "reflected from"), "the environment");
  EXPECT_EQ(valueOf(*inspection, "refracted from"), "no row");
  EXPECT_FALSE(inspection->behind);
}

TEST(Inspector, RowsHaveFourDigits) {
  Scene scene;
  addSheet(scene, mirrorOf(1.0f / 3.0f), 0.0f);
  const auto inspection = inspectorOf(scene).inspectedAt(parallelCamera(0.0f, 30.0f), kInspectedSize,
                                                         glm::vec2(kInspectedSize) / 2.0f, lightAround());
  ASSERT_TRUE(inspection);
  EXPECT_EQ(valueOf(*inspection, "base_color"), "0.3333, 0.3333, 0.3333");
  EXPECT_EQ(valueOf(*inspection, "reflected direction"), "0, 0.5, -0.866") << "without roundings of a 0";
  EXPECT_EQ(valueOf(*inspection, "angle"), "60");
}

TEST(Inspector, WhereNothingIsMetTheEnvironmentIsSeen) {
  Scene ball;
  addPart(ball, sphereMesh(), mirrorOf(0.5f), glm::mat4(glm::mat3(0.5f)));
  for (const Scene& scene : {ball, Scene()}) {
    const auto inspection =
        inspectorOf(scene).inspectedAt(parallelCamera(0.0f, 0.0f), kInspectedSize, {2.0f, 2.0f}, lightAround());
    ASSERT_TRUE(inspection && inspection->behind);
    EXPECT_FALSE(inspection->surface);
    EXPECT_TRUE(inspection->behind->segments.empty());
    EXPECT_LT(glm::distance(inspection->behind->direction, glm::vec3(0, 0, -1)), 1e-6f);
    EXPECT_EQ(inspection->behind->radiance, lightFrom(inspection->behind->direction));
    EXPECT_EQ(valueOf(*inspection, "background from"), "the environment");
  }
}

TEST(Inspector, OutsideOfThePictureNothingIsTold) {
  Scene scene;
  addSheet(scene, mirrorOf(0.5f), 0.0f);
  const Inspector inspector = inspectorOf(scene);
  const Camera camera = parallelCamera(0.0f, 30.0f);
  const auto at = [&](glm::ivec2 size, glm::vec2 pixel) {
    return inspector.inspectedAt(camera, size, pixel, lightAround()).has_value();
  };
  EXPECT_TRUE(at({1, 1}, {0.5f, 0.5f}));
  EXPECT_TRUE(at({1, 1}, {0.0f, 0.0f}));
  EXPECT_FALSE(at({1, 1}, {1.0f, 0.5f}));
  EXPECT_FALSE(at({1, 1}, {0.5f, -0.1f}));
  EXPECT_FALSE(at({0, 0}, {0.0f, 0.0f}));
  EXPECT_FALSE(at(kInspectedSize, {kNan, 3.0f}));
  EXPECT_FALSE(at(kInspectedSize, {3.0f, kNan}));
  Camera lost = camera;
  lost.forward = glm::vec3(kNan);
  EXPECT_FALSE(inspector.inspectedAt(lost, kInspectedSize, {3.0f, 3.0f}, lightAround()));
}

TEST(Inspector, NormalsThatAreNoNumbersDoNoHarm) {
  Mesh mesh = sphereMesh(8, 8);
  for (Vertex& vertex : mesh.vertices) vertex.normal = glm::vec3(kNan);
  Scene scene;
  addPart(scene, std::move(mesh), clearGlass(), glm::mat4(1.0f));
  const InspectedSurface surface = surfaceAt(scene, parallelCamera(0.0f, 0.0f), 0.3f);
  for (const auto* path : {&surface.reflected, &surface.refracted})
    EXPECT_FALSE(*path && std::isnan((*path)->radiance.x));
}

TEST(Inspector, WithoutAnEnvironmentItIsDark) {
  Scene scene;
  addSheet(scene, mirrorOf(0.5f), 0.0f);
  EXPECT_EQ(surfaceAt(scene, parallelCamera(0.0f, 30.0f), 0.0f, {}).reflected->radiance, glm::vec3(0.0f));
}

TEST(Inspector, AnEyeInGlassSeesItFromWithin) {
  Scene scene;
  addPart(scene, sphereMesh(), clearGlass(), glm::mat4(1.0f));
  const Camera camera = makeCamera({.azimuth_deg = 0.0f, .elevation_deg = 0.0f, .distance = 0.01f}, {}, 1.0f);
  const auto inspection =
      inspectorOf(scene).inspectedAt(camera, kInspectedSize, glm::vec2(kInspectedSize) / 2.0f, lightAround());
  ASSERT_TRUE(inspection && inspection->surface);
  EXPECT_TRUE(inspection->surface->is_inside);
  EXPECT_EQ(inspection->surface->fresnel.samples.back().reflectance, glm::vec3(1.0f));
  ASSERT_TRUE(inspection->surface->refracted);
  EXPECT_FALSE(inspection->surface->refracted->segments[0].is_inside);
}

TEST(Inspector, AnEyeInGlassLooksFromItsIndexIntoTheNext) {
  Scene scene;
  addPart(scene, sphereMesh(), clearGlass(1.5f), glm::mat4(1.0f));
  addPart(scene, sphereMesh(), clearGlass(1.5f), glm::mat4(glm::mat3(0.3f)));
  const Camera camera = makeCamera({.azimuth_deg = 0.0f, .elevation_deg = 0.0f, .distance = 0.6f}, {}, 1.0f);
  const auto inspection =
      inspectorOf(scene).inspectedAt(camera, kInspectedSize, glm::vec2(kInspectedSize) / 2.0f, lightAround());
  ASSERT_TRUE(inspection && inspection->surface);
  EXPECT_EQ(inspection->surface->picked.instance, 1u);
  EXPECT_EQ(inspection->surface->fresnel.here.reflectance, glm::vec3(0.0f)) << "both have the same index";
  EXPECT_FALSE(inspection->surface->reflected);
}

TEST(Inspector, AnEyeOutsideOfAProxyLooksThroughItsWall) {
  LightAround around = lightAround();
  around.proxy.kind = ProxyKind::sphere;
  around.proxy.radius = 0.5f;
  const auto inspection =
      inspectorOf({}).inspectedAt(parallelCamera(0.0f, 0.0f), kInspectedSize, {32.0f + 32.0f * 0.3f, 32.0f}, around);
  ASSERT_TRUE(inspection && inspection->behind);
  EXPECT_LT(glm::distance(inspection->behind->direction, glm::vec3(0.6f, 0.0f, -0.8f)), 1e-5f);
}

TEST(Inspector, IsGivenUpWhenToldTo) {
  const auto inspector = Inspector::make(std::make_shared<const Scene>(), {}, [](auto, auto) { return false; });
  ASSERT_FALSE(inspector);
  EXPECT_EQ(inspector.error().code, ErrorCode::interrupted);
}

TEST(FresnelCurve, IsThatOfGlass) {
  const Material glass = clearGlass();
  const FresnelCurve outside = fresnelCurve(glass, 0.5f, false);
  ASSERT_EQ(outside.samples.size(), 91u);
  EXPECT_NEAR(outside.samples[0].reflectance.y, 0.04f, 1e-6f);
  EXPECT_NEAR(outside.samples[90].reflectance.y, 1.0f, 1e-5f);
  EXPECT_NEAR(outside.here.angle_deg, 60.0f, 1e-4f);
  EXPECT_NEAR(outside.here.reflectance.y, outside.samples[60].reflectance.y, 1e-5f);
  const FresnelCurve inside = fresnelCurve(glass, 1.0f, true);
  EXPECT_NEAR(inside.samples[0].reflectance.y, 0.04f, 1e-6f);
  for (int angle = 0; angle <= 90; ++angle) {
    const glm::vec3 reflectance = inside.samples[std::size_t(angle)].reflectance;
    constexpr float kCritical_deg = 41.81f;
    EXPECT_EQ(reflectance == glm::vec3(1.0f), float(angle) > kCritical_deg) << angle;
  }
  // Stokes: both ways alike.
  const float beyond = std::asin(std::sin(glm::radians(30.0f)) * 1.5f);
  EXPECT_NEAR(reflectanceAt(glass, std::cos(glm::radians(30.0f)), true).y,
              reflectanceAt(glass, std::cos(beyond), false).y, 1e-5f);
}

TEST(FresnelCurve, OfAMetalBeginsWithItsColor) {
  Material metal = mirrorOf(0.0f);
  metal.base_color = {1.0f, 0.7f, 0.3f};
  const FresnelCurve curve = fresnelCurve(metal, 1.0f, false);
  EXPECT_EQ(curve.samples[0].reflectance, metal.base_color);
  EXPECT_EQ(curve.here.reflectance, metal.base_color);
  for (std::size_t i = 1; i < curve.samples.size(); ++i)
    EXPECT_GE(curve.samples[i].reflectance.z, curve.samples[i - 1].reflectance.z);
}

}  // namespace
}  // namespace mirrorball
