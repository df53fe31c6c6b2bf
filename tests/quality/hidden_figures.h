#pragma once

#include <filesystem>
#include <string>

#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"
#include "quality/hidden_scenes.h"
#include "quality/number_table.h"

namespace mirrorball::quality {

// How near each quality draws the scenes of hidden_scenes.h to their references, which are kept as files: the pictures
// in tests/quality/references, all numbers in text tables.

/// How far a picture is from its reference.
struct PictureError {
  double flip = 0.0;  ///< LDR-FLIP
  double rmse = 0.0;  ///< of the sRGB-encoded values
};

/// A picture, and what the program printed about it.
struct MadePicture {
  Image image;
  std::string printed;
};

/// Renders a scene with `--dither none`, its file and the picture in the temporary folder for as long as it takes.
///
/// how      "--quality good"
/// errors   io: the program failed (with what it printed)
Result<MadePicture> makePicture(const HiddenScene& scene, const std::string& how);

/// errors   bad_shape
Result<PictureError> findError(const Image& picture, const Image& reference);

/// tests/quality/references/NAME.png
std::filesystem::path referencePath(const std::string& name);

/// errors   not_found; as decodeImage's
Result<Image> readReference(const std::string& name);

/// The standard error that the path tracer printed: "standard error at most 0.0031 of white".
///
/// errors   bad_file
Result<double> parseNoise(const std::string& printed);

/// The options that trace a reference.
std::string tracedBy(int paths);

/// A row for each scene: paths of a pixel and noise of the reference, then FLIP and RMSE of `--reference --bounces 1`.
inline constexpr std::size_t kReferenceColumns = 4;
inline constexpr std::size_t kPathsColumn = 0, kNoiseColumn = 1;
inline constexpr double kNotMeasured = -1.0;
std::filesystem::path referenceTablePath();

/// A row for each scene: FLIP and RMSE of draft, of good and of best.
inline constexpr std::size_t kFigureColumns = 6;
inline constexpr std::size_t kGoodFlip = 2, kGoodRmse = 3;  ///< among them
std::filesystem::path figureTablePath();
/// The figures before the first change of a technique, which stay.
std::filesystem::path firstFigureTablePath();

}  // namespace mirrorball::quality
