#pragma once

#include <string>
#include <string_view>

#include "mirrorball/environment/file/load.h"

namespace mirrorball {

/// What the readers of a cube's faces, from six files, a texture or one picture, have in common.

/// Counts texels that are NaN or infinite, and refuses them unless the options say what to do.
///
/// errors   non_finite
Result<NonFinite> checkNonFinite(const Image& image, const EnvironmentLoadOptions& options);

/// Mends each image of a map, so that nothing from beside a face in its picture gets in.
///
/// errors   non_finite
Result<void> repairImages(ImageSet& images);

/// Counts another image's bad texels in.
void add(const NonFinite& more, NonFinite& total);

/// What speaks against a picture's or six images' being a cube.
inline constexpr std::string_view kFacesJump = "its faces do not meet at their edges";
inline constexpr std::string_view kCellsAreFilled = "light fills the cells that a cross leaves empty";

/// The remark on a cube that may be a photograph.
///
/// reason   one of these
FormDoubt makeCubeDoubt(const Recognition& recognition, std::string_view reason);

/// A cube whose six images are there.
///
/// is_numbered  as possibleArrangements has it
/// errors       bad_shape: another projection is named; non_finite
Result<LoadedEnvironment> cubeFromImages(ImageSet images, std::string format, std::string color, Metadata metadata,
                                         Recognition recognition, const NonFinite& bad,
                                         const EnvironmentLoadOptions& options, bool is_numbered = false);

}  // namespace mirrorball
