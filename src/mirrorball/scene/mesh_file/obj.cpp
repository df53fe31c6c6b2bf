#include "mirrorball/scene/mesh_file/obj.h"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mirrorball/base/text.h"
#include "mirrorball/base/unicode.h"
#include "mirrorball/scene/mesh_file/mtl.h"
#include "mirrorball/scene/mesh_file/named_file.h"
#include "mirrorball/scene/mesh_file/obj_geometry.h"
#include "mirrorball/scene/mesh_file/obj_material.h"
#include "mirrorball/scene/mesh_file/obj_mesh.h"
#include "mirrorball/scene/mesh_file/points_alone.h"
#include "mirrorball/scene/mesh_file/text_scanner.h"
#include "mirrorball/scene/mesh_file/vertex_colors.h"
#include "mirrorball/scene/mesh_repair.h"
#include "mirrorball/scene/model_origin.h"

namespace mirrorball {
namespace {

/// The materials of all tables that an OBJ names.
class MaterialTables {
 public:
  MaterialTables(NamedFiles& named, Scene& scene) : named_(named), scene_(scene) {}

  /// Reads what follows a `mtllib`: one name with blanks in it, or several names. What is missing is a warning.
  ///
  /// errors   too_large
  Result<void> read(const std::string& line) {
    const auto whole = named_.read(readingsOfName(line));
    if (whole) return add(*whole);
    std::string_view names = line;
    std::size_t found = 0, count = 0;
    for (std::string_view name = takeWord(names); !name.empty(); name = takeWord(names), ++count) {
      const std::vector<std::string> reading{std::string(name)};
      const auto one = named_.read(reading);
      if (!one) continue;
      MIRRORBALL_TRY_VOID(add(*one));
      ++found;
    }
    if (found < count || count == 0) scene_.warnings.push_back(whole.error().message + "; its materials are left out");
    return {};
  }

  /// Reads the table beside the model that has its name, if there is one: what no `mtllib` names. Blender does so too.
  ///
  /// errors   too_large
  Result<void> readBeside(const std::filesystem::path& model) {
    const std::vector<std::string> name{model.filename().replace_extension(".mtl").string()};
    const auto table = named_.read(name);
    if (!table) return {};
    scene_.warnings.push_back("no .mtl that it names is there: its materials are those of '" + excerpt(name[0]) + "'");
    return add(*table);
  }

  bool isEmpty() const { return materials_.empty(); }
  const std::vector<MtlMaterial>& materials() const { return materials_; }

  /// The index of a material, by a name which a comment may follow; −1: there is none.
  int findIndex(const std::string& name) const {
    for (const std::string& reading : readingsOfName(name))
      if (const auto found = indices_.find(reading); found != indices_.end()) return found->second;
    return -1;
  }

 private:
  Result<void> add(const NamedFiles::Found& table) {
    if (!tables_.insert(table.bytes.data()).second) return {};  // it was read by another name
    std::vector<std::string> remarks;
    std::string_view text(reinterpret_cast<const char*>(table.bytes.data()), table.bytes.size());
    Bytes converted;
    if (isUtf16(table.bytes)) {
      MIRRORBALL_TRY_VOID(named_.files().budget().take(utf8Size(table.bytes)));
      converted = utf8FromUtf16(table.bytes);
      text = {reinterpret_cast<const char*>(converted.data()), converted.size()};
      remarks.emplace_back(kIsUtf16);
    }
    // In a growing list; their names are no longer than the table.
    MIRRORBALL_TRY_VOID(
        named_.files().budget().take(occurrences(lowerCase(text), "newmtl") * 3 * sizeof(MtlMaterial) + text.size()));
    for (MtlMaterial& material : readMtl(text, remarks)) {
      indices_.try_emplace(material.name, static_cast<int>(materials_.size()));
      materials_.push_back(std::move(material));
    }
    for (const std::string& remark : remarks) scene_.warnings.push_back("'" + excerpt(table.path) + "': " + remark);
    return {};
  }

  NamedFiles& named_;
  Scene& scene_;
  std::vector<MtlMaterial> materials_;
  std::unordered_map<std::string, int> indices_;  // of the first of that name
  std::set<const std::uint8_t*> tables_;          // where those lie that were read
};

/// Reads the tables, and finds the materials in them that the model uses.
///
/// returns  for each of geometry.material_names the index of its material; −1: none
/// errors   too_large
Result<std::vector<int>> findMaterials(const ObjGeometry& geometry, const std::filesystem::path& path,
                                       MaterialTables& tables, Scene& scene) {
  for (const std::string& line : geometry.tables) MIRRORBALL_TRY_VOID(tables.read(line));
  if (tables.isEmpty() && !geometry.material_names.empty()) MIRRORBALL_TRY_VOID(tables.readBeside(path));
  std::vector<int> materials;
  std::set<std::string> unknown;
  for (const std::string& name : geometry.material_names) {
    materials.push_back(tables.findIndex(name));
    if (materials.back() < 0) unknown.insert(name);
  }
  for (const std::string& name : unknown)
    scene.warnings.push_back(path.string() + ": no .mtl has the material '" + excerpt(name) + "'");
  return materials;
}

/// What an OBJ without any triangle lacks.
tl::unexpected<Error> nothingToDraw(const ObjGeometry& geometry) {
  std::string reasons = remarkOn(geometry.repair);
  for (const std::string& remark : geometry.remarks) reasons += (reasons.empty() ? "" : "; ") + remark;
  if (reasons.empty() && geometry.positions.empty())
    return fail(ErrorCode::bad_file, "holds no faces; it is not an OBJ file");
  if (reasons.empty()) return pointsAlone(geometry.positions.size());
  return fail(ErrorCode::bad_file, "holds no face that can be drawn: " + reasons);
}

}  // namespace

Result<Scene> decodeObj(std::span<const std::uint8_t> bytes, const std::filesystem::path& path,
                        const ModelLoadOptions& options) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  Scene scene;
  ModelFiles files(path, options);
  MIRRORBALL_TRY_VOID(files.budget().take(bytes.size() + memoryForObj(text)));
  ObjGeometry geometry = readObjGeometry(text);
  if (geometry.faces.empty()) return nothingToDraw(geometry);
  NamedFiles named(path, files);
  MaterialTables tables(named, scene);
  MIRRORBALL_TRY(materials, findMaterials(geometry, path, tables, scene));

  std::vector<MtlMaterial> used;
  const glm::dvec3 origin = originFor(geometry.positions);
  std::map<int, Mesh> meshes = buildObjMeshes(geometry, materials, origin);
  for (auto& [material, mesh] : meshes) {
    mesh.material = static_cast<int>(scene.meshes.size());
    scene.instances.push_back({mesh.material, glm::mat4(1.0f)});
    scene.meshes.push_back(std::move(mesh));
    if (material >= 0)
      used.push_back(tables.materials()[std::size_t(material)]);
    else
      scene.materials.push_back(materialOfColors(!geometry.colors.empty()));  // the least key, and so the first
  }
  addObjMaterials(used, named, scene);
  for (const std::string& remark : named.remarks()) scene.warnings.push_back(path.string() + ": " + remark);
  for (const std::string& remark : geometry.remarks) scene.warnings.push_back(path.string() + ": " + remark);
  if (const std::string repairs = remarkOn(geometry.repair); !repairs.empty())
    scene.warnings.push_back(path.string() + ": " + repairs);
  tellOfFiles(files, scene);
  setOrigin(scene, origin, false);
  return scene;
}

}  // namespace mirrorball
