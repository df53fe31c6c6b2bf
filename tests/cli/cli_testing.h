#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json_fwd.hpp>

#include "cli/program.h"
#include "mirrorball/base/file.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/environment/file/load.h"
#include "test_data.h"

namespace mirrorball::testing {

/// The words of a command line; where one has spaces or is empty itself, the list is written out.
struct Arguments {
  std::vector<std::string> words;

  Arguments(const char* line) : Arguments(std::string(line)) {}
  Arguments(const std::string& line);
  Arguments(std::vector<std::string> list) : words(std::move(list)) {}

  /// For messages: what a user would have typed.
  std::string text() const;
};

/// Words with the options that they lack: each may be given only once.
///
/// usual   each with its value: "--size 8x8"
std::string withUsual(const std::string& words, const std::vector<std::string>& usual);

/// A fresh folder, in which the program runs and in which its files have plain names; it goes away with the test.
class CliTest : public ::testing::Test {
 protected:
  CliTest();
  ~CliTest() override;

  /// Runs the program to its end. `how` may set all but the arguments and the folder. `render` and `capture` draw with
  /// --quality draft unless another one is given.
  Outcome run(const Arguments& arguments, Start how = {}) const;

  /// Runs the program, which must succeed and complain about nothing; returns what it printed.
  std::string succeed(const Arguments& arguments, Start how = {}) const;

  /// Runs a --reference, which must succeed; returns what it says on standard error of how it went.
  std::string trace(const Arguments& arguments) const;

  /// Runs the program, which must succeed; returns the most memory that it had at a time [bytes].
  std::uint64_t peakOf(const Arguments& arguments) const;

  /// Runs the program, which must refuse: with `exit_code`, one line on stderr, nothing on stdout, and no file made,
  /// changed or removed. Returns the line, after "mirrorball: ".
  std::string refuse(int exit_code, const Arguments& arguments, Start how = {}) const;

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  /// The names of the files that are there, in the alphabet's order.
  std::vector<std::string> files() const;

  Bytes bytes(const std::string& name) const;
  nlohmann::json jsonIn(const std::string& name) const;
  Image image(const std::string& name) const;
  ImageSet texture(const std::string& name) const;
  LoadedEnvironment environment(const std::string& name) const;

  void write(const std::string& name, const Image& image, const Metadata& metadata = {}) const;
  void write(const std::string& name, const std::string& text) const;
  void write(const std::string& name, const Bytes& bytes) const;

  /// Makes a file of the shared data folder known under its own name; false where it is absent.
  bool share(const char* name) const;

 private:
  /// Each file's name and bytes.
  std::map<std::string, Bytes> snapshot() const;

  const std::filesystem::path folder_;
};

/// The same for what needs an OpenGL driver: skipped where there is none.
class RenderCliTest : public CliTest {
 protected:
  void SetUp() override;
};

/// The same for what measures memory: what a process takes at most says nothing where the address sanitizer keeps what
/// was given back.
class PeakMemoryTest : public CliTest {
 protected:
  void SetUp() override {
    if (isSanitized()) GTEST_SKIP() << "the address sanitizer's own memory is larger than what is measured";
  }
};

inline constexpr std::uint64_t kMega = 1024 * 1024;

/// The texel of a cube that looks in a direction.
glm::vec3 texelTowards(const ImageSet& cube, int level, glm::vec3 direction);

/// A map of 64 × 32 texels that no two directions share a radiance in, all between 0.1 and 2.
Image smoothPanorama();
/// The same with a lamp of 10⁵ at (20, 8).
Image smoothPanoramaWithLamp();

/// A map of 512 × 256 texels of which neighbours know nothing, with a lamp here and there and one part without light:
/// of narrow lobes it needs all bands.
Image noisyPanorama();

}  // namespace mirrorball::testing
