#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "mirrorball/scene/gltf/gltf_document.h"
#include "mirrorball/scene/gltf/gltf_remarks.h"

namespace mirrorball::gltf {

/// A node that a scene shows.
struct ListedNode {
  int node = 0;     ///< of the file
  int parent = -1;  ///< in the list, before it; −1: none
};

/// The nodes of the default scene, of the first where the file names none, or of every node that has no parent where it
/// has no scenes: parents before their children, each followed by all below it.
///
/// remarks  gets scenes and nodes that do not exist, and nodes that are reached twice, which count once
std::vector<ListedNode> nodesOfScene(const Document& document, Remarks& remarks);

/// Names of which each is another one.
class Names {
 public:
  /// The name, or if it is taken "name 2", "name 3" and so on.
  std::string unlike(const std::string& wanted);

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> last_number_;  // that was behind a name
};

}  // namespace mirrorball::gltf
