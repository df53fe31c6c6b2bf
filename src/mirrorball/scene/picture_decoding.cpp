#include "mirrorball/scene/picture_decoding.h"

#include <cstddef>

#include "mirrorball/base/parallel.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

std::vector<Result<Image8>> decodePictures(std::span<const EncodedPicture> pictures) {
  std::vector<Result<Image8>> images(pictures.size());
  parallelFor(pictures.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) images[i] = decodeTexture(pictures[i]);
  });
  return images;
}

}  // namespace mirrorball
