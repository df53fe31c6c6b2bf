#include "mirrorball/scene/mesh_file/named_pictures.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "mirrorball/base/text.h"
#include "mirrorball/height_field/slopes.h"
#include "mirrorball/image/resize.h"
#include "mirrorball/scene/material/lost_textures.h"
#include "mirrorball/scene/picture_decoding.h"

namespace mirrorball {
namespace {

constexpr float kHeightOfBumps = 0.01f;  // texture widths; what Material::height_scale is by itself

/// The transform of a .mtl, where v grows upwards: u' = s u + o. With v downwards, 1 − v' = s (1 − v) + o.
TextureSlot transformed(const MtlMap& map, int texture) {
  TextureSlot slot;
  slot.texture = texture;
  slot.scale = map.scale;
  slot.offset = {map.offset.x, 1.0f - map.scale.y - map.offset.y};
  return slot;
}

/// Rec. 709's luma.
float luma(glm::vec4 texel) { return 0.2126f * texel.r + 0.7152f * texel.g + 0.0722f * texel.b; }

float pickOpacity(glm::vec4 texel, char channel, bool has_alpha) {
  switch (channel) {
    case 'r':
      return texel.r;
    case 'g':
      return texel.g;
    case 'b':
      return texel.b;
    case 'm':
      return texel.a;
    default:  // as it is by itself
      return has_alpha && channel != 'l' ? texel.a : luma(texel);
  }
}

bool hasAlpha(const SharedPicture& picture) {
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      if (picture.at(x, y).a < 1.0f) return true;
  return false;
}

std::uint8_t toCode(float fraction) {
  return static_cast<std::uint8_t>(std::clamp(fraction, 0.0f, 1.0f) * 255.0f + 0.5f);
}

void setAlpha(SharedPicture& picture, int x, int y, float alpha) {
  if (picture.hasNumbers())
    picture.editNumbers().texel(x, y)[3] = alpha;
  else
    picture.edit().texel(x, y)[3] = toCode(alpha);
}

/// Brings a picture to a size that is not smaller, in its own codes, as a texture's filter does where it is near.
///
/// errors   too_large
Result<void> enlarge(SharedPicture& picture, glm::ivec2 size, MemoryBudget& budget) {
  if (size == glm::ivec2(picture.width(), picture.height())) return {};
  MIRRORBALL_TRY_VOID(
      budget.take(std::uint64_t{4} * sizeof(float) * static_cast<unsigned>(size.x) * static_cast<unsigned>(size.y)));
  Image numbers = resized(picture.hasNumbers() ? picture.numbers() : fractionsFromCodes(picture.codes()), size);
  if (picture.hasNumbers()) {
    picture = std::move(numbers);
    return {};
  }
  Image8 codes(size.x, size.y, 4, 0);
  std::transform(numbers.samples().begin(), numbers.samples().end(), codes.samples().begin(), toCode);
  picture = std::move(codes);
  return {};
}

}  // namespace

TextureSlot NamedPictures::colors(const MtlMap& map, TextureUse use) {
  return add(map, use == TextureUse::light ? Reading::light : Reading::colors);
}

TextureSlot NamedPictures::colorsWithOpacity(const MtlMap& colors, const MtlMap& opacity) {
  return add(colors, Reading::colors, &opacity);
}

TextureSlot NamedPictures::factors(const MtlMap& map) { return add(map, Reading::factors); }

TextureSlot NamedPictures::normals(const MtlMap& map) { return add(map, Reading::normals); }

TextureSlot NamedPictures::heights(const MtlMap& map) { return add(map, Reading::heights); }

void NamedPictures::warn(const MtlMap& map, const std::string& what) {
  std::string warning = "'" + excerpt(map.readings[0]) + "': " + what;
  if (told_.insert(warning).second) scene_.warnings.push_back(std::move(warning));
}

std::span<const std::uint8_t> NamedPictures::read(const MtlMap& map) {
  if (!map) return {};
  const auto [known, is_new] = read_.try_emplace(map.readings);
  if (!is_new) return known->second;
  const auto file = named_.read(map.readings);
  if (file)
    known->second = file->bytes;
  else
    scene_.warnings.push_back(file.error().message + "; the material goes without it");
  return known->second;
}

TextureSlot NamedPictures::add(const MtlMap& map, Reading reading, const MtlMap* opacity) {
  const std::span<const std::uint8_t> bytes = read(map);
  const std::span<const std::uint8_t> of_opacity = opacity != nullptr ? read(*opacity) : bytes.first(0);
  if (bytes.empty() && of_opacity.empty()) return {};
  // Without colours the opacities' own transform counts.
  const MtlMap& placed = bytes.empty() ? *opacity : map;
  if (!bytes.empty() && !of_opacity.empty() && (map.scale != opacity->scale || map.offset != opacity->offset))
    warn(*opacity, "is placed by other -s and -o than the colours, and is shown where those are");
  const Key key(bytes.data(), of_opacity.data(), reading, placed.is_clamped,
                reading == Reading::heights ? map.strength : 0.0f, opacity != nullptr ? opacity->channel : '\0');
  const auto [found, is_first] = textures_.try_emplace(key, static_cast<int>(scene_.textures.size()));
  if (is_first) {
    pending_.push_back({reading, &placed, of_opacity.empty() ? nullptr : opacity, bytes, of_opacity});
    Texture& texture = scene_.textures.emplace_back();
    texture.srgb = reading == Reading::colors || reading == Reading::light;
    if (placed.is_clamped) texture.wrap_s = texture.wrap_t = Wrap::clamp_to_edge;
  }
  return transformed(placed, found->second);
}

void NamedPictures::decode() {
  std::vector<EncodedPicture> encoded;
  std::vector<const MtlMap*> maps;  // of each
  const auto plan = [&](const MtlMap& map, std::span<const std::uint8_t> bytes, ReadAs as) {
    encoded.push_back({bytes, as});
    maps.push_back(&map);
  };
  for (const Pending& each : pending_) {
    const bool shows_colors = each.reading == Reading::colors || each.reading == Reading::light;
    if (!each.bytes.empty()) plan(*each.map, each.bytes, shows_colors ? ReadAs::light : ReadAs::numbers);
    if (each.opacity != nullptr) plan(*each.opacity, each.opacity_bytes, ReadAs::numbers);
  }
  const auto remark = [&](std::size_t picture, const std::string& oddity) { warn(*maps[picture], oddity); };
  std::vector<Result<Decoded<Texels>>> decoded = decodePictures(encoded, named_.files().budget(), {}, remark);
  auto next = decoded.begin();
  const auto nextTexels = [&]() -> Result<Texels> {
    MIRRORBALL_TRY(read, std::move(*next++));
    return std::move(read.picture);
  };
  std::vector<bool> is_lost;
  for (std::size_t i = 0; i < pending_.size(); ++i) {
    const Pending& each = pending_[i];
    Result<Texels> texels = each.bytes.empty() ? Result<Texels>(Image8(1, 1, 4, 255)) : nextTexels();
    std::optional<Result<Texels>> opacity;
    if (each.opacity != nullptr) opacity = nextTexels();
    const auto filled = fill(each, std::move(texels), opacity ? &*opacity : nullptr, scene_.textures[i]);
    if (!filled) warn(*each.map, filled.error().message + "; the material goes without it");
    is_lost.push_back(!filled);
  }
  leaveOutTextures(scene_, is_lost);
}

Result<void> NamedPictures::fill(Pending pending, Result<Texels> texels, Result<Texels>* opacity, Texture& texture) {
  TextureUse use = TextureUse::factors;
  if (pending.reading == Reading::light) use = TextureUse::light;
  if (pending.reading == Reading::normals) use = TextureUse::normals;
  if (!texels && opacity != nullptr && *opacity) {
    warn(*pending.map, texels.error().message + "; the material goes without it");
    texels = Image8(1, 1, 4, 255);
    pending.bytes = {};
  }
  MIRRORBALL_TRY(read, std::move(texels));
  MIRRORBALL_TRY(changes, setTexels(std::move(read), use, texture));
  for (const std::string& change : changes) warn(*pending.map, change);
  if (pending.reading == Reading::heights) return fillFromHeights(*pending.map, texture);
  if (opacity == nullptr) return {};
  const auto added = *opacity ? addOpacity(pending, std::move(**opacity), texture)
                              : Result<void>(tl::unexpected<Error>(opacity->error()));
  if (!added) warn(*pending.opacity, added.error().message + "; the material goes without it");
  return {};
}

Result<void> NamedPictures::fillFromHeights(const MtlMap& map, Texture& texture) {
  if (looksLikeNormals(texture.image)) {
    warn(map, "holds unit vectors, as normals are and heights are not: it is read as a normal map");
    return {};
  }
  if (!isGrey(texture.image))
    warn(map, "has colours, though no normals: its luma is read as heights (for normals: norm FILE)");
  const SharedPicture& picture = texture.image;
  Image heights(picture.width(), picture.height(), 1);
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) *heights.texel(x, y) = luma(picture.at(x, y));
  MIRRORBALL_TRY_VOID(named_.files().budget().take(std::uint64_t{4} * sizeof(float) * heights.texelCount()));
  MIRRORBALL_TRY(normals, normalsFromHeights(heights, {.edges = map.is_clamped ? MapEdges::clamped : MapEdges::tiled,
                                                       .scale = kHeightOfBumps * map.strength}));
  Image texels(normals.width(), normals.height(), 4, 1.0f);
  for (int y = 0; y < normals.height(); ++y)
    for (int x = 0; x < normals.width(); ++x) std::copy_n(normals.texel(x, y), 3, texels.texel(x, y));
  texture.image = std::move(texels);
  return {};
}

Result<void> NamedPictures::addOpacity(const Pending& pending, Texels texels, Texture& texture) {
  Texture opacities;
  MIRRORBALL_TRY(changes, setTexels(std::move(texels), TextureUse::factors, opacities));
  for (const std::string& change : changes) warn(*pending.opacity, change);
  const SharedPicture& alpha = opacities.image;
  const bool has_alpha = hasAlpha(alpha);
  // A picture of colours that is named a second time has its opacity in its alpha, if in anything.
  if (pending.bytes.data() == pending.opacity_bytes.data() && !has_alpha) return {};
  if (pending.bytes.empty()) {
    MIRRORBALL_TRY_VOID(named_.files().budget().take(std::uint64_t{4} * alpha.texelCount()));
    texture.image = Image8(alpha.width(), alpha.height(), 4, 255);
  }
  SharedPicture& shown = texture.image;
  const glm::ivec2 larger(std::max(shown.width(), alpha.width()), std::max(shown.height(), alpha.height()));
  MIRRORBALL_TRY_VOID(enlarge(shown, larger, named_.files().budget()));
  for (int y = 0; y < shown.height(); ++y)
    for (int x = 0; x < shown.width(); ++x) {
      const auto at = [](int place, int size, int of) { return int((2LL * place + 1) * of / (2LL * size)); };
      const glm::vec4 texel = alpha.at(at(x, shown.width(), alpha.width()), at(y, shown.height(), alpha.height()));
      setAlpha(shown, x, y, pickOpacity(texel, pending.opacity->channel, has_alpha));
    }
  return {};
}

AlphaMode chooseAlphaMode(const SharedPicture& picture) {
  constexpr float kNear = 8.0f / 255.0f;
  std::size_t between = 0, below = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const float alpha = picture.at(x, y).a;
      below += alpha < 1.0f ? 1 : 0;
      between += alpha > kNear && alpha < 1.0f - kNear ? 1 : 0;
    }
  if (below == 0) return AlphaMode::opaque;
  return 10 * between <= picture.texelCount() ? AlphaMode::mask : AlphaMode::blend;
}

}  // namespace mirrorball
