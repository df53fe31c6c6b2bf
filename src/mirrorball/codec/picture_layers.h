#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/option.h"

namespace mirrorball {

/// --layer, of what reads pictures (ImageReadOptions::layer); of maps, --from names it.
OptionText layerText(std::string_view group = {});

/// What is unusual in a picture's file (DecodedImage::oddities), with how to take another layer where it was guessed.
///
/// layer_guess   DecodedImage's
/// way           "{option:layer} NAME"
std::vector<std::string> withOtherLayer(std::vector<std::string> oddities, const std::string& layer_guess,
                                        std::string_view way = "{option:layer} NAME");

}  // namespace mirrorball
