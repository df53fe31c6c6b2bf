#include "mirrorball/gl/buffer.h"

#include <cassert>
#include <utility>

#include "mirrorball/gl/gl_api.h"

namespace mirrorball::gl {

Buffer::Buffer(std::span<const std::byte> bytes) {
  GLuint name = 0;
  glGenBuffers(1, &name);
  handle_ = Handle<destroy>(name);
  // The target of this first binding says nothing about the later use, and unlike
  // GL_ELEMENT_ARRAY_BUFFER this one is no state of the bound vertex array.
  glBindBuffer(GL_ARRAY_BUFFER, name);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
}

void Buffer::destroy(unsigned name) { glDeleteBuffers(1, &name); }

VertexArray::VertexArray() {
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  handle_ = Handle<destroy>(name);
}

VertexArray::VertexArray(Buffer indices) : VertexArray() {
  indices_ = std::move(indices);
  glBindVertexArray(handle_.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_->name());
  glBindVertexArray(0);
}

VertexArray::VertexArray(Buffer vertices, std::size_t stride, std::span<const Attribute> attributes, Buffer indices)
    : VertexArray() {
  vertices_ = std::move(vertices);
  indices_ = std::move(indices);
  read(*vertices_, stride, attributes);
  glBindVertexArray(handle_.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_->name());
  glBindVertexArray(0);
}

void VertexArray::read(const Buffer& buffer, std::size_t stride, std::span<const Attribute> attributes) {
  glBindVertexArray(handle_.name());
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  for (const Attribute& attribute : attributes) {
    assert(attribute.components >= 1 && attribute.components <= 4);
    glEnableVertexAttribArray(attribute.location);
    glVertexAttribPointer(attribute.location, attribute.components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(attribute.offset));
  }
  glBindVertexArray(0);
}

void VertexArray::stopReading(unsigned location) {
  glBindVertexArray(handle_.name());
  glDisableVertexAttribArray(location);
  glBindVertexArray(0);
}

void VertexArray::destroy(unsigned name) { glDeleteVertexArrays(1, &name); }

void VertexArray::drawIndexed(std::size_t count) const {
  assert(indices_);
  glBindVertexArray(handle_.name());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT, nullptr);
}

void VertexArray::draw(std::size_t count) const {
  glBindVertexArray(handle_.name());
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(count));
}

}  // namespace mirrorball::gl
