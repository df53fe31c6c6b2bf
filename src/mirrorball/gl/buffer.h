#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>

#include "mirrorball/gl/handle.h"

namespace mirrorball::gl {

/// Bytes on the GPU that never change: vertices or indices.
class Buffer {
 public:
  /// Copies the elements of a vector or an array: `Buffer(mesh.vertices)`.
  template <typename Elements>
  requires requires(const Elements& elements) { std::data(elements); }
  explicit Buffer(const Elements& elements)
      : Buffer(std::span<const std::byte>(std::as_bytes(std::span(std::data(elements), std::size(elements))))) {}
  explicit Buffer(std::span<const std::byte> bytes);

  unsigned name() const { return handle_.name(); }

 private:
  static void destroy(unsigned name);
  Handle<destroy> handle_;
};

/// One float attribute of a vertex.
struct Attribute {
  unsigned location;   ///< as in the shader's layout(location = …)
  int components;      ///< 1 to 4
  std::size_t offset;  ///< bytes from the vertex's start
};

/// How vertices are laid out in a buffer, and which triangles they make.
class VertexArray {
 public:
  /// No buffers: the vertex shader makes everything from gl_VertexID.
  VertexArray();

  /// Indices alone, 32-bit, three a triangle: they are the shader's gl_VertexID.
  explicit VertexArray(Buffer indices);

  /// Takes both buffers over.
  ///
  /// stride   bytes from one vertex to the next
  /// indices  32-bit, three a triangle
  VertexArray(Buffer vertices, std::size_t stride, std::span<const Attribute> attributes, Buffer indices);

  /// Reads more attributes from a second buffer, which must outlive the drawing and is not owned; or in place of
  /// another such buffer.
  ///
  /// stride   bytes from one vertex to the next
  void read(const Buffer& buffer, std::size_t stride, std::span<const Attribute> attributes);

  /// An attribute is 0 for all vertices, until it is read again.
  void stopReading(unsigned location);

  /// Draws `count` indices from the first, as triangles.
  void drawIndexed(std::size_t count) const;

  /// Draws `count` vertices without indices, as triangles: 3 for a triangle that covers the screen.
  void draw(std::size_t count) const;

 private:
  static void destroy(unsigned name);
  Handle<destroy> handle_;
  std::optional<Buffer> vertices_;
  std::optional<Buffer> indices_;
};

}  // namespace mirrorball::gl
