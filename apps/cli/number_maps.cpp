#include "cli/number_maps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "cli/files.h"
#include "cli/picture_remarks.h"
#include "cli/terminal.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/scene/material/texture_numbers.h"

namespace mirrorball::cli {

Result<ImageFormatId> numberFormat(const std::string& output) {
  MIRRORBALL_TRY(format, formatToWrite(output, {Holds::light, Holds::picture, Holds::texture}));
  if (format == ImageFormatId::hdr || format == ImageFormatId::jpeg)
    return fail(ErrorCode::usage, output + ": that format changes the numbers of a map; name it .exr or .png");
  MIRRORBALL_TRY_VOID(checkFolder(output));
  return format;
}

void flipGreen(Image& normals) {
  const auto channels = std::size_t(normals.channels());
  for (std::size_t i = 1; i < normals.samples().size(); i += channels) normals.samples()[i] = -normals.samples()[i];
}

Result<Image> readNormals(const std::string& input, std::span<const std::uint8_t> bytes, const std::string& layer) {
  MIRRORBALL_TRY(read, decodeDataTexture(bytes, {.layer = layer, .progress = progressBar("reading " + shown(input))}));
  remarkOnPicture(input, read);
  Texture texture;
  MIRRORBALL_TRY(changes, setTexels(std::move(read.picture), TextureUse::normals, texture));
  if (isGrey(texture.image))
    return fail(ErrorCode::bad_shape, "is grey, where a normal map has three channels; heights of heights need no map");
  for (const std::string& change : changes) remark(input + ": " + change);
  const float zero = findNormalZero(texture.image);
  if (zero == 128.0f) remark(input + ": the most frequent texel is 128 128 255, which is taken as flat");
  return decodedNormals(texture.image, zero);
}

Image8 pictureOf(const MadeMap& map, const std::string& output) {
  const Image& numbers = map.images.at(0, 0);
  Image8 picture = Image8::withoutValues(numbers.width(), numbers.height(), numbers.channels());
  std::size_t clipped = 0;
  std::ranges::transform(numbers.samples(), picture.samples().begin(), [&](float number) {
    const float share = map.is_signed ? 0.5f + 0.5f * number : number;
    constexpr float kRounding = 1e-5f;
    if (share < -kRounding || share > 1.0f + kRounding) ++clipped;
    return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(share, 0.0f, 1.0f)));
  });
  if (clipped > 0)
    remark(output + ": " + countedAre(clipped, "number") + " beyond what .png holds, of " +
           std::to_string(numbers.samples().size()) +
           ", and became its least or greatest; .exr holds them, or a smaller --scale");
  return picture;
}

Result<void> writeNumbers(const MadeMap& map, const std::string& output) {
  MIRRORBALL_TRY(format, numberFormat(output));
  if (format == ImageFormatId::png)
    MIRRORBALL_TRY_VOID(savePicture(output, pictureOf(map, output)));
  else if (format == ImageFormatId::exr)
    MIRRORBALL_TRY_VOID(writeImage(output, map.images.at(0, 0)));
  else
    MIRRORBALL_TRY_VOID(writeImageSet(
        output, map.images, {.format = TexelFormat::float32, .progress = progressBar("writing " + shown(output))}));
  announce(output);
  return {};
}

}  // namespace mirrorball::cli
