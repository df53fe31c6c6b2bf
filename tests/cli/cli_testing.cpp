#include "cli/cli_testing.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include "gl_driver.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/gl/context.h"
#include "test_data.h"

namespace mirrorball::testing {
namespace {

namespace fs = std::filesystem;

/// The value of a Result that a test cannot go on without.
template <typename Value>
Value need(Result<Value> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(*result);
}

void need(const Result<void>& result) {
  if (!result) throw std::runtime_error(result.error().message);
}

}  // namespace

Arguments::Arguments(const std::string& line) {
  std::istringstream stream(line);
  words.assign(std::istream_iterator<std::string>(stream), {});
}

std::string Arguments::text() const {
  std::string line = "mirrorball";
  for (const std::string& word : words) {
    const bool plain = !word.empty() && word.find_first_of(" \"#;*'") == std::string::npos;
    line += plain ? " " + word : " '" + word + "'";
  }
  return line;
}

std::string withUsual(const std::string& words, const std::vector<std::string>& usual) {
  const std::vector<std::string> given = Arguments(words).words;
  std::string line = words;
  for (const std::string& option : usual)
    if (std::ranges::find(given, option.substr(0, option.find(' '))) == given.end()) line += " " + option;
  return line;
}

CliTest::CliTest()
    : folder_(fs::path(::testing::TempDir()) / ("mirrorball_cli_" + std::to_string(::getpid()) + "_" +
                                                ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
  fs::create_directories(folder_);
}

CliTest::~CliTest() { fs::remove_all(folder_); }

namespace {

/// Drafts, where a command draws and nothing is said of quality: most tests are about something else, and a note of
/// what was chosen is no complaint.
std::vector<std::string> drawingDrafts(std::vector<std::string> words) {
  const auto has = [&](const char* option) { return std::ranges::find(words, option) != words.end(); };
  const bool draws = !words.empty() && (words[0] == "render" || words[0] == "capture") && !has("--reference");
  if (draws && !has("--quality")) words.insert(words.begin() + 1, {"--quality", "draft"});
  return words;
}

}  // namespace

Outcome CliTest::run(const Arguments& arguments, Start how) const {
  how.arguments = drawingDrafts(arguments.words);
  how.folder = folder_;
  return Program(how).wait();
}

std::string CliTest::succeed(const Arguments& arguments, Start how) const {
  const Outcome outcome = run(arguments, std::move(how));
  EXPECT_EQ(outcome.exit_code, 0) << arguments.text() << "\nended by signal " << outcome.signal;
  EXPECT_EQ(outcome.err, "") << arguments.text();
  return outcome.out;
}

std::string CliTest::trace(const Arguments& arguments) const {
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << arguments.text() << "\n" << outcome.err;
  EXPECT_EQ(outcome.out, "") << arguments.text();
  return outcome.err;
}

std::uint64_t CliTest::peakOf(const Arguments& arguments) const {
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << arguments.text() << "\n" << outcome.err;
  return outcome.peak_memory;
}

std::string CliTest::refuse(int exit_code, const Arguments& arguments, Start how) const {
  const std::map<std::string, Bytes> before = snapshot();
  const Outcome outcome = run(arguments, std::move(how));
  EXPECT_EQ(outcome.exit_code, exit_code) << arguments.text() << "\nended by signal " << outcome.signal << "\n"
                                          << outcome.err;
  EXPECT_EQ(outcome.out, "") << arguments.text();
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << arguments.text() << "\n" << outcome.err;
  EXPECT_TRUE(outcome.err.starts_with("mirrorball: ")) << arguments.text() << "\n" << outcome.err;
  EXPECT_TRUE(snapshot() == before) << arguments.text()
                                    << "\nleft other files than there were: " << ::testing::PrintToString(files());
  const std::size_t begin = std::min(std::string("mirrorball: ").size(), outcome.err.size());
  return outcome.err.substr(begin, outcome.err.find('\n') - begin);
}

std::vector<std::string> CliTest::files() const {
  std::vector<std::string> names;
  for (const auto& [name, bytes] : snapshot()) names.push_back(name);
  return names;
}

std::map<std::string, Bytes> CliTest::snapshot() const {
  std::map<std::string, Bytes> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_)) {
    const std::string name = entry.path().lexically_relative(folder_).generic_string();
    files[entry.is_directory() ? name + "/" : name] = entry.is_regular_file() ? bytes(name) : Bytes{};
  }
  return files;
}

Bytes CliTest::bytes(const std::string& name) const { return need(readFile(path(name))); }

nlohmann::json CliTest::jsonIn(const std::string& name) const {
  const Bytes text = bytes(name);
  return nlohmann::json::parse(text.begin(), text.end());
}

Image CliTest::image(const std::string& name) const { return need(readImage(path(name))).image; }

ImageSet CliTest::texture(const std::string& name) const { return need(readImageSet(path(name))).images; }

LoadedEnvironment CliTest::environment(const std::string& name) const {
  return need(loadEnvironment(path(name).string()));
}

void CliTest::write(const std::string& name, const Image& image, const Metadata& metadata) const {
  need(writeImage(path(name), image, {.half = false, .metadata = metadata}));
}

void CliTest::write(const std::string& name, const std::string& text) const {
  write(name, Bytes(text.begin(), text.end()));
}

void CliTest::write(const std::string& name, const Bytes& bytes) const { need(writeFile(path(name), bytes)); }

bool CliTest::share(const char* name) const {
  const auto original = sharedData(name);
  if (original) fs::create_symlink(fs::absolute(*original), path(name));
  return original.has_value();
}

void RenderCliTest::SetUp() {
  if (const auto context = gl::Context::createHeadless(); !context) MIRRORBALL_END_WITHOUT_GL(context.error().message);
}

glm::vec3 texelTowards(const ImageSet& cube, int level, glm::vec3 direction) {
  const MapPosition place = positionOf(Projection::cube, glm::normalize(direction));
  const Image& face = cube.at(level, place.face);
  const glm::ivec2 texel = glm::min(glm::ivec2(place.uv * float(face.width())), face.width() - 1);
  return rgbAt(face, texel.x, texel.y);
}

Image smoothPanorama() {
  const Environment smooth(smoothRadiance, 32);
  return need(convert(smooth, Projection::equirect, 32)).face(0);
}

Image smoothPanoramaWithLamp() {
  Image map = smoothPanorama();
  std::fill_n(map.texel(20, 8), 3, 1e5f);
  return map;
}

Image noisyPanorama() {
  Image noise(512, 256, 3);
  unsigned state = 1;
  for (float& sample : noise.samples()) {
    state = state * 1664525u + 1013904223u;
    sample = static_cast<float>(state >> 8) / float(1 << 24) + (state % 997 == 0 ? 100.0f : 0.0f);
  }
  for (int y = 96; y < 160; ++y) std::fill_n(noise.texel(64, y), 3 * 64, 0.0f);
  return noise;
}

}  // namespace mirrorball::testing
