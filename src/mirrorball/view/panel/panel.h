#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/option_control.h"
#include "mirrorball/base/result.h"
#include "mirrorball/view/workspace/workspace.h"

namespace mirrorball {

// A panel as data: what a window or a page draws, row by row, without knowing what the rows are about.

/// What is set by hand: one option with its value.
struct PanelRow {
  OptionTable table = OptionTable::frame;
  std::string_view name = {};  ///< of its option, by which it is changed
  std::string_view unit = {};
  std::string help = {};  ///< a sentence; other rows are in it by their names
  OptionControl control = {};
  std::vector<std::string_view> choices = {};  ///< of ControlKind::choice, in the order of its numbers
  std::vector<std::string_view> names = {};    ///< that a text or a file may be
  ControlValue value = {};                     ///< of one that may be repeated: what would be added
  ControlValue default_value = {};             ///< to which a reset leads; in a comparison what both halves have
  std::string text = {};                       ///< the value as a command line has it
  std::vector<std::string> texts = {};         ///< that were given, of one that may be repeated: each can be taken away
  bool may_repeat = false;
  bool is_given = false;  ///< and not left to its default
  bool is_daily = false;  ///< most people use it
};

/// Rows under one heading.
struct PanelGroup {
  std::string_view title;
  std::vector<PanelRow> rows;
};

/// All rows, by group, in the tables' order: of the half that is edited and the material that is selected, with their
/// values; while the map is shown without the model, of that. Of a map that is a photograph, its rows too.
///
/// selected   the material as it is without Workspace::parameters; null: its rows are left out
/// errors     as frameOf's
Result<std::vector<PanelGroup>> panelsOf(const Workspace& workspace, const Material* selected = nullptr);

/// Sets a row. No numbers leave it to its default.
///
/// value    of the row's kind
/// errors   usage
Result<Workspace> withValue(const Workspace& workspace, const PanelRow& row, const ControlValue& value);

/// Leaves all rows of a group to their defaults.
Workspace withoutGroup(Workspace workspace, std::string_view title);

/// Rows that a few letters may mean, the likeliest first: "roug" finds ground-roughness. Names count more than help,
/// a beginning more than what lies inside, and letters may be left out.
///
/// returns  places in `groups`: of the group and of its row
struct FoundRow {
  std::size_t group;
  std::size_t row;
};
std::vector<FoundRow> searchRows(const std::vector<PanelGroup>& groups, std::string_view letters);

}  // namespace mirrorball
