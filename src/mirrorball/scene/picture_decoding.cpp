#include "mirrorball/scene/picture_decoding.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <numeric>
#include <utility>
#include <variant>

#include "mirrorball/base/parallel.h"

namespace mirrorball {

namespace {

Result<Decoded<Texels>> decodeWithin(MemoryBudget& budget, const EncodedPicture& picture,
                                     std::vector<std::string>& oddities) {
  MemoryShare share(budget);
  MIRRORBALL_TRY(read,
                 picture.as == ReadAs::light ? decodeColorTexture(picture.bytes) : decodeDataTexture(picture.bytes));
  const auto bytesOf = [](const auto& texels) { return texels.samples().size_bytes(); };
  MIRRORBALL_TRY_VOID(share.keep(std::visit(bytesOf, read.picture)));
  oddities = std::exchange(read.oddities, {});
  return read;
}

}  // namespace

std::vector<Result<Decoded<Texels>>> decodePictures(std::span<const EncodedPicture> pictures, MemoryBudget& budget,
                                                    const ProgressFunction& progress, const PictureRemark& remark) {
  std::vector<Result<Decoded<Texels>>> images(pictures.size());
  std::vector<std::vector<std::string>> oddities(pictures.size());
  // The largest first, so that at the end no processor is left alone with one.
  std::vector<std::size_t> order(pictures.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return pictures[a].bytes.size() > pictures[b].bytes.size(); });
  std::size_t bytes = 0;
  for (const EncodedPicture& picture : pictures) bytes += picture.bytes.size();
  ProgressCounter counter(progress, bytes);
  std::atomic<std::size_t> next = 0;
  parallelFor(order.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (; begin < end; ++begin) {
      const std::size_t i = order[next++];
      if (const Result<void> goes_on = counter.result(); !goes_on) {
        images[i] = tl::unexpected<Error>(goes_on.error());
        continue;
      }
      images[i] = decodeWithin(budget, pictures[i], oddities[i]);
      counter.advance(pictures[i].bytes.size());
    }
  });
  for (std::size_t i = 0; remark && i < pictures.size(); ++i)
    for (const std::string& oddity : oddities[i]) remark(i, oddity);
  return images;
}

}  // namespace mirrorball
