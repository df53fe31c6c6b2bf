#pragma once

#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/render/frame/view.h"

namespace mirrorball {

/// What there is to be said of one half.
struct SideStatus {
  bool is_traced = false;  ///< what is shown of it: by paths, not by the renderer
  int samples = 0;         ///< of each pixel of its picture, or paths in the mean
  int wanted_samples = 0;
  int programs_left = 0;    ///< that are still to be made before its next picture
  glm::ivec2 size_px{0};    ///< of its picture: smaller than the window's while something moves
  double sample_s = 0.0;    ///< that its last sample took [s]; 0 of a traced one
  LightCost light = {};     ///< of the renderer's technique
  float noise = 0.0f;       ///< of a traced one: TracedPicture's
  std::string chosen = {};  ///< what its quality filled in: "{option:occlusion} vertex"
};

/// One number that says how far two pictures are apart.
struct ErrorText {
  std::string label;  ///< "PSNR"
  std::string value;  ///< "31.4 dB"
};

/// What lines of status say.
struct ViewerStatus {
  std::string loading = {};            ///< what is loaded; empty: nothing
  double loaded = 0.0;                 ///< how much of it, 0 … 1
  std::vector<SideStatus> sides = {};  ///< one, or in a comparison two
  std::vector<ErrorText> errors = {};  ///< by how much the first differs from the second
  std::string saving = {};             ///< the picture file that is being made; empty: none is
  double saved = 0.0;                  ///< how much of it, 0 … 1
  std::string saved_last = {};         ///< what was written last, or why it could not be; empty: nothing was yet
  std::string remark = {};             ///< what is doubtful about what is shown, one line; empty: nothing is
  std::string problem = {};            ///< why what was asked for is not shown, one line; empty: it is
};

}  // namespace mirrorball
