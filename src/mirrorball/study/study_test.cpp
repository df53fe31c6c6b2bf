#include "mirrorball/study/study.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "mirrorball/base/parallel.h"
#include "mirrorball/codec/ldr/png.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"
#include "mirrorball/scene/shapes/interreflection.h"
#include "mirrorball/trace/path_tracer.h"

namespace mirrorball {
namespace {

/// The studio in as much detail as small pictures need.
Environment smallStudio() { return Environment(*convert(*builtinEnvironment("studio"), Projection::cube, 64)); }

StudySettings small() { return {.frame = {.size = {32, 32}, .samples = 4}, .paths = 32}; }

Scene mirrorSphere() { return meshScene(sphereMesh(24, 48), *materialNamed("mirror")); }

Result<Study> studied(Scene scene, const StudySettings& settings, const StudyObserver& observer = {}) {
  MIRRORBALL_TRY(context, gl::Context::createHeadless());
  MIRRORBALL_TRY(prepared, testing::prepareOnce(smallStudio()));
  return study({{std::move(scene), smallStudio(), {}}, std::move(prepared), std::move(context)}, false, settings,
               observer);
}

const StudiedSection* sectionOf(const Study& study, std::string_view id) {
  const auto found = std::ranges::find(study.sections, id, &StudiedSection::id);
  return found == study.sections.end() ? nullptr : &*found;
}

double psnrOf(const StudiedPicture& picture) { return *picture.values[static_cast<std::size_t>(Metric::psnr)]; }

/// A study of a mirror sphere, which most tests look at.
class StudyTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = studied(mirrorSphere(), small(),
                    {.progress =
                         [](std::size_t done, std::size_t total) {
                           most_done_ = std::max(most_done_, done);
                           total_ = total;
                           return true;
                         },
                     .section_done = [] { ++sections_done_; }});
  }
  static void TearDownTestSuite() { made_ = fail(ErrorCode::interrupted, ""); }
  void SetUp() override {
    if (!made_ && made_.error().code == ErrorCode::no_gl) GTEST_SKIP() << made_.error().message;
    ASSERT_TRUE(made_) << made_.error().message;
  }
  static const Study& sphere() { return *made_; }

  static inline Result<Study> made_ = fail(ErrorCode::interrupted, "");
  static inline std::size_t most_done_ = 0;
  static inline std::size_t total_ = 0;
  static inline std::size_t sections_done_ = 0;
};

TEST_F(StudyTest, HasTheSectionsThatApply) {
  EXPECT_NE(sectionOf(sphere(), "look-up"), nullptr);
  EXPECT_EQ(sectionOf(sphere(), "occlusion-map"), nullptr);
  EXPECT_EQ(sectionOf(sphere(), "distance"), nullptr) << "needs two spheres";
  const StudiedSection* blur = sectionOf(sphere(), "blur");
  ASSERT_NE(blur, nullptr);
  EXPECT_EQ(blur->shots.front().label, "as it is");
  EXPECT_GE(blur->shots.size(), 6u);
  EXPECT_EQ(most_done_, total_);
}

/// What the metrics say of a scene as it is drawn with those settings and traced by one bounce: all made anew.
decltype(StudiedPicture::values) comparedAnew(const Scene& scene, const FrameSettings& frame) {
  auto renderer = Renderer::headless();
  EXPECT_TRUE(renderer->setEnvironment(smallStudio(), *testing::prepareOnce(smallStudio())));
  EXPECT_TRUE(renderer->setScene(scene));
  auto drawn = renderer->renderRadiance(frame);
  const Camera camera = *framedCamera(renderer->scene(), renderer->bounds(), frame.camera, frame.size);
  auto tracer = PathTracer::make(scene, smallStudio());
  auto traced = tracer->render(camera, {.size = frame.size,
                                        .samples = 32,
                                        .bounces = 1,
                                        .is_unoccluded = true,
                                        .environment_from_world = frame.environmentFromWorld()});
  return compareImages(*comparedImage(std::move(*drawn), ImageKind::light),
                       *comparedImage(std::move(traced->radiance), ImageKind::light), ImageKind::light)
      ->values;
}

// What is told of a technique is what `compare` tells of its picture and the reference, though one path tracer makes
// the pictures of all materials.
TEST_F(StudyTest, TheNumbersAreThoseOfTheComparison) {
  FrameSettings frame = small().frame;
  frame.resolve = Resolve::radiance;
  frame.mapping = Mapping::sphere;
  const StudiedPicture& sphere_map = sectionOf(sphere(), "look-up")->shots[0].pictures[1];
  ASSERT_EQ(sphere_map.settings, "mapping=sphere");
  EXPECT_EQ(sphere_map.values, comparedAnew(mirrorSphere(), frame));

  const StudiedShot& rough = sectionOf(sphere(), "texels")->shots.back();
  ASSERT_EQ(rough.pictures[1].settings, "blur=mip lookup=flat");
  Scene scene = mirrorSphere();
  scene.materials[0].perceptual_roughness = static_cast<float>(rough.value.value());
  frame.mapping = Mapping::reflection;
  frame.blur = BlurKind::mip;
  frame.look_up = LightLookUp::flat;
  EXPECT_EQ(rough.pictures[1].values, comparedAnew(scene, frame));
}

TEST_F(StudyTest, AFlatPictureOfTheFacesIsTheCubeButForItsSeams) {
  const auto& shots = sectionOf(sphere(), "texels")->shots;
  const auto& smooth = shots.front().pictures;
  EXPECT_NEAR(psnrOf(smooth[1]), psnrOf(smooth[0]), 0.5) << "where texels are smaller than what is seen";
  EXPECT_LT(psnrOf(smooth[2]), psnrOf(smooth[1])) << "the nearest texel";
  const auto& rough = shots.back().pictures;
  EXPECT_LT(psnrOf(rough[1]), psnrOf(rough[0]) - 0.5) << "few texels, wide seams";
}

TEST_F(StudyTest, AWrongTechniqueIsSeenToBeWrong) {
  const auto& look_ups = sectionOf(sphere(), "look-up")->shots[0].pictures;
  EXPECT_GT(psnrOf(look_ups[0]), 25.0) << "a convex mirror: the reflected ray is right";
  EXPECT_LT(psnrOf(look_ups[2]), psnrOf(look_ups[0]) - 10.0) << "the normal is not";
  EXPECT_GT(psnrOf(look_ups[3]), psnrOf(look_ups[1]) + 5.0) << "a sphere map for this camera has no parallel rays";
  const auto& places = sectionOf(sphere(), "reflect-at")->shots[0].pictures;
  EXPECT_LT(psnrOf(places[2]), psnrOf(places[0]) - 5.0) << "tiles";
}

TEST_F(StudyTest, ErrorsByAngleAreOfTheModelAndGrowWithRoughness) {
  const StudiedSection* lobes = sectionOf(sphere(), "lobes");
  const auto errorAt = [&](std::size_t shot) { return lobes->shots[shot].pictures[0].by_angle[8].value_or(0.0); };
  EXPECT_GT(errorAt(lobes->shots.size() - 1), 0.02);
  const StudiedSection* blur = sectionOf(sphere(), "blur");
  for (const StudiedShot& shot : blur->shots)
    for (const StudiedPicture& picture : shot.pictures) EXPECT_TRUE(picture.by_angle[8]) << shot.label;
  EXPECT_FALSE(sectionOf(sphere(), "look-up")->shots[0].pictures[0].by_angle[8]);
}

// Where n·v is greater, the reference's noise is what is left of both.
TEST_F(StudyTest, ARowOfLobesIsNearerThanOneWhereASurfaceIsSeenAslant) {
  const auto& shots = sectionOf(sphere(), "lobes")->shots;
  const auto rough = std::ranges::find(shots, std::optional(0.6), &StudiedShot::value);
  ASSERT_NE(rough, shots.end());
  const auto& one = rough->pictures[0].by_angle;
  const auto& row = rough->pictures[2].by_angle;
  for (std::size_t tenth = 2; tenth < 6; ++tenth) EXPECT_LT(*row[tenth], 0.7 * *one[tenth]) << tenth;
}

TEST_F(StudyTest, CostsAreOfWhatIsRead) {
  const auto costOf = [](const StudiedPicture& picture) { return picture.drawn->light; };
  const auto& shots = sectionOf(sphere(), "blur")->shots;
  const auto rough = std::ranges::find(shots, std::optional(0.6), &StudiedShot::value);
  ASSERT_NE(rough, shots.end());
  const auto& blurs = rough->pictures;
  // The cube has 64² texels a face of half floats with its levels, the irradiance 32².
  const std::size_t irradiance = 6 * 32 * 32 * 8;
  const std::size_t cube = 6 * 8 * (64 * 64 + 32 * 32 + 256 + 64 + 16 + 4 + 1);
  for (const std::size_t of_cube : {2u, 3u}) EXPECT_EQ(costOf(blurs[of_cube]).texture_bytes, cube + irradiance);
  EXPECT_EQ(costOf(blurs[2]).reads, 2);
  EXPECT_GT(costOf(blurs[3]).reads, 50);
  EXPECT_EQ(costOf(blurs[0]).reads, 5) << "four lobes of the chain, and the irradiance";
  EXPECT_LT(costOf(blurs[0]).texture_bytes, cube) << "the cube itself is not read";
  EXPECT_EQ(costOf(shots[0].pictures[0]).texture_bytes, cube + irradiance) << "a mirror reads no blurred light";
  for (const StudiedPicture& picture : blurs) EXPECT_GT(picture.drawn->frame_ms, 0.0);
}

TEST_F(StudyTest, BouncesAndOcclusionAreSeenInABowl) {
  StudySettings settings = small();
  settings.frame.camera.elevation_deg = 40.0f;
  const auto of_bowl = studied(bowlScene(), settings);
  ASSERT_TRUE(of_bowl) << of_bowl.error().message;
  const auto& steps = sectionOf(*of_bowl, "knowledge")->shots[0].pictures;
  EXPECT_LT(psnrOf(steps[1]), psnrOf(steps[4]) - 10.0) << "a map knows less than four bounces";
  const StudiedSection* occlusion = sectionOf(*of_bowl, "occlusion-map");
  ASSERT_NE(occlusion, nullptr);
  EXPECT_GT(psnrOf(occlusion->shots[0].pictures[0]), psnrOf(occlusion->shots[0].pictures[1]) + 1.0);
}

/// All pictures but for those of times.
std::vector<Bytes> picturesOf(const Study& study) {
  std::vector<Bytes> pictures;
  for (const StudiedSection& section : study.sections)
    for (const StudiedShot& shot : section.shots)
      for (const StudiedPicture& picture : shot.pictures)
        for (const Image8* image : {&picture.picture, &picture.flip, &picture.difference})
          pictures.push_back(*encodePng(*image, {}));
  return pictures;
}

TEST_F(StudyTest, IsTheSameForAnyNumberOfThreads) {
  const int usual = threadLimit();
  setThreadLimit(1);
  const auto serial = studied(mirrorSphere(), small());
  setThreadLimit(usual);
  ASSERT_TRUE(serial);
  EXPECT_EQ(picturesOf(*serial), picturesOf(sphere()));
}

TEST_F(StudyTest, StopsWhenToldTo) {
  const auto stopped = studied(mirrorSphere(), small(),
                               {.progress = [](std::size_t done, std::size_t total) { return done < total / 20; }});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

TEST_F(StudyTest, AnInterruptionKeepsTheSubjectsThatAreDone) {
  std::size_t done = 0;
  const auto stopped =
      studied(mirrorSphere(), small(),
              {.progress = [&](std::size_t, std::size_t) { return done == 0; }, .section_done = [&] { ++done; }});
  ASSERT_TRUE(stopped) << stopped.error().message;
  EXPECT_TRUE(stopped->isInterrupted());
  EXPECT_EQ(stopped->planned, sphere().planned);
  ASSERT_EQ(stopped->sections.size(), 1u);
  EXPECT_EQ(stopped->sections[0].shots.size(), sphere().sections[0].shots.size());
}

// Of one convex body all numbers of bounces are one picture, and it hides nothing of itself.
TEST_F(StudyTest, WhatAConvexBodyCannotShowIsLeftOut) {
  EXPECT_EQ(sectionOf(sphere(), "knowledge"), nullptr);
  EXPECT_EQ(sectionOf(sphere(), "self-occlusion"), nullptr);
  EXPECT_EQ(sphere().planned, sphere().sections.size());
  EXPECT_EQ(sections_done_, sphere().sections.size());
}

}  // namespace
}  // namespace mirrorball
