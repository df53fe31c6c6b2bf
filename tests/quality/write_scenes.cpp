// usage: quality_scenes FOLDER
//
// Writes each of the sample scenes into a folder as NAME.glb, so that they can be rendered by hand, and prints how.

#include <cstdio>
#include <filesystem>

#include "quality/scenes.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: quality_scenes FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  for (const mirrorball::quality::SampleScene& scene : mirrorball::quality::sampleScenes()) {
    const auto file = mirrorball::quality::writeScene(scene, folder);
    if (!file) {
      std::fprintf(stderr, "%s\n", file.error().message.c_str());
      return 1;
    }
    std::printf("render %s %s\n", file->c_str(), mirrorball::quality::shownBy(scene, "--quality good").c_str());
  }
}
