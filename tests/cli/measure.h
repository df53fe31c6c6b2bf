#pragma once

#include <functional>
#include <string>

#include <glm/glm.hpp>

#include "mirrorball/environment/environment.h"
#include "mirrorball/image/image.h"

namespace mirrorball::testing {

/// Which face of the built-in environment `uv` has this colour: "+X" is red, "+Y" green, "+Z" blue, and the negative
/// ones have the complements, cyan, magenta and yellow; "name" is the white of names and marks. How bright it is does
/// not matter, since lines of the grid are darker.
std::string uvFace(glm::vec3 light);

/// The same of the texel at a place of an image: (0, 0) is its upper left corner, (1, 1) the lower right one.
std::string uvFaceAt(const Image& image, glm::vec2 place);

/// How the name of a face of `uv` and its triangle stand in a part of an image that shows this one face.
///
/// upper_left, size   the part, as places of the image
/// returns            "upright"; "mirrored", left and right swapped; "turned" by 180°; "mirrored and turned"; "" for
///                    anything else
std::string orientationOfName(const Image& image, glm::vec2 upper_left = {0, 0}, glm::vec2 size = {1, 1});

/// An environment as a display shows it: the program's default tone map, encoded.
Environment displayed(const Environment& environment);

/// Peak signal-to-noise ratio [dB] of two images of one size, as a display shows them, over the texels that count.
double psnrOnDisplay(const Image& a, const Image& b, const std::function<bool(int x, int y)>& counts);

/// How many texels of a picture are covered wholly, and the mean radiance of those.
struct Contents {
  int texels = 0;
  double mean = 0.0;
};
Contents contentsOf(const Image& picture);

/// Over all samples of two images of one size and kind; infinite where they are not.
double meanDifference(const Image& a, const Image& b);
double maxDifference(const Image& a, const Image& b);

}  // namespace mirrorball::testing
