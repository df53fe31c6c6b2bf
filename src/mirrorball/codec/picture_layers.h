#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/option.h"

namespace mirrorball {

/// --layer, of what reads pictures (ImageReadOptions::layer); of maps, --from names it.
OptionText layerText(std::string_view group = {});

/// What is unusual in a picture's file (DecodedImage::oddities); how to take another layer, where it was guessed.
///
/// way   "{option:layer} NAME"
std::vector<std::string> withOtherLayer(std::vector<std::string> oddities, bool is_layer_guessed,
                                        std::string_view way = "{option:layer} NAME");

}  // namespace mirrorball
