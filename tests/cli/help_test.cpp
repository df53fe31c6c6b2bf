// What the program says of itself: --help, --version and the reference.

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/cli_testing.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/cube/cube_layout.h"
#include "mirrorball/environment/cube/preset.h"
#include "mirrorball/environment/projection/projection.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/material/material.h"

namespace mirrorball::testing {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;

using HelpTest = CliTest;
const char* const kCommands[] = {"render", "convert", "bake",  "capture", "export",   "info",  "compare",  "contact",
                                 "study",  "fresnel", "photo", "surface", "transfer", "cache", "reference"};

/// Help with all options, whose lines are joined again.
std::string unwrapped(const std::string& help) { return std::regex_replace(help, std::regex("\n +"), " "); }

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

/// A text of the library as the command line writes it.
std::string asHelp(std::string_view text) {
  return filledIn(text, [](std::string_view name) { return "--" + std::string(name); });
}

TEST_F(HelpTest, HelpOfRenderHasEveryOptionWithUnitRangeAndDefault) {
  const std::string help = unwrapped(succeed("render --help all"));
  for (const Option<FrameSettings>& option : frameOptions()) {
    const std::string name(option.text.name);
    EXPECT_THAT(optionsIn(help), Contains("--" + name));
    EXPECT_THAT(help, HasSubstr(asHelp(option.text.help))) << name;
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
  for (const Option<FrameSettings>& option : frameOptions())
    EXPECT_THAT(reference, HasSubstr("| `--" + std::string(option.text.name) + "`"));
  for (const Option<Material>& parameter : materialParameters())
    EXPECT_THAT(reference, HasSubstr("| `" + std::string(parameter.text.name) + "` |"));
  for (const Option<SkyParameters>& parameter : skyParameters())
    EXPECT_THAT(reference, HasSubstr("| `" + std::string(parameter.text.name) + "` |"));
  for (const std::string command : kCommands) {
    const std::string help = succeed(command + " --help all");
    const std::set<std::string> options = optionsIn(help.substr(0, help.find("Examples:")));
    EXPECT_GE(options.size(), 3u) << command;
    for (const std::string& option : options)
      EXPECT_TRUE(option == "--help" || option == "--version" ||
                  reference.find("`" + option + "`") != std::string::npos)
          << option << " of " << command;
  }
}

TEST_F(HelpTest, ListsOfFormatsAreTheTables) {
  const std::string read(readExtensions());
  for (const std::string command : {"info", "compare", "convert", "render", "capture"})
    EXPECT_THAT(unwrapped(succeed(command + " --help all")), HasSubstr(read)) << command;
  EXPECT_THAT(unwrapped(succeed("render --help")), HasSubstr(writtenExtensions(Holds::picture)));
  for (const std::string command : {"convert", "capture", "photo"})
    EXPECT_THAT(unwrapped(succeed(command + " --help all")),
                HasSubstr(writtenExtensions(Holds::texture) + " (textures"))
        << command;
  const auto readme = readFile(std::filesystem::path(MIRRORBALL_SOURCE_DIR) / "README.md");
  ASSERT_TRUE(readme) << readme.error().message;
  EXPECT_THAT(std::string(readme->begin(), readme->end()), HasSubstr("Maps: `" + read + "`"));
  EXPECT_THAT(refuse(1, "info " + std::string(MIRRORBALL_SOURCE_DIR) + "/README.md"),
              HasSubstr("use " + readFormatNames()));
}

TEST_F(HelpTest, ListsOfNamesAreTheTables) {
  const auto expectIn = [&](const std::string& command, std::string_view list) {
    EXPECT_THAT(unwrapped(succeed(command + " --help all")), HasSubstr(list)) << command;
  };
  const std::string textures = writtenExtensions(Holds::texture, " and ");
  for (const std::string command : {"convert", "bake", "capture", "photo"}) {
    expectIn(command, join(texelFormatNames("dds"), ", ", " or ") + " in " + textures);
    for (const std::string_view format : texelFormatNames()) expectIn(command, format);
    expectIn(command, join(presetNames(), " "));
  }
  const std::string extensions = join(writtenExtensionNames(Holds::texture), "|");
  expectIn("bake", "--extension " + extensions);
  expectIn("bake", "--brdf-extension " + extensions + "|exr");
  for (const std::string command : {"convert", "capture", "photo"}) {
    expectIn(command, join(projectionNames(), ", ", " or "));
    expectIn(command, join(cubeLayoutNames()));
  }
  for (const std::string command : {"render", "capture"}) {
    expectIn(command, "(" + modelExtensions() + ")");
    expectIn(command, join(builtinModelNames(), " "));
    expectIn(command, join(materialNames(), " "));
  }
  for (const std::string command : {"convert", "bake", "info"})
    expectIn(command, "a built-in: " + join(builtinEnvironmentNames(), " "));
}

TEST_F(HelpTest, HelpIsACommandToo) {
  EXPECT_EQ(succeed("help"), succeed("--help"));
  for (const std::string command : kCommands) EXPECT_EQ(succeed("help " + command), succeed(command + " --help"));
  EXPECT_THAT(refuse(2, "help rendr"), HasSubstr("did you mean 'render'?"));
}

// Of a command with many options those that most people use are shown, and how to see the others.
TEST_F(HelpTest, DailyOptionsComeFirst) {
  const std::string daily = succeed("render --help"), all = succeed("render --help all");
  EXPECT_EQ(succeed("help render all"), all);
  EXPECT_EQ(succeed("render -h all"), all);
  for (const char* option : {"--env", "--output", "--quality", "--size", "--material", "--camera", "--stand"})
    EXPECT_THAT(optionsIn(daily), Contains(option));
  for (const char* option : {"--lobe-taps", "--texture-matrix", "--threads"}) {
    EXPECT_THAT(optionsIn(daily), ::testing::Not(Contains(option)));
    EXPECT_THAT(optionsIn(all), Contains(option));
  }
  const std::size_t left_out = optionsIn(all.substr(0, all.find("Examples:"))).size() - optionsIn(daily).size();
  EXPECT_GT(left_out, 20u);
  EXPECT_THAT(daily, ::testing::ContainsRegex("[0-9]+ more options: mirrorball help render all"));
  EXPECT_THAT(all, ::testing::Not(HasSubstr("more options:")));
  EXPECT_EQ(succeed("info --help all"), succeed("info --help")) << "which has few";
  for (const char* option : {"--at", "--to", "--size", "--output", "--layout", "--format"})
    EXPECT_THAT(optionsIn(succeed("capture --help")), Contains(option));
}

TEST_F(HelpTest, HelpIsAsWideAsItIsToBe) {
  const auto widestOf = [&](const std::string& words) {
    std::size_t widest = 0;
    for (const std::string& line : split(succeed(words), '\n'))
      // A line that is wider is one long word, or a line to type.
      if (line.find(" mirrorball ") == std::string::npos && line.find_last_of(' ') > 30)
        widest = std::max(widest, columnsOf(line));
    return widest;
  };
  for (const auto& [columns, widest] : {std::pair("60", 60u), {"100", 100u}, {"100000", 120u}, {"wide", 100u}}) {
    ::setenv("COLUMNS", columns, 1);
    EXPECT_LE(widestOf("render --help all"), widest) << columns;
    EXPECT_GT(widestOf("render --help all"), widest - 12) << columns;
    EXPECT_LE(widestOf("--help"), widest) << columns;
  }
  ::unsetenv("COLUMNS");
}

TEST_F(HelpTest, HelpOnMaterialsHasTheirNamesAndParameters) {
  const std::string help = unwrapped(succeed("help materials"));
  EXPECT_THAT(help, HasSubstr(join(materialNames(), " ")));
  for (const Option<Material>& parameter : materialParameters()) {
    EXPECT_THAT(help, HasSubstr(" " + std::string(parameter.text.name) + " ")) << parameter.text.name;
    EXPECT_THAT(help, HasSubstr(asHelp(parameter.text.help)));
  }
}

TEST_F(HelpTest, EveryHelpEndsWithTwoExamplesWhoseOptionsThereAre) {
  for (const std::string command : kCommands) {
    const std::string help = succeed(command + " --help all");
    const std::size_t begin = help.find("\nExamples:\n");
    ASSERT_NE(begin, std::string::npos) << command;
    const std::string examples = help.substr(begin);
    const std::regex line("\n  mirrorball " + command + "( [^\n]*)?\n      [^ \n]");
    EXPECT_EQ(std::distance(std::sregex_iterator(examples.begin(), examples.end(), line), {}), 2) << examples;
    for (const std::string& option : optionsIn(examples))
      EXPECT_TRUE(optionsIn(help.substr(0, begin)).contains(option)) << option << " of " << command;
  }
}

// "T,T,…" is five columns wide, and seven bytes.
TEST_F(HelpTest, ColumnsAreStraight) {
  const std::string help = succeed("photo --help");
  const auto columnOf = [&](const std::string& option, const std::string& meaning) {
    const std::size_t begin = help.find(option);
    return columnsOf(std::string_view(help).substr(begin, help.find(meaning, begin) - begin));
  };
  EXPECT_EQ(columnOf("--exposures T,T,…", "exposure times of a series"),
            columnOf("--circle X,Y,R", "the ball's centre"));
}

TEST_F(HelpTest, OutputSaysWhatIsTrueOfItsCommand) {
  EXPECT_THAT(unwrapped(succeed("convert --help")), HasSubstr("for several inputs, a folder"));
  for (const std::string command : {"capture", "photo"})
    EXPECT_THAT(unwrapped(succeed(command + " --help all")), ::testing::Not(HasSubstr("several inputs"))) << command;
  EXPECT_THAT(unwrapped(succeed("capture --help all")),
              ::testing::AllOf(::testing::Not(HasSubstr("transparent")),
                               ::testing::Not(HasSubstr("reflection|normal|sphere"))));
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
