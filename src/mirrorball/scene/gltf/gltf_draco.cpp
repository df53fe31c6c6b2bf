#include <exception>
#include <memory>
#include <utility>

#include <draco/compression/decode.h>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/gltf/gltf_file.h"

// KHR_draco_mesh_compression: a buffer view holds a whole mesh, indices and attributes, as Draco's bitstream 2.2.

namespace mirrorball::gltf {
namespace {

constexpr int kMaxComponents = 4;

/// The attribute's value at every point of the mesh, as floats.
Result<Numbers> dracoNumbers(const draco::Mesh& mesh, const draco::PointAttribute& attribute, const std::string& key) {
  Numbers numbers;
  const int components = attribute.num_components();
  if (components < 1 || components > kMaxComponents)
    return fail(ErrorCode::bad_file, key + " has " + counted(std::size_t(components), "component"));
  numbers.components = std::size_t(components);
  numbers.values.resize(mesh.num_points() * numbers.components);
  for (draco::PointIndex point(0); point < mesh.num_points(); ++point) {
    const draco::AttributeValueIndex value = attribute.mapped_index(point);
    float* out = numbers.values.data() + point.value() * numbers.components;
    if (value.value() >= attribute.size() ||
        !attribute.ConvertValue<float>(value, static_cast<std::int8_t>(components), out))
      return fail(ErrorCode::bad_file, key + " is damaged at vertex " + std::to_string(point.value()));
  }
  return numbers;
}

/// The accessors keep the counts of what is compressed. They must agree:
/// the memory that a file may take is judged by them.
Result<void> checkCounts(const File& file, const Primitive& primitive, const draco::Mesh& mesh,
                         const std::string& key) {
  const auto count_of = [&](int accessor) {
    const std::vector<Accessor>& accessors = file.document.accessors;
    const bool exists = accessor >= 0 && std::size_t(accessor) < accessors.size();
    return exists ? accessors[std::size_t(accessor)].count : 0;
  };
  const auto position = primitive.attributes.find("POSITION");
  const std::size_t vertices = position == primitive.attributes.end() ? 0 : count_of(position->second);
  const std::size_t corners = std::size_t(mesh.num_faces()) * 3;
  if (mesh.num_points() == vertices && corners <= count_of(primitive.indices)) return {};
  return fail(ErrorCode::bad_file, key + " holds " + std::to_string(mesh.num_points()) + " vertices and " +
                                       std::to_string(corners) + " indices, not as many as its accessors' counts say");
}

/// Marks an attribute as normalized whose accessor says so. Encoders cannot say it in the compressed mesh (Cesium issue
/// 6561).
void markNormalized(const File& file, const Primitive& primitive, const std::string& name,
                    draco::PointAttribute& attribute) {
  const auto accessor = primitive.attributes.find(name);
  const std::vector<Accessor>& accessors = file.document.accessors;
  if (accessor == primitive.attributes.end() || accessor->second < 0) return;
  const auto index = static_cast<std::size_t>(accessor->second);
  if (index < accessors.size() && accessors[index].normalized) attribute.set_normalized(true);
}

Result<DracoMesh> convertDraco(const File& file, const Primitive& primitive, draco::Mesh& mesh,
                               const std::string& key) {
  MIRRORBALL_TRY_VOID(checkCounts(file, primitive, mesh, key));
  DracoMesh converted;
  converted.corners.reserve(std::size_t(mesh.num_faces()) * 3);
  for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face) {
    for (const draco::PointIndex& point : mesh.face(face)) {
      if (point.value() >= mesh.num_points())
        return fail(ErrorCode::bad_file, key + ": face " + std::to_string(face.value()) +
                                             " of the compressed mesh names vertex " + std::to_string(point.value()) +
                                             " of " + std::to_string(mesh.num_points()));
      converted.corners.push_back(point.value());
    }
  }
  for (const auto& [name, id] : primitive.draco_attributes) {
    const int index = mesh.GetAttributeIdByUniqueId(static_cast<std::uint32_t>(id));
    const std::string attribute_key = key + ".attributes." + excerpt(name);
    if (index < 0)
      return fail(ErrorCode::bad_file, attribute_key + ": the compressed mesh has no attribute " + std::to_string(id));
    draco::PointAttribute& attribute = *mesh.attribute(index);
    markNormalized(file, primitive, name, attribute);
    MIRRORBALL_TRY(numbers, dracoNumbers(mesh, attribute, attribute_key));
    converted.attributes[name] = std::move(numbers);
  }
  return converted;
}

}  // namespace

Result<DracoMesh> decodeDraco(const File& file, const Primitive& primitive, const std::string& primitive_key) {
  const std::string key = primitive_key + ".extensions.KHR_draco_mesh_compression";
  MIRRORBALL_TRY(bytes, viewBytes(file, primitive.draco_view, key + ".bufferView"));
  std::unique_ptr<draco::Mesh> mesh;
  try {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (decoded.ok()) mesh = std::move(decoded).value();
  } catch (const std::exception&) {  // a damaged count that asks for more memory than there is
  }
  if (!mesh) return fail(ErrorCode::bad_file, key + ": the compressed mesh is damaged or of an unknown kind");
  return convertDraco(file, primitive, *mesh, key);
}

}  // namespace mirrorball::gltf
