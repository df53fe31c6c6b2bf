#pragma once

#include <span>
#include <string>

#include "cli/command.h"
#include "cli/scene_inputs.h"
#include "mirrorball/study/study.h"

namespace mirrorball::cli {

/// What `surface --ladder` is told beside its files.
struct LadderOptions {
  bool is_wanted = false;
  SceneRequest scene = {.model = "plane"};
  StudySettings study = {.frame = {.size = {160, 120}, .samples = 64}};
  GivenOptions given = {};  ///< those of the tables below
};

/// Adds --ladder and the options of its pictures.
void addLadder(Command& command, LadderOptions& options);

/// errors   usage: options of the ladder, and none is wanted
Result<void> checkLadder(const LadderOptions& options);

/// Draws a tile by all kinds of relief at three angles, beside the path-traced surface, on one sheet; prints the errors
/// and costs that stand on it.
///
/// input    a height map, or the name of a built-in surface
/// scale    what a height of 1 is, in widths of the tile; 0: the surface's own
/// errors   as studySeries', loadInputs' and savePicture's
Result<void> drawLadder(const std::string& input, float scale, LadderOptions options, const std::string& output);

}  // namespace mirrorball::cli
