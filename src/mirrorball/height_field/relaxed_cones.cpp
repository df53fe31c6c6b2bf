#include "mirrorball/height_field/relaxed_cones.h"

#include <algorithm>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

constexpr std::size_t kRowsPerSearch = 16;

/// How many cells of the finer level a cell has along one axis, with the odd one.
int childrenOf(int cell, int cells, int finer_cells) { return cell == cells - 1 ? finer_cells - 2 * cell : 2; }

/// Raises `best` to the fraction if that is more.
void raise(float& best, float numerator, float denominator) {
  if (numerator > best * denominator) best = numerator / denominator;
}

/// Raises `best` to the greatest squared slope of ways from the origin to a straight edge, h / |p| squared.
///
/// With h + b τ over the square root of α + 2 β τ + γ τ² the derivative is 0 at τ = (b α − h β) / (h γ − b β), and the
/// square there is (h² γ − 2 h b β + b² α) / (α γ − β²): the square of the slope of the plane through edge and origin.
void raiseToEdge(float& best, glm::vec2 begin, float h, glm::vec2 end, float h_end) {
  const float alpha = glm::dot(begin, begin);
  if (h > 0.0f) raise(best, h * h, alpha);
  if (h_end > 0.0f) raise(best, h_end * h_end, glm::dot(end, end));
  const glm::vec2 along = end - begin;
  const float b = h_end - h;
  const float beta = glm::dot(begin, along);
  const float gamma = glm::dot(along, along);
  const float over = b * alpha - h * beta;
  const float under = h * gamma - b * beta;
  if (over > 0.0f && over < under)
    raise(best, h * h * gamma - 2.0f * h * b * beta + b * b * alpha, alpha * gamma - beta * beta);
}

}  // namespace

RelaxedConeSearch::RelaxedConeSearch(const Image& heights, const ImageSet& maxima, MapEdges edges)
    : heights_(heights),
      maxima_(maxima),
      slopes_(maxima.levels(), 1),
      edges_(edges),
      highest_(maxima.at(maxima.levels() - 1, 0).samples()[0]) {
  boundSlopes();
  for (int level = 0; level < maxima_.levels(); ++level) {
    const Image& cells = maxima_.at(level, 0);
    levels_.push_back({{cells.width(), cells.height()}, cells.samples().data(), slopes_.at(level, 0).samples().data()});
  }
}

/// Bilinear slopes are means of those along opposite edges.
void RelaxedConeSearch::boundSlopes() {
  const glm::ivec2 size(heights_.width(), heights_.height());
  Image& finest = slopes_.at(0, 0);
  finest = Image::withoutValues(size.x, size.y, 4);
  parallelFor(std::size_t(size.y), kRowsPerSearch, [&](std::size_t begin, std::size_t end) {
    for (int y = int(begin); y < int(end); ++y)
      for (int x = 0; x < size.x; ++x) {
        const auto [near, right, below, far] = cornersOf({}, {x, y});
        const std::array<float, 4> bounds{std::min(right - near, far - below), std::max(right - near, far - below),
                                          std::min(below - near, far - right), std::max(below - near, far - right)};
        std::copy(bounds.begin(), bounds.end(), finest.texel(x, y));
      }
  });
  for (int level = 1; level < slopes_.levels(); ++level) {
    const Image& finer = slopes_.at(level - 1, 0);
    Image& cells = slopes_.at(level, 0);
    cells = Image::withoutValues(levelSide(size.x, level), levelSide(size.y, level), 4);
    parallelFor(std::size_t(cells.height()), kRowsPerSearch, [&](std::size_t begin, std::size_t end) {
      for (int y = int(begin); y < int(end); ++y)
        for (int x = 0; x < cells.width(); ++x) {
          float* to = cells.texel(x, y);
          std::copy_n(finer.texel(2 * x, 2 * y), 4, to);
          for (int j = 0; j < childrenOf(y, cells.height(), finer.height()); ++j)
            for (int i = 0; i < childrenOf(x, cells.width(), finer.width()); ++i) {
              const float* from = finer.texel(2 * x + i, 2 * y + j);
              for (int bound = 0; bound < 4; ++bound)
                to[bound] = bound % 2 == 0 ? std::min(to[bound], from[bound]) : std::max(to[bound], from[bound]);
            }
        }
    });
  }
}

RelaxedConeSearch::Corners RelaxedConeSearch::cornersOf(const Search& search, glm::ivec2 place) const {
  const int right = texelBeyond(place.x + 1, heights_.width(), edges_);
  const float* row = heights_.row(place.y).data();
  const float* below = heights_.row(texelBeyond(place.y + 1, heights_.height(), edges_)).data();
  return {row[place.x] - search.height, row[right] - search.height, below[place.x] - search.height,
          below[right] - search.height};
}

/// Notes a cell, how high it is and how near. (Number by number: pairs that were just written are slow to read.)
///
/// returns  whether it may change what is known; else nothing is noted
bool RelaxedConeSearch::boundNode(const Search& search, int level, int x, int y, glm::ivec2 shift, Node& node) const {
  const Level& cells = levels_[std::size_t(level)];
  const std::size_t index = std::size_t(y) * std::size_t(cells.cells.x) + std::size_t(x);
  const float rise = std::max(cells.maxima[index] - search.height, 0.0f);
  const int from_tip_x = shift.x - search.tip.x;
  const int from_tip_y = shift.y - search.tip.y;
  const int begin_x = (x << level) + from_tip_x;
  const int begin_y = (y << level) + from_tip_y;
  const int end_x = x == cells.cells.x - 1 ? heights_.width() + from_tip_x : begin_x + (1 << level);
  const int end_y = y == cells.cells.y - 1 ? heights_.height() + from_tip_y : begin_y + (1 << level);
  const float nearest_x = static_cast<float>(std::max(std::max(begin_x, -end_x), 0));
  const float nearest_y = static_cast<float>(std::max(std::max(begin_y, -end_y), 0));
  const float squared_rise = rise * rise;
  const float squared_distance = nearest_x * nearest_x + nearest_y * nearest_y;
  if (squared_rise <= search.best * squared_distance) return false;
  if (!mayFaceAway(cells.slopes + 4 * index, glm::vec2(float(begin_x), float(begin_y)),
                   glm::vec2(float(end_x), float(end_y)), search.top - rise))
    return false;
  node = {level, {x, y}, shift, squared_rise, squared_distance};
  return true;
}

/// Whether a tangent plane of a cell may lie above the rays' beginning, over the tip: h − ∇h · p > top.
///
/// slopes        of the cell
/// first, last   what p is between
/// lowest_plane  top − h, of its highest point
bool RelaxedConeSearch::mayFaceAway(const float* slopes, glm::vec2 first, glm::vec2 last, float lowest_plane) {
  const auto least = [](float low, float high, float begin, float end) {
    return std::min(std::min(low * begin, low * end), std::min(high * begin, high * end));
  };
  return -least(slopes[0], slopes[1], first.x, last.x) - least(slopes[2], slopes[3], first.y, last.y) > lowest_plane;
}

/// The square of the steepest way to a piece, or `best` where that is more. Along a ray from the tip the surface is a
/// parabola. So a piece that has the tip for a corner is steepest there, or at the two edges beyond. Any other lies
/// below its upper hull, two triangles that meet in the higher diagonal: those are steepest at an edge.
float RelaxedConeSearch::steepestOf(const Piece& piece, float best) {
  const auto [near, right, below, far] = piece.heights;
  const glm::vec2 p = piece.begin;
  const glm::vec2 p_far = p + piece.side;
  const glm::vec2 p_right(p_far.x, p.y);
  const glm::vec2 p_below(p.x, p_far.y);
  if (std::max(p.x * p_far.x, p.y * p_far.y) == 0.0f) {
    const bool is_left = p.x == 0.0f;
    const bool is_upper = p.y == 0.0f;
    const float beside = is_left ? (is_upper ? right : far) : (is_upper ? near : below);
    const float above_or_below = is_upper ? (is_left ? below : far) : (is_left ? near : right);
    const glm::vec2 up = glm::max(glm::vec2(beside, above_or_below), 0.0f) / piece.side;
    best = std::max(best, glm::dot(up, up));
    raiseToEdge(best, is_left ? p_right : p, is_left ? right : near, is_left ? p_far : p_below, is_left ? far : below);
    raiseToEdge(best, is_upper ? p_below : p, is_upper ? below : near, is_upper ? p_far : p_right,
                is_upper ? far : right);
    return best;
  }
  raiseToEdge(best, p, near, p_right, right);
  raiseToEdge(best, p_below, below, p_far, far);
  raiseToEdge(best, p, near, p_below, below);
  raiseToEdge(best, p_right, right, p_far, far);
  if (near + far > right + below)
    raiseToEdge(best, p, near, p_far, far);
  else
    raiseToEdge(best, p_right, right, p_below, below);
  return best;
}

/// The same of what faces away from where rays begin. A tangent plane over the tip is bilinear in the place where it
/// touches: it is highest, and lowest, at a corner. A piece that faces both ways is halved both ways some times, and
/// then counts as a whole, so that cones are never too wide.
float RelaxedConeSearch::steepestFacingAway(const Piece& piece, float top, float best, int parts) {
  const auto [near, right, below, far] = piece.heights;
  const glm::vec2 p = piece.begin / piece.side;
  const std::array<float, 4> planes{near - (right - near) * p.x - (below - near) * p.y,
                                    right - (right - near) * (p.x + 1.0f) - (far - right) * p.y,
                                    below - (far - below) * p.x - (below - near) * (p.y + 1.0f),
                                    far - (far - below) * (p.x + 1.0f) - (far - right) * (p.y + 1.0f)};
  const auto [lowest, highest] = std::minmax_element(planes.begin(), planes.end());
  if (*highest <= top) return best;
  const float whole = steepestOf(piece, best);
  if (*lowest > top || parts == 0 || whole == best) return whole;
  const float half = 0.5f * piece.side;
  const float upper = 0.5f * (near + right);
  const float left = 0.5f * (near + below);
  const float middle = 0.25f * (near + right + below + far);
  const float other = 0.5f * (right + far);
  const float lower = 0.5f * (below + far);
  const auto tryPart = [&](float x, float y, const Corners& heights) {
    const Piece part{piece.begin + half * glm::vec2(x, y), half, heights};
    best = steepestFacingAway(part, top, best, parts - 1);
  };
  tryPart(0.0f, 0.0f, {near, upper, left, middle});
  tryPart(1.0f, 0.0f, {upper, right, middle, other});
  tryPart(0.0f, 1.0f, {left, middle, below, lower});
  tryPart(1.0f, 1.0f, {middle, other, lower, far});
  return best;
}

void RelaxedConeSearch::tryPatch(Search& search, const SurfacePatch& patch) const {
  constexpr int kParts = 3;
  const Piece piece{glm::vec2(patch.place + patch.shift - search.tip), 1.0f, cornersOf(search, patch.place)};
  const float best = steepestFacingAway(piece, search.top, search.best, kParts);
  if (best > search.best) {
    search.best = best;
    search.where = patch;
  }
}

/// Those that may matter, the ones on the tip's side last, for they are taken up first.
int RelaxedConeSearch::pushChildren(const Search& search, const Node& node, Node* stack) const {
  const glm::ivec2 cells = levels_[std::size_t(node.level)].cells;
  const glm::ivec2 finer = levels_[std::size_t(node.level - 1)].cells;
  const int across = childrenOf(node.cell.x, cells.x, finer.x);
  const int down = childrenOf(node.cell.y, cells.y, finer.y);
  const glm::ivec2 first = 2 * node.cell;
  const bool is_left = search.tip.x < ((first.x + 1) << (node.level - 1)) + node.shift.x;
  const bool is_upper = search.tip.y < ((first.y + 1) << (node.level - 1)) + node.shift.y;
  int count = 0;
  for (int j = 0; j < down; ++j)
    for (int i = 0; i < across; ++i) {
      const int x = first.x + (is_left ? across - 1 - i : i);
      const int y = first.y + (is_upper ? down - 1 - j : j);
      if (boundNode(search, node.level - 1, x, y, node.shift, stack[count])) ++count;
    }
  return count;
}

void RelaxedConeSearch::writeSteepestWays(int y, float min_square, float* squares) const {
  SurfacePatch nearby{{0, y}, {0, 0}};
  for (int x = 0; x < heights_.width(); ++x) squares[x] = squaredSlope({x, y}, min_square, nearby);
}

/// The same for one texel.
///
/// nearby   where the steepest way of a neighbour ended; becomes where this one's does
float RelaxedConeSearch::squaredSlope(glm::ivec2 tip, float min_square, SurfacePatch& nearby) const {
  const float height = heights_.texel(tip.x, tip.y)[0];
  Search search{tip, height, highest_ - height, min_square, nearby};
  tryPatch(search, nearby);

  constexpr std::size_t kMostLevels = 31;
  constexpr std::size_t kMostChildren = 9;
  std::array<Node, kMostLevels * kMostChildren> stack;
  int count = 0;
  const auto pushCopy = [&](int i, int j) {
    const glm::ivec2 shift(i * heights_.width(), j * heights_.height());
    if (boundNode(search, maxima_.levels() - 1, 0, 0, shift, stack[std::size_t(count)])) ++count;
  };
  // Of a tiled map the eight copies around it too: the nearest copy of any place is in one of them.
  if (edges_ == MapEdges::tiled)
    for (int copy = 0; copy < 9; ++copy)
      if (copy != 4) pushCopy(copy % 3 - 1, copy / 3 - 1);
  pushCopy(0, 0);

  while (count > 0) {
    const Node node = stack[std::size_t(--count)];
    if (node.squared_rise <= search.best * node.squared_distance) continue;
    if (node.level == 0)
      tryPatch(search, {node.cell, node.shift});
    else
      count += pushChildren(search, node, &stack[std::size_t(count)]);
  }
  nearby = search.where;
  return search.best;
}

}  // namespace mirrorball
