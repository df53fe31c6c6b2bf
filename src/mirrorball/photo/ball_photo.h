#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/option.h"
#include "mirrorball/base/result.h"
#include "mirrorball/codec/exif.h"
#include "mirrorball/photo/find_ball.h"
#include "mirrorball/photo/response.h"

namespace mirrorball {

// The photographs of one side of a mirror ball, from their files to the ball in them: what comes before unwrapBall.

/// What is said of the photographs of one side.
struct BallPhotoSettings {
  std::vector<float> circle = {};  ///< centre and radius of a Circle [pixels]; empty: the ball is searched for
  float distance = 0.0f;           ///< Perspective's; 0: unknown
  float fov_deg = 0.0f;            ///< vertical, of the whole photograph; 0: unknown
  std::string exposures = {};      ///< of a series [s], "1/60,1/15,0.25"; empty: from EXIF
  int response = 0;                ///< 0: recovered, or sRGB of a single photograph; else ResponseKind + 1
  std::string layer = {};          ///< of files of several pictures, the one to read; empty: the picture

  bool operator==(const BallPhotoSettings&) const = default;
};

/// The table of these settings.
std::span<const Option<BallPhotoSettings>> ballPhotoOptions();

/// What can be told before anything is read.
///
/// errors   usage: distance and field of view are both given, or the camera stands in the ball
Result<void> checkBallPhoto(const BallPhotoSettings& settings);

/// The light of one side, and what there is to be said of it.
struct BallLight {
  Image light;                            ///< MergedPhotographs'
  std::string name;                       ///< of the first photograph
  Exif exif = {};                         ///< of the one with the middle exposure
  std::string told = {};                  ///< "one photograph, response assumed sRGB"
  std::vector<std::string> remarks = {};  ///< what is odd about the files, light that was not recorded, photographs
                                          ///< that contradict the others
  std::optional<Response> curve = {};     ///< the camera's, if this series has shown it
};

/// Reads and merges a series, or a single photograph.
///
/// files    at least one
/// known    the camera's response that another series has shown; for a single photograph of which none is given
/// errors   usage (times that cannot be read); too_large (all photographs together, and their light); as
///          readPhotograph's and mergePhotographs'
Result<BallLight> readBallLight(std::span<const std::string> files, const BallPhotoSettings& settings,
                                const std::optional<Response>& known = {});

/// What is known about the camera: by the settings, else by the photograph's EXIF.
///
/// size   of the photograph [pixels]
Perspective perspectiveOf(const BallPhotoSettings& settings, const Exif& exif, glm::ivec2 size);

/// The ball as it is given, or as it is found.
///
/// errors   as ballOfCircle's of a circle that is given; else findBall's, with the photograph's name
/// cost     that of findBall, or none
Result<FoundBall> ballIn(const BallLight& photographed, const BallPhotoSettings& settings);

/// "two.jpg: this circle may not be the ball's (confidence 50 %; the next likely one is about 450,150,113)"; empty
/// where it is sure.
///
/// name   of the photograph
std::string doubtAbout(const FoundBall& ball, const std::string& name);

}  // namespace mirrorball
