#include "mirrorball/scene/picture_decoding.h"

#include <cstddef>

#include "mirrorball/base/parallel.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

namespace {

Result<Image8> decodeWithin(MemoryBudget& budget, EncodedPicture picture) {
  MemoryShare share(budget);
  MIRRORBALL_TRY(image, decodeTexture(picture));
  MIRRORBALL_TRY_VOID(share.keep(image.samples().size_bytes()));
  return image;
}

}  // namespace

std::vector<Result<Image8>> decodePictures(std::span<const EncodedPicture> pictures, MemoryBudget& budget) {
  std::vector<Result<Image8>> images(pictures.size());
  parallelFor(pictures.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) images[i] = decodeWithin(budget, pictures[i]);
  });
  return images;
}

}  // namespace mirrorball
