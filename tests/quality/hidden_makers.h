#pragma once

#include "mirrorball/scene/scene.h"

namespace mirrorball::quality {

// The makers of the scenes in hidden_scenes.cpp, by what they are about.

// hidden_fine.cpp: meshes of so many triangles that few rays of a fixed number are left for a vertex.

/// Two balls of 100 000 triangles each, one of matt plaster and one of rough metal, on a floor of 100 000.
Scene fineBalls();
/// 121 balls of 100 000 triangles each in a square, hanging before a wall.
Scene gridOfFineBalls();
/// 121 balls of 3 000 triangles each in a square before a wall: rougher from left to right, metal in the upper half.
Scene gridOfBalls();
/// A floor of 200 000 triangles, on which three boxes of twelve stand.
Scene fineFloor();
/// A knot of 200 000 triangles over two large ones.
Scene fineKnot();

// hidden_sheets.cpp: surfaces without thickness, and large triangles with something near them.

/// A sheet with a front only, a half cylinder open towards +Z that stands on a board, and a ball in it. Its front is
/// outside, so that it is not seen from the open side.
Scene sheetFacingOutwards();
/// That half cylinder with its front inside.
Scene sheetFacingInwards();
/// A level sheet with a front only over a board, with its front above.
Scene sheetFacingUp();
/// That sheet with its front below.
Scene sheetFacingDown();
/// A hemisphere whose front is outside, over a floor, with a ball under it.
Scene dome();
/// Cards whose distance from a board of two triangles is 1 % of its width.
Scene cardsNearBoard();
/// Cards whose distance from a board of two triangles is 5 % of its width.
Scene cardsOverBoard();
/// A wall and a floor of panels of two triangles each, with a post, a ball and a shelf near them.
Scene panels();
/// Twelve triangles: five inner walls of a box that is open in front, and a lamp under its ceiling.
Scene roomOfTwelve();
/// Those with a ball and a box between them.
Scene furnishedRoom();
/// A post and a table on a floor of two triangles.
Scene postOnFloor();

// hidden_rough.cpp: rough surfaces that hide each other.

/// A vase of rough metal whose neck lies between two flanges.
Scene neck();
/// A cylinder of rough metal with deep grooves all around.
Scene grooves();
/// A corner of three plates of rough metal with a box in it.
Scene roughCorner();
/// Nine boards in a row, like books, a finger apart.
Scene rowOfNeighbours();
/// Seven bars of rough metal in a row, a finger apart.
Scene rowOfBars();
/// A dark plastic housing, open in front, with parts inside.
Scene housing();
/// A wide pipe of rough metal, seen from its end.
Scene pipe();
/// A matt sheet in narrow zigzag folds.
Scene zigzag();

// hidden_materials.cpp: thin glass, coats, cloth, print, and what is nearly alone.

/// A thin glass vessel, open above, around a candle with its flame.
Scene vesselWithFlame();
/// The same vessel as a sheet of glass that does not bend light.
Scene sheetVesselWithFlame();
/// A thin glass vessel before a striped board, with a stick in it.
Scene vesselBeforeStripes();
/// One white triangle of rough metal, which is glTF's material where a file has none.
Scene plainTriangle();
/// One white triangle of plastic.
Scene dielectricTriangle();
Scene dielectricBallSmooth();    ///< of perceptual roughness 0
Scene dielectricBallGlossy();    ///< 0.3
Scene dielectricBallRough();     ///< 0.6
Scene dielectricBallRoughest();  ///< 1
/// A dark table under a clear coat whose normal map has ripples.
Scene rippledCoat();
/// A ball with a base of red metal under such a coat.
Scene rippledBall();
/// A curtain with a strong sheen in deep folds.
Scene sheenFolds();
/// Cloth with a sheen laid in a pile of waves, of which half are turned away from the light.
Scene sheenWaves();
/// A board with small print, seen from the front.
Scene print();
/// The same on a table, seen at a slant.
Scene slantedPrint();

}  // namespace mirrorball::quality
