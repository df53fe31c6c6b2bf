#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/gltf/gltf_file.h"

// How an accessor's elements lie in its buffer: glTF 2.0, section 3.6.

namespace mirrorball::gltf {
namespace {

// An accessor without a buffer view is all zeros and takes memory that no bytes of the file stand for: at most this
// many elements of it are made.
constexpr std::size_t kMaxZeroElements = std::size_t{1} << 20;

std::size_t componentSize(int component_type) {
  switch (component_type) {
    case kByte:
    case kUnsignedByte:
      return 1;
    case kShort:
    case kUnsignedShort:
      return 2;
    case kInt:
    case kUnsignedInt:
    case kFloat:
      return 4;
    default:
      return 0;
  }
}

template <typename Value>
Value loadAs(const std::uint8_t* bytes) {
  Value value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

/// A component as a float; normalised as section 3.11 says.
float loadNumber(const std::uint8_t* bytes, int component_type, bool normalized) {
  const auto signed_share = [](float value, float full) { return std::max(value / full, -1.0f); };
  switch (component_type) {
    case kByte: {
      const auto value = static_cast<float>(loadAs<std::int8_t>(bytes));
      return normalized ? signed_share(value, 127.0f) : value;
    }
    case kUnsignedByte: {
      const auto value = static_cast<float>(loadAs<std::uint8_t>(bytes));
      return normalized ? value / 255.0f : value;
    }
    case kShort: {
      const auto value = static_cast<float>(loadAs<std::int16_t>(bytes));
      return normalized ? signed_share(value, 32767.0f) : value;
    }
    case kUnsignedShort: {
      const auto value = static_cast<float>(loadAs<std::uint16_t>(bytes));
      return normalized ? value / 65535.0f : value;
    }
    case kInt:
      return static_cast<float>(loadAs<std::int32_t>(bytes));
    case kUnsignedInt:
      return static_cast<float>(loadAs<std::uint32_t>(bytes));
    default:
      return loadAs<float>(bytes);
  }
}

std::uint32_t loadInteger(const std::uint8_t* bytes, int component_type) {
  switch (componentSize(component_type)) {
    case 1:
      return loadAs<std::uint8_t>(bytes);
    case 2:
      return loadAs<std::uint16_t>(bytes);
    default:
      return loadAs<std::uint32_t>(bytes);
  }
}

/// Indices are never below 0: the signed types that some programs name (UnityGLTF, gdx-gltf) mean the
/// unsigned ones of their sizes.
bool isOfIndices(int component_type) { return componentSize(component_type) > 0 && component_type != kFloat; }

/// Elements that lie in a buffer, all of them inside it.
struct Elements {
  const std::uint8_t* first = nullptr;
  std::size_t stride = 0;
  const std::uint8_t* at(std::size_t i) const { return first + i * stride; }
};

/// The elements of `size` bytes that begin at `offset` of a buffer view.
Result<Elements> elementsIn(const File& file, int view_index, std::size_t offset, std::size_t size, std::size_t count,
                            bool may_stride, const std::string& key) {
  MIRRORBALL_TRY(bytes, viewBytes(file, view_index, key + ".bufferView"));
  const std::size_t given = file.document.buffer_views[std::size_t(view_index)].byte_stride;
  const std::size_t stride = may_stride && given != 0 ? given : size;
  if (stride < size)
    return fail(ErrorCode::bad_file, quoted("bufferViews", std::size_t(view_index)) + ".byteStride is " +
                                         std::to_string(stride) + ", less than an element of " + key);
  if (count == 0) return Elements{};
  const std::size_t last = std::numeric_limits<std::size_t>::max() - size;
  if (offset > last || (count - 1) > (last - offset) / stride)
    return fail(ErrorCode::bad_file, key + " reaches past the end of every buffer");
  const std::size_t end = offset + (count - 1) * stride + size;
  if (end > bytes.size())
    return fail(ErrorCode::bad_file, key + " reaches byte " + std::to_string(end) + " of " +
                                         quoted("bufferViews", std::size_t(view_index)) + ", which has " +
                                         std::to_string(bytes.size()));
  return Elements{bytes.data() + offset, stride};
}

/// Where the elements of an accessor are, those of its buffer view and those that replace them.
struct Layout {
  std::size_t count = 0;
  std::size_t components = 0;
  std::size_t component_size = 0;
  std::optional<Elements> dense;  // all zeros where there is none
  std::vector<std::uint32_t> replaced;
  Elements replacements;
};

Result<void> addSparse(const File& file, const Sparse& sparse, const std::string& key, Layout& layout) {
  if (sparse.count > layout.count)
    return fail(ErrorCode::bad_file,
                key + ".sparse.count is " + std::to_string(sparse.count) + ", more than the accessor has");
  if (!isOfIndices(sparse.indices_type))
    return fail(ErrorCode::bad_file, key + ".sparse.indices.componentType is none of indices");
  MIRRORBALL_TRY(indices, elementsIn(file, sparse.indices_view, sparse.indices_offset,
                                     componentSize(sparse.indices_type), sparse.count, false, key + ".sparse.indices"));
  MIRRORBALL_TRY(values,
                 elementsIn(file, sparse.values_view, sparse.values_offset, layout.components * layout.component_size,
                            sparse.count, false, key + ".sparse.values"));
  layout.replacements = values;
  for (std::size_t i = 0; i < sparse.count; ++i) {
    const std::uint32_t index = loadInteger(indices.at(i), sparse.indices_type);
    if (index >= layout.count)
      return fail(ErrorCode::bad_file, key + ".sparse.indices names element " + std::to_string(index) + " of " +
                                           std::to_string(layout.count));
    layout.replaced.push_back(index);
  }
  return {};
}

Result<Layout> layoutOf(const File& file, int index, const std::string& referrer) {
  MIRRORBALL_TRY_VOID(checkIndex(index, file.document.accessors.size(), referrer, "accessor"));
  const Accessor& accessor = file.document.accessors[std::size_t(index)];
  const std::string key = quoted("accessors", std::size_t(index));
  Layout layout;
  layout.count = accessor.count;
  layout.components = accessor.components;
  layout.component_size = componentSize(accessor.component_type);
  if (layout.components == 0 || layout.component_size == 0)
    return fail(ErrorCode::bad_file, key + " has a type that " + referrer + " cannot have");

  if (accessor.buffer_view >= 0) {
    MIRRORBALL_TRY(dense, elementsIn(file, accessor.buffer_view, accessor.byte_offset,
                                     layout.components * layout.component_size, layout.count, true, key));
    layout.dense = dense;
  } else if (layout.count > kMaxZeroElements) {
    return fail(ErrorCode::too_large, key + ".count is " + std::to_string(layout.count) + ", but it has no bufferView");
  }
  if (accessor.sparse) MIRRORBALL_TRY_VOID(addSparse(file, *accessor.sparse, key, layout));
  return layout;
}

/// Calls `take(element, bytes)` for every element that bytes stand for, the replacements last.
template <typename Take>
void forEachElement(const Layout& layout, Take&& take) {
  if (layout.dense)
    for (std::size_t i = 0; i < layout.count; ++i) take(i, layout.dense->at(i));
  for (std::size_t i = 0; i < layout.replaced.size(); ++i) take(layout.replaced[i], layout.replacements.at(i));
}

}  // namespace

Result<std::span<const std::uint8_t>> bufferBytes(const File& file, int buffer, std::size_t offset, std::size_t length,
                                                  const std::string& key) {
  MIRRORBALL_TRY_VOID(checkIndex(buffer, file.buffers.size(), key + ".buffer", "buffer"));
  if (const auto lost = file.lost_buffers.find(buffer); lost != file.lost_buffers.end())
    return tl::unexpected<Error>(lost->second);
  const std::span<const std::uint8_t> data = file.buffers[std::size_t(buffer)];
  if (offset > data.size() || length > data.size() - offset)
    return fail(ErrorCode::bad_file, key + " takes " + counted(length, "byte") + " from byte " +
                                         std::to_string(offset) + " of " + quoted("buffers", std::size_t(buffer)) +
                                         ", which has " + std::to_string(data.size()));
  return data.subspan(offset, length);
}

Result<std::span<const std::uint8_t>> viewBytes(const File& file, int view_index, const std::string& key) {
  MIRRORBALL_TRY_VOID(checkIndex(view_index, file.document.buffer_views.size(), key, "bufferView"));
  const BufferView& view = file.document.buffer_views[std::size_t(view_index)];
  const std::string view_key = quoted("bufferViews", std::size_t(view_index));
  return bufferBytes(file, view.buffer, view.byte_offset, view.byte_length, view_key);
}

Result<Numbers> readNumbers(const File& file, int index, const std::string& key) {
  MIRRORBALL_TRY(layout, layoutOf(file, index, key));
  const Accessor& accessor = file.document.accessors[std::size_t(index)];
  Numbers numbers;
  numbers.components = layout.components;
  numbers.values.assign(layout.count * layout.components, 0.0f);
  forEachElement(layout, [&](std::size_t element, const std::uint8_t* bytes) {
    float* out = numbers.values.data() + element * layout.components;
    for (std::size_t i = 0; i < layout.components; ++i)
      out[i] = loadNumber(bytes + i * layout.component_size, accessor.component_type, accessor.normalized);
  });
  return numbers;
}

Result<Numbers> readFiniteNumbers(const File& file, int index, const std::string& key) {
  MIRRORBALL_TRY(numbers, readNumbers(file, index, key));
  for (std::size_t i = 0; i < numbers.values.size(); ++i)
    if (!std::isfinite(numbers.values[i]))
      return fail(ErrorCode::bad_file, quoted("accessors", std::size_t(index)) + " (" + key +
                                           ") holds NaN or infinity in element " +
                                           std::to_string(i / numbers.components));
  return numbers;
}

Result<std::vector<std::uint32_t>> readIntegers(const File& file, int index, const std::string& key) {
  MIRRORBALL_TRY(layout, layoutOf(file, index, key));
  const Accessor& accessor = file.document.accessors[std::size_t(index)];
  if (layout.components != 1 || !isOfIndices(accessor.component_type))
    return fail(ErrorCode::bad_file,
                quoted("accessors", std::size_t(index)) + " has a type that " + key + " cannot have");
  std::vector<std::uint32_t> integers(layout.count, 0u);
  forEachElement(layout, [&](std::size_t element, const std::uint8_t* bytes) {
    integers[element] = loadInteger(bytes, accessor.component_type);
  });
  return integers;
}

}  // namespace mirrorball::gltf
