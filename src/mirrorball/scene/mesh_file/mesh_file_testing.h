#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/file.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball::testing {

inline Bytes toBytes(std::string_view text) { return Bytes(text.begin(), text.end()); }

/// A folder of the test's own, where a model's files lie beside each other.
class MeshFolderTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) / (std::string(test->test_suite_name()) + "_" + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  void write(const std::string& name, std::string_view text) const {
    std::filesystem::create_directories(path(name).parent_path());
    ASSERT_TRUE(writeFile(path(name), toBytes(text)));
  }

  /// A picture of one row, of codes.
  void writePicture(const std::string& name, const std::vector<std::uint8_t>& red_green_blue) const {
    std::string picture = "P6 " + std::to_string(red_green_blue.size() / 3) + " 1 255\n";
    picture.append(red_green_blue.begin(), red_green_blue.end());
    write(name, picture);
  }

 private:
  std::filesystem::path folder_;
};

/// The area of all triangles.
inline double totalArea(const Scene& scene) {
  double area = 0.0;
  for (const Mesh& mesh : scene.meshes)
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      const auto corner = [&](std::size_t k) { return glm::dvec3(mesh.vertices[mesh.indices[i + k]].position); };
      area += 0.5 * glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    }
  return area;
}

}  // namespace mirrorball::testing
