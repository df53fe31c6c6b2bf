#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball::testing {

/// Writes small glTF files by hand: numbers go into one buffer, each list with its buffer view and accessor.
class GltfMaker {
 public:
  /// Appends numbers to the buffer and returns the index of their buffer view.
  template <typename Number>
  int view(const std::vector<Number>& numbers) {
    buffer_.resize((buffer_.size() + 3) / 4 * 4);
    const std::size_t offset = buffer_.size();
    const std::size_t size = numbers.size() * sizeof(Number);
    buffer_.resize(offset + size);
    if (size > 0) std::memcpy(buffer_.data() + offset, numbers.data(), size);
    return add(views_, "{\"buffer\":0,\"byteOffset\":" + std::to_string(offset) +
                           ",\"byteLength\":" + std::to_string(size) + "}");
  }

  /// Appends numbers and returns the index of their accessor.
  ///
  /// type   "VEC3"
  /// extra  more members: ",\"normalized\":true"
  template <typename Number>
  int accessor(const std::vector<Number>& numbers, const std::string& type, const std::string& extra = "") {
    const std::size_t components = type == "SCALAR" ? 1 : type == "MAT4" ? 16 : static_cast<std::size_t>(type[3] - '0');
    const int view_index = view(numbers);
    return rawAccessor(
        "{\"bufferView\":" + std::to_string(view_index) + ",\"componentType\":" + componentType<Number>() +
        ",\"count\":" + std::to_string(numbers.size() / components) + ",\"type\":\"" + type + "\"" + extra + "}");
  }
  int rawAccessor(const std::string& json) { return add(accessors_, json); }

  /// The JSON with a node for mesh 0, whose one primitive is given; `rest` are more members of the root, which may be
  /// nodes of their own.
  std::string gltf(const std::string& primitive, const std::string& rest = "") const {
    return json(primitive, rest, ",\"uri\":\"data:application/octet-stream;base64," + base64(buffer_) + "\"");
  }

  /// The same as a .glb.
  Bytes glb(const std::string& primitive, const std::string& rest = "") const {
    std::string text = json(primitive, rest, "");
    text.resize((text.size() + 3) / 4 * 4, ' ');
    Bytes binary = buffer_;
    binary.resize((binary.size() + 3) / 4 * 4);
    Bytes file = {'g', 'l', 'T', 'F'};
    const auto put = [&](std::size_t word) {
      for (int shift = 0; shift < 32; shift += 8) file.push_back(static_cast<std::uint8_t>(word >> shift));
    };
    put(2);
    put(12 + 8 + text.size() + 8 + binary.size());
    put(text.size());
    put(0x4E4F534A);
    file.insert(file.end(), text.begin(), text.end());
    put(binary.size());
    put(0x004E4942);
    file.insert(file.end(), binary.begin(), binary.end());
    return file;
  }

  static std::string base64(const Bytes& bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
      std::uint32_t bits = 0;
      for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
      for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
    }
    return text;
  }

 private:
  static int add(std::vector<std::string>& list, const std::string& json) {
    list.push_back(json);
    return static_cast<int>(list.size()) - 1;
  }

  template <typename Number>
  static std::string componentType() {
    if constexpr (std::is_same_v<Number, std::int8_t>) return "5120";
    if constexpr (std::is_same_v<Number, std::uint8_t>) return "5121";
    if constexpr (std::is_same_v<Number, std::int16_t>) return "5122";
    if constexpr (std::is_same_v<Number, std::uint16_t>) return "5123";
    if constexpr (std::is_same_v<Number, std::uint32_t>) return "5125";
    return "5126";
  }

  static std::string array(const std::vector<std::string>& list) {
    std::string text = "[";
    for (const std::string& element : list) text += (text.size() > 1 ? "," : "") + element;
    return text + "]";
  }

  std::string json(const std::string& primitive, const std::string& rest, const std::string& uri) const {
    std::string text = "{\"asset\":{\"version\":\"2.0\"},\"meshes\":[{\"primitives\":[" + primitive + "]}]";
    if (rest.find("\"nodes\":") == std::string::npos) text += ",\"nodes\":[{\"mesh\":0}]";
    text += ",\"accessors\":" + array(accessors_) + ",\"bufferViews\":" + array(views_);
    text += ",\"buffers\":[{\"byteLength\":" + std::to_string(buffer_.size()) + uri + "}]";
    return text + (rest.empty() ? "" : "," + rest) + "}";
  }

  Bytes buffer_;
  std::vector<std::string> views_;
  std::vector<std::string> accessors_;
};

/// An animation of such a file as it grows.
class AnimationMaker {
 public:
  explicit AnimationMaker(GltfMaker& maker) : maker_(maker) {}

  /// Moves something: "node":3,"path":"rotation".
  AnimationMaker& move(const std::string& target, const std::vector<float>& times, const std::vector<float>& values,
                       const std::string& type, const std::string& interpolation = "LINEAR") {
    const std::string input = std::to_string(maker_.accessor(times, "SCALAR"));
    const std::string output = std::to_string(maker_.accessor(values, type));
    return sample(target,
                  "\"input\":" + input + ",\"output\":" + output + R"(,"interpolation":")" + interpolation + "\"");
  }
  /// The same with the sampler's members.
  AnimationMaker& sample(const std::string& target, const std::string& sampler) {
    const std::string comma = samplers_.empty() ? "" : ",";
    channels_ += comma + R"({"sampler":)" + std::to_string(count_++) + R"(,"target":{)" + target + "}}";
    samplers_ += comma + "{" + sampler + "}";
    return *this;
  }
  /// The same of what a JSON pointer leads to.
  AnimationMaker& point(const std::string& pointer, const std::vector<float>& times, const std::vector<float>& values,
                        const std::string& type, const std::string& interpolation = "LINEAR") {
    return move(R"("path":"pointer","extensions":{"KHR_animation_pointer":{"pointer":")" + pointer + "\"}}", times,
                values, type, interpolation);
  }

  std::string json(const std::string& name = "Walk") const {
    return R"({"name":")" + name + R"(","samplers":[)" + samplers_ + R"(],"channels":[)" + channels_ + "]}";
  }

 private:
  GltfMaker& maker_;
  int count_ = 0;
  std::string samplers_;
  std::string channels_;
};

/// A file is shown all the same, with remarks of which one says `part`.
inline void expectTold(const Result<Scene>& scene, const std::string& part) {
  ASSERT_TRUE(scene) << part << ": " << scene.error().message;
  EXPECT_FALSE(scene->instances.empty()) << part;
  EXPECT_THAT(scene->warnings, ::testing::Contains(::testing::HasSubstr(part)));
  for (const std::string& warning : scene->warnings) {
    EXPECT_EQ(warning, printable(warning));
    EXPECT_LT(warning.size(), 500u);
  }
}

inline void expectSafe(const Scene& scene) {
  for (const Instance& instance : scene.instances) ASSERT_LT(std::size_t(instance.mesh), scene.meshes.size());
  for (const Mesh& mesh : scene.meshes) {
    ASSERT_LT(std::size_t(mesh.material), scene.materials.size());
    for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.vertices.size());
  }
}

}  // namespace mirrorball::testing
