#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/result.h"
#include "mirrorball/scene/animation/rig.h"
#include "mirrorball/scene/camera/model_camera.h"
#include "mirrorball/scene/gltf/gltf_light.h"
#include "mirrorball/scene/gltf/gltf_remarks.h"
#include "mirrorball/scene/material/material.h"
#include "mirrorball/scene/scene.h"

/// The JSON of a glTF 2.0 file as plain data. Types and required keys are checked; indices are −1 where there is none,
/// and neither they nor ranges of bytes are checked against what they point to.
namespace mirrorball::gltf {

/// The numbers that glTF takes from OpenGL.
enum ComponentType { kByte = 5120, kUnsignedByte, kShort, kUnsignedShort, kInt, kUnsignedInt, kFloat };
enum Mode { kTriangles = 4, kTriangleStrip, kTriangleFan };

struct Sparse {
  std::size_t count = 0;
  int indices_view = -1;
  std::size_t indices_offset = 0;
  int indices_type = 0;
  int values_view = -1;
  std::size_t values_offset = 0;
};

struct Accessor {
  int buffer_view = -1;
  std::size_t byte_offset = 0;
  std::size_t count = 0;
  int component_type = 0;
  std::size_t components = 0;  ///< 1 to 4; 16 of MAT4; 0 for other matrices, which nothing uses
  bool normalized = false;
  std::optional<Sparse> sparse;
};

/// Where and how EXT_meshopt_compression holds a buffer view's bytes.
struct Compression {
  int buffer = -1;
  std::size_t byte_offset = 0;
  std::size_t byte_length = 0;
  std::size_t byte_stride = 0;  ///< of the elements
  std::size_t count = 0;
  std::string mode;
  std::string filter;
};

struct BufferView {
  int buffer = -1;
  std::size_t byte_offset = 0;
  std::size_t byte_length = 0;
  std::size_t byte_stride = 0;  ///< 0: elements follow each other
  std::optional<Compression> compression = {};
};

struct Buffer {
  std::optional<std::string> uri;  ///< none: the .glb's binary chunk
  std::size_t byte_length = 0;
  bool is_fallback = false;  ///< only for readers that do not know EXT_meshopt_compression
};

struct Image {
  int buffer_view = -1;  ///< where it has neither this nor a uri, it has no picture
  std::optional<std::string> uri;
};

struct Sampler {
  Wrap wrap_s = Wrap::repeat;
  Wrap wrap_t = Wrap::repeat;
  bool nearest = false;
};

struct Texture {
  int image = -1;
  int sampler = -1;
};

/// What a primitive is made of in some variants of KHR_materials_variants.
struct VariantMapping {
  int material = -1;
  std::vector<int> variants;
};

struct Primitive {
  std::map<std::string, int> attributes;  ///< name → accessor
  int indices = -1;
  int material = -1;
  int mode = kTriangles;
  std::vector<std::map<std::string, int>> targets;  ///< of morphing: of each, attribute → accessor
  int draco_view = -1;                              ///< of KHR_draco_mesh_compression
  std::map<std::string, int> draco_attributes;      ///< name → the attribute's unique id in the compressed mesh
  std::vector<VariantMapping> variant_mappings;
};

/// A mesh of the file.
struct FileMesh {
  std::vector<Primitive> primitives;
  std::vector<float> weights;  ///< of the morph targets
};

struct Node {
  NodePlace place;
  bool is_somewhere = true;  ///< else its place holds NaN
  bool has_rotation = true;  ///< else its quaternion is 0 or NaN
  bool is_affine = true;     ///< else the last row of its matrix was not 0, 0, 0, 1
  int mesh = -1;
  std::vector<int> children;
  std::string name;
  int camera = -1;
  int light = -1;  ///< of KHR_lights_punctual
  int skin = -1;
  std::vector<float> weights;  ///< of its mesh's morph targets, in place of the mesh's own
};

struct FileSkin {
  int inverse_bind_matrices = -1;
  std::vector<int> joints;
};

struct FileSampler {
  int input = -1;
  int output = -1;
  std::string interpolation;
};

struct FileChannel {
  int sampler = -1;
  /// What moves, as KHR_animation_pointer names it: "/nodes/3/rotation"; empty: nothing.
  std::string pointer;
  std::string key;  ///< of the target, for messages
};

struct FileAnimation {
  std::string name;
  std::vector<FileSampler> samplers;
  std::vector<FileChannel> channels;
};

/// A material of the file.
struct FileMaterial {
  Material material;  ///< whose slots hold indices into Document::textures
  /// Of KHR_materials_pbrSpecularGlossiness, where a texture has it too: the roughness is 1 − this · the alpha of
  /// roughness_map.
  std::optional<float> glossiness = {};
  glm::vec3 emissive_factor{0.0f};  ///< of which, times the strength, the emission is the product
  float emissive_strength = 1.0f;
  bool is_sheet = true;  ///< it is one without a thickness, where it transmits
  /// The keys of its colours that have three numbers for four, or four for three.
  std::vector<std::string_view> miscounted = {};
};

/// The sets of texture coordinates of a file that become those of our vertices: TEXCOORD_0 and TEXCOORD_1, unless its
/// materials use others.
using TexCoordSets = std::array<int, 2>;

struct Document {
  std::vector<Accessor> accessors;
  std::vector<BufferView> buffer_views;
  std::vector<Buffer> buffers;
  std::vector<Image> images;
  std::vector<Sampler> samplers;
  std::vector<Texture> textures;
  std::vector<FileMaterial> materials;
  TexCoordSets tex_coord_sets{0, 1};
  std::vector<FileMesh> meshes;
  std::vector<std::optional<ModelCamera>> cameras;  ///< parseCamera()
  std::vector<std::optional<FileLight>> lights;     ///< parseLight()
  std::vector<std::string> variants;                ///< names, of KHR_materials_variants
  std::vector<Node> nodes;
  std::vector<FileSkin> skins;
  std::vector<FileAnimation> animations;
  std::vector<std::vector<int>> scenes;  ///< root nodes
  int scene = -1;
  std::vector<std::string> unread_extensions;  ///< unreadExtensions()
};

/// Reads a file's JSON. A value of a wrong type counts as absent.
///
/// budget   gets what the document takes, and while it is read the parsed JSON too: many times the text's bytes
/// remarks  gets wrong values, and extensions that are required and not read
/// errors   bad_file (no JSON, or no glTF; the byte or key is named); unsupported (the version); too_large
Result<Document> parseDocument(std::string_view json, MemoryBudget& budget, Remarks& remarks);

}  // namespace mirrorball::gltf
