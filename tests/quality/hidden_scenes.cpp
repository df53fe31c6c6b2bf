#include "quality/hidden_scenes.h"

#include <algorithm>
#include <array>

#include "quality/hidden_makers.h"

namespace mirrorball::quality {
namespace {

// None is taken out: each shows a fault that there was.
constexpr auto kHiddenScenes = std::to_array<HiddenScene>({
    {"fine_balls", fineBalls, "-e studio --camera 20,12,0.95 --target 0.05,0.6,0", true},
    {"fine_grid", gridOfFineBalls, "-e studio --camera 0,0"},
    {"ball_grid", gridOfBalls, "-e studio --camera 0,0"},
    {"fine_floor", fineFloor, "-e sky:sun=0 --exposure 1 --camera 30,35,1.3 --target 0,0.2,0"},
    {"fine_knot", fineKnot, "-e studio --camera 20,20,1.3 --target 0,0,0"},
    {"sheet_closed", sheetFacingOutwards, "-e studio --camera 150,25"},
    {"sheet_open", sheetFacingOutwards, "-e studio --camera 10,25"},
    {"sheet_inside", sheetFacingInwards, "-e studio --camera 10,25"},
    {"sheet_through", sheetFacingInwards, "-e studio --camera 150,25"},
    {"sheet_up", sheetFacingUp, "-e studio --camera 30,12"},
    {"sheet_down", sheetFacingDown, "-e studio --camera 30,45", true},
    {"dome_inside", dome, "-e studio --camera 20,30,0.4 --target 0,0.2,0 --fov 80"},
    {"cards_1", cardsNearBoard, "-e studio --camera 20,45"},
    {"cards_5", cardsOverBoard, "-e studio --camera 20,45", true},
    {"panels", panels, "-e studio --camera 20,15", true},
    {"room_of_twelve", roomOfTwelve, "-e studio --env-intensity 0.5 --camera 0,0,1.9"},
    {"furnished_room", furnishedRoom, "-e studio --env-intensity 0.5 --camera 0,0,1.9", true},
    {"post", postOnFloor, "-e studio --camera 25,30"},
    {"neck", neck, "-e studio --camera 20,12,1.9 --target 0,0.8,0", true},
    {"grooves", grooves, "-e studio --camera 20,15,1.9 --target 0,0.75,0"},
    {"rough_corner", roughCorner, "-e studio --camera 40,25"},
    {"row", rowOfNeighbours, "-e studio --camera 50,30,1.7 --target 0,0.5,0", true},
    {"bars", rowOfBars, "-e studio --camera 50,30,1.7 --target 0,0.5,0"},
    {"housing", housing, "-e studio --camera 15,15,1.8 --target 0,0.6,0", true},
    {"pipe", pipe, "-e studio --camera 20,55"},
    {"zigzag", zigzag, "-e studio --camera 15,25,1.8 --target 0,0.6,0"},
    {"vessel_flame", vesselWithFlame, "-e studio --env-intensity 0.15 --camera 20,15,2.1 --target 0,0.65,0", true},
    {"sheet_flame", sheetVesselWithFlame, "-e studio --env-intensity 0.15 --camera 20,15,2.1 --target 0,0.65,0"},
    {"vessel_stripes", vesselBeforeStripes, "-e studio --camera 20,15,1.3 --target 0,0.7,0"},
    {"triangle", plainTriangle, "-e studio --camera 0,0"},
    {"triangle_dielectric", dielectricTriangle, "-e studio --camera 60,10", true},
    {"dielectric_0", dielectricBallSmooth, "-e studio"},
    {"dielectric_3", dielectricBallGlossy, "-e studio"},
    {"dielectric_6", dielectricBallRough, "-e studio"},
    {"dielectric_10", dielectricBallRoughest, "-e studio"},
    {"rippled_coat", rippledCoat, "-e studio --camera 20,25,1.6 --target 0,0.3,0", true},
    {"rippled_ball", rippledBall, "-e studio --camera 20,15,1.8 --target 0,0.75,0"},
    {"sheen_folds", sheenFolds, "-e studio --camera 30,10,1.8 --target 0,0.9,0"},
    {"sheen_waves", sheenWaves, "-e studio --camera 20,20,1.7 --target 0,0.5,0", true},
    {"print", print, "-e studio --camera 10,5,1.3"},
    {"print_slanted", slantedPrint, "-e studio --camera 30,25,1.1", true},
});

}  // namespace

std::span<const HiddenScene> hiddenScenes() { return kHiddenScenes; }

const HiddenScene& hiddenSceneNamed(std::string_view name) {
  return *std::find_if(kHiddenScenes.begin(), kHiddenScenes.end(),
                       [&](const auto& scene) { return scene.name == name; });
}

std::string shownBy(const HiddenScene& scene, const std::string& how) {
  return std::string(scene.shown) + " --size " + kHiddenSize + " " + how;
}

}  // namespace mirrorball::quality
