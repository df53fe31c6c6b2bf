#include "mirrorball/gl/shader_source.h"

#include <array>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shaders/embedded_text.h"

namespace mirrorball::gl {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::optional<std::string_view> findSourceShader(std::string_view name) {
  static const std::map<std::string_view, std::string_view> kTexts = {
      {"a.glsl", "float a;"},
      {"b.glsl", "float b;\n"},
      {"twice.frag", "one\n#include \"a.glsl\"\n # include \"b.glsl\"\n#include \"a.glsl\"\nlast"},
      {"missing.frag", "one\ntwo\n#include \"c.glsl\"\n"},
  };
  const auto found = kTexts.find(name);
  if (found == kTexts.end()) return std::nullopt;
  return found->second;
}

TEST(ShaderSource, PutsEachIncludedFileInOnceAndKeepsTheLines) {
  const auto source = shaderSource(Api::desktop43, "twice.frag", {}, findSourceShader);
  ASSERT_TRUE(source) << source.error().message;
  EXPECT_THAT(source->files, ElementsAre("twice.frag", "a.glsl", "b.glsl"));
  EXPECT_THAT(source->text, EndsWith("#line 1 0\none\n"
                                     "#line 1 1\nfloat a;\n#line 3 0\n"
                                     "#line 1 2\nfloat b;\n#line 4 0\n"
                                     "\nlast\n"));
}

TEST(ShaderSource, StartsWithWhatTheApiAsksFor) {
  const auto desktop = shaderSource(Api::desktop43, "twice.frag", {}, findSourceShader);
  const auto embedded = shaderSource(Api::es30, "twice.frag", {}, findSourceShader);
  ASSERT_TRUE(desktop && embedded);
  EXPECT_THAT(desktop->text, StartsWith("#version 430 core\n"));
  EXPECT_THAT(desktop->text, Not(HasSubstr("precision")));
  EXPECT_THAT(embedded->text, StartsWith("#version 300 es\nprecision highp float;\n"));
}

TEST(ShaderSource, PutsDefinesBeforeTheEntry) {
  constexpr std::array<std::string_view, 2> kDefines = {"PER_VERTEX", "SIZE 3"};
  const auto source = shaderSource(Api::es30, "twice.frag", kDefines, findSourceShader);
  ASSERT_TRUE(source);
  EXPECT_THAT(source->text, HasSubstr("#define PER_VERTEX\n#define SIZE 3\n#line 1 0\none\n"));
}

TEST(ShaderSource, NamesWhatIsMissing) {
  const auto entry = shaderSource(Api::es30, "none.frag", {}, findSourceShader);
  ASSERT_FALSE(entry);
  EXPECT_EQ(entry.error().code, ErrorCode::not_found);
  EXPECT_EQ(entry.error().message, "none.frag: no such shader");
  const auto include = shaderSource(Api::es30, "missing.frag", {}, findSourceShader);
  ASSERT_FALSE(include);
  EXPECT_EQ(include.error().message, "missing.frag, line 3: no shader text is named c.glsl");
}

TEST(NamedLog, ReadsEveryDriversForm) {
  const std::array<std::string, 2> files = {"surface.frag", "optics.glsl"};
  EXPECT_EQ(namedLog("1:12(5): error: no\n\n", files), "optics.glsl:12: error: no");
  EXPECT_EQ(namedLog("0(7) : error C1008: undefined", files), "surface.frag:7: error C1008: undefined");
  EXPECT_EQ(namedLog("ERROR: 1:3: 'x' : undeclared\nERROR: 2 errors", files),
            "ERROR: optics.glsl:3: 'x' : undeclared\nERROR: 2 errors");
  EXPECT_EQ(namedLog("9:12(5): error: no", files), "9:12(5): error: no");
}

TEST(EmbeddedText, HoldsTheFormulas) {
  const auto text = embeddedText("optics.glsl");
  ASSERT_TRUE(text);
  EXPECT_THAT(std::string(*text), HasSubstr("FN vec3 refractedDirection"));
  EXPECT_FALSE(embeddedText("no_such.glsl"));
}

}  // namespace
}  // namespace mirrorball::gl
