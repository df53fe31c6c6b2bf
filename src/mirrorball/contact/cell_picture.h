#pragma once

#include <string>
#include <vector>

#include "mirrorball/base/observer.h"
#include "mirrorball/contact/contact_settings.h"
#include "mirrorball/environment/file/load.h"

namespace mirrorball {

/// The picture of an input, and what is known of it.
struct CellPicture {
  Image8 picture;                       ///< 3 channels, encoded
  std::string facts = {};               ///< a few words
  std::vector<std::string> files = {};  ///< that were read
  std::vector<std::string> notes = {};  ///< what is unusual about it, a line each, which begins with its name
};

/// loadEnvironment, where texels that are not finite get the mean of their neighbours.
///
/// notes    gets a line about those
/// errors   as loadEnvironment's, but for non_finite where some texels are finite
Result<LoadedEnvironment> loadRepaired(const std::string& input, const EnvironmentLoadOptions& options,
                                       std::vector<std::string>& notes, const ProgressFunction& progress = {});

/// The picture of a map: an equirectangular panorama, whatever projection the map has. A large panorama is read by
/// rows.
///
/// width_px  of the panorama, which is half as high, rounded down; at least 2
/// facts     size and projection in the file, and the exposure: "2048x1024 equirect, +1.3 EV"
/// errors    as loadEnvironment's and convert's
/// cost      reading and converting the map: some 15 ns a texel on one core
Result<CellPicture> mapCellPicture(const std::string& input, int width_px, const ContactSettings& settings,
                                   const Observer& observer, const ProgressFunction& progress);

}  // namespace mirrorball
