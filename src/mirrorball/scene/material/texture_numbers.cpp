#include "mirrorball/scene/material/texture_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include <glm/glm.hpp>

#include "formula/surface.h"
#include "mirrorball/image/neutral_code.h"

namespace mirrorball {
namespace {

constexpr float kGltfZero = 127.5f;
constexpr float kNeutralCode = 128.0f;
constexpr float kSignedZero = 0.0f;
constexpr float kGreatestHalf = 65504.0f;  // that a texture of half floats holds

glm::vec3 normalAt(const Image& numbers, std::size_t texel, float zero) {
  const float* const number = numbers.samples().data() + 4 * texel;
  return formula::decodedNormal(glm::vec3(number[0], number[1], number[2]), zero);
}

/// The sum over the texels of what a cost says of the normal that they are with this zero. Texels that have no
/// direction with one of the two zeros, as what lies beside the charts of a map, do not count.
template <typename Cost>
double sumOfCosts(const Image& numbers, float zero, const Cost& cost) {
  constexpr float kShortest = 0.05f;
  double sum = 0.0;
  for (std::size_t texel = 0; texel < numbers.texelCount(); ++texel)
    if (glm::length(normalAt(numbers, texel, kSignedZero)) > kShortest &&
        glm::length(normalAt(numbers, texel, kGltfZero)) > kShortest)
      sum += cost(normalAt(numbers, texel, zero));
  return sum;
}

/// Whether some number is below 0 by more than filters ring.
bool hasNegative(const Image& numbers) {
  constexpr float kRinging = -0.01f;
  for (std::size_t i = 0; i < numbers.samples().size(); ++i)
    if (i % 4 != 3 && numbers.samples()[i] < kRinging) return true;
  return false;
}

/// Whether the numbers are codes of 16 bits, which are never signed: all are multiples of 1/65535, and not 0 and 1
/// alone.
bool areCodes(const Image& numbers) {
  constexpr float kGreatest = 65535.0f, kRounding = 0.01f;
  bool has_others = false;
  for (const float number : numbers.samples()) {
    const float code = kGreatest * number;
    if (std::abs(code - std::round(code)) > kRounding) return false;
    has_others = has_others || (number != 0.0f && number != 1.0f);
  }
  return has_others;
}

/// That of the two zeros of floats with which they are likelier to be normals: at which the cost of them is less.
template <typename Cost>
float likelierZero(const Image& numbers, const Cost& cost) {
  if (hasNegative(numbers)) return kSignedZero;
  if (areCodes(numbers)) return kGltfZero;
  return sumOfCosts(numbers, kSignedZero, cost) < sumOfCosts(numbers, kGltfZero, cost) ? kSignedZero : kGltfZero;
}

bool hasBlue(const Image& numbers) {
  for (std::size_t i = 2; i < numbers.samples().size(); i += 4)
    if (numbers.samples()[i] != 0.0f) return true;
  return false;
}

/// Gives normals of which a file keeps x and y alone their z.
void addBlue(Image& numbers) {
  const auto square = [](glm::vec3 n) { return n.x * n.x + n.y * n.y; };
  const float zero = likelierZero(numbers, [&](glm::vec3 n) { return std::max(double(square(n)) - 1.0, 0.0); });
  for (std::size_t texel = 0; texel < numbers.texelCount(); ++texel) {
    const float z = std::sqrt(std::max(1.0f - square(normalAt(numbers, texel, zero)), 0.0f));
    numbers.samples()[4 * texel + 2] = formula::encodedNormal(glm::vec3(z), zero).z;
  }
}

bool clampAll(Image& numbers, float greatest) {
  bool was_outside = false;
  for (float& number : numbers.samples()) {
    const float clamped = std::clamp(number, 0.0f, greatest);
    was_outside = was_outside || clamped != number;
    number = clamped;
  }
  return was_outside;
}

/// Makes floats fit for a texture.
///
/// returns  what was changed
/// errors   non_finite
Result<std::vector<std::string>> fit(Image& numbers, TextureUse use) {
  std::vector<std::string> changes;
  if (const NonFinite bad = findNonFinite(numbers); bad.count > 0) {
    MIRRORBALL_TRY_VOID(repairNonFinite(numbers));
    changes.push_back("has numbers that are not finite (" + textOf(bad) + "), for which their neighbours' mean stands");
  }
  if (use == TextureUse::normals) {
    if (hasBlue(numbers)) return changes;
    addBlue(numbers);
    changes.emplace_back("has no blue, which is taken to be that of normals of length 1");
    return changes;
  }
  const bool is_light = use == TextureUse::light;
  if (clampAll(numbers, is_light ? kGreatestHalf : 1.0f))
    changes.emplace_back(is_light ? "has light outside of 0 to 65504, to which it is cut"
                                  : "has numbers outside of 0 to 1, to which they are cut");
  return changes;
}

}  // namespace

TextureUse useOf(const MaterialMap& map) {
  if (map.holdsNormals()) return TextureUse::normals;
  return map.slot == &Material::emission_map ? TextureUse::light : TextureUse::factors;
}

Result<std::vector<std::string>> setTexels(Texels texels, TextureUse use, Texture& texture) {
  std::vector<std::string> changes;
  if (auto* numbers = std::get_if<Image>(&texels)) {
    MIRRORBALL_TRY(made, fit(*numbers, use));
    changes = std::move(made);
    texture.srgb = false;
  }
  texture.image = SharedPicture(std::move(texels));
  if (use == TextureUse::normals && isGrey(texture.image))
    changes.emplace_back("is grey, as heights are and normals are not (for heights: height=FILE)");
  return changes;
}

bool isGrey(const SharedPicture& picture) {
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      if (const glm::vec4 texel = picture.at(x, y); texel.x != texel.y || texel.y != texel.z) return false;
  return true;
}

bool looksLikeNormals(const SharedPicture& picture) {
  constexpr float kLeastColor = 16.0f / 255.0f, kLengthError = 0.1f, kLeastZ = 0.5f;
  const float zero = findNormalZero(picture);
  std::size_t with_color = 0, normals = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const glm::vec3 texel(picture.at(x, y));
      const auto [least, greatest] = std::minmax({texel.x, texel.y, texel.z});
      if (greatest - least < kLeastColor) continue;
      ++with_color;
      const glm::vec3 normal = formula::decodedNormal(texel, zero);
      normals += std::abs(glm::length(normal) - 1.0f) < kLengthError && normal.z > kLeastZ ? 1 : 0;
    }
  return 2 * normals > with_color;
}

Image decodedNormals(const SharedPicture& map, float zero) {
  Image normals = Image::withoutValues(map.width(), map.height(), 3);
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x) {
      const glm::vec3 normal = formula::decodedNormal(glm::vec3(map.at(x, y)), zero);
      std::copy_n(&normal.x, 3, normals.texel(x, y));
    }
  return normals;
}

float findNormalZero(const SharedPicture& map) {
  if (map.empty()) return kGltfZero;
  constexpr NeutralChannels kOfNormals{.first = 0, .second = 1, .greatest = 2};
  const bool is_flat_at_128 =
      map.hasNumbers() ? isNeutralAt128(map.numbers(), kOfNormals) : isNeutralAt128(map.codes(), kOfNormals);
  if (is_flat_at_128) return kNeutralCode;
  if (!map.hasNumbers()) return kGltfZero;
  return likelierZero(map.numbers(), [](glm::vec3 n) { return std::abs(double(glm::length(n)) - 1.0); });
}

void findNormalZeros(Scene& scene, const std::string& name, const MaterialMap* only) {
  std::map<int, float> zeros;
  for (Material& material : scene.materials)
    for (const MaterialMap& map : materialMaps()) {
      const int texture = (material.*map.slot).texture;
      if (!map.holdsNormals() || texture < 0 || (only != nullptr && map.slot != only->slot)) continue;
      const auto [zero, is_new] = zeros.try_emplace(texture, 0.0f);
      if (is_new) zero->second = findNormalZero(scene.textures[std::size_t(texture)].image);
      material.*map.zero = zero->second;
    }
  const auto count =
      std::count_if(zeros.begin(), zeros.end(), [](const auto& each) { return each.second == kNeutralCode; });
  if (count == 0) return;
  const std::string of_maps = count == 1 ? "a normal map" : std::to_string(count) + " normal maps";
  scene.warnings.push_back(name + ": the most frequent texel of " + of_maps +
                           " is 128 128 255, which is taken as flat; glTF's rule would tilt it by 0.3 degrees "
                           "(normal_zero=127.5)");
}

}  // namespace mirrorball
