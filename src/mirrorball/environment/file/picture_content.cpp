#include "mirrorball/environment/file/picture_content.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "mirrorball/environment/cube/cube_layout.h"

namespace mirrorball {
namespace {

/// The brightest channel of a texel; NaN and infinity are not light.
float brightness(const Image& picture, int x, int y) {
  const glm::vec3 light = rgbAt(picture, x, y);
  const float brightest = std::max({light.x, light.y, light.z, 0.0f});
  return std::isfinite(brightest) ? brightest : 0.0f;
}

/// A square part of a picture, of which texels are taken on a grid.
struct Square {
  const Image& picture;
  glm::ivec2 corner;
  int side;

  /// Calls visit(texel) with texels counted from the corner.
  ///
  /// most_rows  of the grid, which has as many columns
  template <typename Visit>
  void forEachTexel(int most_rows, Visit&& visit) const {
    const int count = std::min(side, most_rows);
    for (int j = 0; j < count; ++j)
      for (int i = 0; i < count; ++i) visit(glm::ivec2((glm::dvec2(i, j) + 0.5) / double(count) * double(side)));
  }

  /// Calls visit(place, brightness) with places in [-1, 1]² about the middle.
  template <typename Visit>
  void forEachSample(Visit&& visit) const {
    constexpr int kMostSamples = 128;
    forEachTexel(kMostSamples, [&](glm::ivec2 texel) {
      const glm::vec2 place = (glm::vec2(texel) + 0.5f) * (2.0f / static_cast<float>(side)) - 1.0f;
      visit(place, brightness(picture, corner.x + texel.x, corner.y + texel.y));
    });
  }
};

struct Count {
  int all = 0;
  int lit = 0;

  void add(bool is_lit) {
    ++all;
    lit += is_lit ? 1 : 0;
  }
  bool isMostlyLit() const { return 10 * lit > 6 * all; }
  bool isBlack() const { return all > 0 && 50 * lit <= all; }
};

/// Whether a square is black outside of its inscribed disc, and lit near each of the four points where that touches the
/// sides: a strip of a panorama on black is dark at two of them.
bool holdsDisc(const Square& square) {
  constexpr int kSmallest = 16;
  if (square.side < kSmallest) return false;
  std::vector<float> inside;
  square.forEachSample([&](glm::vec2 place, float light) {
    if (glm::dot(place, place) < 1.0f) inside.push_back(light);
  });
  const auto middle = inside.begin() + static_cast<std::ptrdiff_t>(inside.size() / 2);
  std::nth_element(inside.begin(), middle, inside.end());
  // A camera's black is not quite black. Of a bright lamp a mean would say too much.
  const float dark = 0.03f * *middle;
  Count outside;
  std::array<Count, 4> caps;
  square.forEachSample([&](glm::vec2 place, float light) {
    constexpr float kOutside = 1.1f, kCapBegin = 0.7f, kCapEnd = 0.9f, kCapWidth = 0.25f;
    const bool is_lit = light > dark;
    if (glm::dot(place, place) > kOutside * kOutside) outside.add(is_lit);
    for (const int axis : {0, 1}) {
      const float along = std::abs(place[axis]), across = std::abs(place[1 - axis]);
      if (along > kCapBegin && along < kCapEnd && across < kCapWidth)
        caps[static_cast<std::size_t>(2 * axis + (place[axis] > 0.0f ? 1 : 0))].add(is_lit);
    }
  });
  return *middle > 0.0f && outside.isBlack() &&
         std::all_of(caps.begin(), caps.end(), [](const Count& cap) { return cap.isMostlyLit(); });
}

/// How far two lists of light differ: 0, equal, to 1.
float difference(const std::vector<float>& a, const std::vector<float>& b) {
  double apart = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    apart += std::abs(double(a[i]) - double(b[i]));
    sum += double(a[i]) + double(b[i]);
  }
  return sum > 0.0 ? static_cast<float>(apart / sum) : 0.0f;
}

/// The light along an edge of a square: 0 and 1 the upper and the lower, 2 and 3 the left and the right one.
std::vector<float> lightAlongEdge(const Image& picture, int edge, int count) {
  std::vector<float> light;
  const int last = picture.width() - 1;
  for (int i = 0; i < count; ++i) {
    const int at = static_cast<int>((i + 0.5) / count * picture.width());
    const int across = edge % 2 == 0 ? 0 : last;
    light.push_back(edge < 2 ? brightness(picture, at, across) : brightness(picture, across, at));
  }
  return light;
}

/// The same numbers, begun in their middle.
std::vector<float> movedByHalf(std::vector<float> numbers) {
  std::rotate(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2), numbers.end());
  return numbers;
}

/// Whether edges that fold show a horizon direction each, from which they meet at the nadir. In a vignette, an ornament
/// or a tile edges are alike, or differ only by noise and by what does not fold.
///
/// folds    sum of the edges' differences from themselves, folded
bool areOfOwnDirections(std::array<std::vector<float>, 4> edges, float folds) {
  // Without the middle, where a ball that touches the sides shows.
  constexpr double kMiddle = 0.15;
  const std::size_t count = edges[0].size();
  const auto begin = static_cast<std::ptrdiff_t>(double(count) * (1.0 - kMiddle) / 2.0);
  for (std::vector<float>& light : edges) light.erase(light.begin() + begin, light.end() - begin);
  int alike = 0;
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = 0; b < a; ++b) alike += difference(edges[a], edges[b]) > 0.5f * folds + 0.01f ? 0 : 1;
  // Two of four directions may look alike.
  if (alike > 1) return false;
  double light_of_all = 0.0, moves = 0.0;
  std::vector<float> common(edges[0].size());
  for (const std::vector<float>& light : edges)
    for (std::size_t i = 0; i < light.size(); ++i) {
      common[i] += 0.25f * light[i];
      light_of_all += double(light[i]);
    }
  for (std::vector<float>& light : edges) {
    for (std::size_t i = 0; i < light.size(); ++i) light[i] -= common[i];
    const std::vector<float> moved = movedByHalf(light);
    for (std::size_t i = 0; i < light.size(); ++i) moves += std::abs(double(light[i]) - double(moved[i]));
  }
  // As the sum of the edges' differences would be, were each as bright as all of them.
  return 2.0 * moves > double(2.5f * folds + 0.1f) * light_of_all;
}

/// foldsAtEdges() of a square that shows no disc.
bool edgesFold(const Image& picture) {
  constexpr int kSmallest = 16, kMostSamples = 512;
  if (picture.width() < kSmallest) return false;
  const int count = std::min(picture.width(), kMostSamples) / 2 * 2;
  std::array<std::vector<float>, 4> edges;
  float all_folds = 0.0f;
  for (int edge = 0; edge < 4; ++edge) {
    const std::vector<float> light = lightAlongEdge(picture, edge, count);
    const float fold = difference(light, {light.rbegin(), light.rend()});
    if (fold > 0.25f) return false;
    all_folds += fold;
    edges[static_cast<std::size_t>(edge)] = light;
  }
  return areOfOwnDirections(edges, all_folds);
}

/// Square roots of the mean light in the cells of a part of a picture, by rows: a lamp counts less among them.
std::vector<float> cellsIn(const Image& picture, glm::ivec2 corner, glm::ivec2 size, glm::ivec2 cells) {
  constexpr int kSamples = 4;  // a cell, along each side
  std::vector<float> means;
  for (int y = 0; y < cells.y; ++y)
    for (int x = 0; x < cells.x; ++x) {
      double sum = 0.0;
      for (int sample = 0; sample < kSamples * kSamples; ++sample) {
        const glm::dvec2 inside(sample % kSamples, sample / kSamples);
        const glm::dvec2 share = (glm::dvec2(x, y) + (inside + 0.5) / double(kSamples)) / glm::dvec2(cells);
        const glm::ivec2 texel = corner + glm::min(glm::ivec2(share * glm::dvec2(size)), size - 1);
        sum += double(brightness(picture, texel.x, texel.y));
      }
      means.push_back(static_cast<float>(std::sqrt(sum / (kSamples * kSamples))));
    }
  return means;
}

/// Whether a cell of a layout holds one colour, as far as a compressed picture can.
bool isOfOneColour(const Square& cell) {
  constexpr int kMostRows = 32;
  glm::vec3 sum(0.0f);
  std::vector<glm::vec3> colours;
  cell.forEachTexel(kMostRows, [&](glm::ivec2 texel) {
    colours.push_back(rgbAt(cell.picture, cell.corner.x + texel.x, cell.corner.y + texel.y));
    sum += colours.back();
  });
  const glm::vec3 mean = sum / static_cast<float>(colours.size());
  float apart = 0.0f;
  for (const glm::vec3& colour : colours) apart += glm::length(colour - mean);
  return !(apart / static_cast<float>(colours.size()) > 0.02f * glm::length(mean) + 0.002f);
}

/// Whether each of the cells in which a layout has no face holds more than one colour.
bool fillsCellsBeside(const Image& picture, CubeLayout layout) {
  const glm::ivec2 cells = cellsOf(layout);
  constexpr int kSmallest = 16;
  const int side = picture.width() / cells.x;
  if (side < kSmallest) return false;
  for (int y = 0; y < cells.y; ++y)
    for (int x = 0; x < cells.x; ++x) {
      bool is_face = false;
      for (int face = 0; face < 6; ++face) is_face = is_face || cellOf(layout, face) == glm::ivec2(x, y);
      if (!is_face && isOfOneColour({picture, glm::ivec2(x, y) * side, side})) return false;
    }
  return true;
}

/// Whether a part's cells, by rows, go on at its left edge where they end at the right one: it is then a whole circle,
/// or two halves of a circle that shows the same twice. Black edges show nothing.
bool goesRound(const std::vector<float>& cells, glm::ivec2 count) {
  const auto at = [&](int x, int y) { return cells[static_cast<std::size_t>(y * count.x + x)]; };
  double seam = 0.0, steps = 0.0, at_edges = 0.0, all = 0.0;
  for (int y = 0; y < count.y; ++y) {
    seam += std::abs(double(at(count.x - 1, y)) - double(at(0, y)));
    at_edges += double(at(count.x - 1, y)) + double(at(0, y));
    for (int x = 0; x < count.x; ++x) all += double(at(x, y));
    for (int x = 1; x < count.x; ++x) steps += std::abs(double(at(x, y)) - double(at(x - 1, y)));
  }
  // Cells are square roots of light.
  if (at_edges / 2.0 < 0.2 * all / count.x) return false;
  return seam <= 1.5 * steps / (count.x - 1);
}

std::vector<float> withRowsReversed(std::vector<float> cells, int width) {
  for (auto row = cells.begin(); row != cells.end(); row += width) std::reverse(row, row + width);
  return cells;
}

/// Whether a picture's halves, of which one is named, are nearly equal, and not in many other ways too.
bool hasEqualHalves(const Image& picture, PictureHalf half) {
  constexpr glm::ivec2 kCells(48, 24);
  const glm::ivec2 whole(picture.width(), picture.height());
  const glm::ivec2 size = sizeOfHalf(whole, half);
  if (size.x < kCells.x || size.y < kCells.y) return false;
  const std::vector<float> first = cellsIn(picture, {0, 0}, size, kCells);
  const std::vector<float> second = cellsIn(picture, whole - size, size, kCells);
  // Sky and ground differ, and so do right and left. Stripes, tiles and one colour are equal in many other ways too.
  const auto middle = first.begin() + static_cast<std::ptrdiff_t>(first.size() / 2);
  const float from_top_to_bottom = difference({first.begin(), middle}, {middle, first.end()});
  const float from_side_to_side = difference(first, withRowsReversed(first, kCells.x));
  const float between = difference(first, second);
  const bool is_panorama = size.x < 2 * size.y && goesRound(first, kCells);
  return between < 0.08f && between < 0.3f * std::min(from_top_to_bottom, from_side_to_side) && !is_panorama;
}

/// Whether all texels are alike.
bool isEven(const Image& picture) {
  const auto first = picture.samples().first(static_cast<std::size_t>(picture.channels()));
  for (std::size_t i = 0; i < picture.samples().size(); ++i)
    if (picture.samples()[i] != first[i % first.size()]) return false;
  return true;
}

}  // namespace

bool showsDisc(const Image& picture) { return holdsDisc({picture, {0, 0}, picture.width()}); }

bool showsTwoDiscs(const Image& picture) {
  const int side = picture.height();
  return picture.width() == 2 * side && holdsDisc({picture, {0, 0}, side}) && holdsDisc({picture, {side, 0}, side});
}

bool foldsAtEdges(const Image& picture) { return !showsDisc(picture) && edgesFold(picture); }

std::optional<PictureHalf> equalHalves(const Image& picture) {
  const glm::ivec2 whole(picture.width(), picture.height());
  const PictureHalf half = whole.x == whole.y ? PictureHalf::top : PictureHalf::left;
  const glm::ivec2 size = sizeOfHalf(whole, half);
  return size.x == 2 * size.y && hasEqualHalves(picture, half) ? std::optional(half) : std::nullopt;
}

bool fillsEmptyCells(const Image& picture, CubeLayout cross) {
  if (cross == CubeLayout::hcross)
    return fillsCellsBeside(picture, CubeLayout::hcross) && fillsCellsBeside(picture, CubeLayout::lecture);
  return cross == CubeLayout::vcross && fillsCellsBeside(picture, cross);
}

Result<FormDoubt> settleByContent(const Image& picture, Recognition& recognition) {
  if (!recognition.is_by_shape) return FormDoubt{};
  MapForm& form = recognition.form;
  if (form.projection == Projection::equirect && showsTwoDiscs(picture))
    return fail(ErrorCode::bad_shape,
                "is 2:1 and shows two discs on black, as a camera with two fisheye lenses writes them before they are "
                "stitched: {option:from} dual-fisheye stitches it, {option:from} paraboloid reads a dual paraboloid "
                "map, {option:from} equirect a panorama");
  if (form.projection == Projection::equirect && hasEqualHalves(picture, PictureHalf::left))
    return FormDoubt{
        "is 2:1 with two nearly equal halves, as the pictures of half the sphere for two eyes are: taken as one "
        "panorama",
        {"equirect:eye=left,fov=180x180"}};
  // Light of one colour is the same in every form.
  if (form.projection != Projection::sphere || isEven(picture)) return FormDoubt{};
  if (showsDisc(picture))
    return FormDoubt{"is square, with a disc on black: taken as a sphere map, a mirror ball seen from far away",
                     {"angular", "ball"}};
  if (edgesFold(picture)) {
    form.projection = Projection::equal_area;
    recognition.told_by += ", and how its edges fold";
    return FormDoubt{"is square, and its edges fold as an octahedron's: taken as pbrt's equal-area map",
                     {"octahedral", "sphere"}};
  }
  return FormDoubt{
      "is square, with light in its corners, where a disc has none: taken as a sphere map, cut to its disc",
      {"angular", "ball", "equal-area", "octahedral"}};
}

}  // namespace mirrorball
