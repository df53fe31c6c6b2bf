// A build without Draco.
#include "mirrorball/base/left_out.h"
#include "mirrorball/scene/gltf/gltf_file.h"

namespace mirrorball::gltf {

Result<DracoMesh> decodeDraco(const File&, const Primitive&, const std::string& key) {
  return withName(key, Result<DracoMesh>(leftOut("reads no meshes compressed by Draco", "MIRRORBALL_DRACO")));
}

}  // namespace mirrorball::gltf
