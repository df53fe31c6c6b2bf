#include "mirrorball/scene/mesh_file/ply.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "formula/color.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/mesh_file/polygon.h"
#include "mirrorball/scene/mesh_file/smoothing.h"
#include "mirrorball/scene/mesh_file/text_scanner.h"
#include "mirrorball/scene/tangents.h"

// The format: Greg Turk, "The PLY Polygon File Format" (1994).

namespace mirrorball {
namespace {

enum class Encoding { ascii, little_endian, big_endian };
enum class ValueType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
  std::string name;
  ValueType type = ValueType::float32;
  std::optional<ValueType> count_type;  // of a list: the type of its length
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
  std::size_t size = 0;  // bytes
};

std::optional<ValueType> valueTypeNamed(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kNames = {{
      {"char", "int8"},
      {"uchar", "uint8"},
      {"short", "int16"},
      {"ushort", "uint16"},
      {"int", "int32"},
      {"uint", "uint32"},
      {"float", "float32"},
      {"double", "float64"},
  }};
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (name == kNames[i].first || name == kNames[i].second) return static_cast<ValueType>(i);
  return {};
}

std::size_t sizeOf(ValueType type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

/// The largest value of an integer type, by which a colour is divided; 1 for a float.
double fullScale(ValueType type) {
  constexpr double kFull[] = {127, 255, 32767, 65535, 2147483647, 4294967295, 1, 1};
  return kFull[static_cast<std::size_t>(type)];
}

bool isFloat(ValueType type) { return type == ValueType::float32 || type == ValueType::float64; }

/// Reads the values after the header, one by one.
class ValueReader {
 public:
  ValueReader(std::span<const std::uint8_t> body, Encoding encoding, std::size_t offset)
      : body_(body),
        encoding_(encoding),
        offset_(offset),
        scanner_({reinterpret_cast<const char*>(body.data()), body.size()}) {}

  std::size_t remaining() const { return body_.size() - position(); }

  /// The min_count bytes that a value takes: in ascii a digit (its separator is not counted).
  std::size_t minSize(ValueType type) const { return encoding_ == Encoding::ascii ? 1 : sizeOf(type); }

  /// Nothing at the end of the file, or where there is no finite number.
  std::optional<double> next(ValueType type) {
    if (encoding_ == Encoding::ascii) return scanner_.number();
    const std::size_t size = sizeOf(type);
    if (size > body_.size() - at_) return {};
    std::array<std::uint8_t, 8> raw{};
    std::memcpy(raw.data(), body_.data() + at_, size);
    if ((encoding_ == Encoding::big_endian) == (std::endian::native == std::endian::little))
      for (std::size_t i = 0; i < size / 2; ++i) std::swap(raw[i], raw[size - 1 - i]);
    const double value = decode(type, raw.data());
    if (!std::isfinite(value)) return {};
    at_ += size;
    return value;
  }

  /// Where the value stands that was asked for last.
  std::string place() const {
    return encoding_ == Encoding::ascii ? "line " + std::to_string(scanner_.line()) + " of its data"
                                        : "byte " + std::to_string(offset_ + at_);
  }

 private:
  std::size_t position() const { return encoding_ == Encoding::ascii ? scanner_.position() : at_; }

  template <typename Value>
  static double as(const std::uint8_t* raw) {
    Value value;
    std::memcpy(&value, raw, sizeof value);
    return static_cast<double>(value);
  }

  static double decode(ValueType type, const std::uint8_t* raw) {
    switch (type) {
      case ValueType::int8:
        return as<std::int8_t>(raw);
      case ValueType::uint8:
        return as<std::uint8_t>(raw);
      case ValueType::int16:
        return as<std::int16_t>(raw);
      case ValueType::uint16:
        return as<std::uint16_t>(raw);
      case ValueType::int32:
        return as<std::int32_t>(raw);
      case ValueType::uint32:
        return as<std::uint32_t>(raw);
      case ValueType::float32:
        return as<float>(raw);
      case ValueType::float64:
        return as<double>(raw);
    }
    return 0.0;
  }

  std::span<const std::uint8_t> body_;
  Encoding encoding_;
  std::size_t offset_;
  std::size_t at_ = 0;
  TextScanner scanner_;
};

std::optional<Property> parseProperty(TextScanner& words) {
  Property property;
  std::string_view word = words.word();
  if (word == "list") {
    property.count_type = valueTypeNamed(words.word());
    if (!property.count_type || isFloat(*property.count_type)) return {};
    word = words.word();
  }
  const std::optional<ValueType> type = valueTypeNamed(word);
  property.name = words.word();
  if (!type || property.name.empty()) return {};
  property.type = *type;
  return property;
}

Result<Header> parseHeader(std::string_view text) {
  TextScanner lines(text);
  if (lines.restOfLine() != "ply") return fail(ErrorCode::bad_file, "is not a PLY file: its first line is not 'ply'");

  Header header;
  bool has_format = false;
  while (true) {
    const std::size_t line_number = lines.line();
    const std::string_view line = lines.restOfLine();
    const auto wrong = [&](const std::string& what) {
      return fail(ErrorCode::bad_file, "line " + std::to_string(line_number) + ": " + what);
    };
    TextScanner words(line);
    const std::string_view key = words.word();
    if (key == "end_header") break;
    if (key == "format") {
      const std::string_view encoding = words.word();
      if (encoding == "ascii")
        header.encoding = Encoding::ascii;
      else if (encoding == "binary_little_endian")
        header.encoding = Encoding::little_endian;
      else if (encoding == "binary_big_endian")
        header.encoding = Encoding::big_endian;
      else
        return wrong("unknown format '" + excerpt(encoding) + "'");
      has_format = true;
    } else if (key == "element") {
      Element& element = header.elements.emplace_back();
      element.name = words.word();
      const std::optional<double> count = words.number();
      if (!count || *count < 0.0 || *count > 4294967295.0 || *count != std::floor(*count))
        return wrong("the element has no valid count");
      element.count = static_cast<std::size_t>(*count);
    } else if (key == "property") {
      const std::optional<Property> property = parseProperty(words);
      if (!property || header.elements.empty()) return wrong("not a valid property");
      header.elements.back().properties.push_back(*property);
    } else if (lines.position() >= text.size()) {
      return fail(ErrorCode::bad_file, "the header does not end; the file is truncated");
    } else if (key != "comment" && key != "obj_info" && !key.empty()) {
      return wrong("unknown key '" + excerpt(key) + "'");
    }
  }
  if (!has_format) return fail(ErrorCode::bad_file, "the header names no format");
  header.size = lines.position();
  return header;
}

/// What a vertex's property means; `kRoles` gives the names.
enum Role { kX, kY, kZ, kNx, kNy, kNz, kU, kV, kRed, kGreen, kBlue, kAlpha, kRoleCount };

std::optional<Role> roleNamed(std::string_view name) {
  constexpr std::pair<std::string_view, Role> kRoles[] = {
      {"x", kX},
      {"y", kY},
      {"z", kZ},
      {"nx", kNx},
      {"ny", kNy},
      {"nz", kNz},
      {"u", kU},
      {"v", kV},
      {"s", kU},
      {"t", kV},
      {"texture_u", kU},
      {"texture_v", kV},
      {"texture_s", kU},
      {"texture_t", kV},
      {"red", kRed},
      {"green", kGreen},
      {"blue", kBlue},
      {"alpha", kAlpha},
      {"diffuse_red", kRed},
      {"diffuse_green", kGreen},
      {"diffuse_blue", kBlue},
  };
  for (const auto& [role_name, role] : kRoles)
    if (name == role_name) return role;
  return {};
}

/// Gives a mesh the normals of its smooth parts: a vertex at a sharp edge becomes several.
void addNormals(Mesh& mesh) {
  std::vector<glm::vec3> positions;
  for (const Vertex& vertex : mesh.vertices) positions.push_back(vertex.position);
  std::vector<PolygonFace> triangles;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    triangles.push_back({std::span(mesh.indices).subspan(i, 3)});
  CornerNormals made = cornerNormals(positions, triangles);
  // All corners that share a normal are of one vertex.
  std::vector<Vertex> vertices(made.normals.size());
  for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner) {
    const std::uint32_t normal = made.of_corner[corner];
    vertices[normal] = mesh.vertices[mesh.indices[corner]];
    vertices[normal].normal = made.normals[normal];
  }
  mesh.vertices = std::move(vertices);
  mesh.indices = std::move(made.of_corner);
}

/// Reads one file's elements into a mesh.
class PlyDecoder {
 public:
  PlyDecoder(const Header& header, std::span<const std::uint8_t> bytes)
      : header_(header), reader_(bytes.subspan(header.size), header.encoding, header.size) {}

  Result<Mesh> decode() {
    for (const Element& element : header_.elements) {
      MIRRORBALL_TRY_VOID(checkSize(element));
      memory_ += memoryOf(element);
      MIRRORBALL_TRY_VOID(checkMemory(memory_));
      MIRRORBALL_TRY_VOID(element.name == "vertex" ? readVertices(element) : readLists(element));
    }
    for (const std::uint32_t index : mesh_.indices)
      if (index >= mesh_.vertices.size())
        return fail(ErrorCode::bad_file,
                    "a face uses vertex " + std::to_string(index) + " of " + std::to_string(mesh_.vertices.size()));
    if (mesh_.indices.empty()) return fail(ErrorCode::unsupported, "holds no faces; only surfaces can be drawn");

    if (!has_normals_) addNormals(mesh_);
    computeTangents(mesh_);
    return std::move(mesh_);
  }

 private:
  static constexpr std::size_t kOfCorner = 100;  // bytes, measured with triangles whose normals are computed

  tl::unexpected<Error> wrong(const std::string& what) const {
    return fail(ErrorCode::bad_file, reader_.place() + ": " + what);
  }

  /// What an element takes at least, until the mesh has normals and tangents: a face is a triangle or more.
  static std::uint64_t memoryOf(const Element& element) {
    const std::size_t each = element.name == "vertex" ? sizeof(Vertex) : element.name == "face" ? 3 * kOfCorner : 0;
    return element.count * std::uint64_t{each};
  }

  /// Refuses a count that the bytes cannot hold, before memory is taken for it.
  Result<void> checkSize(const Element& element) const {
    std::size_t min = 0;
    for (const Property& property : element.properties)
      min += reader_.minSize(property.count_type.value_or(property.type));
    if (element.count > 0 && (min == 0 || element.count > reader_.remaining() / min))
      return fail(ErrorCode::bad_file, "the header names " + std::to_string(element.count) + " of '" +
                                           excerpt(element.name) + "', more than its " +
                                           std::to_string(reader_.remaining()) +
                                           " bytes of data can hold; the file is truncated");
    return {};
  }

  Result<void> readVertices(const Element& element) {
    std::vector<std::optional<Role>> roles;
    std::array<double, kRoleCount> scales{};  // 0: the property is absent
    for (const Property& property : element.properties) {
      roles.push_back(property.count_type ? std::nullopt : roleNamed(property.name));
      if (roles.back()) scales[*roles.back()] = fullScale(property.type);
    }
    if (scales[kX] == 0 || scales[kY] == 0 || scales[kZ] == 0)
      return fail(ErrorCode::bad_file, "its vertices lack x, y or z");
    has_normals_ = scales[kNx] != 0 && scales[kNy] != 0 && scales[kNz] != 0;

    mesh_.vertices.reserve(element.count);
    for (std::size_t row = 0; row < element.count; ++row) {
      std::array<double, kRoleCount> values{};
      for (std::size_t i = 0; i < roles.size(); ++i) {
        const Property& property = element.properties[i];
        if (property.count_type) {
          MIRRORBALL_TRY_VOID(readList(property));
          continue;
        }
        const std::optional<double> value = reader_.next(property.type);
        if (!value)
          return wrong("no finite number for '" + excerpt(property.name) + "' of vertex " + std::to_string(row));
        if (roles[i]) values[*roles[i]] = *value;
      }
      MIRRORBALL_TRY_VOID(addVertex(values, scales));
    }
    return {};
  }

  Result<void> addVertex(const std::array<double, kRoleCount>& values, const std::array<double, kRoleCount>& scales) {
    const auto at = [&](Role role) { return values[role]; };
    const glm::dvec3 position(at(kX), at(kY), at(kZ));
    if (glm::any(glm::greaterThan(glm::abs(position), glm::dvec3(std::numeric_limits<float>::max()))))
      return wrong("a coordinate is too large");
    Vertex vertex;
    vertex.position = glm::vec3(position);
    if (has_normals_) {
      const glm::dvec3 normal(at(kNx), at(kNy), at(kNz));
      const double length = glm::length(normal);
      if (length > 0.0 && std::isfinite(length))
        vertex.normal = glm::vec3(normal / length);
      else
        has_normals_ = false;  // then they are all computed
    }
    const auto coordinate = [](double value) { return static_cast<float>(glm::clamp(value, -1e6, 1e6)); };
    if (scales[kU] != 0 && scales[kV] != 0)
      vertex.uv[0] = vertex.uv[1] = glm::vec2(coordinate(at(kU)), coordinate(1.0 - at(kV)));
    if (scales[kRed] != 0 && scales[kGreen] != 0 && scales[kBlue] != 0)
      for (int channel = 0; channel < 3; ++channel)
        vertex.color[channel] = linearColor(at(Role(kRed + channel)), scales[std::size_t(kRed + channel)]);
    if (scales[kAlpha] != 0) vertex.color.a = static_cast<float>(glm::clamp(at(kAlpha) / scales[kAlpha], 0.0, 1.0));
    mesh_.vertices.push_back(vertex);
    return {};
  }

  static float linearColor(double value, double scale) {
    const auto share = static_cast<float>(glm::clamp(value / scale, 0.0, 1.0));
    return scale == 1.0 ? share : formula::linearFromSrgb1(share);
  }

  /// Reads any element but the vertices, and takes the faces and strips from it.
  Result<void> readLists(const Element& element) {
    for (std::size_t row = 0; row < element.count; ++row) {
      for (const Property& property : element.properties) {
        if (!property.count_type) {
          if (!reader_.next(property.type)) return wrong("no finite number for '" + excerpt(property.name) + "'");
          continue;
        }
        MIRRORBALL_TRY_VOID(readList(property));
        if (property.name != "vertex_indices" && property.name != "vertex_index") continue;
        if (element.name == "face") {
          MIRRORBALL_TRY_VOID(addFace());
        } else if (element.name == "tristrips") {
          MIRRORBALL_TRY_VOID(addStrips());
        }
      }
    }
    return {};
  }

  Result<void> readList(const Property& property) {
    const std::optional<double> length = reader_.next(*property.count_type);
    if (!length || *length < 0 || *length != std::floor(*length) ||
        *length > static_cast<double>(reader_.remaining() / reader_.minSize(property.type)))
      return wrong("the list '" + excerpt(property.name) + "' has no valid length; the file may be truncated");
    list_.clear();
    for (auto left = static_cast<std::size_t>(*length); left > 0; --left) {
      const std::optional<double> value = reader_.next(property.type);
      if (!value) return wrong("no finite number in the list '" + excerpt(property.name) + "'");
      list_.push_back(*value);
    }
    return {};
  }

  /// The index as the mesh stores it; where the vertices are known already it must be one of them.
  std::optional<std::uint32_t> index(double value) const {
    if (value < 0 || value != std::floor(value) || value >= 4294967295.0) return {};
    if (!mesh_.vertices.empty() && value >= static_cast<double>(mesh_.vertices.size())) return {};
    return static_cast<std::uint32_t>(value);
  }

  Result<void> badIndex(double value) const {
    return wrong("a face uses vertex " + std::to_string(static_cast<long long>(glm::clamp(value, -1e18, 1e18))) +
                 " of " + std::to_string(mesh_.vertices.size()));
  }

  Result<void> addFace() {
    if (list_.size() < 3) return {};
    std::vector<std::uint32_t> corners;
    for (const double value : list_) {
      const std::optional<std::uint32_t> corner = index(value);
      if (!corner) return badIndex(value);
      corners.push_back(*corner);
    }
    if (corners.size() == 3 || mesh_.vertices.empty()) {  // faces that precede their vertices: a fan is all one can do
      for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        mesh_.indices.insert(mesh_.indices.end(), {corners[0], corners[i], corners[i + 1]});
      return {};
    }
    std::vector<glm::vec3> positions;
    for (const std::uint32_t corner : corners) positions.push_back(mesh_.vertices[corner].position);
    for (const auto& triangle : triangulate(positions))
      for (const std::uint32_t i : triangle) mesh_.indices.push_back(corners[i]);
    return {};
  }

  /// A strip's triangles turn alternately; −1 begins a new strip.
  Result<void> addStrips() {
    std::vector<std::uint32_t> strip;
    for (const double value : list_) {
      if (value == -1.0) {
        strip.clear();
        continue;
      }
      const std::optional<std::uint32_t> corner = index(value);
      if (!corner) return badIndex(value);
      strip.push_back(*corner);
      const std::size_t count = strip.size();
      if (count < 3) continue;
      const bool odd = count % 2 == 0;
      mesh_.indices.insert(mesh_.indices.end(),
                           {strip[count - 3], strip[count - (odd ? 1 : 2)], strip[count - (odd ? 2 : 1)]});
    }
    return {};
  }

  const Header& header_;
  std::uint64_t memory_ = 0;  // of the elements that were read [bytes]
  ValueReader reader_;
  Mesh mesh_;
  std::vector<double> list_;
  bool has_normals_ = false;
};

}  // namespace

Result<Scene> decodePly(std::span<const std::uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  MIRRORBALL_TRY(header, parseHeader(text));
  MIRRORBALL_TRY(mesh, PlyDecoder(header, bytes).decode());
  return meshScene(std::move(mesh));
}

}  // namespace mirrorball
