#include "mirrorball/scene/mesh_file/ply_content.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/channel_range.h"
#include "mirrorball/scene/mesh_file/ply_values.h"
#include "mirrorball/scene/mesh_file/polygon.h"
#include "mirrorball/scene/mesh_file/vertex_colors.h"

namespace mirrorball {
namespace {

/// What a property means, of a vertex or of a face.
enum Role { kX, kY, kZ, kNx, kNy, kNz, kU, kV, kRed, kGreen, kBlue, kAlpha, kPicture, kRoleCount };

std::optional<Role> roleNamed(std::string_view name) {
  constexpr std::pair<std::string_view, Role> kRoles[] = {
      {"x", kX},
      {"y", kY},
      {"z", kZ},
      {"nx", kNx},
      {"ny", kNy},
      {"nz", kNz},
      {"normal_x", kNx},
      {"normal_y", kNy},
      {"normal_z", kNz},
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
      {"r", kRed},
      {"g", kGreen},
      {"b", kBlue},
      {"a", kAlpha},
      {"diffuse_red", kRed},
      {"diffuse_green", kGreen},
      {"diffuse_blue", kBlue},
      {"diffuse_alpha", kAlpha},
      {"texnumber", kPicture},
  };
  for (const auto& [role_name, role] : kRoles)
    if (name == role_name) return role;
  return {};
}

/// What a list of a face holds.
enum class ListRole { none, corners, uvs };

ListRole listRoleNamed(std::string_view name) {
  for (const std::string_view corners : {"vertex_indices", "vertex_index", "vertex_indexes", "indices"})
    if (name == corners) return ListRole::corners;
  for (const std::string_view uvs : {"texcoord", "texcoords", "texture_coordinates", "t"})
    if (name == uvs) return ListRole::uvs;
  return ListRole::none;
}

/// The properties of an element, and the values of one of its rows.
class Row {
 public:
  explicit Row(const PlyElement& element) : element_(element) {
    for (const PlyProperty& property : element.properties) {
      roles_.push_back(property.count_type ? std::nullopt : roleNamed(property.name));
      if (roles_.back()) scales_[*roles_.back()] = isFloat(property.type) ? 1.0 : fullScale(property.type);
    }
  }

  const std::vector<PlyProperty>& properties() const { return element_.properties; }
  bool has(std::initializer_list<Role> roles) const {
    return std::all_of(roles.begin(), roles.end(), [&](Role role) { return scales_[role] != 0.0; });
  }
  bool hasColor() const { return has({kRed, kGreen, kBlue}); }
  /// What stands for 1 by the type of a channel: 1 of a float.
  double full(Role channel) const { return scales_[channel]; }

  void set(std::size_t property, double value) {
    if (roles_[property]) values_[*roles_[property]] = value;
  }
  double at(Role role) const { return values_[role]; }

  /// As the file has it; alpha is NaN where it has none.
  glm::dvec4 color() const {
    return {at(kRed), at(kGreen), at(kBlue), has({kAlpha}) ? at(kAlpha) : std::numeric_limits<double>::quiet_NaN()};
  }

 private:
  const PlyElement& element_;
  std::vector<std::optional<Role>> roles_;
  std::array<double, kRoleCount> scales_{};  // 0: the property is absent
  std::array<double, kRoleCount> values_{};
};

glm::vec4 toFloats(glm::dvec4 numbers) {
  return {toFloat(numbers.x), toFloat(numbers.y), toFloat(numbers.z), toFloat(numbers.w)};
}

/// The colours of an element's rows, of which only all together tell what their numbers are.
class ElementColors {
 public:
  void add(glm::vec4 color) {
    for (int channel = 0; channel < 3; ++channel) color_.add(color[channel]);
    alpha_.add(color.a);
  }

  /// To be called when all are added: what stands for 1 is known by their types.
  void setTypes(double full_color, double full_alpha) {
    type_full_ = static_cast<float>(full_color);
    full_ = full(color_, full_color);
    full_alpha_ = full(alpha_, full_alpha);
  }

  /// The linear colour of what the file has.
  glm::vec4 toLinear(glm::vec4 read) const {
    const glm::vec3 share = glm::vec3(read) / full_;
    const float alpha = std::isnan(read.a) ? 1.0f : std::clamp(read.a / full_alpha_, 0.0f, 1.0f);
    if (full_ != 1.0f) return {linearFromCodes(share), alpha};
    return {glm::mix(glm::clamp(share, 0.0f, 1.0f), glm::vec3(1.0f), glm::isnan(share)), alpha};
  }

  /// What is odd about them, as "go to 188, …"; empty: nothing.
  std::string remark() const {
    const std::string greatest = formatNumber(color_.greatest());
    if (full_ != type_full_ && color_.greatest() > 0.0f) return "go to " + greatest + ", and are read as codes of 255";
    if (full_ == 1.0f && color_.isBeyond())
      return "go from " + formatNumber(color_.least()) + " to " + greatest + ", and are cut to 0 to 1";
    return "";
  }

 private:
  /// An integer wider than a byte may hold codes of bytes, and so may a float.
  static float full(const ChannelRange& range, double of_type) {
    const bool are_bytes =
        of_type == 1.0 ? range.isOfCodes()
                       : of_type > ChannelRange::kGreatestCode && range.greatest() <= ChannelRange::kGreatestCode;
    return are_bytes ? ChannelRange::kGreatestCode : static_cast<float>(of_type);
  }

  ChannelRange color_, alpha_;
  float type_full_ = 1.0f;
  float full_ = 1.0f;
  float full_alpha_ = 1.0f;
};

glm::vec2 downwards(double u, double v) {
  const auto coordinate = [](double value) { return toFloat(std::clamp(value, -1e6, 1e6)); };
  return {coordinate(u), coordinate(1.0 - v)};
}

class ContentReader {
 public:
  ContentReader(std::span<const std::uint8_t> file, const PlyHeader& header) : header_(header), values_(file, header) {}

  Result<PlyContent> read() {
    for (const PlyElement& element : header_.elements) {
      MIRRORBALL_TRY(rows, rowsThatFit(element));
      memory_ += memoryFor(element, rows);
      MIRRORBALL_TRY_VOID(checkMemory(memory_));
      MIRRORBALL_TRY(read, element.isVertices() ? readVertices(element, rows) : readFaces(element, rows));
      if (read == element.count) continue;
      content_.truncation = "ends in row " + std::to_string(read + 1) + " of " + std::to_string(element.count) +
                            " of '" + excerpt(element.name) + "'; it is truncated";
      break;
    }
    if (const std::size_t behind = values_.bytesBehind(); content_.truncation.empty() && behind > 0)
      content_.remarks.push_back(countedAre(behind, "byte") + " behind what its header counts, and left out");
    dropTrianglesOfNoPlace();
    for (std::string& remark : values_.remarks()) content_.remarks.push_back(std::move(remark));
    return std::move(content_);
  }

 private:
  static constexpr std::uint64_t kOfCorner = 100;  // bytes, measured with triangles whose normals are computed
  static constexpr std::uint64_t kOfOwn = 150;     // of a corner that has a vertex for itself, in growing lists
  static constexpr std::uint64_t kOfListed = 2 * sizeof(double);  // of a number in a list, which is kept twice

  tl::unexpected<Error> wrong(const std::string& what) const {
    return fail(ErrorCode::bad_file, values_.place() + ": " + what);
  }

  /// What an element takes at least, until the mesh has normals and tangents: a face is a triangle or more.
  static std::uint64_t memoryFor(const PlyElement& element, std::size_t rows) {
    if (element.isVertices()) return rows * std::uint64_t{sizeof(Vertex) + sizeof(glm::dvec3)};
    return element.isFaces() ? rows * triangleBytes(element) : 0;
  }

  static std::uint64_t triangleBytes(const PlyElement& element) {
    const bool has_own = Row(element).hasColor() || std::any_of(element.properties.begin(), element.properties.end(),
                                                                [](const PlyProperty& property) {
                                                                  return listRoleNamed(property.name) == ListRole::uvs;
                                                                });
    return 3 * (kOfCorner + (has_own ? kOfOwn : 0));
  }

  /// Asks for the memory of triangles that memoryFor() has not counted, before they are made. It is more than what
  /// their polygon takes while it is cut.
  ///
  /// errors   too_large
  Result<void> askForTriangles(std::size_t count) {
    memory_ += count * of_triangle_;
    return checkMemory(memory_);
  }

  /// How many rows the bytes can hold of those that the header names: memory is taken for no more.
  Result<std::size_t> rowsThatFit(const PlyElement& element) const {
    std::size_t least = 0;
    for (const PlyProperty& property : element.properties)
      least += values_.minSize(property.count_type.value_or(property.type));
    if (element.count > 0 && least == 0)
      return fail(ErrorCode::bad_file, "the rows of '" + excerpt(element.name) + "' have no properties");
    return element.count == 0 ? std::size_t{0} : std::min(element.count, values_.remaining() / least);
  }

  /// rows      that the bytes can hold
  /// returns   how many there are
  Result<std::size_t> readVertices(const PlyElement& element, std::size_t rows) {
    Row row(element);
    if (!row.has({kX, kY, kZ})) return fail(ErrorCode::bad_file, "its vertices lack x, y or z");
    content_.has_normals = row.has({kNx, kNy, kNz});
    content_.has_uvs = row.has({kU, kV});
    content_.has_colors = row.hasColor();
    // A text has all the digits that it has, whatever its header says.
    for (const PlyProperty& property : element.properties)
      if (roleNamed(property.name) == kX)
        content_.positions_are_floats = header_.encoding != PlyEncoding::ascii && property.type == PlyType::float32;

    content_.vertices.reserve(content_.vertices.size() + rows);
    content_.positions.reserve(content_.positions.size() + rows);
    const std::size_t first = content_.vertices.size();
    std::size_t read = 0;
    for (; read < rows; ++read) {
      MIRRORBALL_TRY(is_whole, readRow(row, read, element.count));
      if (!is_whole) break;
      addVertex(row);
    }
    if (!content_.has_colors) return read;
    const auto added = std::span(content_.vertices).subspan(first);
    ElementColors colors;
    for (const Vertex& vertex : added) colors.add(vertex.color);
    colors.setTypes(row.full(kRed), row.full(kAlpha));
    for (Vertex& vertex : added) vertex.color = colors.toLinear(vertex.color);
    tellOfColors("vertices", colors);
    return read;
  }

  void addVertex(const Row& row) {
    content_.positions.push_back(toPlace({row.at(kX), row.at(kY), row.at(kZ)}));
    Vertex& vertex = content_.vertices.emplace_back();
    if (content_.has_normals) vertex.normal = {toFloat(row.at(kNx)), toFloat(row.at(kNy)), toFloat(row.at(kNz))};
    if (content_.has_uvs) vertex.uv[0] = vertex.uv[1] = downwards(row.at(kU), row.at(kV));
    if (content_.has_colors) vertex.color = toFloats(row.color());
  }

  void tellOfColors(const char* of, const ElementColors& colors) {
    if (const std::string remark = colors.remark(); !remark.empty())
      content_.remarks.push_back("the colours of its " + std::string(of) + " " + remark);
  }

  /// Reads a row of an element of `count`; false where the file ends within it. A number at the very end of a text that
  /// lacks rows may be cut, too.
  Result<bool> readRow(Row& row, std::size_t index, std::size_t count) {
    values_.passComments();
    for (std::size_t i = 0; i < row.properties().size(); ++i) {
      const PlyProperty& property = row.properties()[i];
      if (property.count_type) {
        MIRRORBALL_TRY(is_whole, readList(property));
        if (!is_whole) return false;
        const ListRole role = listRoleNamed(property.name);
        if (role == ListRole::corners) corners_ = list_;
        if (role == ListRole::uvs) uvs_ = list_;
        continue;
      }
      const std::optional<double> value = values_.next(property.type);
      if (!value && values_.isAtEnd()) return false;
      if (!value) return wrong("no number for '" + excerpt(property.name) + "' of its row " + std::to_string(index));
      row.set(i, *value);
    }
    return index + 1 == count || !values_.endsWithinWord();
  }

  /// Reads any element but the vertices, and takes the faces and strips from it.
  ///
  /// rows, returns   as readVertices()
  Result<std::size_t> readFaces(const PlyElement& element, std::size_t rows) {
    Row row(element);
    const bool has_own = element.isFaces() && (row.hasColor() || row.has({kPicture}));
    of_triangle_ = triangleBytes(element);
    // Triangles before them have nothing for themselves.
    if (has_own) content_.faces.resize(content_.indices.size() / 3);
    const std::size_t first = content_.faces.size();
    ElementColors colors;
    std::size_t read = 0;
    for (; read < rows; ++read) {
      corners_.clear();
      uvs_.clear();
      MIRRORBALL_TRY(is_whole, readRow(row, read, element.count));
      if (!is_whole) break;
      if (element.isFaces()) MIRRORBALL_TRY_VOID(addFace());
      if (element.name == "tristrips") MIRRORBALL_TRY_VOID(addStrips());
      if (!has_own) continue;
      PlyFace face;
      if (row.hasColor()) colors.add(face.color = toFloats(row.color()));
      if (row.has({kPicture}) && std::abs(row.at(kPicture)) < 1e6) face.picture = static_cast<int>(row.at(kPicture));
      content_.faces.resize(content_.indices.size() / 3, face);
    }
    if (!has_own || !row.hasColor()) return read;
    content_.has_face_colors = true;
    colors.setTypes(row.full(kRed), row.full(kAlpha));
    for (PlyFace& face : std::span(content_.faces).subspan(first)) face.color = colors.toLinear(face.color);
    tellOfColors("faces", colors);
    return read;
  }

  /// Reads a list; false where the file ends within it.
  Result<bool> readList(const PlyProperty& property) {
    const std::optional<double> length = values_.next(*property.count_type);
    if (!length && values_.isAtEnd()) return false;
    const bool is_length =
        length && *length >= 0.0 && *length == std::floor(*length) && *length <= fullScale(*property.count_type);
    if (!is_length) return wrong("the list '" + excerpt(property.name) + "' has no valid length");
    if (*length > static_cast<double>(values_.remaining() / values_.minSize(property.type))) return false;
    const auto count = static_cast<std::size_t>(*length);
    MIRRORBALL_TRY_VOID(checkMemory(memory_ + count * kOfListed));
    list_.clear();
    list_.reserve(count);
    for (std::size_t left = count; left > 0; --left) {
      const std::optional<double> value = values_.next(property.type);
      if (!value && values_.isAtEnd()) return false;
      if (!value) return wrong("no number in the list '" + excerpt(property.name) + "'");
      list_.push_back(*value);
    }
    return true;
  }

  /// The index as a mesh stores it; where the vertices are known already it must be one of them.
  std::optional<std::uint32_t> findIndex(double value) const {
    if (!(value >= 0.0) || value != std::floor(value) || value >= 4294967295.0) return {};
    if (!content_.vertices.empty() && value >= static_cast<double>(content_.vertices.size())) return {};
    return static_cast<std::uint32_t>(value);
  }

  /// errors   too_large
  Result<void> addFace() {
    if (corners_.size() < 3) return {};
    MIRRORBALL_TRY_VOID(askForTriangles(corners_.size() - 3));
    face_.clear();
    for (const double value : corners_) {
      const std::optional<std::uint32_t> corner = findIndex(value);
      if (!corner) {
        content_.repair.triangles_of_no_vertex += corners_.size() - 2;
        return {};
      }
      face_.push_back(*corner);
    }
    // Faces that precede their vertices: a fan is all one can do.
    if (face_.size() == 3 || content_.vertices.empty()) {
      for (std::uint32_t i = 1; i + 1 < face_.size(); ++i) addTriangle({0, i, i + 1});
      return {};
    }
    polygon_.clear();
    // From its first corner, so that floats hold it wherever it lies.
    const glm::dvec3 origin = content_.positions[face_[0]];
    for (const std::uint32_t corner : face_) polygon_.emplace_back(content_.positions[corner] - origin);
    if (std::any_of(polygon_.begin(), polygon_.end(), [](glm::vec3 place) { return std::isnan(place.x); })) {
      content_.repair.triangles_of_no_place += face_.size() - 2;
      return {};
    }
    TriangulationWork work;
    for (const auto& triangle : triangulate(polygon_, &work)) addTriangle(triangle);
    content_.repair.faces_fanned += work.gave_up ? 1 : 0;
    return {};
  }

  /// Of corners of the face.
  void addTriangle(std::array<std::uint32_t, 3> corners) {
    for (const std::uint32_t corner : corners) content_.indices.push_back(face_[corner]);
    if (uvs_.size() != 2 * face_.size()) return;
    // Faces before the first with coordinates have none.
    content_.corner_uvs.resize(content_.indices.size() - 3);
    for (const std::uint32_t corner : corners)
      content_.corner_uvs.push_back(downwards(uvs_[2 * std::size_t(corner)], uvs_[2 * std::size_t(corner) + 1]));
  }

  /// A strip's triangles turn alternately; −1 begins a new strip.
  ///
  /// errors   too_large
  Result<void> addStrips() {
    MIRRORBALL_TRY_VOID(askForTriangles(corners_.size()));
    std::vector<std::optional<std::uint32_t>> strip;
    for (const double value : corners_) {
      if (value == -1.0) {
        strip.clear();
        continue;
      }
      strip.push_back(findIndex(value));
      const std::size_t count = strip.size();
      if (count < 3) continue;
      const bool odd = count % 2 == 0;
      const auto a = strip[count - 3], b = strip[count - (odd ? 1 : 2)], c = strip[count - (odd ? 2 : 1)];
      if (a && b && c)
        content_.indices.insert(content_.indices.end(), {*a, *b, *c});
      else
        ++content_.repair.triangles_of_no_vertex;
    }
    return {};
  }

  /// Vertices may follow their faces, so that only now it is known which are there.
  void dropTrianglesOfNoPlace() {
    if (!content_.corner_uvs.empty()) content_.corner_uvs.resize(content_.indices.size());
    if (!content_.faces.empty()) content_.faces.resize(content_.indices.size() / 3);
    std::size_t kept = 0;
    for (std::size_t triangle = 0; triangle < content_.indices.size() / 3; ++triangle) {
      const auto corners = std::span(content_.indices).subspan(3 * triangle, 3);
      const bool has_vertices =
          std::all_of(corners.begin(), corners.end(), [&](std::uint32_t i) { return i < content_.vertices.size(); });
      const bool has_places = has_vertices && std::none_of(corners.begin(), corners.end(), [&](std::uint32_t i) {
                                return std::isnan(content_.positions[i].x);
                              });
      if (!has_vertices) ++content_.repair.triangles_of_no_vertex;
      if (has_vertices && !has_places) ++content_.repair.triangles_of_no_place;
      if (!has_places) continue;
      std::copy_n(corners.begin(), 3, content_.indices.begin() + std::ptrdiff_t(3 * kept));
      if (!content_.corner_uvs.empty())
        std::copy_n(content_.corner_uvs.begin() + std::ptrdiff_t(3 * triangle), 3,
                    content_.corner_uvs.begin() + std::ptrdiff_t(3 * kept));
      if (!content_.faces.empty()) content_.faces[kept] = content_.faces[triangle];
      ++kept;
    }
    content_.indices.resize(3 * kept);
    if (!content_.corner_uvs.empty()) content_.corner_uvs.resize(3 * kept);
    if (!content_.faces.empty()) content_.faces.resize(kept);
  }

  const PlyHeader& header_;
  PlyValues values_;
  PlyContent content_;
  std::uint64_t memory_ = 0;       // of the elements that were read [bytes]
  std::uint64_t of_triangle_ = 0;  // of the element that is read [bytes]
  std::vector<double> list_;
  std::vector<double> corners_;  // of the row
  std::vector<double> uvs_;      // of the row
  std::vector<std::uint32_t> face_;
  std::vector<glm::vec3> polygon_;
};

}  // namespace

Result<PlyContent> readPlyContent(std::span<const std::uint8_t> file, const PlyHeader& header) {
  return ContentReader(file, header).read();
}

}  // namespace mirrorball
