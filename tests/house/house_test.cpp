// Holds the tree to the rules of docs/architecture.md: which room may include which, and how files
// are written.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using Complaints = std::vector<std::string>;

/// The rooms that each room may include, besides itself and what those rooms may include. Any room
/// may include formula/. Programs (apps/, examples/) may include every room.
const std::map<std::string, std::set<std::string>> kPermitted = {
    {"base", {}},
    {"image", {"base"}},
    {"metric", {"image"}},
    {"codec", {"image"}},
    {"environment", {"codec"}},
    {"photo", {"environment"}},
    {"bake", {"environment"}},
    {"light_edit", {"bake", "metric"}},
    {"output", {"light_edit"}},
    {"height_field", {"image"}},
    {"scene", {"codec", "height_field"}},
    {"gl", {"image"}},
    {"rays", {"scene"}},
    {"trace", {"rays", "bake"}},
    {"transfer", {"rays", "height_field"}},
    {"render", {"gl", "rays", "light_edit"}},
    {"contact", {"render"}},
    {"study", {"render", "trace", "metric"}},
    {"view", {"study", "photo", "light_edit"}},
};

/// The folders of render/, each of which may include itself and those before it.
const std::vector<std::string> kLayers = {"settings", "light", "surface", "stage", "frame"};

constexpr std::size_t kLongestFile = 600;
const std::string kWindow = "apps/window/";
constexpr std::ptrdiff_t kLongestWindow = 1500;  // lines in all
constexpr std::size_t kWidestLine = 120;         // columns, as .clang-format has it, which leaves comments alone

struct SourceFile {
  std::string path;  ///< relative to the root, with '/'
  std::string text;
};

bool startsWith(const std::string& text, const std::string& beginning) {
  return text.compare(0, beginning.size(), beginning) == 0;
}

bool isOneOf(const std::string& extension, const std::set<std::string>& extensions) {
  return extensions.contains(extension);
}

std::vector<SourceFile> readTree() {
  const fs::path root = MIRRORBALL_SOURCE_DIR;
  const std::set<std::string> extensions = {".h", ".inc", ".cpp", ".glsl", ".vert", ".frag", ".cmake", ".sh"};
  std::vector<SourceFile> files;
  for (const char* folder : {"apps", "src", "formula", "shaders", "cmake", "tests", "bench", "fuzz", "examples"}) {
    if (!fs::exists(root / folder)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
      if (!entry.is_regular_file()) continue;
      const fs::path& path = entry.path();
      if (!isOneOf(path.extension().string(), extensions) && path.filename() != "CMakeLists.txt") continue;
      std::ifstream stream(path, std::ios::binary);
      files.push_back(
          {path.lexically_relative(root).generic_string(), std::string(std::istreambuf_iterator<char>(stream), {})});
    }
  }
  return files;
}

/// Calls `visit(line number from 1, line)`.
void forEachLine(const std::string& text, const std::function<void(int, const std::string&)>& visit) {
  std::istringstream stream(text);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) visit(number, line);
}

std::string place(const SourceFile& file, int line) { return file.path + ":" + std::to_string(line) + ": "; }

/// A room with everything below it.
std::set<std::string> reachableFrom(const std::string& room) {
  std::set<std::string> reachable = {room};
  for (const std::string& direct : kPermitted.at(room)) reachable.merge(reachableFrom(direct));
  return reachable;
}

bool isTest(const std::string& path) { return path.ends_with("_test.cpp") || path.ends_with("_testing.h"); }

/// The third part of src/mirrorball/ROOM/…; empty for a file outside the rooms, as src/mirrorball/mirrorball.h is.
std::string roomOf(const std::string& path) {
  const std::string rooms = "src/mirrorball/";
  if (!startsWith(path, rooms)) return "";
  const std::size_t end = path.find('/', rooms.size());
  return end == std::string::npos ? "" : path.substr(rooms.size(), end - rooms.size());
}

Complaints checkRoomRule(const SourceFile& file) {
  const std::string room = roomOf(file.path);
  if (room.empty()) return {};
  if (!kPermitted.contains(room)) return {file.path + ": the room " + room + " is not in the table"};
  const std::set<std::string> reachable = reachableFrom(room);
  const std::regex include(R"re(^\s*#\s*include\s*[<"]mirrorball/([^/"]+)/)re");
  Complaints complaints;
  forEachLine(file.text, [&](int number, const std::string& line) {
    std::smatch match;
    if (std::regex_search(line, match, include) && !reachable.contains(match[1]))
      complaints.push_back(place(file, number) + room + " may not include " + match[1].str());
  });
  return complaints;
}

/// Tests may look at their layer from above.
Complaints checkLayers(const SourceFile& file) {
  const std::regex place_of(R"(^src/mirrorball/render/([a-z_]+)/)");
  const std::regex include(R"re(^\s*#\s*include\s*"mirrorball/render/([a-z_]+)/)re");
  std::smatch own;
  if (!std::regex_search(file.path, own, place_of) || isTest(file.path)) return {};
  const auto layerOf = [](const std::string& name) { return std::find(kLayers.begin(), kLayers.end(), name); };
  if (layerOf(own[1]) == kLayers.end()) return {file.path + ": " + own[1].str() + " is no layer of render"};
  Complaints complaints;
  forEachLine(file.text, [&](int number, const std::string& line) {
    std::smatch other;
    if (std::regex_search(line, other, include) && layerOf(other[1]) > layerOf(own[1]))
      complaints.push_back(place(file, number) + own[1].str() + " may not include " + other[1].str());
  });
  return complaints;
}

/// What a room is linked with must be what the table permits, no more and no less. What a permitted room is linked with
/// comes along and need not be named again.
Complaints checkLinks(const SourceFile& file) {
  const std::string room = roomOf(file.path);
  if (!kPermitted.contains(room) || file.path != "src/mirrorball/" + room + "/CMakeLists.txt") return {};
  const std::regex target(R"(\bmirrorball::([a-z_]+))");
  const std::set<std::string> permitted = reachableFrom(room);
  std::set<std::string> linked = {room};
  Complaints complaints;
  for (std::sregex_iterator match(file.text.begin(), file.text.end(), target), end; match != end; ++match) {
    const std::string other = (*match)[1];
    if (!kPermitted.contains(other)) continue;  // a part of a room
    if (!permitted.contains(other)) complaints.push_back(file.path + ": " + room + " may not be linked with " + other);
    linked.merge(reachableFrom(other));
  }
  for (const std::string& other : permitted)
    if (!linked.contains(other)) complaints.push_back(file.path + ": " + room + " is not linked with " + other);
  return complaints;
}

Complaints checkFormula(const SourceFile& file) {
  if (!startsWith(file.path, "formula/") || !file.path.ends_with(".glsl")) return {};
  const std::regex directive(R"(^\s*#\s*(include|if|ifdef|ifndef|pragma)\b)");
  // A type's name is the only one of capital and small letters; in a comment a function of mathematics has one, too.
  const std::regex parentheses(R"(^(?!\s*//).*\b[A-Z]\w*[a-z]\w*\()");
  Complaints complaints;
  forEachLine(file.text, [&](int number, const std::string& line) {
    if (std::regex_search(line, directive))
      complaints.push_back(place(file, number) + "a formula is the same text for C++ and GLSL: no " + line);
    if (std::regex_search(line, parentheses))
      complaints.push_back(place(file, number) + "a struct is made by MAKE(Type)(fields…): " + line);
  });
  return complaints;
}

/// libc++ 14 has no <=> of containers: what has some among its members has == and < of its own.
Complaints checkThreeWay(const SourceFile& file) {
  const std::regex container(R"(\bstd::(vector|array|map|set|string|optional|variant)\b)");
  Complaints complaints;
  bool has_containers = false;
  forEachLine(file.text, [&](int number, const std::string& line) {
    if (startsWith(line, "struct ") || startsWith(line, "class ")) has_containers = false;
    const bool is_member = line.ends_with(';') || line.find("///<") != std::string::npos;
    if (is_member && std::regex_search(line, container)) has_containers = true;
    if (has_containers && line.find("operator<=>") != std::string::npos && line.find("default") != std::string::npos)
      complaints.push_back(place(file, number) + "the compiler for browsers has no <=> of containers");
  });
  return complaints;
}

/// What Emscripten's compiler lacks (docs/building.md, "For browsers"), in all rooms; in the tests of the
/// higher ones, which it does not compile yet, it may stand.
Complaints checkBrowser(const SourceFile& file) {
  static const std::set<std::string> kTestsToo = {"base",  "image",       "height_field", "metric",
                                                  "codec", "environment", "bake",         "gl"};
  const std::string room = roomOf(file.path);
  const bool is_compiled = !room.empty() && (kTestsToo.contains(room) || !isTest(file.path));
  if (!is_compiled && !startsWith(file.path, "formula/")) return {};
  const std::regex missing(
      R"(std::(ranges|views|bit_cast|jthread|source_location|from_chars|to_chars|make_unique_for_overwrite)\b)"
      R"(|<(ranges|format|expected|charconv)>)");
  Complaints complaints = checkThreeWay(file);
  forEachLine(file.text, [&](int number, const std::string& line) {
    std::smatch match;
    const std::string code = line.substr(0, line.find("//"));
    if (std::regex_search(code, match, missing))
      complaints.push_back(place(file, number) + "the compiler for browsers has no " + match[0].str());
  });
  return complaints;
}

/// OpenGL and EGL are called through gl/gl_api.h, and EGL by one file of gl/platform.
Complaints checkOpenGl(const SourceFile& file) {
  const std::string gl = "src/mirrorball/gl/";
  const std::regex include(R"(^\s*#\s*include\s*<(epoxy|GL|GLES[23]?|EGL|KHR)/)");
  Complaints complaints;
  if (file.path == gl + "gl_api.h" || startsWith(file.path, gl + "platform/")) return {};
  forEachLine(file.text, [&](int number, const std::string& line) {
    if (std::regex_search(line, include))
      complaints.push_back(place(file, number) + "OpenGL is called through mirrorball/gl/gl_api.h");
  });
  return complaints;
}

/// What a viewer is stands in view/; the window has the words for a context, and what any program needs.
Complaints checkWindow(const SourceFile& file) {
  if (!startsWith(file.path, kWindow)) return {};
  const std::regex include(R"re(^\s*#\s*include\s*"mirrorball/([^"]+)")re");
  const std::set<std::string> others = {"gl/context.h", "render/stage/device.h"};
  Complaints complaints;
  forEachLine(file.text, [&](int number, const std::string& line) {
    std::smatch match;
    if (!std::regex_search(line, match, include)) return;
    const std::string header = match[1];
    if (startsWith(header, "view/") || startsWith(header, "base/") || others.contains(header)) return;
    complaints.push_back(place(file, number) + "the window asks the viewer for that (src/mirrorball/view)");
  });
  return complaints;
}

Complaints checkWidth(const SourceFile& file) {
  Complaints complaints;
  const bool is_code = isOneOf(fs::path(file.path).extension().string(), {".h", ".cpp", ".glsl", ".vert", ".frag"});
  forEachLine(file.text, [&](int number, const std::string& line) {
    // Each code point but for UTF-8's continuing bytes is a column.
    const auto columns = std::ranges::count_if(line, [](unsigned char byte) { return (byte & 0xC0u) != 0x80u; });
    if (is_code && static_cast<std::size_t>(columns) > kWidestLine)
      complaints.push_back(file.path + ":" + std::to_string(number) + " is " + std::to_string(columns) +
                           " columns wide");
  });
  return complaints;
}

Complaints checkLength(const SourceFile& file) {
  const auto lines = std::size_t(std::count(file.text.begin(), file.text.end(), '\n'));
  if (lines <= kLongestFile) return {};
  return {file.path + ": " + std::to_string(lines) + " lines; past " + std::to_string(kLongestFile) +
          " a file wants to be two"};
}

Complaints checkLeftovers(const SourceFile& file) {
  // Spelled in two halves, so that this file does not find itself.
  const std::regex leftover(
      "\\b(TO"
      "DO|FIX"
      "ME|XX"
      "X)\\b|^\\s*#\\s*if\\s+0\\b");
  Complaints complaints;
  forEachLine(file.text, [&](int number, const std::string& line) {
    if (std::regex_search(line, leftover)) complaints.push_back(place(file, number) + line);
  });
  return complaints;
}

Complaints checkPragmaOnce(const SourceFile& file) {
  if (!file.path.ends_with(".h") || file.text.find("#pragma once\n") != std::string::npos) return {};
  return {file.path + ": no #pragma once"};
}

/// The types that a file defines for other files to see, with their namespaces. The layout that .clang-format describes
/// makes a namespace's first and last line, and a type's first, known by their beginnings.
std::set<std::string> visibleTypesOf(const std::string& text) {
  const std::regex opening(R"(^(?:inline )?namespace ?([\w:]*) ?\{$)");
  const std::regex type(R"(^(?:template <.*> )?(?:struct|class|enum class|union) ([\w:]+)(?: final)?(?: : .*)? \{)");
  std::vector<std::string> scopes;
  std::set<std::string> types;
  forEachLine(text, [&](int, const std::string& line) {
    std::smatch match;
    if (std::regex_search(line, match, opening)) scopes.push_back(match[1]);
    if (startsWith(line, "}  // namespace") && !scopes.empty()) scopes.pop_back();
    if (!std::regex_search(line, match, type) || std::ranges::count(scopes, "") > 0) return;
    std::string name;
    for (const std::string& scope : scopes) name += scope + "::";
    types.insert(name + match[1].str());
  });
  return types;
}

/// Of two types with one name the linker keeps either one's functions for both, and says nothing.
Complaints checkTypesAreDefinedOnce(const std::vector<SourceFile>& files) {
  std::map<std::string, std::string> places;
  Complaints complaints;
  for (const SourceFile& file : files) {
    if (!isOneOf(fs::path(file.path).extension().string(), {".h", ".cpp"})) continue;
    for (const std::string& type : visibleTypesOf(file.text)) {
      const auto [first, is_new] = places.emplace(type, file.path);
      if (!is_new) complaints.push_back(type + " is defined in " + first->second + " and in " + file.path);
    }
  }
  return complaints;
}

Complaints checkTree(Complaints (*check)(const SourceFile&)) {
  Complaints all;
  for (const SourceFile& file : readTree()) {
    const Complaints complaints = check(file);
    all.insert(all.end(), complaints.begin(), complaints.end());
  }
  return all;
}

TEST(House, TreeIsRead) {
  std::vector<std::string> paths;
  for (const SourceFile& file : readTree()) paths.push_back(file.path);
  EXPECT_THAT(paths, Contains("src/mirrorball/base/result.h"));
  EXPECT_THAT(paths, Contains("formula/formula.h"));
  EXPECT_THAT(paths, Contains("tests/house/house_test.cpp"));
}

TEST(House, RoomsIncludeOnlyWhatTheTablePermits) {
  EXPECT_THAT(checkRoomRule({"src/mirrorball/gl/x.h", "#include \"mirrorball/codec/image_file.h\"\n"}), SizeIs(1));
  EXPECT_THAT(checkRoomRule({"src/mirrorball/render/x.h", "#include \"mirrorball/base/file.h\"\n"}), IsEmpty());
  EXPECT_THAT(checkRoomRule({"src/mirrorball/attic/x.h", ""}), SizeIs(1));
  EXPECT_THAT(checkTree(checkRoomRule), IsEmpty());
}

TEST(House, LayersOfTheRendererIncludeThoseBelow) {
  const std::string upwards = "#include \"mirrorball/render/stage/stage.h\"\n";
  EXPECT_THAT(checkLayers({"src/mirrorball/render/light/x.h", upwards}), SizeIs(1));
  EXPECT_THAT(checkLayers({"src/mirrorball/render/light/x_test.cpp", upwards}), IsEmpty());
  EXPECT_THAT(checkLayers({"src/mirrorball/render/frame/x.cpp", upwards}), IsEmpty());
  EXPECT_THAT(checkLayers({"src/mirrorball/render/attic/x.cpp", ""}), SizeIs(1));
  EXPECT_THAT(checkTree(checkLayers), IsEmpty());
}

TEST(House, RoomsAreLinkedWithWhatTheTablePermits) {
  EXPECT_THAT(checkLinks({"src/mirrorball/gl/CMakeLists.txt", "DEPENDS mirrorball::image mirrorball::shaders"}),
              IsEmpty());
  EXPECT_THAT(checkLinks({"src/mirrorball/gl/CMakeLists.txt", "DEPENDS mirrorball::image mirrorball::codec"}),
              SizeIs(1));
  EXPECT_THAT(checkLinks({"src/mirrorball/image/CMakeLists.txt", ""}), SizeIs(1));
  EXPECT_THAT(checkTree(checkLinks), IsEmpty());
}

/// The rooms that docs/architecture.md permits each room, from its lines of the form
/// `name/   what it is   → room, room` (or `→ nothing`).
std::map<std::string, std::set<std::string>> readDocumentedTable(const std::string& text) {
  const std::regex row(R"(^\s*([a-z_]+)/\s.*→ ([a-z_, ]+)$)");
  std::map<std::string, std::set<std::string>> table;
  forEachLine(text, [&](int, const std::string& line) {
    std::smatch match;
    if (!std::regex_search(line, match, row) || !kPermitted.contains(match[1])) return;
    std::set<std::string>& rooms = table[match[1]];
    std::istringstream names(match[2]);
    for (std::string name; std::getline(names >> std::ws, name, ',');)
      if (name != "nothing") rooms.insert(name);
  });
  return table;
}

TEST(House, DocumentedTableIsTheOneInForce) {
  const auto sample = readDocumentedTable("  gl/    windows → image\n  base/  words → nothing\nno row\n");
  EXPECT_EQ(sample, (decltype(sample){{"base", {}}, {"gl", {"image"}}}));

  std::ifstream stream(fs::path(MIRRORBALL_SOURCE_DIR) / "docs/architecture.md");
  const auto documented = readDocumentedTable({std::istreambuf_iterator<char>(stream), {}});
  for (const auto& [room, permitted] : documented) EXPECT_EQ(permitted, kPermitted.at(room)) << room;
  std::set<std::string> rooms;
  for (const SourceFile& file : readTree()) rooms.insert(roomOf(file.path));
  rooms.erase("");
  for (const std::string& room : rooms)
    EXPECT_TRUE(documented.contains(room)) << "docs/architecture.md has no line for " << room;
}

TEST(House, FormulasHaveNothingThatOneSideLacks) {
  EXPECT_THAT(checkFormula({"formula/x.glsl", "# ifdef GL_ES\n"}), SizeIs(1));
  EXPECT_THAT(checkFormula({"formula/x.glsl", "#define HALF 0.5f\n"}), IsEmpty());
  EXPECT_THAT(checkFormula({"formula/x.glsl", "  return Beam(lobe, pixel);\n"}), SizeIs(1));
  EXPECT_THAT(checkFormula({"formula/x.glsl", "  return MAKE(Beam)(lobe, vec2(0.0f));\n"}), IsEmpty());
  EXPECT_THAT(checkTree(checkFormula), IsEmpty());
}

TEST(House, RoomsForBrowsersUseWhatTheirCompilerHas) {
  EXPECT_THAT(checkBrowser({"src/mirrorball/base/x.h", "  std::ranges::sort(a);\n"}), SizeIs(1));
  EXPECT_THAT(checkBrowser({"src/mirrorball/codec/x.cpp", "#include <charconv>\n"}), SizeIs(1));
  EXPECT_THAT(checkBrowser({"formula/x.h", "float a = std::bit_cast<float>(1u);\n"}), SizeIs(1));
  EXPECT_THAT(checkBrowser({"src/mirrorball/image/x.cpp", "std::sort(a, b);  // no std::ranges\n"}), IsEmpty());
  EXPECT_THAT(checkBrowser({"src/mirrorball/study/x.cpp", "std::ranges::sort(a);\n"}), SizeIs(1));
  EXPECT_THAT(checkBrowser({"src/mirrorball/study/x_test.cpp", "std::ranges::sort(a);\n"}), IsEmpty());
  EXPECT_THAT(checkBrowser({"src/mirrorball/gl/x_test.cpp", "std::ranges::sort(a);\n"}), SizeIs(1));
  EXPECT_THAT(checkBrowser({"apps/cli/x.cpp", "std::ranges::sort(a);\n"}), IsEmpty());
  const std::string three_way = "  auto operator<=>(const A&) const = default;\n};\n";
  EXPECT_THAT(checkBrowser({"src/mirrorball/gl/x.h", "struct A {\n  std::vector<int> a;\n" + three_way}), SizeIs(1));
  EXPECT_THAT(checkBrowser({"src/mirrorball/gl/x.h", "struct A {\n  int a;\n" + three_way}), IsEmpty());
  EXPECT_THAT(checkTree(checkBrowser), IsEmpty());
}

TEST(House, OpenGlIsIncludedInOnePlace) {
  EXPECT_THAT(checkOpenGl({"src/mirrorball/render/x.cpp", "#include <epoxy/gl.h>\n"}), SizeIs(1));
  EXPECT_THAT(checkOpenGl({"tests/x.cpp", "#include <EGL/egl.h>\n"}), SizeIs(1));
  EXPECT_THAT(checkOpenGl({"src/mirrorball/gl/gl_api.h", "#include <epoxy/gl.h>\n"}), IsEmpty());
  EXPECT_THAT(checkTree(checkOpenGl), IsEmpty());
}

TEST(House, WindowHasNoProductLogic) {
  EXPECT_THAT(checkWindow({"apps/window/x.cpp", "#include \"mirrorball/render/frame/view.h\"\n"}), SizeIs(1));
  EXPECT_THAT(checkWindow({"apps/window/x.cpp", "#include \"mirrorball/view/panel/panel.h\"\n"}), IsEmpty());
  EXPECT_THAT(checkWindow({"src/x.cpp", "#include \"mirrorball/render/frame/view.h\"\n"}), IsEmpty());
  EXPECT_THAT(checkTree(checkWindow), IsEmpty());
  std::ptrdiff_t lines = 0;
  for (const SourceFile& file : readTree())
    if (startsWith(file.path, kWindow)) lines += std::count(file.text.begin(), file.text.end(), '\n');
  EXPECT_GT(lines, 0);
  EXPECT_LE(lines, kLongestWindow);
}

TEST(House, FilesAreShortEnoughToRead) {
  EXPECT_THAT(checkLength({"src/x.cpp", std::string(kLongestFile + 1, '\n')}), SizeIs(1));
  EXPECT_THAT(checkLength({"src/x.cpp", std::string(kLongestFile, '\n')}), IsEmpty());
  EXPECT_THAT(checkTree(checkLength), IsEmpty());
}

TEST(House, LinesAreNarrowEnoughToRead) {
  EXPECT_THAT(checkWidth({"a.cpp", "// " + std::string(117, 'a')}), IsEmpty());
  EXPECT_THAT(checkWidth({"a.cpp", "// " + std::string(118, 'a')}), SizeIs(1));
  EXPECT_THAT(checkTree(checkWidth), IsEmpty());
}

TEST(House, NothingIsLeftForLater) {
  EXPECT_THAT(checkLeftovers({"src/x.cpp",
                              "int a;  // TO"
                              "DO: b\n"}),
              SizeIs(1));
  EXPECT_THAT(checkLeftovers({"src/x.cpp", "#  if 0\n"}), SizeIs(1));
  EXPECT_THAT(checkTree(checkLeftovers), IsEmpty());
}

TEST(House, TypesAreDefinedOnce) {
  const std::string type = "namespace a {\nstruct B final : C {\n};\n}  // namespace a\n";
  EXPECT_THAT(visibleTypesOf(type), ElementsAre("a::B"));
  EXPECT_THAT(visibleTypesOf("namespace a {\nnamespace {\n" + type + "}  // namespace\nclass D;\nstruct E::F {\n};\n"),
              ElementsAre("a::E::F"));
  EXPECT_THAT(checkTypesAreDefinedOnce({{"b.h", type}, {"c.h", type}}), SizeIs(1));
  EXPECT_THAT(checkTypesAreDefinedOnce({{"b.h", type}, {"c.h", "struct B {\n};\n"}}), IsEmpty());
  EXPECT_THAT(checkTypesAreDefinedOnce(readTree()), IsEmpty());
}

TEST(House, HeadersHavePragmaOnce) {
  EXPECT_THAT(checkPragmaOnce({"src/x.h", "int a;\n"}), SizeIs(1));
  EXPECT_THAT(checkTree(checkPragmaOnce), IsEmpty());
}

}  // namespace
