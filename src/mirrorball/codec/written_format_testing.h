#pragma once

#include <filesystem>

#include "mirrorball/codec/image_file_testing.h"

namespace mirrorball::testing {

/// A folder of which the files are counted.
class CodecFile : public FolderTest {
 protected:
  std::size_t fileCount() const {
    namespace fs = std::filesystem;
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
};

/// A format that image_file_test.cpp writes and reads back. The tests of a format add theirs by
/// INSTANTIATE_TEST_SUITE_P.
struct WrittenFormat {
  const char* name;
  float tolerance;  ///< of a sample near 1
  bool keeps_alpha;
};

class CodecFormat : public CodecFile, public ::testing::WithParamInterface<WrittenFormat> {
 protected:
  std::filesystem::path path() const { return folder_ / GetParam().name; }
};

}  // namespace mirrorball::testing
