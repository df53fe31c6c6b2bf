#include "mirrorball/codec/ldr/coded_file.h"

#include <algorithm>
#include <utility>

#include "mirrorball/base/memory.h"
#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/image/upright.h"

namespace mirrorball {
namespace {

int channelsOf(const CodedPicture& picture) {
  return std::visit([](const auto& codes) { return codes.channels(); }, picture);
}

/// Whether codes of 8 bits can hold the light: what is beyond them by less than half a code is rounding.
bool fitsCodes(const Image& light) {
  constexpr float kLeast = -0.5f / 255.0f / 12.92f;
  constexpr float kMost = 1.0f + 0.5f / 255.0f;
  return std::all_of(light.samples().begin(), light.samples().end(),
                     [](float sample) { return sample >= kLeast && sample <= kMost; });
}

void tellUnreadProfile(CodedFile& file) {
  if (std::string remark = unreadProfileRemark(file.color); !remark.empty()) file.oddities.push_back(std::move(remark));
}

/// What a texture takes while floats are made of it [bytes]: its codes, floats with as many channels and with alpha,
/// and the codes of 8 bits that are made of those.
std::uint64_t bytesToConvert(const CodedPicture& picture) {
  return std::visit(
      [](const auto& codes) {
        const auto channels = static_cast<std::uint64_t>(codes.channels());
        const std::uint64_t of_light = (channels == 4 ? 0 : channels) + 4;
        return std::uint64_t{codes.samples().size_bytes()} +
               std::uint64_t{codes.texelCount()} * (sizeof(float) * of_light + 4);
      },
      picture);
}

/// As ReadAs::numbers.
DecodedImage makeNumbers(CodedFile file) {
  tellUnapplied(statedSpace(file.color, channelsOf(file.codes)), file.oddities);
  DecodedImage image{sharesOf(file.codes), std::move(file.metadata), std::move(file.format), std::string(kAsStored)};
  image.oddities = std::move(file.oddities);
  return image;
}

/// The remark on colours that are not sRGB's as they stand.
void tellColor(CodedFile& file) {
  tellUnreadProfile(file);
  if (!isSrgb(file.color))
    file.oddities.push_back("its colours are not sRGB's: " + describeColor(file.color, channelsOf(file.codes)));
}

}  // namespace

std::string unreadProfileRemark(const CodedColor& color) {
  const std::string& name = color.unread_profile;
  if (name.empty() || name.starts_with("sRGB")) return {};
  return "has an ICC profile (" + name + ") without a matrix and one curve, which is not applied: taken as sRGB";
}

std::string uprightRemark(int orientation, const std::string& source) {
  if (orientation <= 1 || orientation > 8) return {};
  return "turned upright, as its " + source + " says (orientation " + std::to_string(orientation) + ")";
}

void turnUpright(CodedFile& file) {
  std::string remark = uprightRemark(file.orientation, file.orientation_source);
  if (remark.empty()) return;
  file.oddities.push_back(std::move(remark));
  std::visit([&](auto& codes) { codes = upright(std::move(codes), file.orientation); }, file.codes);
  file.orientation = 1;
}

DecodedImage asImage(CodedFile file, ReadAs as) {
  turnUpright(file);
  if (as == ReadAs::numbers) return makeNumbers(std::move(file));
  tellUnreadProfile(file);
  Image light = lightOf(file.codes, file.color);
  std::string color = describeColor(file.color, light.channels());
  DecodedImage image{std::move(light), std::move(file.metadata), std::move(file.format), std::move(color)};
  image.oddities = std::move(file.oddities);
  image.is_converted = true;
  return image;
}

Result<Decoded<Texels>> asTexels(CodedFile file, ReadAs as) {
  turnUpright(file);
  const bool are_bytes = std::holds_alternative<Image8>(file.codes);
  if (as == ReadAs::numbers) {
    tellUnapplied(statedSpace(file.color, channelsOf(file.codes)), file.oddities);
    if (!are_bytes) MIRRORBALL_TRY_VOID(checkMemory(bytesToConvert(file.codes)));
    Texels texels = are_bytes ? Texels(textureOf(std::move(file.codes))) : Texels(withAlpha(sharesOf(file.codes)));
    return Decoded<Texels>{std::move(texels), std::move(file.oddities)};
  }
  tellColor(file);
  if (isSrgb(file.color))
    return Decoded<Texels>{.picture = Texels(textureOf(std::move(file.codes))),
                           .oddities = std::move(file.oddities),
                           .is_converted = !are_bytes};
  MIRRORBALL_TRY_VOID(checkMemory(bytesToConvert(file.codes)));
  Image light = withAlpha(lightOf(file.codes, file.color));
  Texels texels = fitsCodes(light) ? Texels(pictureFromLinear(light, 4)) : Texels(std::move(light));
  return Decoded<Texels>{.picture = std::move(texels), .oddities = std::move(file.oddities), .is_converted = true};
}

PictureCodes asCodes(CodedFile file) {
  turnUpright(file);
  tellColor(file);
  return {textureOf(std::move(file.codes)), std::move(file.color), file.exif, std::move(file.oddities)};
}

PictureFractions asFractions(CodedFile file) {
  turnUpright(file);
  tellColor(file);
  return {sharesOf(file.codes), std::move(file.color), file.exif, std::move(file.oddities)};
}

Image withAlpha(Image image) {
  if (image.channels() == 4) return image;
  Image rgba = Image::withoutValues(image.width(), image.height(), 4);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const glm::vec4 texel = rgbaAt(image, x, y);
      std::copy_n(&texel.x, 4, rgba.texel(x, y));
    }
  return rgba;
}

}  // namespace mirrorball
