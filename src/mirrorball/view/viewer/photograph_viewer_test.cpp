// A viewer whose light is a photograph of a mirror ball.

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/left_out_testing.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/photo/unwrap.h"
#include "mirrorball/view/control/gesture.h"
#include "mirrorball/view/viewer/photograph_testing.h"
#include "mirrorball/view/viewer/viewer_testing.h"
#include "mirrorball/view/workspace/arguments.h"
#include "mirrorball/view/workspace/asked_map.h"

namespace mirrorball {
namespace {

using testing::ballBeforeWall;
using testing::BallScene;
using testing::differing;
using testing::finish;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kViewerSize;
using ::testing::Not;
using testing::photographOf;

constexpr glm::ivec2 kPageSize{320, 180};

Workspace mirrorIn(const std::string& map) {
  Workspace workspace;
  workspace.model = "sphere";
  workspace.maps = {map};
  workspace.materials = {{"material", {"mirror"}}};
  workspace.frame = {{"quality", {"draft"}}, {"samples", {"1"}}};
  return workspace;
}

/// The same in a photograph, which is opened like any other file.
Workspace mirrorInPhotograph(const std::string& path) {
  Workspace workspace = withOnlyMap(*withFile(mirrorIn("white"), path), path);
  EXPECT_EQ(workspace.photos.size(), 1u);
  return workspace;
}

/// What `mirrorball photo` writes of it.
std::string unwrapped(const std::string& photograph, const BallPhotoSettings& settings, const char* name) {
  BallLight light = *readBallLight({{photograph}}, settings);
  const FoundBall ball = *ballIn(light, settings);
  const Environment around = unwrapBall({{std::move(light.light), ball.view}})->environment;
  const EnvironmentMap map = *convert(around, Projection::equirect, around.naturalSize(Projection::equirect));
  std::string path = ::testing::TempDir() + name;
  ImageWriteOptions options;
  options.metadata = metadataOf({Projection::equirect});
  EXPECT_TRUE(writeImage(path, map.face(0), options));
  return path;
}

/// A photograph beside its map, as a page of kPageSize shows it.
struct Page {
  explicit Page(const BallScene& scene)
      : place(*mapLayout({}, mapCanvas(kPageSize, scene.size)).photograph),
        scale(float(place.extent.x) / float(scene.size.x)) {}
  glm::vec2 placeOf(glm::dvec2 photograph_px) const {
    return glm::vec2(place.corner) + scale * glm::vec2(photograph_px);
  }
  /// The circle around lines over the photograph.
  Circle circleOf(const std::vector<DrawnLine>& lines) const {
    glm::vec2 low(1e9f), high(-1e9f);
    for (const DrawnLine& line : lines)
      for (const glm::vec2 each : line.places) {
        if (!place.holds(each)) continue;
        low = glm::min(low, each);
        high = glm::max(high, each);
      }
    const glm::vec2 middle = 0.5f * (low + high) - glm::vec2(place.corner);
    return {glm::dvec2(middle / scale), 0.5 * double((high.x - low.x) / scale)};
  }
  PixelRectangle place;
  float scale;
};

void drag(Viewer& viewer, glm::vec2 from_px, glm::vec2 by_px) {
  viewer.handle(PointerPressed{PointerButton::left, from_px});
  for (const float share : {0.25f, 0.5f, 1.0f}) {
    viewer.handle(PointerMoved{from_px + share * by_px});
    ASSERT_TRUE(viewer.advance(0.01));
  }
  viewer.handle(PointerReleased{PointerButton::left});
}

BallPhotoSettings settingsOf(const Viewer& viewer) { return *ballPhotoOf(*askedMap(viewer.workspace(), 0).photo); }

class ViewerPhotographTest : public testing::ViewerTest {};

TEST_F(ViewerPhotographTest, ShowsWhatTheUnwrappedMapShows) {
  MIRRORBALL_NEEDS(testing::checkFormat(ImageFormatId::exr));
  const std::string path = photographOf(ballBeforeWall(), "shown_ball.hdr");
  Viewer viewer(device(), mirrorInPhotograph(path), kViewerSize);
  finish(viewer);
  EXPECT_EQ(viewer.status().problem, "");
  EXPECT_THAT(viewer.status().remark, HasSubstr("infinitely far away"));
  const Image8 seen = *viewer.picture();
  Viewer of_map(device(), mirrorIn(unwrapped(path, {}, "shown_ball.exr")), kViewerSize);
  finish(of_map);
  EXPECT_EQ(differing(seen, *of_map.picture(), 0, kViewerSize.x), 0);
  viewer.history().change("Distance", *withOption(viewer.workspace(), OptionTable::photo, "distance", "8"));
  finish(viewer);
  EXPECT_GT(differing(seen, *viewer.picture(), 0, kViewerSize.x), 50) << "another distance is another map";
  EXPECT_EQ(viewer.status().remark, "");
}

TEST_F(ViewerPhotographTest, ShowsTheBallThatItFindsBesideTheMap) {
  const BallScene scene = ballBeforeWall();
  Workspace workspace = mirrorInPhotograph(photographOf(scene, "found_ball.hdr"));
  workspace.shows_map = true;
  Viewer viewer(device(), workspace, kPageSize);
  finish(viewer);
  const Page page(scene);
  Circle truth{glm::dvec2(scene.size) / 2.0, scene.focal_px / std::sqrt(scene.distance() * scene.distance() - 1.0)};
  const Circle found = page.circleOf(viewer.underPointer().lines);
  EXPECT_LT(glm::distance(found.center_px, truth.center_px), 1.5);
  EXPECT_NEAR(found.radius_px, truth.radius_px, 1.5);
  // The wall beside the ball is seen in the photograph's corner, and no wall beside the photograph.
  const Image8 picture = *viewer.picture();
  const glm::ivec2 corner = page.place.corner;
  EXPECT_GT(int(picture.texel(corner.x + 2, corner.y + 2)[0]), 100);
  EXPECT_LT(int(picture.texel(corner.x + 2, corner.y - 2)[0]), 50);
}

TEST_F(ViewerPhotographTest, ThePointerOverTheBallIsFollowedIntoTheMap) {
  const BallScene scene = ballBeforeWall();
  Workspace workspace = mirrorInPhotograph(photographOf(scene, "pointed_ball.hdr"));
  workspace.shows_map = true;
  workspace.map_view = {{"picture", {"equirect"}}};
  Viewer viewer(device(), workspace, kPageSize);
  finish(viewer);
  const std::size_t outline = viewer.underPointer().lines.size();
  // The middle of a ball reflects its camera, which is in the middle of the panorama.
  const Page page(scene);
  viewer.handle(PointerMoved{page.placeOf(glm::dvec2(scene.size) / 2.0)});
  const UnderPointer under = viewer.underPointer();
  ASSERT_EQ(under.lines.size(), outline + 2) << "a cross";
  const glm::vec2 middle = 0.5f * (under.lines[0].places[0] + under.lines[0].places[1]);
  const auto camera = pixelsOf(*mapViewOf(workspace), mapCanvas(kPageSize, scene.size), {0, 0, 1});
  EXPECT_LT(glm::distance(middle, camera[0]), 3.0f);
  EXPECT_THAT(under.rows, ::testing::Contains(::testing::Field(&InspectionRow::name, "direction")));
  viewer.handle(PointerMoved{glm::vec2(page.place.corner) + 2.0f});
  EXPECT_EQ(viewer.underPointer().lines.size(), outline) << "the wall";
}

TEST_F(ViewerPhotographTest, AHandMovesTheCircleInOneStep) {
  const BallScene scene = ballBeforeWall();
  Workspace start = mirrorInPhotograph(photographOf(scene, "dragged_ball.hdr"));
  start.shows_map = true;
  Viewer viewer(device(), start, kPageSize);
  finish(viewer);
  const Page page(scene);
  const Circle before = page.circleOf(viewer.underPointer().lines);
  drag(viewer, page.placeOf(before.center_px), {10, 6});
  EXPECT_EQ(viewer.history().undoName(), "Move the ball's circle");
  const std::vector<float> moved = settingsOf(viewer).circle;
  ASSERT_EQ(moved.size(), 3u);
  EXPECT_NEAR(moved[0], before.center_px.x + 10.0 / double(page.scale), 1.0);
  EXPECT_NEAR(moved[1], before.center_px.y + 6.0 / double(page.scale), 1.0);
  EXPECT_NEAR(moved[2], before.radius_px, 1.0);
  const Circle drawn = page.circleOf(viewer.underPointer().lines);
  EXPECT_NEAR(drawn.center_px.x, moved[0], 0.5) << "at once, before it is unwrapped again";
  EXPECT_FALSE(viewer.isDone());
  finish(viewer);
  drag(viewer, page.placeOf({moved[0] + moved[2], moved[1]}), {-8, 0});
  EXPECT_EQ(viewer.history().undoName(), "Resize the ball's circle");
  EXPECT_NEAR(settingsOf(viewer).circle[2], moved[2] - 8.0f / page.scale, 0.1);
  EXPECT_EQ(settingsOf(viewer).circle[0], moved[0]);
  finish(viewer);
  EXPECT_TRUE(viewer.history().undo());
  EXPECT_EQ(settingsOf(viewer).circle, moved);
  EXPECT_TRUE(viewer.history().undo());
  EXPECT_EQ(viewer.workspace(), start);
  finish(viewer);
  EXPECT_NEAR(page.circleOf(viewer.underPointer().lines).center_px.x, before.center_px.x, 0.1);
}

TEST_F(ViewerPhotographTest, AWrongCircleIsTakenAsItIs) {
  const BallScene scene = ballBeforeWall();
  Workspace workspace = mirrorInPhotograph(photographOf(scene, "wrong_circle.hdr"));
  workspace.photos.begin()->second = {{"circle", {"60,50,20"}}, {"distance", {"8"}}};
  workspace.shows_map = true;
  Viewer viewer(device(), workspace, kPageSize);
  finish(viewer);
  EXPECT_EQ(viewer.status().problem + viewer.status().remark, "");
  const Circle taken = Page(scene).circleOf(viewer.underPointer().lines);
  EXPECT_NEAR(taken.center_px.x, 60.0, 0.5);
  EXPECT_NEAR(taken.center_px.y, 50.0, 0.5);
  EXPECT_NEAR(taken.radius_px, 20.0, 1.0) << "an ellipse";
}

TEST_F(ViewerPhotographTest, WithoutABallThePictureBeforeStaysAndAHandCanShowTheBall) {
  Viewer viewer(device(), mirrorIn("white"), kPageSize);
  finish(viewer);
  const Image8 before = *viewer.picture();
  const std::string path = testing::photographOfWall("wall.hdr");
  viewer.history().change("Open", *withFile(viewer.workspace(), path));
  finish(viewer);
  EXPECT_THAT(viewer.status().problem, HasSubstr("wall.hdr: no mirror ball is found; drag the circle"));
  EXPECT_THAT(viewer.status().problem, Not(HasSubstr("\n")));
  EXPECT_EQ(differing(*viewer.picture(), before, 0, kPageSize.x), 0);
  viewer.handle(KeyPressed{"M"});
  finish(viewer);
  EXPECT_THAT(viewer.underPointer().lines, Not(IsEmpty())) << "a circle to begin with";
  EXPECT_EQ(viewer.status().problem, "");
  EXPECT_THAT(viewer.status().remark, HasSubstr("no mirror ball is found"));
  drag(viewer, Page(ballBeforeWall()).placeOf({120, 85}), {5, 5});
  viewer.handle(KeyPressed{"M"});
  finish(viewer);
  EXPECT_EQ(viewer.status().problem, "");
  EXPECT_GT(differing(*viewer.picture(), before, 0, kPageSize.x), 100) << "the light of the circle that was given";
}

TEST_F(ViewerPhotographTest, AKeyTakesTheMapForAPhotographAndBack) {
  const std::string path = photographOf(ballBeforeWall(), "key_ball.hdr");
  Viewer viewer(device(), mirrorIn(path), kViewerSize);
  finish(viewer);
  EXPECT_THAT(viewer.status().problem, HasSubstr("key_ball.hdr")) << "its shape is that of no map";
  viewer.handle(KeyPressed{"B"});
  finish(viewer);
  EXPECT_EQ(viewer.status().problem, "");
  EXPECT_TRUE(viewer.hasPicture());
  viewer.handle(KeyPressed{"B"});
  EXPECT_EQ(viewer.workspace(), mirrorIn(path));
}

// The second of the commands that renderCommandLine says reads the file that the first one writes.
TEST_F(ViewerPhotographTest, ASavedPictureIsThatOfTheUnwrappedMap) {
  MIRRORBALL_NEEDS(testing::checkFormat(ImageFormatId::exr));
  const std::string path = photographOf(ballBeforeWall(), "saved_ball.hdr");
  Workspace workspace = mirrorInPhotograph(path);
  workspace.photos.begin()->second = {{"distance", {"8"}}};
  BallPhotoSettings settings;
  settings.distance = 8.0f;
  const Workspace of_map = mirrorIn(unwrapped(path, settings, "saved_ball_unwrapped.exr"));
  EXPECT_THAT(*renderCommandLine(workspace, 0),
              HasSubstr("mirrorball photo " + path + " --distance=8 -o " + of_map.maps[0] +
                        " && mirrorball render sphere -e " + of_map.maps[0]));
  for (const bool is_traced : {false, true}) {
    std::vector<Image> saved;
    for (Workspace each : {workspace, of_map}) {
      if (is_traced) each = withTruth(each);
      const std::string file = ::testing::TempDir() + "saved_in_photograph.exr";
      const auto made =
          makePicture(each, {.path = file, .size_px = {48, 32}, .side = is_traced ? 1u : 0u}, true, {}, {});
      ASSERT_TRUE(made) << made.error().message;
      saved.push_back(readImage(file)->image);
    }
    EXPECT_TRUE(std::equal(saved[0].samples().begin(), saved[0].samples().end(), saved[1].samples().begin()))
        << (is_traced ? "traced" : "drawn");
  }
}

TEST_F(ViewerPhotographTest, TheSavedPageIsWhatIsSeen) {
  Workspace workspace = mirrorInPhotograph(photographOf(ballBeforeWall(), "page_ball.hdr"));
  workspace.shows_map = true;
  Viewer viewer(device(), workspace, kPageSize);
  finish(viewer);
  const std::string file = ::testing::TempDir() + "page_of_photograph.png";
  ASSERT_TRUE(makePicture(workspace, {.path = file, .size_px = kPageSize}, true, {}, {}));
  const Image8 saved = pictureFromLinear(readImage(file)->image, 3);
  EXPECT_EQ(differing(saved, *viewer.picture(), 0, kPageSize.x), 0);
}

// A ball that is not found is one whose circle is given.
TEST_F(ViewerPhotographTest, OfOneWithoutABallThereIsAPictureOnceItsCircleIsGiven) {
  const std::string wall = testing::photographOfWall("thumbnail_of_wall.hdr");
  Workspace workspace = mirrorIn("white");
  workspace.maps.push_back(wall);
  workspace.photos[wall] = {};
  Viewer viewer(device(), workspace, kViewerSize);
  finish(viewer);
  ASSERT_EQ(viewer.thumbnails().at(1).texture, 0u);
  workspace.photos[wall] = {{"circle", {"120,85,60"}}};
  viewer.history().change("Circle", workspace);
  finish(viewer);
  EXPECT_NE(viewer.thumbnails().at(1).texture, 0u);
}

}  // namespace
}  // namespace mirrorball
