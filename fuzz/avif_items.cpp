// An AVIF taken apart into boxes and items, and put together again.

#include <string_view>
#include <utility>

#include "avif_mutation.h"

namespace mirrorball::fuzz {
namespace {

/// Numbers whose highest byte is first. Behind the end they are 0, and `isBehindEnd`.
class BigNumbers {
 public:
  explicit BigNumbers(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint64_t read(std::size_t count) {
    std::uint64_t number = 0;
    for (; count > 0; --count, ++next_) number = number << 8 | (next_ < bytes_.size() ? bytes_[next_] : 0u);
    return number;
  }
  bool isBehindEnd() const { return next_ > bytes_.size(); }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

/// The sizes of an `iloc`'s numbers, in bytes.
struct NumberSizes {
  std::size_t offset, length, base, index;
};

NumberSizes readSizes(BigNumbers& numbers, std::uint64_t version) {
  const std::uint64_t both = numbers.read(2);
  const auto half = [&](unsigned shift) { return static_cast<std::size_t>(both >> shift & 15u); };
  return {half(12), half(8), half(4), version > 0 ? half(0) : 0};
}

/// Appends an item's next piece to it; false where that is not in the file.
bool appendExtent(Bytes& data, std::span<const std::uint8_t> from, std::uint64_t offset, std::uint64_t length) {
  if (offset > from.size() || length > from.size() - offset) return false;
  const auto piece = from.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
  data.insert(data.end(), piece.begin(), piece.end());
  return true;
}

std::optional<std::vector<AvifItem>> itemsIn(std::span<const std::uint8_t> iloc, std::span<const std::uint8_t> file,
                                             std::span<const std::uint8_t> idat) {
  BigNumbers numbers(iloc);
  const std::uint64_t version = numbers.read(4) >> 24;
  const NumberSizes sizes = readSizes(numbers, version);
  const std::size_t of_item = version < 2 ? 2 : 4;
  std::vector<AvifItem> items;
  for (std::uint64_t left = numbers.read(of_item); left > 0 && !numbers.isBehindEnd(); --left) {
    AvifItem item{.number = static_cast<std::uint32_t>(numbers.read(of_item))};
    const std::uint64_t method = version > 0 ? numbers.read(2) & 15u : 0;
    numbers.read(2);  // data_reference_index
    const std::uint64_t base = numbers.read(sizes.base);
    for (std::uint64_t extents = numbers.read(2); extents > 0; --extents) {
      numbers.read(sizes.index);
      const std::uint64_t offset = base + numbers.read(sizes.offset), length = numbers.read(sizes.length);
      if (numbers.isBehindEnd() || !appendExtent(item.data, method == 1 ? idat : file, offset, length))
        return std::nullopt;
    }
    items.push_back(std::move(item));
  }
  return numbers.isBehindEnd() ? std::nullopt : std::optional(std::move(items));
}

/// The data of all items, one behind the other.
Bytes dataOfItems(const std::vector<AvifItem>& items, bool goes_back) {
  Bytes data;
  for (const AvifItem& item : items)
    data.insert(goes_back ? data.begin() : data.end(), item.data.begin(), item.data.end());
  return data;
}

/// What `iloc` holds if the items' data begins at byte `start`.
Bytes ilocOfItems(const std::vector<AvifItem>& items, std::uint64_t start, const AvifPlaces& places) {
  constexpr std::size_t kSize = 4;  // of offsets and lengths
  const std::size_t of_item = places.version < 2 ? 2 : 4;
  Bytes iloc;
  appendBig(iloc, std::uint64_t(places.version) << 24, 4);
  appendBig(iloc, kSize << 12 | kSize << 8 | (places.has_base ? kSize : 0) << 4, 2);
  appendBig(iloc, items.size(), of_item);
  if (places.goes_back) start += dataOfItems(items, true).size();
  for (const AvifItem& item : items) {
    if (places.goes_back) start -= item.data.size();
    appendBig(iloc, item.number, of_item);
    if (places.version > 0) appendBig(iloc, places.is_in_meta ? 1 : 0, 2);
    appendBig(iloc, 0, 2);
    if (places.has_base) appendBig(iloc, start, kSize);
    appendBig(iloc, places.extents, 2);
    const std::size_t piece = item.data.size() / places.extents;
    for (std::size_t i = 0; i < places.extents; ++i) {
      appendBig(iloc, (places.has_base ? 0 : start) + i * piece, kSize);
      appendBig(iloc, i + 1 < places.extents ? piece : item.data.size() - i * piece, kSize);
    }
    if (!places.goes_back) start += item.data.size();
  }
  return iloc;
}

void eraseBoxes(std::vector<FileBox>& boxes, std::string_view type) {
  std::erase_if(boxes, [&](const FileBox& box) { return box.type == type; });
}

}  // namespace

std::optional<AvifParts> avifPartsIn(std::span<const std::uint8_t> bytes) {
  auto boxes = boxesIn(bytes);
  if (!boxes) return std::nullopt;
  FileBox* meta = firstBox(*boxes, "meta");
  FileBox* iloc = meta == nullptr ? nullptr : firstBox(meta->boxes, "iloc");
  if (iloc == nullptr) return std::nullopt;
  const FileBox* idat = firstBox(meta->boxes, "idat");
  auto items = itemsIn(iloc->content, bytes, idat == nullptr ? Bytes{} : idat->content);
  if (!items || items->empty()) return std::nullopt;
  iloc->content.clear();
  eraseBoxes(meta->boxes, "idat");
  eraseBoxes(*boxes, "mdat");
  return AvifParts{std::move(*boxes), std::move(*items)};
}

Bytes avifOfParts(const AvifParts& parts, const AvifPlaces& places) {
  AvifParts whole = parts;
  Bytes data = dataOfItems(whole.items, places.goes_back);
  FileBox* meta = firstBox(whole.boxes, "meta");
  FileBox* iloc = firstBox(meta->boxes, "iloc");
  iloc->content = ilocOfItems(whole.items, 0, places);
  if (places.is_in_meta) {
    meta->boxes.push_back({"idat", std::move(data)});
    return bytesOfBoxes(whole.boxes);
  }
  // Its size is the same whatever the offsets are.
  constexpr std::size_t kHeader = 8;
  iloc->content = ilocOfItems(whole.items, bytesOfBoxes(whole.boxes).size() + kHeader, places);
  whole.boxes.push_back({"mdat", std::move(data)});
  return bytesOfBoxes(whole.boxes);
}

}  // namespace mirrorball::fuzz
