#pragma once

#include <span>
#include <string_view>

#include "mirrorball/view/workspace/history.h"

namespace mirrorball {

/// Something that a menu or a key does: a row of a table, from which faces make their menus and their page of keys.
struct ViewerCommand {
  std::string_view name;   ///< "frame-all"
  std::string_view title;  ///< "Show all", as a menu says it
  std::string_view group;
  std::string_view key;        ///< chordOf(): "Ctrl+Z"
  std::string_view other_key;  ///< that does the same; empty: none
  void (*perform)(History&);
};

std::span<const ViewerCommand> viewerCommands();

/// The command of a key; null: it has none.
const ViewerCommand* commandOfKey(std::string_view chord);

}  // namespace mirrorball
