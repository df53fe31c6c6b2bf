#include "mirrorball/scene/bodies/box_tree.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

/// Boxes in all places and of all sizes.
std::vector<Box> randomBoxes(std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 low(unit(random), unit(random), unit(random));
    const glm::vec3 size(unit(random), unit(random), unit(random));
    boxes.push_back({low, low + 0.1f * size * size});
  }
  return boxes;
}

/// Checks that boxes enclose all that is below them, and counts it.
struct Inspection {
  const BoxTree& tree;
  std::span<const Box> boxes;
  std::vector<int> seen = std::vector<int>(boxes.size());
  std::uint32_t most_items = 0;
  int depth = 0;

  static bool encloses(const Box& outer, const Box& inner) {
    return glm::all(glm::lessThanEqual(outer.low, inner.low)) &&
           glm::all(glm::greaterThanEqual(outer.high, inner.high));
  }
  void visit(const BoxTree::Child& child, int level) {
    depth = std::max(depth, level);
    if (child.count > 0) {
      most_items = std::max(most_items, child.count);
      for (std::uint32_t i = child.first; i < child.first + child.count; ++i) {
        EXPECT_TRUE(encloses(child.box, boxes[tree.items[i]]));
        ++seen[tree.items[i]];
      }
      return;
    }
    for (const BoxTree::Child& below : tree.nodes[child.first].children) {
      EXPECT_TRUE(encloses(child.box, below.box));
      visit(below, level + 1);
    }
  }
};

TEST(BoxTree, HoldsEachItemOnceWithinItsBoxes) {
  for (const std::size_t count : {1u, 2u, 5u, 1000u}) {
    const std::vector<Box> boxes = randomBoxes(count);
    const BoxTree tree = boxTree(boxes, 4, 40);
    Inspection inspection{tree, boxes};
    inspection.visit(tree.root, 1);
    EXPECT_TRUE(std::ranges::all_of(inspection.seen, [](int times) { return times == 1; }));
    EXPECT_LE(inspection.most_items, 4u);
    EXPECT_LE(inspection.depth, 40);
  }
}

// Where nothing tells items apart they are halved; and where each is ten times as far away as the one before, a cut by
// area takes them off one by one.
TEST(BoxTree, IsNoDeeperThanAsked) {
  std::vector<Box> same(1000, Box{glm::vec3(1.0f), glm::vec3(2.0f)});
  std::vector<Box> apart;
  for (float at = 1e-30f; at < 1e30f; at *= 1.15f) apart.push_back({glm::vec3(at), glm::vec3(at * 1.01f)});
  for (const std::vector<Box>& boxes : {same, apart})
    for (const int depth : {13, 40}) {
      const BoxTree tree = boxTree(boxes, 4, depth);
      Inspection inspection{tree, boxes};
      inspection.visit(tree.root, 1);
      EXPECT_LE(inspection.depth, depth);
      EXPECT_LE(inspection.most_items, 4u);
      EXPECT_TRUE(std::ranges::all_of(inspection.seen, [](int times) { return times == 1; }));
    }
}

// As many as subtrees on threads of their own need.
TEST(BoxTree, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Box> boxes = randomBoxes(300000);
  const int threads = threadLimit();
  setThreadLimit(1);
  const BoxTree one = boxTree(boxes, 4, 40);
  setThreadLimit(4);
  const BoxTree other = boxTree(boxes, 4, 40);
  setThreadLimit(threads);
  EXPECT_EQ(one.items, other.items);
  ASSERT_EQ(one.nodes.size(), other.nodes.size());
  for (std::size_t i = 0; i < one.nodes.size(); ++i)
    for (int side = 0; side < 2; ++side)
      EXPECT_EQ(one.nodes[i].children[side].first, other.nodes[i].children[side].first);
}

TEST(BoxTree, OfPartsHasATreeOfEach) {
  const std::vector<Box> boxes = randomBoxes(1000);
  for (const std::vector<std::size_t>& ends : {std::vector<std::size_t>{1000}, {1, 400, 403, 1000}}) {
    std::vector<BoxTree::Child> roots;
    const BoxTree tree = boxTreeOfParts(boxes, ends, 4, 40, roots);
    ASSERT_EQ(roots.size(), ends.size());
    Inspection whole{tree, boxes};
    whole.visit(tree.root, 1);
    EXPECT_EQ(std::ranges::count(whole.seen, 1), 1000);
    EXPECT_LE(whole.most_items, 4u);
    std::size_t begin = 0;
    for (std::size_t part = 0; part < ends.size(); ++part) {
      Inspection inspection{tree, boxes};
      inspection.visit(roots[part], 1);
      for (std::size_t i = 0; i < boxes.size(); ++i)
        ASSERT_EQ(inspection.seen[i], i >= begin && i < ends[part] ? 1 : 0) << "part " << part << ", box " << i;
      begin = ends[part];
    }
  }
}

}  // namespace
}  // namespace mirrorball
