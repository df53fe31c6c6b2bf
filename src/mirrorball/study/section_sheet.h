#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/image/image.h"
#include "mirrorball/study/study.h"

namespace mirrorball {

/// What there is to say of one technique in one shot, a few words each.
///
/// compared_to  the technique whose cost is 1; one of the shot's, drawn
/// returns      name, PSNR, a sample's time, and that as a multiple: "bump", "24.10 dB", "1.62 ms", "1.00 x bump"
std::vector<std::string> wordsOf(const StudiedPicture& picture, const StudiedShot& shot, std::string_view compared_to);

/// All pictures of a section: a row for each shot, a column for each technique, and the path-traced reference last.
/// Under each stands what wordsOf says.
///
/// section      with at least one shot; its pictures are drawn, and of one size
/// compared_to  as of wordsOf
/// returns      3 channels, encoded
Image8 sectionSheet(const StudiedSection& section, std::string_view compared_to);

}  // namespace mirrorball
