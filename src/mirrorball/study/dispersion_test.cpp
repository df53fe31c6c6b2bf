// Light that dispersing bodies bend, drawn and traced, against what Snell and catalogues of glass say.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "gl_driver.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"
#include "mirrorball/scene/shapes/faceted.h"
#include "mirrorball/study/traced_frame.h"
#include "mirrorball/trace/path_tracer.h"

namespace mirrorball {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// A line of light and the index of Schott's SF11 there, of its data sheet.
struct Line {
  float wavelength_nm;
  double index;
};
constexpr Line kLineC{656.2725f, 1.77599};
constexpr Line kLined{587.5618f, 1.78472};
constexpr Line kLineF{486.1327f, 1.80645};
constexpr Line kLineG{435.8343f, 1.82518};

/// By which angle an equilateral prism turns light [rad].
double deviationOf(double index, double incidence) {
  const double top = 60.0 * kDegree;
  const double inside = top - std::asin(std::sin(incidence) / index);
  return incidence + std::asin(index * std::sin(inside)) - top;
}

/// The eye's rays go up towards a prism's side, which they meet at 63°, near the least deviation of SF11.
constexpr double kElevation = -33.0 * kDegree;
constexpr double kIncidence = 30.0 * kDegree - kElevation;
/// Where they go then, as an angle about Z from +X, in the middle of those that lines have.
const double kMiddle = std::numbers::pi + kElevation + deviationOf(1.80, kIncidence);
/// What is added to angles, so that light is not negative.
constexpr double kZero = 0.15;

double angleAboutZ(glm::vec3 d) {
  const double angle = std::atan2(double(d.y), double(d.x));
  return angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
}

/// Light that tells the direction from which it comes.
glm::vec3 angleAsLight(glm::vec3 d) {
  return glm::vec3(std::max(static_cast<float>(angleAboutZ(d) - kMiddle + kZero), 0.0f));
}

/// A prism of SF11 that mirrors nothing.
Scene clearPrism() {
  Scene scene = meshScene(prismMesh(), *materialNamed("sf11"));
  EXPECT_TRUE(setParameter(scene.materials[0], "specular=0"));
  return scene;
}

/// A point of the side that faces +X, near the edge on top.
glm::vec3 placeOnSide() {
  glm::vec3 top(-1.0f), right(-1.0f);
  for (const Vertex& vertex : prismMesh().vertices) {
    if (vertex.position.y > top.y) top = vertex.position;
    if (vertex.position.x > right.x) right = vertex.position;
  }
  const glm::vec3 place = glm::mix(top, right, 0.3f);
  return {place.x, place.y, 0.0f};
}

/// That place alone, from that direction.
FrameSettings shotOfSide() {
  FrameSettings frame;
  frame.size = {4, 4};
  frame.samples = 1;
  frame.refraction = RefractionKind::traced;
  frame.camera.target = placeOnSide();
  frame.camera.orthographic_height = 0.05f;
  testing::aim(frame, 90.0f, static_cast<float>(kElevation / kDegree));
  return frame;
}

class Dispersion : public ::testing::Test {
 protected:
  void SetUp() override {
    auto made = gl::Context::createHeadless();
    if (!made) MIRRORBALL_END_WITHOUT_GL(made.error().message);
    context_.emplace(std::move(*made));
  }

  static Image drawn(Scene scene, const Environment& environment, const FrameSettings& frame) {
    const auto draw = [&]() -> Result<Image> {
      MIRRORBALL_TRY(prepared, testing::prepareOnce(environment));
      MIRRORBALL_TRY(renderer, testing::rendererOf(std::move(scene), environment, prepared));
      return renderer.renderRadiance(frame);
    };
    return valueOf(draw());
  }

  static Image traced(Scene scene, const Environment& environment, const FrameSettings& frame, TraceSettings settings) {
    const auto trace = [&]() -> Result<Image> {
      MIRRORBALL_TRY(camera, framedCamera(scene, boundingSphere(scene), frame.camera, frame.size));
      MIRRORBALL_TRY(tracer, PathTracer::make(std::move(scene), environment));
      MIRRORBALL_TRY(picture, tracer.render(camera, tracedFrame(frame, std::move(settings))));
      return std::move(picture.radiance);
    };
    return valueOf(trace());
  }

 private:
  static Image valueOf(Result<Image> image) {
    if (image) return std::move(*image);
    ADD_FAILURE() << image.error().message;
    return Image(1, 1, 4);
  }
  std::optional<gl::Context> context_;
};

/// By which angle the light was turned that a picture of angleAsLight shows [degrees].
double turnSeenIn(const Image& picture) {
  const double angle = double(picture.texel(1, 2)[1]) - kZero + kMiddle;
  return (angle - std::numbers::pi - kElevation) / kDegree;
}

double rmsDifference(const Image& a, const Image& b) {
  double sum = 0.0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const glm::dvec3 difference(glm::min(rgbAt(a, x, y), glm::vec3(1.0f)) -
                                  glm::min(rgbAt(b, x, y), glm::vec3(1.0f)));
      sum += glm::dot(difference, difference) / 3.0;
    }
  return std::sqrt(sum / (double(a.width()) * a.height()));
}

// Between the lines C and g the prism turns light by 7° more; two numbers, as glTF has them, would miss g by 0.4°.
TEST_F(Dispersion, APrismTurnsLightOfAWavelengthBySnell) {
  const Environment angles(angleAsLight, 128);
  for (const Line& line : {kLineC, kLined, kLineF, kLineG}) {
    FrameSettings frame = shotOfSide();
    frame.wavelength_nm = line.wavelength_nm;
    const double expected = deviationOf(line.index, kIncidence) / kDegree;
    EXPECT_NEAR(turnSeenIn(drawn(clearPrism(), angles, frame)), expected, 0.05) << line.wavelength_nm << " nm, drawn";
    EXPECT_NEAR(turnSeenIn(traced(clearPrism(), angles, frame, {.samples = 1})), expected, 0.05)
        << line.wavelength_nm << " nm, traced";
  }
}

// One surface alone: n sin θ is the same on both sides.
TEST_F(Dispersion, OneSurfaceTurnsLightOfAWavelengthBySnell) {
  const auto bent = [](double index) { return kIncidence - std::asin(std::sin(kIncidence) / index); };
  const double middle = std::numbers::pi + kElevation + bent(1.80);
  const Environment angles(
      [=](glm::vec3 d) { return glm::vec3(std::max(static_cast<float>(angleAboutZ(d) - middle + kZero), 0.0f)); }, 128);
  for (const Line& line : {kLineC, kLineG}) {
    FrameSettings frame = shotOfSide();
    frame.refraction = RefractionKind::single;
    frame.wavelength_nm = line.wavelength_nm;
    const double turned = double(drawn(clearPrism(), angles, frame).texel(1, 2)[1]) - kZero + bent(1.80);
    EXPECT_NEAR(turned / kDegree, bent(line.index) / kDegree, 0.05) << line.wavelength_nm;
  }
}

TEST_F(Dispersion, WhiteStaysWhite) {
  const Environment white([](glm::vec3) { return glm::vec3(1.0f); }, 16);
  FrameSettings frame;
  frame.size = {64, 64};
  frame.samples = 1;
  frame.background = BackgroundKind::transparent;
  frame.dispersion = DispersionKind::spectral;
  Material glass = *materialNamed("sf11");
  for (const RefractionKind kind : {RefractionKind::single, RefractionKind::traced})
    for (const int wavelengths : {8, 16}) {
      frame.refraction = kind;
      frame.wavelengths = wavelengths;
      testing::expectFurnaceWhite(drawn(meshScene(prismMesh(), glass), white, frame), "prism", 2e-3f);
      testing::expectFurnaceWhite(drawn(meshScene(sphereMesh(24, 48), glass), white, frame), "sphere", 2e-3f);
    }
  frame.wavelength_nm = 450.0f;
  testing::expectFurnaceWhite(drawn(meshScene(brilliantMesh(), glass), white, frame), "450 nm", 2e-3f);
}

/// The studio in as much detail as small pictures need.
Environment studioOfDispersion() { return Environment(*convert(*builtinEnvironment("studio"), Projection::cube, 128)); }

/// A prism through which a lamp is seen as its spectrum.
FrameSettings shotOfSpectrum() {
  FrameSettings frame;
  frame.size = {60, 45};
  frame.refraction = RefractionKind::traced;
  testing::aim(frame, 70.0f, -30.0f);
  return frame;
}

// What has one index for all light does not know of wavelengths: the pictures are the same, bit by bit but for sums.
TEST_F(Dispersion, WhatDoesNotDisperseIsTheSame) {
  FrameSettings frame = shotOfSpectrum();
  frame.samples = 2;
  Scene crown = meshScene(prismMesh(), *materialNamed("sf11"));
  ASSERT_TRUE(setParameter(crown.materials[0], "dispersion=0"));
  const Image channels = drawn(crown, studioOfDispersion(), frame);
  frame.dispersion = DispersionKind::spectral;
  const Image spectral = drawn(crown, studioOfDispersion(), frame);
  EXPECT_LT(rmsDifference(spectral, channels), 1e-6);
  for (int y = 0; y < spectral.height(); ++y)
    for (int x = 0; x < spectral.width(); ++x)
      for (int channel = 0; channel < 3; ++channel) ASSERT_GE(spectral.texel(x, y)[channel], 0.0f);
}

// Three images of a lamp are no spectrum; what the paths of single wavelengths sum up to is.
TEST_F(Dispersion, TheSpectrumIsTheReferences) {
  const Environment studio = studioOfDispersion();
  const Scene prism = meshScene(prismMesh(), *materialNamed("sf11"));
  FrameSettings frame = shotOfSpectrum();
  frame.samples = 8;
  const Image truth = traced(prism, studio, frame, {.samples = 1024, .bounces = 1, .is_unoccluded = true});
  const double of_channels = rmsDifference(drawn(prism, studio, frame), truth);
  frame.dispersion = DispersionKind::spectral;
  const double of_spectrum = rmsDifference(drawn(prism, studio, frame), truth);
  EXPECT_LT(of_spectrum, 0.35 * of_channels) << of_spectrum << " " << of_channels;
}

// A slit of light behind a glass that spreads colours over some 30°: with one sample, 12 wavelengths would be 12 lines.
// Pixels side by side have other wavelengths, so that the mean of 4 × 4 of them is a spectrum already.
TEST_F(Dispersion, ASlitBecomesASpectrumWithoutBands) {
  const Environment slit(
      [](glm::vec3 d) {
        const double from_middle = (angleAboutZ(d) - kMiddle) / 0.01;
        return glm::vec3(static_cast<float>(std::exp(-0.5 * from_middle * from_middle)));
      },
      512);
  Scene scene = clearPrism();
  ASSERT_TRUE(setParameter(scene.materials[0], "ior=1.6"));
  ASSERT_TRUE(setParameter(scene.materials[0], "dispersion=5"));
  const auto prepared = testing::prepareOnce(slit);
  ASSERT_TRUE(prepared);
  auto renderer = testing::rendererOf(std::move(scene), slit, *prepared);
  ASSERT_TRUE(renderer) << renderer.error().message;
  FrameSettings frame = shotOfSide();
  frame.dispersion = DispersionKind::spectral;
  const auto meanOfPixels = [&](int samples, double turn_deg) {
    frame.samples = samples;
    frame.env_rotation_deg.z = static_cast<float>(turn_deg);
    const auto picture = renderer->renderRadiance(frame);
    glm::vec3 sum(0.0f);
    for (int pixel = 0; pixel < 16; ++pixel) sum += rgbAt(*picture, pixel % 4, pixel / 4) / 16.0f;
    return sum;
  };
  double error2 = 0.0, light2 = 0.0;
  for (double turn_deg = -20.0; turn_deg <= 10.0; turn_deg += 0.5) {
    const glm::dvec3 truth(meanOfPixels(64, turn_deg));
    const glm::dvec3 error = glm::dvec3(meanOfPixels(1, turn_deg)) - truth;
    error2 += glm::dot(error, error);
    light2 += glm::dot(truth, truth);
  }
  EXPECT_LT(std::sqrt(error2 / light2), 0.01);
}

}  // namespace
}  // namespace mirrorball
