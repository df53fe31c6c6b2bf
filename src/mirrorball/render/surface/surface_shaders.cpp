#include "mirrorball/render/surface/surface_shaders.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mirrorball/light_edit/sun_split.h"
#include "mirrorball/render/surface/map_sources.h"
#include "shaders/embedded_text.h"

namespace mirrorball {
namespace {

constexpr std::string_view kMapsFile = "material_maps.glsl";  // made here

constexpr std::array<std::string_view, 3> kWraps{"kWrapRepeat", "kWrapMirroredRepeat", "kWrapClampToEdge"};  // by Wrap

/// What a row's function returns that has a texture, and the uniforms for it.
struct MapReading {
  std::string uniforms;
  std::string expression;
};

/// What one sample of a pixel sees of what the pixel does, as GLSL's two expressions.
std::string ofSample(const std::string& across, const std::string& down) {
  const std::string part = "inversesqrt(samples_per_pixel) * ";
  return part + across + ", " + part + down;
}

/// What a sample reads: all samples together see the pixel.
///
/// coordinates   of the texture, as GLSL's expression
/// changes       of the coordinates over what is seen, as GLSL's two expressions; empty: the next pixels are compared
MapReading mapReading(std::span<const MapSource> sources, std::size_t row, const std::string& coordinates,
                      const std::string& changes) {
  const std::string name(materialMaps()[row].name);
  const std::string sampler(samplerName(sources, row));
  const MapSource& source = sources[row];
  if (source.layer < 0)
    return {name == sampler ? "uniform sampler2D " + name + ";\n" : "",
            changes.empty() ? "texture(" + sampler + ", " + coordinates + ", sampleLod())"
                            : "textureGrad(" + sampler + ", " + coordinates + ", " + changes + ")"};
  const auto flag = [](bool value) { return value ? std::string("true") : std::string("false"); };
  const auto wrap = [](Wrap mode) { return std::string(kWraps[static_cast<std::size_t>(mode)]); };
  const std::string layer = std::to_string(source.layer) + ", " + name + "_extent, " + flag(source.srgb);
  const std::string sampling = wrap(source.wrap_s) + ", " + wrap(source.wrap_t) + ", " + flag(source.nearest);
  return {"uniform vec3 " + name + "_extent;\n",
          "layerAt(MapLayer(" + layer + "), MapSampling(" + sampling + "), " + coordinates + ", " +
              (changes.empty() ? ofSample("dFdx(" + coordinates + ")", "dFdy(" + coordinates + ")") : changes) + ")"};
}

/// What a sample of a pixel sees of the mesh's coordinates: of normal maps as their spread is worked out, and where
/// heights move the coordinates.
std::string changesOfMesh(const SurfaceVariant& variant, std::size_t row) {
  if (variant.has(Part::point, PointPart::raster) && !materialMaps()[row].holdsNormals()) return "";
  const std::string arguments = "(point, " + std::to_string(row) + ")";
  return ofSample("mapAcross" + arguments, "mapDown" + arguments);
}

/// Of a normal map, without the alpha that the picture had.
MapReading withoutSpread(MapReading reading) {
  reading.expression = "vec4((" + reading.expression + ").xyz, 1.0)";
  return reading;
}

/// The row of the map whose coordinates may be generated.
bool isPicture(std::size_t row) { return materialMaps()[row].slot == &Material::base_color_map; }

/// What a row's function returns where the material has no texture.
std::string absentValue(std::size_t row) {
  const glm::vec4 absent = materialMaps()[row].absent;
  return "vec4(" + std::to_string(absent.x) + ", " + std::to_string(absent.y) + ", " + std::to_string(absent.z) + ", " +
         std::to_string(absent.w) + ")";
}

/// What a row's function returns that has a texture, with the coordinates that the frame chooses.
MapReading chosenReading(const SurfaceVariant& variant, std::size_t row) {
  const std::string of_mesh = "mapCoordinates(point, " + std::to_string(row) + ")";
  const PictureFrom from = variant.coordinates.picture_from;
  if (!isPicture(row) || from == PictureFrom::mesh) {
    const MapReading reading = mapReading(variant.maps, row, of_mesh, changesOfMesh(variant, row));
    return materialMaps()[row].holdsNormals() && !variant.maps[row].has_spread ? withoutSpread(reading) : reading;
  }
  const std::string generated =
      from == PictureFrom::transformed_mesh ? "coordinatesOfUv(" + of_mesh + ")" : "pictureCoordinates(point)";
  const std::string coordinates = "picture_matrix * " + generated;
  MapReading reading = mapReading(variant.maps, row, "uvOfCoordinates(" + coordinates + ")", "");
  if (from == PictureFrom::projector)
    reading.expression = "mix(vec4(1.0), " + reading.expression + ", projectedShare(" + coordinates + "))";
  return reading;
}

/// The function that returns what stands for 0 in a normal map: `float normal_zero()`, as the parameter's name.
std::string zeroText(const MapSource& source, const MaterialMap& map) {
  const std::string name = std::string(map.name.substr(0, map.name.rfind('_'))) + "_zero";
  return "float " + name + "() { return " + (source.is_decoded ? "0.0" : "material." + name) + "; }\n";
}

/// For each row of materialMaps() its function `vec4 base_color_map_at(SurfacePoint point)`: the texture where the
/// material has one, and else what changes nothing.
std::string mapsText(const SurfaceVariant& variant) {
  std::string text =
      "float sampleLod() { return -0.5 * log2(samples_per_pixel); }\n"
      "vec2 mapCoordinates(SurfacePoint point, int map) {\n"
      "  vec2 uv = map_offset[map].z > 0.5 ? point.uv_1 : point.uv_0;\n"
      "  return mat2(map_matrix[map].xy, map_matrix[map].zw) * uv + map_offset[map].xy;\n"
      "}\n"
      "vec2 mapAcross(SurfacePoint point, int map) {\n"
      "  vec2 change = map_offset[map].z > 0.5 ? point.uv_1_across : point.uv_across;\n"
      "  return mat2(map_matrix[map].xy, map_matrix[map].zw) * change;\n"
      "}\n"
      "vec2 mapDown(SurfacePoint point, int map) {\n"
      "  vec2 change = map_offset[map].z > 0.5 ? point.uv_1_down : point.uv_down;\n"
      "  return mat2(map_matrix[map].xy, map_matrix[map].zw) * change;\n"
      "}\n";
  if (std::any_of(variant.maps.begin(), variant.maps.end(), [](const MapSource& source) { return source.layer >= 0; }))
    text += "#include \"map_layers.glsl\"\n";
  for (std::size_t row = 0; row < variant.maps.size(); ++row) {
    const bool has_texture = variant.maps[row].unit >= 0;
    const MapReading reading = has_texture ? chosenReading(variant, row) : MapReading{"", absentValue(row)};
    text += reading.uniforms + "vec4 " + std::string(materialMaps()[row].name) + "_at(SurfacePoint point) { return " +
            reading.expression + "; }\n";
    if (materialMaps()[row].holdsNormals()) text += zeroText(variant.maps[row], materialMaps()[row]);
  }
  return text;
}

void answer(std::string& text, std::string_view question, std::string_view file) {
  const std::string asked = "\"part: " + std::string(question) + '"';
  if (const std::size_t begin = text.find(asked); begin != std::string::npos)
    text.replace(begin, asked.size(), '"' + std::string(file) + '"');
}

/// surface.frag with the names of the variant's files in place of the questions.
std::string answeredText(const SurfaceVariant& variant) {
  std::string text(embeddedText("surface.frag").value());
  answer(text, "maps", kMapsFile);
  for (std::size_t part = 0; part < kParts; ++part)
    answer(text, surfaceQuestions()[part].name, surfaceQuestions()[part].answers[variant.answers[part]]);
  return text;
}

}  // namespace

Result<gl::ShaderSource> withProxy(gl::Api api, std::string_view entry, ProxyKind kind) {
  const SurfaceQuestion& question = surfaceQuestions()[static_cast<std::size_t>(Part::proxy)];
  std::string text(embeddedText(entry).value());
  answer(text, question.name, question.answers[static_cast<std::size_t>(kind)]);
  const gl::FindText find = [&](std::string_view name) -> std::optional<std::string_view> {
    if (name == entry) return text;
    return embeddedText(name);
  };
  const std::string suns = "SUN_COUNT " + std::to_string(kMostSuns);
  return gl::shaderSource(api, entry, std::array<std::string_view, 1>{suns}, find);
}

Result<SurfaceShaders> surfaceShaders(gl::Api api, const SurfaceVariant& variant) {
  const std::string answered = answeredText(variant);
  const std::string maps = mapsText(variant);
  const gl::FindText find = [&](std::string_view name) -> std::optional<std::string_view> {
    if (name == "surface.frag") return answered;
    if (name == kMapsFile) return maps;
    return embeddedText(name);
  };
  const CoordinateChoice& coordinates = variant.coordinates;
  std::vector<std::string> defines{"MAP_COUNT " + std::to_string(materialMaps().size()),
                                   "LOOK_UP_COORDINATES " + std::string(formulaOf(coordinates.look_up)),
                                   "PICTURE_COORDINATES " + std::string(formulaOf(coordinates.picture))};
  if (variant.sun_count > 0) defines.push_back("SUN_COUNT " + std::to_string(variant.sun_count));
  if (variant.lamp_count > 0) defines.push_back("LAMP_COUNT " + std::to_string(variant.lamp_count));
  for (std::string& definition : definitionsOf(variant.constants)) defines.push_back(std::move(definition));
  const std::vector<std::string_view> views(defines.begin(), defines.end());
  const bool is_of_prisms = variant.has(Part::point, PointPart::exact);
  MIRRORBALL_TRY(vertex, gl::shaderSource(api, is_of_prisms ? "screen.vert" : "surface.vert", views, find));
  MIRRORBALL_TRY(fragment, gl::shaderSource(api, "surface.frag", views, find));
  return SurfaceShaders{std::move(vertex), std::move(fragment)};
}

}  // namespace mirrorball
