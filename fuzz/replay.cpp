// usage: fuzz_replay_DECODER FOLDER
//
// Feeds every file of a corpus to the fuzzer's entry point, without libFuzzer: for the normal tests. Exit code 1 where
// the folder has no file; a finding ends the program by itself.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "fuzz.h"
#include "mirrorball/base/file.h"

int main(int count, char** arguments) {
  namespace fs = std::filesystem;
  if (count != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", arguments[0]);
    return 2;
  }
  std::error_code missing;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(arguments[1], missing)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    const auto bytes = mirrorball::readFile(file);
    if (!bytes) {
      std::fprintf(stderr, "%s\n", bytes.error().message.c_str());
      return 1;
    }
    // Named before it is tried, so that the last name printed is the one that failed.
    std::printf("%s\n", file.filename().c_str());
    std::fflush(stdout);
    LLVMFuzzerTestOneInput(bytes->data(), bytes->size());
  }
  if (files.empty()) std::fprintf(stderr, "%s: no corpus\n", arguments[1]);
  return files.empty() ? 1 : 0;
}
