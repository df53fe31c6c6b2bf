#include "mirrorball/gl/uniform_block.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <utility>

#include "mirrorball/gl/gl_api.h"

namespace mirrorball::gl {
namespace {

/// One property of each of a program's uniforms.
std::vector<GLint> propertiesOf(unsigned program, const std::vector<GLuint>& uniforms, GLenum property) {
  std::vector<GLint> values(uniforms.size());
  glGetActiveUniformsiv(program, static_cast<GLsizei>(uniforms.size()), uniforms.data(), property, values.data());
  return values;
}

std::string nameOfUniform(unsigned program, GLuint uniform) {
  std::array<char, 128> name{};
  GLsizei length = 0;
  GLint count = 0;
  GLenum type = 0;
  glGetActiveUniform(program, uniform, name.size(), &length, &count, &type, name.data());
  std::string text(name.data(), static_cast<std::size_t>(length));
  if (text.ends_with("[0]")) text.resize(text.size() - 3);
  return text;
}

/// The bytes from one block to the next: where the driver lets one begin.
std::size_t strideOf(std::size_t size, std::size_t count) {
  if (count == 1) return size;
  GLint alignment = 1;
  glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
  const auto step = static_cast<std::size_t>(alignment);
  return (size + step - 1) / step * step;
}

}  // namespace

std::optional<BlockLayout> BlockLayout::of(unsigned program, const std::string& block) {
  const GLuint index = glGetUniformBlockIndex(program, block.c_str());
  if (index == GL_INVALID_INDEX) return std::nullopt;
  const auto ask = [&](GLenum property) {
    GLint value = 0;
    glGetActiveUniformBlockiv(program, index, property, &value);
    return static_cast<std::size_t>(value);
  };
  BlockLayout layout;
  layout.size_ = ask(GL_UNIFORM_BLOCK_DATA_SIZE);
  std::vector<GLint> indices(ask(GL_UNIFORM_BLOCK_ACTIVE_UNIFORMS));
  glGetActiveUniformBlockiv(program, index, GL_UNIFORM_BLOCK_ACTIVE_UNIFORM_INDICES, indices.data());
  const std::vector<GLuint> uniforms(indices.begin(), indices.end());
  const std::vector<GLint> offsets = propertiesOf(program, uniforms, GL_UNIFORM_OFFSET);
  const std::vector<GLint> types = propertiesOf(program, uniforms, GL_UNIFORM_TYPE);
  const std::vector<GLint> counts = propertiesOf(program, uniforms, GL_UNIFORM_SIZE);
  for (std::size_t i = 0; i < uniforms.size(); ++i)
    layout.members_.emplace(nameOfUniform(program, uniforms[i]),
                            Member{static_cast<std::size_t>(offsets[i]), static_cast<unsigned>(types[i]),
                                   static_cast<std::size_t>(counts[i])});
  return layout;
}

const BlockLayout::Member* BlockLayout::find(std::string_view name) const {
  const auto found = members_.find(name);
  return found == members_.end() ? nullptr : &found->second;
}

UniformBlock::UniformBlock(std::shared_ptr<const BlockLayout> layout, std::size_t count)
    : layout_(std::move(layout)),
      stride_(strideOf(layout_->size(), count)),
      bytes_(stride_ * count),
      changed_end_(bytes_.size()) {
  GLuint name = 0;
  glGenBuffers(1, &name);
  handle_ = Handle<destroy>(name);
  glBindBuffer(GL_UNIFORM_BUFFER, name);
  glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(bytes_.size()), nullptr, GL_DYNAMIC_DRAW);
}

void UniformBlock::destroy(unsigned name) { glDeleteBuffers(1, &name); }

std::byte* UniformBlock::place(std::string_view name, [[maybe_unused]] unsigned type,
                               [[maybe_unused]] std::size_t count) {
  const BlockLayout::Member* member = layout_->find(name);
  assert(member && "the shader's block has no member of that name");
  assert(member->type == type && member->count >= count);
  const std::size_t begin = chosen_ * stride_;
  changed_begin_ = std::min(changed_begin_, begin);
  changed_end_ = std::max(changed_end_, begin + stride_);
  return bytes_.data() + begin + member->offset;
}

void UniformBlock::set(std::string_view member, float value) {
  std::memcpy(place(member, GL_FLOAT), &value, sizeof value);
}

void UniformBlock::set(std::string_view member, int value) { std::memcpy(place(member, GL_INT), &value, sizeof value); }

void UniformBlock::set(std::string_view member, const glm::vec3& value) {
  std::memcpy(place(member, GL_FLOAT_VEC3), &value, sizeof value);
}

void UniformBlock::set(std::string_view member, const glm::vec4& value) {
  std::memcpy(place(member, GL_FLOAT_VEC4), &value, sizeof value);
}

void UniformBlock::set(std::string_view member, const glm::mat3& value) {
  // std140 puts each column where a vec4 would begin.
  std::byte* column = place(member, GL_FLOAT_MAT3);
  for (int i = 0; i < 3; ++i) std::memcpy(column + std::size_t(i) * sizeof(glm::vec4), &value[i], sizeof value[i]);
}

void UniformBlock::set(std::string_view member, const glm::mat4& value) {
  std::memcpy(place(member, GL_FLOAT_MAT4), &value, sizeof value);
}

void UniformBlock::set(std::string_view member, std::span<const glm::vec4> values) {
  // std140's stride of an array of vec4 is a vec4.
  std::memcpy(place(member, GL_FLOAT_VEC4, values.size()), values.data(), values.size_bytes());
}

UniformBlock& UniformBlock::at(std::size_t index) {
  assert((index + 1) * stride_ <= bytes_.size());
  chosen_ = index;
  return *this;
}

void UniformBlock::bind(unsigned point, std::size_t index) {
  if (changed_begin_ < changed_end_) {
    glBindBuffer(GL_UNIFORM_BUFFER, handle_.name());
    glBufferSubData(GL_UNIFORM_BUFFER, static_cast<GLintptr>(changed_begin_),
                    static_cast<GLsizeiptr>(changed_end_ - changed_begin_), bytes_.data() + changed_begin_);
    bytes_sent_ += changed_end_ - changed_begin_;
    changed_begin_ = bytes_.size();
    changed_end_ = 0;
  }
  glBindBufferRange(GL_UNIFORM_BUFFER, point, handle_.name(), static_cast<GLintptr>(index * stride_),
                    static_cast<GLsizeiptr>(layout_->size()));
}

}  // namespace mirrorball::gl
