#pragma once

#include <span>
#include <string>

namespace mirrorball {

/// How much a layer is like the picture, by its name: the first there is of these is the picture.
enum class ExrLayerRank {
  plain,       ///< R G B without a name, what OpenEXR itself reads as the image
  picture,     ///< a name by which a program calls its picture: "rgba", "ViewLayer.Combined", "C"
  plain_grey,  ///< Y without a name
  variant,     ///< a name with such a word: "Beauty_denoised", "RGBA_key", "RGB color"
  unknown,     ///< any other name
  light,       ///< a share of the picture's light: "diffuse", "GlossDir", "Emit"
  aid,         ///< weights, and colours of surfaces: "AO", "albedo", "mask"
  numbers,     ///< numbers in channels of colours: "Normal.R", "crypto_object00.r", "depth.Y"
};

/// A rank, and the order among names of it, less first.
struct ExrNameRank {
  ExrLayerRank rank = ExrLayerRank::numbers;
  int order = 0;
};

/// The rank of a layer of colours.
///
/// words    its name at the dots, without those that name a view; the last decides
ExrNameRank exrNameRank(std::span<const std::string> words);

}  // namespace mirrorball
