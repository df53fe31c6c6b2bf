#include "mirrorball/scene/gltf/gltf_nodes.h"

#include <algorithm>

#include "mirrorball/scene/gltf/gltf_file.h"

namespace mirrorball::gltf {
namespace {

/// The nodes of the default scene; of a file that names none, all that are nobody's child.
Result<std::vector<ListedNode>> rootNodes(const Document& document) {
  std::vector<ListedNode> roots;
  if (const int scene = document.scene; scene != -1) {
    MIRRORBALL_TRY_VOID(checkIndex(scene, document.scenes.size(), "scene", "scene"));
    for (const int node : document.scenes[std::size_t(scene)]) roots.push_back({node, -1});
    return roots;
  }
  std::vector<bool> is_child(document.nodes.size(), false);
  for (const Node& node : document.nodes)
    for (const int child : node.children)
      if (child >= 0 && std::size_t(child) < is_child.size()) is_child[std::size_t(child)] = true;
  for (std::size_t i = 0; i < is_child.size(); ++i)
    if (!is_child[i]) roots.push_back({static_cast<int>(i), -1});
  return roots;
}

/// What refers to a node, for messages.
std::string referrer(const Document& document, const std::vector<ListedNode>& listed, ListedNode node) {
  if (node.parent >= 0) return quoted("nodes", std::size_t(listed[std::size_t(node.parent)].node)) + ".children";
  return document.scene == -1 ? "nodes" : quoted("scenes", std::size_t(document.scene)) + ".nodes";
}

}  // namespace

Result<std::vector<ListedNode>> nodesOfScene(const Document& document) {
  MIRRORBALL_TRY(pending, rootNodes(document));
  std::vector<ListedNode> listed;
  std::vector<bool> visited(document.nodes.size(), false);
  // A stack of its own, so that a deep tree cannot overflow the program's; the last is the next.
  std::reverse(pending.begin(), pending.end());
  while (!pending.empty()) {
    const ListedNode next = pending.back();
    pending.pop_back();
    if (next.node < 0 || std::size_t(next.node) >= document.nodes.size())
      return fail(checkIndex(next.node, document.nodes.size(), referrer(document, listed, next), "node"));
    const auto index = std::size_t(next.node);
    if (visited[index])
      return fail(ErrorCode::bad_file,
                  quoted("nodes", index) + " is reached twice; nodes must form a tree without cycles");
    visited[index] = true;
    const int place = static_cast<int>(listed.size());
    listed.push_back(next);
    const std::vector<int>& children = document.nodes[index].children;
    for (auto child = children.rbegin(); child != children.rend(); ++child) pending.push_back({*child, place});
  }
  return listed;
}

std::string Names::unlike(const std::string& wanted) {
  std::string name = wanted;
  // What was tried before stays taken.
  for (int& number = last_number_.try_emplace(wanted, 1).first->second; !taken_.insert(name).second;)
    name = wanted + " " + std::to_string(++number);
  return name;
}

}  // namespace mirrorball::gltf
