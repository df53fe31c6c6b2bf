#include "mirrorball/render/frame/renderer.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "formula/bsdf.h"
#include "mirrorball/bake/brdf/directional_albedo.h"
#include "mirrorball/bake/prefilter/mip_chain.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/render/frame/shot_testing.h"
#include "mirrorball/render/light/cube_look_up_testing.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/material/material_changes.h"

namespace mirrorball {
namespace {

using testing::RendererTest;
using testing::Shot;
using testing::smallShot;
using testing::Studio;

TEST_F(RendererTest, InAWhiteEnvironmentMirrorAndWhiteDiffuseVanish) {
  Studio white = studio("white");
  for (const char* model : {"sphere", "torus", "knot", "teapot", "cube"}) {
    Shot mirror = smallShot(model, "mirror");
    mirror.frame.background = BackgroundKind::transparent;
    testing::expectFurnaceWhite(white.radiance(mirror), std::string(model) + " mirror");
    Shot diffuse = smallShot(model, "");
    diffuse.frame.background = BackgroundKind::transparent;
    diffuse.materials.set = {"base_color=1"};
    testing::expectFurnaceWhite(white.radiance(diffuse), std::string(model) + " white dielectric");
    diffuse.materials.set = {"base_color=1", "specular=0"};
    testing::expectFurnaceWhite(white.radiance(diffuse), std::string(model) + " white diffuse");
    Shot glass = smallShot(model, "glass");
    glass.frame.background = BackgroundKind::transparent;
    testing::expectFurnaceWhite(white.radiance(glass), std::string(model) + " glass");
  }
}

TEST_F(RendererTest, AWhiteMetalVanishesHoweverRoughItIs) {
  Studio white = studio("white");
  for (int tenths = 0; tenths <= 10; ++tenths) {
    Shot shot = smallShot("sphere", "");
    shot.frame.background = BackgroundKind::transparent;
    const std::string roughness = "perceptual_roughness=" + std::to_string(static_cast<float>(tenths) / 10.0f);
    shot.materials.set = {"base_color=1", "metallic=1", roughness};
    testing::expectFurnaceWhite(white.radiance(shot), "white metal of " + roughness);
    shot.materials.set = {"base_color=1", roughness};
    testing::expectFurnaceWhite(white.radiance(shot), "white dielectric of " + roughness);
  }
}

// Without light from several bounces a pixel of a metal shows f0 · scale + bias of the table, at its angle and
// roughness; f0 of 0.02 leaves next to nothing to a second one.
TEST_F(RendererTest, ADarkMetalReflectsWhatTheBrdfTableSays) {
  Studio white = studio("white");
  Shot shot = smallShot("sphere", "");
  shot.frame.size = {129, 129};
  shot.frame.camera.orthographic_height = 2.0f;
  testing::aim(shot.frame, 0, 0);
  shot.frame.samples = 1;
  const glm::vec3 f0(0.02f);
  for (const float roughness : {0.25f, 0.5f, 1.0f}) {
    shot.materials.set = {"base_color=0.02", "metallic=1", "perceptual_roughness=" + std::to_string(roughness)};
    const Image image = white.radiance(shot);
    for (int x = 1; x < 128; ++x) {
      const float nx = (static_cast<float>(x) + 0.5f) / 64.5f - 1.0f;
      const DirectionalAlbedo share = directionalAlbedo(Distribution::ggx, roughness, std::sqrt(1.0f - nx * nx));
      const glm::vec3 single = f0 * share.scale + share.bias;
      const glm::vec3 mean = f0 + (1.0f - f0) / 21.0f;  // of Schlick's form
      const glm::vec3 first = glm::max(single / share.total(), mean);
      const glm::vec3 multiple = formula::multipleScattering(first, mean, 1.0f - share.total());
      // The table's 0.002, and a sphere of flat triangles.
      EXPECT_NEAR(rgbAt(image, x, 64).x, single.x + multiple.x, 0.004f) << "roughness " << roughness << " at nx " << nx;
    }
  }
}

TEST_F(RendererTest, EveryMappingIsWhiteInTheFurnace) {
  Studio white = studio("white");
  for (const Mapping mapping : {Mapping::reflection, Mapping::normal, Mapping::sphere})
    for (const ReflectAt reflect_at : {ReflectAt::vertex, ReflectAt::fragment, ReflectAt::triangle}) {
      Shot shot = smallShot("teapot", "mirror");
      shot.frame.background = BackgroundKind::transparent;
      shot.frame.mapping = mapping;
      shot.frame.reflect_at = reflect_at;
      testing::expectFurnaceWhite(white.radiance(shot), "mapping " + std::to_string(static_cast<int>(mapping)));
    }
  for (const Texgen texgen :
       {Texgen::object_linear, Texgen::eye_linear, Texgen::sphere, Texgen::reflection, Texgen::normal, Texgen::light}) {
    Shot shot = smallShot("teapot", "mirror");
    shot.frame.background = BackgroundKind::transparent;
    shot.frame.texgen = texgen;
    shot.frame.lights = {{glm::vec3(2.0f), glm::vec3(0.0f)}};
    testing::expectFurnaceWhite(white.radiance(shot), "texgen " + std::to_string(static_cast<int>(texgen)));
  }
  Shot shot = smallShot("torus", "glass");
  shot.frame.background = BackgroundKind::transparent;
  shot.frame.refraction = RefractionKind::image_space;
  testing::expectFurnaceWhite(white.radiance(shot), "image-space refraction", 2e-3f);
}

// Looking along +Z with +Y up, +X is on the left (docs/conventions.md).
TEST_F(RendererTest, TheBackgroundIsTheRightWayRound) {
  Studio marked(Environment([](glm::vec3 d) { return glm::max(d, glm::vec3(0.0f)); }, 128));
  Shot shot = smallShot("none", "");
  shot.frame.size = {65, 65};
  shot.frame.camera.fov_deg = 90;
  testing::aim(shot.frame, 180, 0);
  const Image image = marked.radiance(shot);
  EXPECT_NEAR(rgbAt(image, 32, 32).z, 1.0f, 1e-2f) << "+Z in the middle";
  EXPECT_GT(rgbAt(image, 2, 32).x, 0.6f) << "+X on the left";
  EXPECT_EQ(rgbAt(image, 62, 32).x, 0.0f) << "-X on the right";
  EXPECT_GT(rgbAt(image, 32, 2).y, 0.6f) << "+Y above";
}

// A mirror ball seen from +Z shows what is behind the camera in its middle, +X on its right.
TEST_F(RendererTest, AMirrorSphereIsTheSphereMap) {
  const auto light = [](glm::vec3 d) {
    return glm::vec3(1.0f + d.x, 1.0f + d.y, 1.0f + d.z) * (1.5f + std::sin(9.0f * d.x) * std::cos(7.0f * d.y + d.z));
  };
  const Environment environment(light, 256);
  Studio room(environment);
  Shot shot = smallShot("sphere", "mirror");
  shot.frame.size = {256, 256};
  testing::aim(shot.frame, 0, 0);
  shot.frame.camera.orthographic_height = 2.0f;
  const Image rendered = room.radiance(shot);
  const EnvironmentMap expected = *convert(environment, Projection::sphere, 256);
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) {
      const glm::vec2 p = (glm::vec2(x, y) + 0.5f) / 128.0f - 1.0f;
      if (glm::dot(p, p) >= 0.9f) continue;
      const glm::vec3 difference = (rgbAt(rendered, x, y) - rgbAt(expected.face(0), x, y)) / 5.0f;
      sum += double(glm::dot(difference, difference)) / 3.0;
      ++count;
    }
  // The cube between is interpolated bilinearly and kept in halves; a shift of half a pixel would leave 37 dB.
  EXPECT_GT(-10.0 * std::log10(sum / count), 50.0);
}

TEST_F(RendererTest, TheSphereMappingOfAnOrthographicSphereIsItsReflection) {
  Studio room(Environment([](glm::vec3 d) { return d * 0.5f + 0.5f; }, 256));
  Shot shot = smallShot("sphere", "mirror");
  shot.frame.size = {128, 128};
  shot.frame.camera.orthographic_height = 2.0f;
  shot.frame.background = BackgroundKind::transparent;
  for (const float azimuth : {0.0f, 130.0f}) {
    testing::aim(shot.frame, azimuth, 25.0f);
    shot.frame.mapping = Mapping::reflection;
    const Image reflected = room.radiance(shot);
    shot.frame.mapping = Mapping::sphere;
    const Image mapped = room.radiance(shot);
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < 128; ++y)
      for (int x = 0; x < 128; ++x) {
        const glm::vec2 p = (glm::vec2(x, y) + 0.5f) / 64.0f - 1.0f;
        if (glm::dot(p, p) >= 0.9f) continue;
        sum += double(glm::length(rgbAt(reflected, x, y) - rgbAt(mapped, x, y)));
        ++count;
      }
    EXPECT_LT(sum / count, 0.005) << "azimuth " << azimuth;
  }
}

// A frame of 9 samples is drawn one by one; what is shown after each is the mean so far. The window's framebuffer is a
// texture of its own here, larger than the picture.
TEST_F(RendererTest, ShowsTheMeanOfTheSamplesThatThereAreInAnotherFramebuffer) {
  const Environment uv = *builtinEnvironment("uv");
  auto renderer = testing::rendererOf(*loadModel("sphere"), uv, *testing::prepareOnce(uv));
  ASSERT_TRUE(renderer) << renderer.error().message;
  for (const Resolve resolve : {Resolve::display, Resolve::radiance}) {
    FrameSettings settings = smallShot("sphere", "").frame;
    settings.samples = 9;
    settings.resolve = resolve;
    const Image8 whole = *renderer->render(settings);
    const auto window = gl::Framebuffer::make(gl::Format::rgba8, 100, 70);
    ASSERT_TRUE(window);
    ASSERT_TRUE(renderer->begin(settings));
    double first = 0.0;
    for (int drawn = 1; drawn <= 9; ++drawn) {
      EXPECT_EQ(*renderer->drawSample(), drawn);
      window->bind();
      GLint name = 0;
      glGetIntegerv(GL_FRAMEBUFFER_BINDING, &name);
      ASSERT_TRUE(renderer->show(static_cast<unsigned>(name)));
      const Image8 shown = window->readBytes();
      double difference = 0.0;
      for (int y = 0; y < whole.height(); ++y)
        for (int x = 0; x < whole.width(); ++x)
          for (int c = 0; c < 4; ++c)
            difference += std::abs(int(whole.texel(x, y)[c]) - int(shown.texel(x, y + 70 - 64)[c]));
      difference /= 96.0 * 64.0;
      if (drawn == 1) first = difference;
      EXPECT_LT(difference, 12.0) << "no mean is darker for having few samples";
      EXPECT_EQ(difference == 0.0, drawn == 9);
    }
    EXPECT_GT(first, 0.1) << "one sample is no mean of nine";
    EXPECT_EQ(*renderer->drawSample(), 9) << "there is none left";
  }
}

// What a frame shows is of what the renderer was given last, whatever it drew before.
TEST_F(RendererTest, SceneEnvironmentAndMaterialsMayChangeBetweenFrames) {
  const Environment uv = *builtinEnvironment("uv");
  const Environment studio = *builtinEnvironment("studio");
  const PreparedEnvironment of_uv = *testing::prepareOnce(uv);
  const PreparedEnvironment of_studio = *testing::prepareOnce(studio);
  const FrameSettings settings = smallShot("", "").frame;
  const auto bytesOf = [&](Renderer& used) {
    const Image8 picture = *used.render(settings);
    return std::vector<std::uint8_t>(picture.samples().begin(), picture.samples().end());
  };
  const auto pictureOf = [&](const char* model, const char* material, const Environment& light) {
    Scene scene = *loadModel(model);
    EXPECT_TRUE(changeMaterials(scene, {.material = material}));
    auto fresh = testing::rendererOf(scene, light, &light == &uv ? of_uv : of_studio);
    return bytesOf(*fresh);
  };
  auto renderer = testing::rendererOf(*loadModel("cube"), uv, of_uv);
  ASSERT_TRUE(renderer);
  ASSERT_TRUE(renderer->render(settings));
  Scene teapot = *loadModel("teapot");
  ASSERT_TRUE(changeMaterials(teapot, {.material = "gold"}));
  ASSERT_TRUE(renderer->setScene(std::move(teapot)));
  EXPECT_EQ(bytesOf(*renderer), pictureOf("teapot", "gold", uv));
  ASSERT_TRUE(renderer->setEnvironment(studio, of_studio));
  EXPECT_EQ(bytesOf(*renderer), pictureOf("teapot", "gold", studio));
  Scene sphere = *loadModel("sphere");
  ASSERT_TRUE(changeMaterials(sphere, {.material = "glass"}));
  ASSERT_TRUE(renderer->setScene(std::move(sphere)));
  EXPECT_EQ(bytesOf(*renderer), pictureOf("sphere", "glass", studio));
}

TEST_F(RendererTest, EnvRotationTurnsPlusZTowardsPlusX) {
  Studio lamp(Environment([](glm::vec3 d) { return glm::vec3(d.z > 0.9f ? 1.0f : 0.0f); }, 128));
  Shot shot = smallShot("none", "");
  shot.frame.size = {33, 33};
  shot.frame.env_rotation_deg.x = 90.0f;
  testing::aim(shot.frame, 270, 0);  // stands on −X and looks along +X
  EXPECT_NEAR(rgbAt(lamp.radiance(shot), 16, 16).x, 1.0f, 1e-3f);
  testing::aim(shot.frame, 90, 0);
  EXPECT_EQ(rgbAt(lamp.radiance(shot), 16, 16).x, 0.0f);
}

// The lamp over +Z: pitched by 90 degrees it stands below, and a turn by 90 degrees after that does not move it. One
// over +X, rolled by 90 degrees, stands over +Y, and pitch brings that to +Z, yaw to +X.
TEST_F(RendererTest, PitchAndRollTurnTheEnvironmentBeforeItsYaw) {
  const auto lightOf = [&](const Environment& lamp, glm::vec3 turn_deg, glm::vec2 camera_deg) {
    Studio studio(lamp);
    Shot shot = smallShot("none", "");
    shot.frame.size = {33, 33};
    shot.frame.env_rotation_deg = turn_deg;
    testing::aim(shot.frame, camera_deg.x, camera_deg.y);
    return rgbAt(studio.radiance(shot), 16, 16).x;
  };
  const Environment over_z([](glm::vec3 d) { return glm::vec3(d.z > 0.9f ? 1.0f : 0.0f); }, 128);
  EXPECT_NEAR(lightOf(over_z, {90.0f, 90.0f, 0.0f}, {0, 90}), 1.0f, 1e-3f) << "the camera stands on +Y and looks down";
  EXPECT_EQ(lightOf(over_z, {90.0f, 90.0f, 0.0f}, {270, 0}), 0.0f);
  const Environment over_x([](glm::vec3 d) { return glm::vec3(d.x > 0.9f ? 1.0f : 0.0f); }, 128);
  EXPECT_NEAR(lightOf(over_x, {90.0f, 90.0f, 90.0f}, {270, 0}), 1.0f, 1e-3f);
}

TEST_F(RendererTest, RefractionBendsBySnellsLawAndReflectsPastTheCriticalAngle) {
  const auto light = [](glm::vec3 d) { return d * 0.5f + 0.5f; };
  Studio room(Environment(light, 256));
  Shot shot = smallShot("sphere", "");
  shot.frame.size = {129, 129};
  shot.frame.camera.orthographic_height = 2.0f;
  testing::aim(shot.frame, 0, 0);
  shot.frame.samples = 1;
  for (const auto& [ior, is_thin] : {std::pair(1.5f, false), {0.7f, false}, {1.5f, true}}) {
    shot.materials.set = {"transmission=1", "base_color=1", "perceptual_roughness=0", "ior=" + std::to_string(ior),
                          is_thin ? "thin_walled=yes" : "thin_walled=no"};
    const Image image = room.radiance(shot);
    for (int x = 4; x < 125; ++x) {
      const float nx = (static_cast<float>(x) + 0.5f) / 64.5f - 1.0f;
      const glm::vec3 n(nx, 0.0f, std::sqrt(1.0f - nx * nx));
      const glm::vec3 ray(0, 0, -1);
      const float reflectance = formula::fresnelDielectric(n.z, ior);
      const glm::vec3 expected = light(glm::reflect(ray, n)) * reflectance +
                                 light(is_thin ? ray : formula::refractedDirection(ray, n, ior)) * (1.0f - reflectance);
      EXPECT_LT(glm::length(rgbAt(image, x, 64) - expected), 0.02f)
          << "ior " << ior << " at nx " << nx << (is_thin ? ", thin" : "");
    }
  }
}

// A level whose texels were only as wide as the lobe's alpha left 0.5 to 1.2 here.
TEST_F(RendererTest, AMipLevelBlursAsWideAsTheLobe) {
  Studio room = smallStudio("studio");
  Shot shot = smallShot("sphere", "mirror");
  shot.frame.camera.orthographic_height = 2.0f;
  shot.frame.background = BackgroundKind::radiance;
  for (const char* roughness : {"0.3", "0.5", "0.7", "1"}) {
    shot.materials.set = {std::string("perceptual_roughness=") + roughness};
    shot.frame.blur = BlurKind::exact;
    const Image exact = room.radiance(shot);
    shot.frame.blur = BlurKind::mip;
    const Image level = room.radiance(shot);
    double difference = 0.0;
    double light = 0.0;
    for (int y = 0; y < exact.height(); ++y)
      for (int x = 0; x < exact.width(); ++x) {
        const glm::vec3 apart = rgbAt(level, x, y) - rgbAt(exact, x, y);
        difference += double(glm::dot(apart, apart));
        light += double(glm::dot(rgbAt(exact, x, y), rgbAt(exact, x, y)));
      }
    EXPECT_LT(std::sqrt(difference / light), 0.3) << "roughness " << roughness;
  }
}

// A sun in a dim room, as a cube of 96², 48² … 6², 3², 1 texels. What is odd in such a picture, a square sun and a pale
// frame around a face where the level of one texel has a share, is in the levels: the look-up on the CPU has it too.
TEST_F(RendererTest, AMipLevelIsWhatALookUpInTheChainSays) {
  constexpr int kSide = 96;
  EnvironmentMap cube = *convert(Environment([](glm::vec3 d) { return 0.2f + 0.1f * d; }, 64), Projection::cube, kSide);
  Image sunny = cube.face(5);
  std::fill_n(sunny.texel(20, 20), 3, 5000.0f);
  ImageSet images = cube.images();
  images.at(0, 5) = sunny;
  cube = EnvironmentMap(Projection::cube, images);
  const ImageSet chain = mipChain(cube);
  Studio room{Environment(cube)};
  Shot shot = smallShot("none", "");
  shot.frame.size = {64, 64};
  shot.frame.camera.fov_deg = 90.0f;
  shot.frame.samples = 1;
  shot.frame.blur = BlurKind::mip;
  shot.frame.background = BackgroundKind::blur;
  for (const float azimuth : {0.0f, 70.0f, 180.0f}) {
    testing::aim(shot.frame, azimuth, 0.0f);
    const Image image = room.radiance(shot);
    const float c = std::cos(glm::radians(azimuth));
    const float s = std::sin(glm::radians(azimuth));
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        const glm::vec2 p((static_cast<float>(x) - 31.5f) / 32.0f, (31.5f - static_cast<float>(y)) / 32.0f);
        const glm::vec3 d = glm::normalize(glm::vec3(c * p.x - s, p.y, -s * p.x - c));
        const testing::CubeLookUp expected(chain, d, formula::lodOfLobe(0.35f, kSide / 2.0f, d));
        // A driver has 8 bits of the place between two texels.
        ASSERT_NEAR(rgbAt(image, x, y).x, expected.light.x, 0.01f * expected.max) << azimuth << ": " << x << ", " << y;
      }
  }
}

TEST_F(RendererTest, APointLightLightsItsSideOnly) {
  Studio dark(Environment([](glm::vec3) { return glm::vec3(0.0f); }, 8));
  Shot shot = smallShot("sphere", "");
  shot.frame.size = {65, 65};
  testing::aim(shot.frame, 0, 0);
  shot.materials.set = {"specular=0", "base_color=0.5"};
  testing::set(shot.frame, "light", "1000,0,0,2,1,0");
  const Image image = dark.radiance(shot);
  EXPECT_EQ(rgbAt(image, 12, 32), glm::vec3(0.0f)) << "the side away from the light";
  const glm::vec3 lit = rgbAt(image, 48, 32);
  EXPECT_GT(lit.x, 0.3f);
  EXPECT_NEAR(lit.x, 2.0f * lit.y, 1e-4f);
  EXPECT_LE(lit.x, 1.0f);
}

TEST_F(RendererTest, ABumpBendsNormalsAndAFlatBumpDoesNot) {
  Studio room = smallStudio("studio");
  Shot smooth = smallShot("sphere", "orange");
  smooth.materials.set = {"bump=none"};
  Shot flat = smallShot("sphere", "orange");
  flat.materials.set = {"bump_height=0"};
  const Image a = room.radiance(smooth);
  const Image b = room.radiance(flat);
  const Image c = room.radiance(smallShot("sphere", "orange"));
  float flat_difference = 0.0f;
  float bump_difference = 0.0f;
  for (std::size_t i = 0; i < a.samples().size(); ++i) {
    flat_difference = std::max(flat_difference, std::abs(a.samples()[i] - b.samples()[i]));
    bump_difference = std::max(bump_difference, std::abs(a.samples()[i] - c.samples()[i]));
  }
  EXPECT_LT(flat_difference, 1e-3f);
  EXPECT_GT(bump_difference, 0.05f);
}

TEST_F(RendererTest, TheSameFrameTwiceIsTheSame) {
  Studio room = smallStudio("sky");
  Shot shot = smallShot("showcase", "");
  const Image first = room.radiance(shot);
  const Image second = room.radiance(shot);
  EXPECT_TRUE(std::equal(first.samples().begin(), first.samples().end(), second.samples().begin()));
}

// The shaders are the same text; only the drivers' arithmetic may differ.
TEST(RendererApis, Es30DrawsTheSamePictureAsDesktop) {
  std::vector<Image8> pictures[2];
  for (const gl::Api api : {gl::Api::desktop43, gl::Api::es30}) {
    MIRRORBALL_NEEDS_GL(context, api);
    Studio room(*builtinEnvironment("studio"));
    for (const DispersionKind dispersion : {DispersionKind::channels, DispersionKind::spectral}) {
      Shot shot = smallShot("showcase", "");
      shot.frame.dispersion = dispersion;
      pictures[api == gl::Api::es30].push_back(room.picture(shot));
    }
  }
  for (std::size_t shot = 0; shot < pictures[0].size(); ++shot) {
    const Image8 &desktop = pictures[0][shot], &embedded = pictures[1][shot];
    ASSERT_EQ(desktop.samples().size(), embedded.samples().size());
    ASSERT_FALSE(desktop.empty());
    for (std::size_t i = 0; i < desktop.samples().size(); ++i)
      EXPECT_NEAR(desktop.samples()[i], embedded.samples()[i], 2);
  }
}

}  // namespace
}  // namespace mirrorball
