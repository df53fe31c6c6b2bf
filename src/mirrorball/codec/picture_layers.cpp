#include "mirrorball/codec/picture_layers.h"

namespace mirrorball {

OptionText layerText(std::string_view group) {
  return {.name = "layer",
          .value = "NAME",
          .help =
              "which picture of an OpenEXR file of several is read; without it, the one that the names of its layers "
              "tell, which `info` lists",
          .group = group};
}

std::vector<std::string> withOtherLayer(std::vector<std::string> oddities, bool is_layer_guessed,
                                        std::string_view way) {
  if (is_layer_guessed && !oddities.empty()) oddities.front() += "; " + std::string(way) + " takes another";
  return oddities;
}

}  // namespace mirrorball
