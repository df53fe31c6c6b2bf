#include "mirrorball/view/panel/panel.h"

#include <optional>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

/// The row of an option, or else the first of that name.
const PanelRow* rowOf(const std::vector<PanelGroup>& groups, std::optional<OptionTable> table, std::string_view name) {
  for (const PanelGroup& group : groups)
    for (const PanelRow& row : group.rows)
      if (row.name == name && row.table == table.value_or(row.table)) return &row;
  return nullptr;
}

const PanelRow* rowNamed(const std::vector<PanelGroup>& groups, std::string_view name) {
  return rowOf(groups, std::nullopt, name);
}

Workspace withMaterial() {
  Workspace workspace;
  workspace.selected_material = 0;
  return workspace;
}

TEST(Panel, HasEveryRowOfTheTablesOnce) {
  const Material material;
  const auto groups = *panelsOf(withMaterial(), &material);
  std::multiset<std::pair<OptionTable, std::string_view>> rows;
  std::set<std::string_view> titles;
  for (const PanelGroup& group : groups) {
    EXPECT_TRUE(titles.insert(group.title).second) << group.title << " stands twice";
    EXPECT_FALSE(group.title.empty());
    for (const PanelRow& row : group.rows) rows.emplace(row.table, row.name);
  }
  EXPECT_EQ(rows.size(), stanceOptions().size() + frameOptions().size() + qualityOptions().size() +
                             materialOptions().size() + materialParameters().size());
  for (const auto& option : frameOptions()) EXPECT_EQ(rows.count({OptionTable::frame, option.text.name}), 1u);
  for (const auto& option : materialParameters()) EXPECT_EQ(rows.count({OptionTable::parameter, option.text.name}), 1u);
}

TEST(Panel, EveryRowTakesItsOwnValue) {
  const Material material;
  const auto groups = *panelsOf(withMaterial(), &material);
  for (const PanelGroup& group : groups)
    for (const PanelRow& row : group.rows) {
      EXPECT_EQ(row.value, row.default_value) << row.name;
      EXPECT_FALSE(row.is_given) << row.name;
      EXPECT_FALSE(row.help.empty()) << row.name;
      EXPECT_EQ(row.help.find("{option:"), std::string::npos) << row.help;
      const auto same = withValue(withMaterial(), row, row.value);
      ASSERT_TRUE(same) << row.name << ": " << same.error().message;
      const auto again = *panelsOf(*same, &material);
      EXPECT_EQ(rowOf(again, row.table, row.name)->value, row.value) << row.name;
    }
}

TEST(Panel, ShowsWhatWasGivenAndResetsIt) {
  const Material material;
  Workspace workspace = withMaterial();
  workspace = *withValue(workspace, *rowNamed(*panelsOf(workspace, &material), "fov"), std::vector<float>{50.0f});
  workspace = *withValue(workspace, *rowNamed(*panelsOf(workspace, &material), "metallic"), std::vector<float>{1.0f});
  const auto groups = *panelsOf(workspace, &material);
  EXPECT_TRUE(rowNamed(groups, "fov")->is_given);
  EXPECT_EQ(rowNamed(groups, "fov")->value, ControlValue(std::vector<float>{50.0f}));
  EXPECT_TRUE(rowNamed(groups, "metallic")->is_given);
  EXPECT_FALSE(rowNamed(groups, "samples")->is_given);
  std::string_view title;
  for (const PanelGroup& group : groups)
    if (rowNamed({group}, "fov")) title = group.title;
  EXPECT_FALSE(rowNamed(*panelsOf(withoutGroup(workspace, title), &material), "fov")->is_given);
  EXPECT_TRUE(rowNamed(*panelsOf(withoutGroup(workspace, title), &material), "metallic")->is_given);
  EXPECT_FALSE(rowNamed(*panelsOf(withoutGroup(workspace, "Selected material"), &material), "metallic")->is_given);
  EXPECT_EQ(*frameOf(withoutOptions(workspace), 0), *frameOf(*withOption({}, OptionTable::frame, "fov", "50"), 0));
  EXPECT_TRUE(withoutOptions(workspace).parameters.empty());
}

TEST(Panel, RefusesAValueOutOfRange) {
  const auto groups = *panelsOf({});
  EXPECT_FALSE(withValue({}, *rowNamed(groups, "fov"), std::vector<float>{500.0f}));
  EXPECT_FALSE(withValue({}, *rowNamed(groups, "blur"), 77));
}

TEST(Panel, ARepeatedOptionGrowsAndShrinksTextByText) {
  Workspace workspace;
  const auto lamp = [](const Workspace& of) { return *rowNamed(*panelsOf(of), "light"); };
  for (const float x : {1.0f, 2.0f, 3.0f})
    workspace = *withValue(workspace, lamp(workspace), std::vector<float>{x, 2, 3, 4, 5, 6});
  EXPECT_TRUE(lamp(workspace).may_repeat);
  EXPECT_THAT(lamp(workspace).texts, ::testing::ElementsAre("1,2,3,4,5,6", "2,2,3,4,5,6", "3,2,3,4,5,6"));
  workspace = withoutText(workspace, OptionTable::frame, "light", 1);
  EXPECT_EQ(frameOf(workspace, 0)->lights.size(), 2u);
  EXPECT_FLOAT_EQ(frameOf(workspace, 0)->lights[1].position.x, 3.0f);
  EXPECT_EQ(withoutText(workspace, OptionTable::frame, "light", 7), workspace);
  workspace = withoutText(withoutText(workspace, OptionTable::frame, "light", 0), OptionTable::frame, "light", 0);
  EXPECT_EQ(workspace, Workspace());
}

TEST(Panel, InAComparisonRowsAreOfTheHalf) {
  Workspace workspace = *withOption({}, OptionTable::frame, "samples", "9");
  workspace = *withOption(workspace, OptionTable::frame, "light", "1,2,3,4,5,6");
  workspace.compare_by = CompareBy::slider;
  workspace.edited_side = 1;
  const auto row = [&](std::string_view name) { return *rowNamed(*panelsOf(workspace), name); };
  EXPECT_FALSE(row("samples").is_given);
  EXPECT_EQ(row("samples").default_value, ControlValue(9)) << "what both have";
  workspace = *withValue(workspace, row("samples"), 2);
  EXPECT_TRUE(row("samples").is_given);
  workspace = withoutOption(workspace, OptionTable::frame, "samples");
  EXPECT_EQ(row("samples").value, ControlValue(9));
  workspace = *withOption(workspace, OptionTable::frame, "light", "7,2,3,4,5,6");
  EXPECT_EQ(frameOf(workspace, 1)->lights.size(), 2u) << "one more than both have";
  EXPECT_EQ(frameOf(workspace, 0)->lights.size(), 1u);
  for (int lamp = 0; lamp < 2; ++lamp) workspace = withoutText(workspace, OptionTable::frame, "light", 0);
  EXPECT_TRUE(frameOf(workspace, 1)->lights.empty()) << "a half may have none";
  workspace.compare_by = CompareBy::none;
  EXPECT_EQ(*frameOf(workspace, 1), *frameOf(workspace, 0)) << "without a comparison halves count for nothing";
  EXPECT_EQ(row("light").texts.size(), 1u);
}

TEST(Panel, AColourOfTheBackgroundStaysThatColour) {
  Workspace workspace = *withOption({}, OptionTable::frame, "background", "#3366ff");
  const FrameSettings before = *frameOf(workspace, 0);
  const PanelRow row = *rowNamed(*panelsOf(workspace), "background");
  EXPECT_EQ(row.text, "#3366ff");
  workspace = *withValue(workspace, row, row.value);
  EXPECT_EQ(*frameOf(workspace, 0), before);
}

/// The names of the rows that are found, in their order.
std::vector<std::string_view> found(std::string_view letters) {
  const Material material;
  const auto groups = *panelsOf(withMaterial(), &material);
  std::vector<std::string_view> names;
  for (const FoundRow& place : searchRows(groups, letters)) names.push_back(groups[place.group].rows[place.row].name);
  return names;
}

TEST(Search, FindsWhatIsMeantFirst) {
  using ::testing::Contains;
  EXPECT_EQ(found("samples").front(), "samples");
  EXPECT_THAT(found("roug"), Contains("perceptual_roughness"));
  EXPECT_THAT(found("roug"), Contains("ground-roughness"));
  EXPECT_EQ(found("expo").front(), "exposure");
  EXPECT_EQ(found("ToneM").front(), "tone-map") << "letters left out";
  EXPECT_EQ(found("orang").size() > 0, true) << "the name of a choice";
  EXPECT_TRUE(found("qqqq").empty());
  EXPECT_EQ(found("").size(), stanceOptions().size() + frameOptions().size() + qualityOptions().size() +
                                  materialOptions().size() + materialParameters().size());
}

}  // namespace
}  // namespace mirrorball
