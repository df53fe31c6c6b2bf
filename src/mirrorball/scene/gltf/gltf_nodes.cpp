#include "mirrorball/scene/gltf/gltf_nodes.h"

#include <algorithm>

#include "mirrorball/scene/gltf/gltf_file.h"

namespace mirrorball::gltf {
namespace {

/// The scene that is shown: the default one, else the first; −1: the file has none.
int sceneToShow(const Document& document, Remarks& remarks) {
  if (document.scenes.empty()) return -1;
  if (document.scene == -1) {
    if (document.scenes.size() > 1)
      remarks.tell("does not say which of its " + std::to_string(document.scenes.size()) +
                   " scenes is shown; it is the first");
    return 0;
  }
  const Result<void> exists = checkIndex(document.scene, document.scenes.size(), "scene", "scene");
  if (exists) return document.scene;
  remarks.suspect(exists.error());
  remarks.tell(exists.error().message + "; the first is shown");
  return 0;
}

/// The nodes of a scene; of a file without scenes all that are nobody's child.
std::vector<ListedNode> rootNodes(const Document& document, int scene) {
  std::vector<ListedNode> roots;
  if (scene != -1) {
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
std::string referrer(const std::vector<ListedNode>& listed, ListedNode node, int scene) {
  if (node.parent >= 0) return quoted("nodes", std::size_t(listed[std::size_t(node.parent)].node)) + ".children";
  return quoted("scenes", std::size_t(scene)) + ".nodes";
}

}  // namespace

std::vector<ListedNode> nodesOfScene(const Document& document, Remarks& remarks) {
  const int scene = sceneToShow(document, remarks);
  std::vector<ListedNode> pending = rootNodes(document, scene);
  std::vector<ListedNode> listed;
  std::vector<bool> visited(document.nodes.size(), false);
  // A stack of its own, so that a deep tree cannot overflow the program's; the last is the next.
  std::reverse(pending.begin(), pending.end());
  while (!pending.empty()) {
    const ListedNode next = pending.back();
    pending.pop_back();
    if (next.node < 0 || std::size_t(next.node) >= document.nodes.size()) {
      const auto missing = checkIndex(next.node, document.nodes.size(), referrer(listed, next, scene), "node");
      remarks.leaveOut(missing.error(), "reference");
      continue;
    }
    const auto index = std::size_t(next.node);
    if (visited[index]) {
      remarks.leaveOut({ErrorCode::bad_file, quoted("nodes", index) + " is reached twice, and nodes form a tree"},
                       "second");
      continue;
    }
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
