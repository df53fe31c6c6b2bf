#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/animation/deformation.h"
#include "mirrorball/scene/gltf/gltf_file.h"

namespace mirrorball::gltf {

/// What of a primitive's deformation is asked for.
struct WantedDeformation {
  bool skin = false;
  bool targets = false;

  bool any() const { return skin || targets; }
};

/// Reads an attribute of a primitive by its name, with a number of components between the two; none: it has none.
using ReadAttribute = std::function<Result<Numbers>(const std::string& name, std::size_t min, std::size_t max)>;

/// The vertices of a mesh that was read, and what became of the file's.
struct FileVertices {
  const Mesh& mesh;
  std::span<const std::uint32_t> sources;  ///< of each of its vertices, the file's
  std::size_t count;                       ///< of the file's
  bool are_flat;                           ///< the file has no normals, and each triangle got its own
};

/// How many sets of four joints the vertices of a primitive have.
std::size_t jointSets(const Primitive& primitive);

/// The memory that the deformation of so many vertices may take, by what a primitive says [bytes].
std::size_t deformationSize(const Primitive& primitive, WantedDeformation wanted, std::size_t vertices);

/// Reads what bends a primitive. What is damaged (counts and types that do not fit, joints that are not indices, NaN)
/// does not.
///
/// damage   gets that
/// returns  none: nothing that is asked for bends it
/// errors   too_large
Result<std::shared_ptr<const MeshDeformation>> readDeformation(const File& file, const Primitive& primitive,
                                                               WantedDeformation wanted, const FileVertices& vertices,
                                                               const ReadAttribute& attribute, const std::string& key,
                                                               std::vector<Damage>& damage);

}  // namespace mirrorball::gltf
