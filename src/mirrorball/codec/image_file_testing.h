#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "mirrorball/base/file.h"
#include "mirrorball/image/image.h"

namespace mirrorball::testing {

/// A picture whose every sample differs from its neighbours: from 0.06 to 0.9, alpha 0.5 and more.
inline Image gradient(int width, int height, int channels) {
  Image image(width, height, channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c)
        image.texel(x, y)[c] = c == 3 ? 0.5f + 0.5f * static_cast<float>(x) / static_cast<float>(width)
                                      : (1.0f + static_cast<float>((3 * x + 5 * y + 2 * c) % 15)) / 17.0f;
  return image;
}

/// The bytes of a text, as a file holds them.
inline Bytes bytesOf(const std::string& text) { return Bytes(text.begin(), text.end()); }

/// A fresh folder that goes away with the test.
class FolderTest : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  const std::filesystem::path folder_ = fresh();

 private:
  /// Not named by the process: all of a browser's have one number.
  static std::filesystem::path fresh() {
    std::string name = ::testing::TempDir() + "mirrorball_codec_XXXXXX";
    EXPECT_NE(::mkdtemp(name.data()), nullptr);
    return name;
  }
};

}  // namespace mirrorball::testing
