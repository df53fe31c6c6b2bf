#include "mirrorball/scene/mesh_file/mtl.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/mesh_file/named_file.h"
#include "mirrorball/scene/mesh_file/number_text.h"
#include "mirrorball/scene/mesh_file/obj_statements.h"

namespace mirrorball {
namespace {

/// A statement of one number.
struct MtlNumber {
  std::string_view keyword;
  std::optional<float> MtlMaterial::*number;
};
constexpr MtlNumber kMtlNumbers[] = {
    {"ns", &MtlMaterial::exponent},
    {"ni", &MtlMaterial::ior},
    {"d", &MtlMaterial::dissolve},
    {"tr", &MtlMaterial::transparency},
    {"illum", &MtlMaterial::illumination},
    {"pr", &MtlMaterial::roughness},
    {"pm", &MtlMaterial::metallic},
    {"ps", &MtlMaterial::sheen},
    {"pc", &MtlMaterial::coat},
    {"pcr", &MtlMaterial::coat_roughness},
    {"aniso", &MtlMaterial::anisotropy},
    {"anisor", &MtlMaterial::anisotropy_turns},
};

/// A statement of a colour.
struct MtlColor {
  std::string_view keyword;
  std::optional<glm::vec3> MtlMaterial::*color;
};
constexpr MtlColor kMtlColors[] = {
    {"kd", &MtlMaterial::diffuse}, {"ks", &MtlMaterial::specular}, {"ke", &MtlMaterial::emission}};

/// A statement of a picture.
struct MtlPicture {
  std::string_view keyword;
  MtlMapKind kind;
};
constexpr MtlPicture kMtlPictures[] = {
    {"map_kd", MtlMapKind::base_color}, {"map_ke", MtlMapKind::emission},     {"map_emissive", MtlMapKind::emission},
    {"map_d", MtlMapKind::opacity},     {"map_opacity", MtlMapKind::opacity}, {"map_pr", MtlMapKind::roughness},
    {"map_pm", MtlMapKind::metallic},   {"bump", MtlMapKind::heights},        {"map_bump", MtlMapKind::heights},
    {"norm", MtlMapKind::normals},      {"map_norm", MtlMapKind::normals},    {"map_kn", MtlMapKind::normals},
    {"map_ao", MtlMapKind::occlusion},
};

/// What changes what is seen, and is not read.
constexpr std::string_view kMtlLeftOut[] = {"map_ks",   "map_ns", "map_tr", "map_ps",   "map_pc", "map_pcr",
                                            "map_refl", "refl",   "disp",   "map_disp", "decal",  "map_aniso"};

/// The options of pictures: how many words follow at most; -s and -o may have fewer.
struct MtlOption {
  std::string_view name;
  std::size_t words;
};
constexpr MtlOption kMtlOptions[] = {{"-s", 3},      {"-o", 3},      {"-t", 3},    {"-mm", 2},        {"-bm", 1},
                                     {"-boost", 1},  {"-texres", 1}, {"-type", 1}, {"-clamp", 1},     {"-imfchan", 1},
                                     {"-blendu", 1}, {"-blendv", 1}, {"-cc", 1},   {"-colorspace", 1}};

const MtlOption* optionNamed(std::string_view word) {
  const std::string name = lowerCase(word);
  for (const MtlOption& option : kMtlOptions)
    if (name == option.name) return &option;
  return nullptr;
}

/// Up to three numbers, as many as there are.
///
/// leaves_word   the last word of the text is a file's name, whatever it looks like
std::vector<float> takeVector(std::string_view& rest, bool leaves_word) {
  std::vector<float> numbers;
  while (numbers.size() < 3) {
    std::string_view after = rest;
    const NumberText number = readNumber(takeWord(after));
    if (number.kind != NumberText::Kind::plain || (leaves_word && after.empty())) break;
    numbers.push_back(static_cast<float>(std::clamp(number.value, -1e6, 1e6)));
    rest = after;
  }
  return numbers;
}

void takeOption(const MtlOption& option, std::string_view& rest, bool leaves_word, MtlMap& map) {
  if (option.words == 3) {
    const std::vector<float> numbers = takeVector(rest, leaves_word);
    if (option.name == "-t" || numbers.empty()) return;  // turbulence is of procedural textures
    glm::vec2& vector = option.name == "-s" ? map.scale : map.offset;
    vector.x = numbers[0];
    if (numbers.size() > 1) vector.y = numbers[1];
    return;
  }
  const std::string word = lowerCase(takeWord(rest));
  const double number = readNumber(word).value;
  if (option.name == "-clamp") map.is_clamped = word == "on";
  if (option.name == "-imfchan") map.channel = word.empty() ? '\0' : word[0];
  if (option.name == "-bm" && std::isfinite(number)) map.strength = static_cast<float>(std::clamp(number, -1e3, 1e3));
  if (option.name == "-mm") {
    const double gain = readNumber(takeWord(rest)).value;
    map.has_other_range = number != 0.0 || gain != 1.0;
  }
}

/// Takes the options with which a text begins.
void takeOptions(std::string_view& rest, bool leaves_word, MtlMap& map) {
  while (true) {
    std::string_view after = rest;
    const MtlOption* const option = optionNamed(takeWord(after));
    if (option == nullptr || after.empty()) return;
    takeOption(*option, rest = after, leaves_word, map);
  }
}

/// A picture with its options, which the format has before the name; some programs write them behind it.
MtlMap readMap(std::string_view line) {
  MtlMap map;
  takeOptions(line, true, map);
  std::string_view name = line;
  for (std::string_view rest = line; !rest.empty();) {
    std::string_view options = rest;
    if (optionNamed(takeWord(rest)) == nullptr || rest.empty()) continue;
    name = line.substr(0, line.size() - options.size());
    takeOptions(options, false, map);
    break;
  }
  map.readings = readingsOfName(name);
  if (name.size() < line.size())  // or else it is a part of the name
    for (std::string& whole : readingsOfName(line)) map.readings.push_back(std::move(whole));
  return map;
}

/// "r g b", or "r" for a grey.
std::optional<glm::vec3> readColor(std::string_view rest, NumberReader& numbers, std::size_t line) {
  glm::vec3 color(0.0f);
  for (int channel = 0; channel < 3; ++channel) {
    const bool is_grey = channel > 0 && (rest.empty() || rest.starts_with('#'));
    color[channel] =
        is_grey ? color[0] : static_cast<float>(std::clamp(numbers.read(takeWord(rest), line).value, -1e6, 1e6));
    if (std::isnan(color[channel])) return {};
  }
  return color;
}

class MtlReader {
 public:
  explicit MtlReader(std::string_view text) : statements_(text) {}

  std::vector<MtlMaterial> read(std::vector<std::string>& remarks) {
    while (statements_.next()) {
      if (statements_.keyword() == "newmtl")
        materials_.emplace_back().name = statements_.rest();
      else if (!materials_.empty())
        readStatement(materials_.back());
    }
    for (std::string& remark : numbers_.remarks()) remarks.push_back(std::move(remark));
    return std::move(materials_);
  }

 private:
  void readStatement(MtlMaterial& material) {
    const std::string& keyword = statements_.keyword();
    std::string_view rest = statements_.rest();
    for (const MtlPicture& picture : kMtlPictures)
      if (keyword == picture.keyword) material.maps[std::size_t(picture.kind)] = readMap(rest);
    if (keyword == "map_ka") material.ambient = readMap(rest);
    for (const std::string_view left_out : kMtlLeftOut)
      if (keyword == left_out && !rest.empty()) material.left_out.push_back(keyword);
    for (const MtlColor& color : kMtlColors)
      if (keyword == color.keyword && !namesSpectrum(rest))
        if (const auto read = readColor(rest, numbers_, statements_.line())) material.*color.color = read;
    for (const MtlNumber& number : kMtlNumbers) {
      if (keyword != number.keyword) continue;
      if (lowerCase(rest.substr(0, 5)) == "-halo") takeWord(rest);  // of d: less at the silhouette, which is not done
      const double read = numbers_.read(takeWord(rest), statements_.line()).value;
      if (std::isfinite(read)) material.*number.number = static_cast<float>(std::clamp(read, -1e6, 1e6));
    }
  }

  /// Whether a colour is not red, green and blue: "spectral FILE", "xyz x y z".
  static bool namesSpectrum(std::string_view rest) {
    const std::string word = lowerCase(takeWord(rest));
    return word == "spectral" || word == "xyz";
  }

  StatementReader statements_;
  NumberReader numbers_;
  std::vector<MtlMaterial> materials_;
};

}  // namespace

std::vector<MtlMaterial> readMtl(std::string_view text, std::vector<std::string>& remarks) {
  return MtlReader(text).read(remarks);
}

}  // namespace mirrorball
