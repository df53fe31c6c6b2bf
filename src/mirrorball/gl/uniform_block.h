#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/gl/handle.h"

namespace mirrorball::gl {

/// Where the members of a `layout(std140)` uniform block lie: the same in every program that declares the block alike.
class BlockLayout {
 public:
  /// What the driver says of a linked program's block; nothing where it has none of that name.
  static std::optional<BlockLayout> of(unsigned program, const std::string& block);

  struct Member {
    std::size_t offset;  ///< bytes from the block's start
    unsigned type;       ///< GL_FLOAT, GL_FLOAT_VEC3 …
    std::size_t count;   ///< an array's elements
  };

  /// By the name that the shader uses, "base_color" or "material.base_color"; an array's without "[0]".
  const Member* find(std::string_view name) const;

  /// Of the whole block, in bytes.
  std::size_t size() const { return size_; }

 private:
  std::size_t size_ = 0;
  std::map<std::string, Member, std::less<>> members_;
};

/// The values of a uniform block on the GPU, or of many that are alike, side by side in one buffer: so a draw needs to
/// know no more than a number. They are sent when a block is next bound.
class UniformBlock {
 public:
  /// count   of blocks
  explicit UniformBlock(std::shared_ptr<const BlockLayout> layout, std::size_t count = 1);

  /// Chooses which block is set.
  UniformBlock& at(std::size_t index);

  /// Sets a member by its name. That the block has it, and of that type, is asserted.
  void set(std::string_view member, float value);
  void set(std::string_view member, int value);
  void set(std::string_view member, const glm::vec3& value);
  void set(std::string_view member, const glm::vec4& value);
  void set(std::string_view member, const glm::mat3& value);
  void set(std::string_view member, const glm::mat4& value);
  /// An array from its first element on.
  void set(std::string_view member, std::span<const glm::vec4> values);

  /// Makes a block what programs read whose block is connected to `point`.
  void bind(unsigned point, std::size_t index = 0);

  /// That were sent until now: blocks, from the first to the last that has changed.
  std::size_t bytesSent() const { return bytes_sent_; }

 private:
  static void destroy(unsigned name);
  std::byte* place(std::string_view member, unsigned type, std::size_t count = 1);

  std::shared_ptr<const BlockLayout> layout_;
  std::size_t stride_;  // from block to block
  std::vector<std::byte> bytes_;
  std::size_t chosen_ = 0;
  std::size_t changed_begin_ = 0;  // of the bytes that are not sent yet
  std::size_t changed_end_ = 0;
  std::size_t bytes_sent_ = 0;
  Handle<destroy> handle_;
};

}  // namespace mirrorball::gl
