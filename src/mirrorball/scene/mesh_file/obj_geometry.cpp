#include "mirrorball/scene/mesh_file/obj_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/channel_range.h"
#include "mirrorball/scene/mesh_file/number_text.h"
#include "mirrorball/scene/mesh_file/obj_statements.h"
#include "mirrorball/scene/mesh_file/smoothing.h"
#include "mirrorball/scene/mesh_file/vertex_colors.h"

namespace mirrorball {
namespace {

/// The colours of vertices, in whichever of their places the file has them.
class VertexColors {
 public:
  /// Of the vertex of that index, behind its position.
  void add(std::size_t vertex, glm::dvec3 color) {
    behind_positions_.resize(vertex, kNone);
    behind_positions_.emplace_back(toFloat(color.x), toFloat(color.y), toFloat(color.z));
    for (int channel = 0; channel < 3; ++channel) range_.add(behind_positions_.back()[channel]);
  }

  /// Of the next vertices: 8 hexadecimal digits each, the first two of which are a mask.
  void addPolypaint(std::string_view digits) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    const std::string text = lowerCase(digits);
    if (text.find_first_not_of(kDigits) != std::string::npos) return;
    const auto byteAt = [&](std::size_t at) { return 16 * kDigits.find(text[at]) + kDigits.find(text[at + 1]); };
    for (std::size_t at = 0; at + 8 <= text.size(); at += 8)
      polypaint_.emplace_back(byteAt(at + 2), byteAt(at + 4), byteAt(at + 6));
  }

  /// Of that many vertices; empty: the file has none.
  std::vector<glm::vec3> linear(std::size_t vertices, std::vector<std::string>& remarks) {
    const bool are_codes = behind_positions_.empty() || range_.isOfCodes();
    std::vector<glm::vec3>& colors = behind_positions_.empty() ? polypaint_ : behind_positions_;
    if (colors.empty()) return {};
    if (range_.isBeyond())
      remarks.push_back(are_codes ? "has colours of vertices up to " + formatNumber(range_.greatest()) +
                                        ", beyond the 1 that is usual: they are read as codes of 255"
                                  : "has colours of vertices from " + formatNumber(range_.least()) + " to " +
                                        formatNumber(range_.greatest()) + ": they are cut to 0 to 1");
    colors.resize(vertices, kNone);
    for (glm::vec3& color : colors) color = linearFromCodes(are_codes ? color / ChannelRange::kGreatestCode : color);
    return std::move(colors);
  }

 private:
  static constexpr glm::vec3 kNone{std::numeric_limits<float>::quiet_NaN()};  // white

  std::vector<glm::vec3> behind_positions_;
  std::vector<glm::vec3> polypaint_;
  ChannelRange range_;  // of those behind positions
};

/// An index as OBJ counts it, from 1, or from the last one backwards: from 0. Nothing where it can name none.
std::optional<int> fromZero(std::string_view text, std::size_t count) {
  const int index = readInteger(text).value_or(0);
  if (index == 0) return {};
  const long long from_zero = index > 0 ? index - 1LL : static_cast<long long>(count) + index;
  const bool is_index = from_zero >= 0 && from_zero <= std::numeric_limits<int>::max();
  return is_index ? std::optional(static_cast<int>(from_zero)) : std::nullopt;
}

/// The numbers of a statement: at most 8, up to a comment.
struct StatementNumbers {
  std::array<double, 8> values{};
  std::size_t count = 0;
};

class GeometryReader {
 public:
  explicit GeometryReader(std::string_view text) : statements_(text) {}

  ObjGeometry read() {
    while (statements_.next()) readStatement();
    dropBadFaces();
    tellOfFaces();
    tellOfOtherElements();
    geometry_.colors = colors_.linear(geometry_.positions.size(), geometry_.remarks);
    for (std::string& remark : numbers_.remarks()) geometry_.remarks.push_back(std::move(remark));
    if (line_of_index_ > 0)
      geometry_.remarks.push_back("line " + std::to_string(line_of_index_) +
                                  ": has a point or a comma behind an index, which is read without it");
    if (line_of_weight_ > 0)
      geometry_.remarks.push_back(
          "line " + std::to_string(line_of_weight_) +
          ": the weight of a vertex is not 1; weights are left out, since only curves have them");
    return std::move(geometry_);
  }

 private:
  void readStatement() {
    const std::string& keyword = statements_.keyword();
    if (keyword == "v") {
      addPosition();
    } else if (keyword == "vn") {
      const StatementNumbers numbers = takeNumbers();
      const auto& n = numbers.values;
      geometry_.normals.emplace_back(toFloat(n[0]), toFloat(n[1]), toFloat(n[2]));
    } else if (keyword == "vt") {
      const StatementNumbers numbers = takeNumbers();
      geometry_.uvs.emplace_back(toFloat(numbers.values[0]), toFloat(1.0 - numbers.values[1]));
    } else if (keyword == "f" || keyword == "fo") {  // "fo" is what version 2 of the format had
      addFace();
    } else if (keyword == "usemtl") {
      useMaterial(std::string(statements_.rest()));
    } else if (keyword == "s") {
      setSmoothing();
    } else if (keyword == "mtllib") {
      if (known_tables_.emplace(statements_.rest()).second) geometry_.tables.emplace_back(statements_.rest());
    } else if (keyword == "l") {
      ++lines_;
    } else if (keyword == "p") {
      ++points_;
    } else if (keyword == "curv" || keyword == "surf") {
      ++free_forms_;
    } else if (keyword == "#mrgb") {
      colors_.addPolypaint(statements_.rest());
    }
  }

  StatementNumbers takeNumbers() {
    StatementNumbers numbers;
    std::string_view rest = statements_.rest();
    while (!rest.empty() && !rest.starts_with('#') && numbers.count < numbers.values.size())
      numbers.values[numbers.count++] = numbers_.read(takeWord(rest), statements_.line()).value;
    return numbers;
  }

  void addPosition() {
    const StatementNumbers numbers = takeNumbers();
    const auto& n = numbers.values;
    const std::size_t vertex = geometry_.positions.size();
    // "v 1 2" is nowhere, rather than at z = 0.
    const double z = numbers.count >= 3 ? n[2] : std::numeric_limits<double>::quiet_NaN();
    geometry_.positions.push_back(toPlace({n[0], n[1], z}));
    if (numbers.count >= 6) colors_.add(vertex, {n[3], n[4], n[5]});
    if (numbers.count == 4 && n[3] != 1.0 && line_of_weight_ == 0) line_of_weight_ = statements_.line();
  }

  void useMaterial(std::string name) {
    const auto [found, is_new] =
        materials_.try_emplace(std::move(name), static_cast<int>(geometry_.material_names.size()));
    if (is_new) geometry_.material_names.push_back(found->first);
    material_ = found->second;
  }

  void setSmoothing() {
    std::string_view rest = statements_.rest();
    const std::string_view word = takeWord(rest);
    const double number = readNumber(word).value;
    const bool is_group = number >= 0.0 && number <= std::numeric_limits<int>::max();
    if (!is_group && lowerCase(word) != "off") return;
    has_smoothing_ = true;
    smoothing_ = is_group ? static_cast<int>(number) : kFlat;
  }

  /// An index without what makes another number of it: the comma of "5," and the zeros of "5.0".
  std::string_view wholeIndex(std::string_view text) {
    std::string_view whole = text.substr(0, text.size() - (text.ends_with(',') ? 1 : 0));
    const std::size_t point = std::min(whole.find('.'), whole.size());
    if (whole.find_first_not_of('0', point + 1) == std::string_view::npos) whole = whole.substr(0, point);
    if (whole.size() < text.size() && line_of_index_ == 0) line_of_index_ = statements_.line();
    return whole;
  }

  /// Adds a corner "5/2/7", "5//7", "5/2", "5/2/" or "5"; false where it names no position.
  bool addCorner(std::string_view word) {
    std::array<std::string_view, 3> parts;
    for (std::string_view& part : parts) {
      part = word.substr(0, word.find('/'));
      word.remove_prefix(std::min(part.size() + 1, word.size()));
      if (part.find_first_of(".,") != std::string_view::npos) part = wholeIndex(part);
    }
    const std::optional<int> position = fromZero(parts[0], geometry_.positions.size());
    ObjCorner& corner = geometry_.corners.emplace_back();
    corner.position = position.value_or(-1);
    corner.uv = attribute(parts[1], geometry_.uvs.size());
    corner.normal = attribute(parts[2], geometry_.normals.size());
    return position.has_value();
  }

  int attribute(std::string_view text, std::size_t count) {
    if (text.empty() || text == "0") return -1;  // some programs write 0 for none
    const std::optional<int> index = fromZero(text, count);
    if (!index) ++attributes_past_end_;
    return index.value_or(-1);
  }

  void addFace() {
    const std::size_t first = geometry_.corners.size();
    std::string_view rest = statements_.rest();
    bool is_good = true;
    while (!rest.empty() && !rest.starts_with('#')) is_good = addCorner(takeWord(rest)) && is_good;
    const std::size_t count = geometry_.corners.size() - first;
    if (count >= 3 && is_good) {
      geometry_.faces.push_back({first, count, material_, has_smoothing_ ? smoothing_ : kSmoothByAngle});
      return;
    }
    if (count < 3)
      ++faces_of_few_corners_;
    else
      geometry_.repair.triangles_of_no_vertex += count - 2;
    geometry_.corners.resize(first);
  }

  /// Positive indices may name what comes later in the file, so that only now it is known whether it is there.
  void dropBadFaces() {
    const auto isPast = [](int index, std::size_t count) { return index >= 0 && std::size_t(index) >= count; };
    const bool has_groups = std::any_of(geometry_.faces.begin(), geometry_.faces.end(),
                                        [](const ObjFace& face) { return face.smoothing != kSmoothByAngle; });
    std::erase_if(geometry_.faces, [&](ObjFace& face) {
      // "The default value for s is off" (Wavefront, Object Files), in files that have any.
      if (has_groups && face.smoothing == kSmoothByAngle) face.smoothing = kFlat;
      bool has_vertices = true, has_places = true;
      for (std::size_t i = face.first_corner; i < face.first_corner + face.corner_count; ++i) {
        ObjCorner& corner = geometry_.corners[i];
        has_vertices = has_vertices && !isPast(corner.position, geometry_.positions.size());
        has_places = has_places && has_vertices && !std::isnan(geometry_.positions[std::size_t(corner.position)].x);
        for (const auto& [index, count] :
             {std::pair(&corner.uv, geometry_.uvs.size()), std::pair(&corner.normal, geometry_.normals.size())})
          if (isPast(*index, count)) {
            *index = -1;
            ++attributes_past_end_;
          }
      }
      if (!has_vertices) geometry_.repair.triangles_of_no_vertex += face.corner_count - 2;
      if (has_vertices && !has_places) geometry_.repair.triangles_of_no_place += face.corner_count - 2;
      return !has_vertices || !has_places;
    });
  }

  void tellOfOtherElements() {
    if (lines_ + points_ > 0) {
      std::vector<std::string> names;
      if (lines_ > 0) names.push_back(counted(lines_, "line"));
      if (points_ > 0) names.push_back(counted(points_, "point"));
      geometry_.remarks.push_back(join(names, " and ") + (lines_ + points_ == 1 ? " is" : " are") +
                                  " left out, since only faces are drawn");
    }
    if (free_forms_ > 0)
      geometry_.remarks.push_back(countedAre(free_forms_, "free-form curve or surface") +
                                  " left out; export the model as polygons");
  }

  void tellOfFaces() {
    if (faces_of_few_corners_ > 0)
      geometry_.remarks.push_back(countedAre(faces_of_few_corners_, "face") + " left out that " +
                                  (faces_of_few_corners_ == 1 ? "has" : "have") + " fewer corners than three");
    if (attributes_past_end_ > 0)
      geometry_.remarks.push_back(counted(attributes_past_end_, "corner") + " of faces " +
                                  (attributes_past_end_ == 1 ? "names" : "name") +
                                  " normals or texture coordinates that are not there, and go without");
  }

  StatementReader statements_;
  NumberReader numbers_;
  VertexColors colors_;
  ObjGeometry geometry_;
  std::unordered_map<std::string, int> materials_;
  std::set<std::string> known_tables_;
  int material_ = -1;
  int smoothing_ = kFlat;
  bool has_smoothing_ = false;
  std::size_t faces_of_few_corners_ = 0;
  std::size_t lines_ = 0;
  std::size_t points_ = 0;
  std::size_t free_forms_ = 0;
  std::size_t attributes_past_end_ = 0;
  std::size_t line_of_index_ = 0;   // of the first that has more than digits; 0: there is none
  std::size_t line_of_weight_ = 0;  // of the first that is not 1; 0: there is none
};

}  // namespace

ObjGeometry readObjGeometry(std::string_view text) { return GeometryReader(text).read(); }

std::uint64_t memoryForObj(std::string_view text) {
  constexpr std::uint64_t kOfCorner = 300;  // measured with triangles that share nothing, whose normals are computed
  // A position and its colour, a normal or a coordinate in a growing list.
  constexpr std::uint64_t kOfElement = 2 * (sizeof(glm::dvec3) + sizeof(glm::vec3));
  std::uint64_t bytes = 0;
  for (StatementReader statements(text); statements.next();) {
    const std::string& keyword = statements.keyword();
    if (keyword.starts_with('v')) bytes += kOfElement;
    if (!keyword.starts_with('f')) continue;
    std::string_view rest = statements.rest();
    while (!rest.empty()) {
      takeWord(rest);
      bytes += kOfCorner;
    }
  }
  return bytes;
}

}  // namespace mirrorball
