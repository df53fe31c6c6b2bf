#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "golden/cases.h"
#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"

namespace mirrorball::golden {

/// Whether MIRRORBALL_UPDATE_GOLDEN=1 asks for new golden pictures instead of a comparison with the old ones.
bool isUpdating();

/// tests/golden/pictures/NAME.png
std::filesystem::path goldenPath(const std::string& name);

/// The golden picture in that file, with 4 channels.
///
/// errors   not_found, with what to do; whatever readFile and decodeTexture say
Result<Image8> readGolden(const std::filesystem::path& path);

/// Holds a picture against the golden one in that file. Where they differ, or where there is no golden one, the answer
/// says by how much and names the contact sheet to look at.
///
/// path     of a folder `pictures` beside its test, whose label is that folder's name
/// failures the folder for contact sheets, made when it is needed; one left there by an earlier run is removed
::testing::AssertionResult matchesGolden(const std::filesystem::path& path, const Image8& now,
                                         const Tolerance& tolerance, const std::filesystem::path& failures);

}  // namespace mirrorball::golden
