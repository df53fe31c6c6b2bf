// Reading by rows: the same bytes, in a file, must give the rows of the whole image or be refused like it.

#include <algorithm>
#include <cstring>

#include <sys/mman.h>
#include <unistd.h>

#include "fuzz.h"
#include "mirrorball/codec/hdr/hdr.h"
#include "mirrorball/codec/row_reader.h"

namespace {

using namespace mirrorball;

/// Few at a time, and more of the empty pictures that a display window can be.
constexpr int kFewRows = 3;
constexpr int kMostReads = 1000;

/// A file in memory, which the row readers need one to be.
class MemoryFile {
 public:
  explicit MemoryFile(std::span<const std::uint8_t> bytes) : descriptor_(::memfd_create("rows", MFD_CLOEXEC)) {
    if (descriptor_ < 0 || ::write(descriptor_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
      std::abort();
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { ::close(descriptor_); }

  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

/// Rows [first, first + part.height()) of the whole image are those bits. OpenEXR may leave texels of damaged blocks as
/// its memory held them (README.md), so only Radiance pictures are compared.
bool isPartOf(const Image& part, const Image& whole, int first) {
  return std::memcmp(part.samples().data(), whole.texel(0, first), part.samples().size_bytes()) == 0;
}

}  // namespace

MIRRORBALL_HARNESS(rows) {
  const std::span<const std::uint8_t> bytes(data, size);
  const MemoryFile file(bytes);
  const auto rows = openRows(file.path());
  fuzz::checkError(rows, file.path());
  if (!rows || !*rows) return 0;
  const auto whole = isHdr(bytes) ? decodeImage(bytes) : Result<DecodedImage>(DecodedImage{});
  const int height = (*rows)->description().height;
  const int rows_per_read = std::max(kFewRows, height / kMostReads);
  for (int first = 0; first < height; first += rows_per_read) {
    const auto part = (*rows)->read(std::min(rows_per_read, height - first));
    fuzz::checkError(part, file.path());
    if (!part) {
      if (isHdr(bytes) && whole) std::abort();  // only read as a whole it is sound
      return 0;
    }
    if (whole && !whole->image.empty() && !isPartOf(*part, whole->image, first)) std::abort();
  }
  if (!whole) std::abort();  // only read by rows it is sound
  return 0;
}
