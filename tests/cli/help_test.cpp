// What the program says of itself: --help, --version and the reference.

#include <regex>
#include <set>
#include <string>

#include "cli/cli_testing.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/builtin.h"
#include "mirrorball/render/render_options.h"

namespace mirrorball::testing {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;

using HelpTest = CliTest;
const char* const kCommands[] = {"render", "convert", "capture", "info", "photo", "reference"};

std::set<std::string> optionsIn(const std::string& help) {
  std::set<std::string> options;
  const std::regex option("--[a-z][a-z-]*");
  for (std::sregex_iterator match(help.begin(), help.end(), option), end; match != end; ++match)
    options.insert(match->str());
  return options;
}

TEST_F(HelpTest, HelpNamesEveryCommand) {
  for (const std::string flag : {"--help", "-h"}) {
    const std::string help = succeed(flag);
    for (const char* command : kCommands) EXPECT_THAT(help, HasSubstr(command));
  }
}

TEST_F(HelpTest, EveryCommandHasHelp) {
  for (const std::string command : kCommands)
    for (const std::string flag : {" --help", " -h"})
      EXPECT_THAT(succeed(command + flag), HasSubstr("mirrorball " + command)) << command;
}

TEST_F(HelpTest, EveryCommandHasTheVersion) {
  EXPECT_THAT(succeed("--version"), MatchesRegex("mirrorball [0-9]+\\.[0-9]+\\.[0-9]+\n"));
  for (const std::string command : kCommands) EXPECT_EQ(succeed(command + " --version"), succeed("--version"));
}

TEST_F(HelpTest, HelpOfRenderHasEveryOptionWithUnitRangeAndDefault) {
  const std::string help = succeed("render --help");
  for (const Option<RenderOptions>& option : renderOptions()) {
    const std::string name(option.text.name);
    EXPECT_THAT(optionsIn(help), Contains("--" + name));
    EXPECT_THAT(help, HasSubstr(option.text.help)) << name;
    EXPECT_THAT(help, HasSubstr(option.text.unit)) << name;
    EXPECT_THAT(help, HasSubstr(rangeText(option.text))) << name;
  }
  EXPECT_THAT(help, HasSubstr("default 1280x720"));
  EXPECT_THAT(help, HasSubstr("default 30,15"));
  EXPECT_THAT(help, HasSubstr("default studio"));
  EXPECT_THAT(help, HasSubstr("default mirrorball.png"));
}

TEST_F(HelpTest, TheReferenceHasEveryOptionAndParameter) {
  const std::string reference = succeed("reference");
  for (const Option<RenderOptions>& option : renderOptions())
    EXPECT_THAT(reference, HasSubstr("| `--" + std::string(option.text.name) + "`"));
  for (const Option<Material>& parameter : materialParameters())
    EXPECT_THAT(reference, HasSubstr("| `" + std::string(parameter.text.name) + "` |"));
  for (const Option<SkyParameters>& parameter : skyParameters())
    EXPECT_THAT(reference, HasSubstr("| `" + std::string(parameter.text.name) + "` |"));
  for (const std::string command : {"render", "convert", "capture", "info", "photo"}) {
    const std::set<std::string> options = optionsIn(succeed(command + " --help"));
    EXPECT_GE(options.size(), 3u) << command;
    for (const std::string& option : options)
      EXPECT_TRUE(option == "--help" || option == "--version" ||
                  reference.find("| `" + option + "`") != std::string::npos)
          << option << " of " << command;
  }
}

TEST_F(HelpTest, ListsOfFormatsAreTheTables) {
  const std::string read(readExtensions());
  for (const std::string command : {"info", "convert", "render", "capture"})
    EXPECT_THAT(succeed(command + " --help"), HasSubstr(read)) << command;
  EXPECT_THAT(succeed("render --help"), HasSubstr(writtenExtensions(Holds::picture)));
  for (const std::string command : {"convert", "capture", "photo"})
    EXPECT_THAT(succeed(command + " --help"), HasSubstr(writtenExtensions(Holds::texture) + " (textures")) << command;
  const auto readme = readFile(std::filesystem::path(MIRRORBALL_SOURCE_DIR) / "README.md");
  ASSERT_TRUE(readme) << readme.error().message;
  EXPECT_THAT(std::string(readme->begin(), readme->end()), HasSubstr("Maps: `" + read + "`"));
  EXPECT_THAT(refuse(1, "info " + std::string(MIRRORBALL_SOURCE_DIR) + "/README.md"),
              HasSubstr("use " + readFormatNames()));
}

TEST_F(HelpTest, TheDocumentationHasTheReferenceAsItIs) {
  const auto page = readFile(std::filesystem::path(MIRRORBALL_SOURCE_DIR) / "docs/options.md");
  ASSERT_TRUE(page) << page.error().message;
  EXPECT_TRUE(std::string(page->begin(), page->end()) == succeed("reference"))
      << "docs/options.md is out of date: mirrorball reference > docs/options.md";
}

using TimingsTest = RenderCliTest;

TEST_F(TimingsTest, AreToldOnStderr) {
  const Outcome outcome = run("render none -e white --size 8x8 --timings -o a.png");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr(" ms "));
}

}  // namespace
}  // namespace mirrorball::testing
