#include "mirrorball/scene/bodies/box_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <optional>

#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

constexpr int kBins = 16;
/// What a visit of a node costs, in tests of items.
constexpr float kCostOfNode = 1.0f;
/// Below this many items, a subtree is not worth a thread.
constexpr std::size_t kItemsOfTask = std::size_t{1} << 12;

/// Where items are cut in two: by the bin of their centre along an axis.
struct Cut {
  int axis;
  int bin;  ///< the first of the second part
  float cost;
};

/// A range of the items, sorted into a tree of its own.
class Subtree {
 public:
  Subtree(std::span<const Box> boxes, std::span<std::uint32_t> all, std::uint32_t items_of_leaf)
      : boxes_(boxes), all_(all), items_of_leaf_(items_of_leaf) {}

  BoxTree::Child build(std::span<std::uint32_t> items, int depth);
  std::vector<BoxTree::Node> takeNodes() { return std::move(nodes_); }

 private:
  int binOf(std::uint32_t item, int axis, const Box& centers) const;
  std::optional<Cut> bestCut(std::span<const std::uint32_t> items, const Box& centers) const;
  std::size_t cut(std::span<std::uint32_t> items, const Box& box, int depth) const;
  BoxTree::Child append(const Subtree& other, BoxTree::Child root);

  std::span<const Box> boxes_;
  std::span<std::uint32_t> all_;
  std::uint32_t items_of_leaf_;
  std::vector<BoxTree::Node> nodes_;
};

int Subtree::binOf(std::uint32_t item, int axis, const Box& centers) const {
  const float begin = centers.low[axis];
  const float along = (boxes_[item].center()[axis] - begin) / (centers.high[axis] - begin);
  return std::clamp(static_cast<int>(along * kBins), 0, kBins - 1);
}

/// The cut of the least cost by the surface area heuristic, if the centres are not all in one place.
std::optional<Cut> Subtree::bestCut(std::span<const std::uint32_t> items, const Box& centers) const {
  std::optional<Cut> best;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(centers.high[axis] > centers.low[axis])) continue;
    std::array<Box, kBins> bins;
    std::array<std::size_t, kBins> counts{};
    for (const std::uint32_t item : items) {
      const auto bin = static_cast<std::size_t>(binOf(item, axis, centers));
      bins[bin].include(boxes_[item]);
      ++counts[bin];
    }
    std::array<float, kBins> cost_below{};
    Box below;
    std::size_t count_below = 0;
    for (std::size_t bin = 1; bin < kBins; ++bin) {
      below.include(bins[bin - 1]);
      count_below += counts[bin - 1];
      cost_below[bin] = below.halfArea() * static_cast<float>(count_below);
    }
    Box above;
    std::size_t count_above = 0;
    for (std::size_t bin = kBins - 1; bin > 0; --bin) {
      above.include(bins[bin]);
      count_above += counts[bin];
      if (count_above == 0 || count_above == items.size()) continue;
      const float cost = cost_below[bin] + above.halfArea() * static_cast<float>(count_above);
      if (!best || cost < best->cost) best = Cut{axis, static_cast<int>(bin), cost};
    }
  }
  return best;
}

/// Puts the items of the first part before the others.
///
/// returns  how many they are; 0: they are best kept together
std::size_t Subtree::cut(std::span<std::uint32_t> items, const Box& box, int depth) const {
  if (items.size() <= 1 || depth <= 1) return 0;
  Box centers;
  for (const std::uint32_t item : items) centers.include({boxes_[item].center(), boxes_[item].center()});
  // So deep, that only halves still fit.
  const bool must_halve = std::bit_width(items.size()) + 2 > static_cast<std::size_t>(depth);
  const auto best = must_halve ? std::nullopt : bestCut(items, centers);
  if (best) {
    const float together = box.halfArea() * (static_cast<float>(items.size()) - kCostOfNode);
    if (items.size() <= items_of_leaf_ && best->cost >= together) return 0;
    const auto middle = std::partition(
        items.begin(), items.end(), [&](std::uint32_t item) { return binOf(item, best->axis, centers) < best->bin; });
    return static_cast<std::size_t>(middle - items.begin());
  }
  if (items.size() <= items_of_leaf_) return 0;
  const glm::vec3 size = centers.high - centers.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto middle = items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
  std::nth_element(items.begin(), middle, items.end(), [&](std::uint32_t a, std::uint32_t b) {
    const float at_a = boxes_[a].center()[axis], at_b = boxes_[b].center()[axis];
    return at_a != at_b ? at_a < at_b : a < b;
  });
  return items.size() / 2;
}

/// Takes over another subtree's nodes.
///
/// returns  its root, as numbered here
BoxTree::Child Subtree::append(const Subtree& other, BoxTree::Child root) {
  const auto offset = static_cast<std::uint32_t>(nodes_.size());
  for (BoxTree::Node node : other.nodes_) {
    for (BoxTree::Child& child : node.children)
      if (child.count == 0) child.first += offset;
    nodes_.push_back(node);
  }
  if (root.count == 0) root.first += offset;
  return root;
}

BoxTree::Child Subtree::build(std::span<std::uint32_t> items, int depth) {
  BoxTree::Child built;
  for (const std::uint32_t item : items) built.box.include(boxes_[item]);
  const std::size_t first_part = cut(items, built.box, depth);
  if (first_part == 0) {
    built.first = static_cast<std::uint32_t>(items.data() - all_.data());
    built.count = static_cast<std::uint32_t>(items.size());
    return built;
  }
  built.first = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  const std::span<std::uint32_t> parts[2] = {items.first(first_part), items.subspan(first_part)};
  BoxTree::Child children[2];
  if (std::min(parts[0].size(), parts[1].size()) >= kItemsOfTask) {
    Subtree other(boxes_, all_, items_of_leaf_);
    Subtree* const trees[2] = {this, &other};
    parallelFor(2, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) children[i] = trees[i]->build(parts[i], depth - 1);
    });
    children[1] = append(other, children[1]);
  } else {
    for (int i = 0; i < 2; ++i) children[i] = build(parts[i], depth - 1);
  }
  std::copy(std::begin(children), std::end(children), nodes_[built.first].children);
  return built;
}

}  // namespace

BoxTree boxTree(std::span<const Box> boxes, std::uint32_t items_of_leaf, int depth) {
  assert(!boxes.empty() && items_of_leaf >= 1 && std::bit_width(boxes.size()) + 2 <= static_cast<std::size_t>(depth));
  BoxTree tree;
  tree.items.resize(boxes.size());
  std::iota(tree.items.begin(), tree.items.end(), 0u);
  Subtree whole(boxes, tree.items, items_of_leaf);
  tree.root = whole.build(tree.items, depth);
  tree.nodes = whole.takeNodes();
  return tree;
}

BoxTree boxTreeOfParts(std::span<const Box> boxes, std::span<const std::size_t> ends, std::uint32_t items_of_leaf,
                       int depth, std::vector<BoxTree::Child>& roots) {
  const int depth_above = static_cast<int>(std::bit_width(ends.size())) + 2;
  std::vector<BoxTree> parts;
  std::vector<Box> boxes_of_parts;
  std::size_t begin = 0;
  for (const std::size_t end : ends) {
    parts.push_back(boxTree(boxes.subspan(begin, end - begin), items_of_leaf, depth - depth_above));
    boxes_of_parts.push_back(parts.back().root.box);
    begin = end;
  }
  BoxTree whole = boxTree(boxes_of_parts, 1, depth_above);
  const std::vector<std::uint32_t> order = std::move(whole.items);
  const std::size_t nodes_above = whole.nodes.size();
  whole.items.clear();
  roots.clear();
  for (const BoxTree& part : parts) {
    const auto first_node = static_cast<std::uint32_t>(whole.nodes.size());
    const auto first_item = static_cast<std::uint32_t>(whole.items.size());
    const auto renumbered = [&](BoxTree::Child child) {
      child.first += child.count == 0 ? first_node : first_item;
      return child;
    };
    roots.push_back(renumbered(part.root));
    for (const BoxTree::Node& node : part.nodes)
      whole.nodes.push_back({{renumbered(node.children[0]), renumbered(node.children[1])}});
    for (const std::uint32_t item : part.items) whole.items.push_back(first_item + item);
  }
  for (std::size_t node = 0; node < nodes_above; ++node)
    for (BoxTree::Child& child : whole.nodes[node].children)
      if (child.count > 0) child = roots[order[child.first]];
  if (whole.root.count > 0) whole.root = roots[order[whole.root.first]];
  return whole;
}

}  // namespace mirrorball
