#pragma once

#include <cstddef>
#include <optional>
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
  int programs_left = 0;             ///< that are still to be made before its next picture
  glm::ivec2 size_px{0};             ///< of its picture: smaller than the window's while something moves
  double sample_s = 0.0;             ///< that its last sample took [s]; 0 of a traced one
  std::optional<double> gpu_s = {};  ///< of it, by the GPU's clock; nothing: that is not known
  LightCost light = {};              ///< of the renderer's technique
  float noise = 0.0f;                ///< of a traced one: TracedPicture's
  std::string chosen = {};           ///< what its quality filled in: "{option:occlusion} vertex"
};

/// One number that says how far two pictures are apart.
struct ErrorText {
  std::string label;  ///< "PSNR"
  std::string value;  ///< "31.4 dB"
};

/// The animations that a model has of its own.
struct AnimationStatus {
  std::vector<std::string> names = {};    ///< empty: it has none
  std::optional<std::size_t> shown = {};  ///< of these; nothing: the model is at rest
  float seconds = 0.0f;                   ///< the moment that is shown
  float length_s = 0.0f;                  ///< of the one that is shown
  bool plays = false;
};

/// One of the panoramas that there are to choose among.
struct MapThumbnail {
  std::string name;       ///< as Workspace::maps has it
  bool is_shown = false;  ///< in the half that is edited
  unsigned texture = 0;   ///< OpenGL's name of a small picture; row 0 is its bottom. 0: there is none yet, or it cannot
                          ///< be loaded
  glm::ivec2 size_px{0};
};

/// What lines of status say.
struct ViewerStatus {
  AnimationStatus animation = {};
  std::string loading = {};            ///< what is loaded; empty: nothing
  double loaded = 0.0;                 ///< how much of it, 0 … 1
  std::vector<SideStatus> sides = {};  ///< one, or in a comparison two
  std::vector<ErrorText> errors = {};  ///< by how much the first differs from the second
  std::string saving = {};             ///< the picture file that is being made; empty: none is
  double saved = 0.0;                  ///< how much of it, 0 … 1
  std::string saved_last = {};         ///< what was just written, or why it could not be; empty: nothing was
  std::string remark = {};             ///< what is doubtful about what is shown, one line; empty: nothing is
  std::string problem = {};            ///< why what was asked for is not shown, one line; empty: it is
};

}  // namespace mirrorball
