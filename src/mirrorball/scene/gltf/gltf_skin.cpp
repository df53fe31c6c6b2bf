#include "mirrorball/scene/gltf/gltf_skin.h"

#include <glm/gtc/type_ptr.hpp>

#include "mirrorball/base/text.h"

namespace mirrorball::gltf {

Result<Skin> readSkin(const File& file, int index, std::span<const int> place_of_node) {
  const FileSkin& source = file.document.skins[std::size_t(index)];
  const std::string key = quoted("skins", std::size_t(index));
  if (source.joints.empty()) return fail(ErrorCode::bad_file, key + ".joints is empty");
  Skin skin;
  for (const int joint : source.joints) {
    MIRRORBALL_TRY_VOID(checkIndex(joint, place_of_node.size(), key + ".joints", "node"));
    if (place_of_node[std::size_t(joint)] < 0) return Skin{};
    skin.joints.push_back(place_of_node[std::size_t(joint)]);
  }
  MIRRORBALL_TRY_VOID(file.files.budget().take(skin.joints.size() * (2 * sizeof(glm::mat4) + sizeof(int))));
  skin.joint_from_mesh.assign(skin.joints.size(), glm::mat4(1.0f));
  if (source.inverse_bind_matrices == -1) return skin;
  const std::string matrices_key = key + ".inverseBindMatrices";
  MIRRORBALL_TRY(matrices, readFiniteNumbers(file, source.inverse_bind_matrices, matrices_key));
  if (matrices.components != 16)
    return fail(ErrorCode::bad_file, matrices_key + " has " + counted(matrices.components, "component"));
  if (matrices.count() < skin.joints.size())
    return fail(ErrorCode::bad_file, matrices_key + " has " + counted(matrices.count(), "element") +
                                         ", but there are " + counted(skin.joints.size(), "joint"));
  for (std::size_t i = 0; i < skin.joints.size(); ++i)
    skin.joint_from_mesh[i] = glm::make_mat4(matrices.values.data() + i * 16);
  return skin;
}

}  // namespace mirrorball::gltf
