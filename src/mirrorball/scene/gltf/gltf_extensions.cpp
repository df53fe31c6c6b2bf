#include "mirrorball/scene/gltf/gltf_extensions.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "mirrorball/base/json_reader.h"
#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"

namespace mirrorball::gltf {
namespace {

constexpr auto kRead = std::to_array<std::string_view>({
    "EXT_meshopt_compression",
    "EXT_texture_avif",
    "EXT_texture_webp",
    "KHR_animation_pointer",
    "KHR_draco_mesh_compression",
    "KHR_lights_punctual",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_iridescence",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_variants",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
});

/// Of an extension, in a message.
constexpr std::size_t kLongestName = 60;

bool isRead(std::string_view extension) { return contains(kRead, extension); }

/// Whether an extension is by its name about how surfaces look, which says nothing of whether there are any.
bool isOfMaterials(std::string_view extension) {
  return extension.find("_materials_") != std::string_view::npos ||
         extension.find("_texture_") != std::string_view::npos;
}

}  // namespace

std::vector<std::string> unreadExtensions(const nlohmann::json& file, Remarks& remarks) {
  JsonProblem other_types;  // what is not a list of words names no extension
  const JsonReader root(&file, "", other_types);
  std::set<std::string> used;
  for (const JsonReader& required : root["extensionsRequired"].elements()) {
    const std::string name = required.text("");
    if (name.empty() || isRead(name)) continue;
    used.insert(name);
    if (!isOfMaterials(name))
      remarks.suspect({ErrorCode::unsupported, "extensionsRequired names '" + excerpt(name, kLongestName) +
                                                   "', which this program cannot read; export the model without it"});
  }
  for (const JsonReader& declared : root["extensionsUsed"].elements()) used.insert(declared.text(""));
  for (const JsonReader& material : root["materials"].elements())
    for (const auto& [name, extension] : material["extensions"].members()) used.insert(name);
  used.erase("");
  constexpr std::size_t kMostNamed = 8;
  std::vector<std::string> unread;
  for (const std::string& name : used) {
    if (isRead(name)) continue;
    unread.push_back(unread.size() < kMostNamed ? excerpt(name, kLongestName) : "…");
    if (unread.size() > kMostNamed) break;
  }
  return unread;
}

}  // namespace mirrorball::gltf
