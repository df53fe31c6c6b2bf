// The manual's page and the completions: what man and the shells make of them.

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "cli/cli_testing.h"
#include "mirrorball/render/settings/frame_settings.h"

namespace mirrorball::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

class CompletionTest : public CliTest {
 protected:
  static bool isInstalled(const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
  }

  /// What a shell's command says on both streams, in the test's folder.
  std::string said(const std::string& command) const {
    const std::string line = "cd '" + path("").string() + "' && { " + command + "; } 2>&1";
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen(line.c_str(), "r"), ::pclose);
    std::string all;
    std::array<char, 4096> piece{};
    while (const std::size_t count = std::fread(piece.data(), 1, piece.size(), pipe.get()))
      all.append(piece.data(), count);
    return all;
  }

  /// What bash offers for the last of these words.
  std::vector<std::string> offers(const std::vector<std::string>& words) const {
    write("words.bash", succeed("reference --format bash"));
    std::string line;
    for (const std::string& word : words) line += " '" + word + "'";
    write("ask.bash", "source ./words.bash\ncompopt() { :; }\nCOMP_WORDS=(mirrorball" + line + ")\nCOMP_CWORD=" +
                          std::to_string(words.size()) + "\n_mirrorball\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n");
    std::istringstream stream(said("bash ask.bash"));
    std::vector<std::string> offered;
    for (std::string word; std::getline(stream, word);)
      if (!word.empty()) offered.push_back(word);
    return offered;
  }
};

TEST_F(CompletionTest, BashOffersCommandsOptionsAndTheirValues) {
  if (!isInstalled("bash")) GTEST_SKIP() << "there is no bash";
  write("hall.exr", std::string());
  EXPECT_THAT(offers({"re"}), ElementsAre("render", "reference"));
  EXPECT_THAT(offers({"help", "conv"}), ElementsAre("convert"));
  EXPECT_THAT(offers({"render", "--tone"}), ElementsAre("--tone-map"));
  EXPECT_THAT(offers({"render", "--rot"}), ElementsAre("--rotate")) << "the other name of --env-rotation";
  EXPECT_THAT(offers({"render", "--tone-map", "a"}), ElementsAre("agx", "aces"));
  EXPECT_THAT(offers({"render", "--tone-map", "=", "neu"}), ElementsAre("neutral")) << "bash cuts at =";
  EXPECT_THAT(offers({"convert", "--to", "eq"}), ElementsAre("equirect", "equal-area"));
  EXPECT_THAT(offers({"convert", "--for", "="}), IsSupersetOf({"unity", "three"}));
  EXPECT_THAT(offers({"render", "--material", "g"}), ElementsAre("glass", "gold"));
  EXPECT_THAT(offers({"convert", "hal"}), ElementsAre("hall.exr"));
  EXPECT_THAT(offers({"bake", "--env", ""}), Contains("studio")) << "it is no option there, and an input may follow";
  EXPECT_THAT(offers({"render", "-e", ""}), IsSupersetOf({"studio", "hall.exr"}));
  EXPECT_THAT(offers({"render", "--samples", ""}), ElementsAre()) << "a number";
  EXPECT_THAT(offers({"cache", ""}), ElementsAre("show", "clear", "warm"));
  EXPECT_THAT(offers({"cache", "warm", ""}), Contains("teapot"));
  EXPECT_THAT(offers({"cache", "warm", "sho"}), ElementsAre("showcase"));
}

TEST_F(CompletionTest, BashOffersEveryOptionThatHelpHas) {
  if (!isInstalled("bash")) GTEST_SKIP() << "there is no bash";
  const std::vector<std::string> offered = offers({"render", "-"});
  for (const Option<FrameSettings>& option : frameOptions())
    EXPECT_THAT(offered, Contains("--" + std::string(option.text.name)));
  EXPECT_THAT(offered, IsSupersetOf({"--quiet", "--threads", "--help", "-o"}));
}

TEST_F(CompletionTest, EachShellReadsItsOwn) {
  for (const auto& [shell, check] : {std::pair<std::string, std::string>{"bash", "bash -n words"},
                                     {"zsh", "zsh -n words"},
                                     {"fish", "fish --no-execute words"}}) {
    const std::string words = succeed("reference --format " + shell);
    EXPECT_THAT(words, HasSubstr("env-rotation")) << shell;
    if (!isInstalled(shell)) continue;
    write("words", words);
    EXPECT_EQ(said(check), "") << shell;
  }
}

TEST_F(CompletionTest, ManShowsItsPageWithoutAWarning) {
  const std::string page = succeed("reference --format man");
  for (const Option<FrameSettings>& option : frameOptions()) {
    std::string name;
    for (const char letter : option.text.name) name += letter == '-' ? std::string("\\-") : std::string(1, letter);
    EXPECT_THAT(page, HasSubstr("\\fB\\-\\-" + name + "\\fR"));
  }
  EXPECT_THAT(page, HasSubstr("MIRRORBALL_CACHE_SIZE"));
  EXPECT_THAT(page, Not(HasSubstr("\n\n"))) << "an empty line is a request of its own";
  if (!isInstalled("man")) GTEST_SKIP() << "there is no man";
  write("mirrorball.1", page);
  EXPECT_EQ(said("LC_ALL=C.UTF-8 MANWIDTH=100 man --warnings -E UTF-8 -l -Tutf8 -Z mirrorball.1 >/dev/null"), "");
  EXPECT_THAT(said("LC_ALL=C.UTF-8 man -E UTF-8 -l mirrorball.1 | col -b"), HasSubstr("--tone-map"));
}

}  // namespace
}  // namespace mirrorball::testing
