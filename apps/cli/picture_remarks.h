#pragma once

#include <string>

#include "cli/terminal.h"
#include "mirrorball/codec/picture_layers.h"

namespace mirrorball::cli {

/// Reports what is unusual in a picture's file, and how to read another of its layers.
///
/// name     of the file
/// picture  as it was read: a DecodedImage or a Decoded
template <typename Picture>
void remarkOnPicture(const std::string& name, const Picture& picture) {
  for (const std::string& oddity : withOtherLayer(picture.oddities, picture.layer_guess)) remark(name + ": " + oddity);
}

}  // namespace mirrorball::cli
