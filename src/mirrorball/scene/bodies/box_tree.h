#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mirrorball/scene/box.h"

namespace mirrorball {

/// A tree of boxes around items that are found by rays.
struct BoxTree {
  /// What a node has on each side: another node, or some of the items.
  struct Child {
    Box box;
    std::uint32_t first = 0;  ///< a node; of a leaf, a place in `items`
    std::uint32_t count = 0;  ///< of a leaf's items; 0: it is a node
  };
  struct Node {
    Child children[2];
  };

  Child root;
  std::vector<Node> nodes;           ///< a node stands before its children
  std::vector<std::uint32_t> items;  ///< by their numbers, those of a leaf side by side
};

/// Sorts boxes into a tree in which rays visit few: each node is cut in two where Goldsmith & Salmon's surface area
/// heuristic finds the least, tried at 16 places along each axis (Wald 2007, "On fast construction of SAH-based
/// bounding volume hierarchies").
///
/// boxes            finite, fewer than 2³¹, at least one
/// items_of_leaf    at most
/// depth            at most so many nodes from the root to a leaf, which is one; at least log₂(boxes) + 3
/// cost             O(n log n) time, 36 bytes an item beside the tree; the same for any number of threads
BoxTree boxTree(std::span<const Box> boxes, std::uint32_t items_of_leaf, int depth);

/// The same of parts that are kept apart, each with a tree of its own in the whole one.
///
/// ends     of each part's boxes, which stand side by side; no part is empty
/// depth    at least 4 + log₂(parts) more than the largest part needs
/// roots    becomes those of the parts' trees
BoxTree boxTreeOfParts(std::span<const Box> boxes, std::span<const std::size_t> ends, std::uint32_t items_of_leaf,
                       int depth, std::vector<BoxTree::Child>& roots);

}  // namespace mirrorball
