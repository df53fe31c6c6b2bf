#pragma once

#include <string>

#include "mirrorball/base/result.h"
#include "mirrorball/study/study.h"

namespace mirrorball {

/// What a page says of itself.
struct PageText {
  std::string title;         ///< "sphere in room.hdr"
  std::string made_by = {};  ///< how it was made: a command line; optional
};

/// A study as one HTML page: pictures to flip between by keys and buttons, heat maps, tables and plots. It holds all
/// that it shows, and asks for nothing from the network.
///
/// returns  UTF-8; the same for the same study
/// errors   as encodePicture's, of a PNG
/// cost     some 0.07 MB a picture of 256 × 256, of which a study has four a technique and shot
Result<std::string> pageOf(const Study& study, const PageText& text);

}  // namespace mirrorball
