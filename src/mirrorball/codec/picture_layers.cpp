#include "mirrorball/codec/picture_layers.h"

#include <algorithm>

namespace mirrorball {

OptionText layerText(std::string_view group) {
  return {.name = "layer",
          .value = "NAME",
          .help =
              "which picture of an OpenEXR file of several is read; without it, the one that the names of its layers "
              "tell, which `info` lists",
          .group = group};
}

std::vector<std::string> withOtherLayer(std::vector<std::string> oddities, const std::string& layer_guess,
                                        std::string_view way) {
  const auto guess = std::find(oddities.begin(), oddities.end(), layer_guess);
  if (!layer_guess.empty() && guess != oddities.end()) *guess += "; " + std::string(way) + " takes another";
  return oddities;
}

}  // namespace mirrorball
