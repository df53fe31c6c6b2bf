#include "mirrorball/codec/exr/exr_rows.h"

#include <algorithm>

#include "mirrorball/codec/exr/exr_part.h"
#include "mirrorball/codec/exr/exr_sizes.h"
#include "mirrorball/codec/exr/exr_stream.h"

namespace mirrorball {
namespace {

/// Room for the headers of nearly all files, and of any real one, previews included.
constexpr std::uint64_t kUsualHeaderBytes = std::uint64_t{1} << 16;
constexpr std::uint64_t kMaxHeaderBytes = std::uint64_t{1} << 24;

/// checkExrSizes for what a file begins with.
Result<void> checkBeginning(const FileReader& file, std::uint64_t max_bytes) {
  Bytes begin(std::min(file.size(), max_bytes));
  MIRRORBALL_TRY_VOID(file.readAt(0, begin));
  return checkExrSizes(begin, file.size());
}

class ExrRows : public RowReader {
 public:
  ExrRows(Description description, ExrPart part) : RowReader(std::move(description)), part_(std::move(part)) {}

 private:
  Result<Image> readRows(int first, int count) override {
    return decodingExr<Image>([&] {
      Image rows = Image::withoutValues(part_.width(), count, part_.channels());
      part_.readRows(first, count, rows.samples().data());
      convertToRec709(rows, part_.primaries());
      return rows;
    });
  }

  ExrPart part_;
};

}  // namespace

Result<std::unique_ptr<RowReader>> openExrRows(FileReader file, const ImageReadOptions& options) {
  // Headers that are longer than usual seem to end early.
  if (!checkBeginning(file, kUsualHeaderBytes)) MIRRORBALL_TRY_VOID(checkBeginning(file, kMaxHeaderBytes));
  return decodingExr<std::unique_ptr<RowReader>>([&]() -> Result<std::unique_ptr<RowReader>> {
    const std::string name = file.name();
    const std::uint64_t size = file.size();
    MIRRORBALL_TRY(part, ExrPart::open(std::make_unique<ExrFileInput>(std::move(file)), size, options.layer));
    if (part.hasChroma()) return nullptr;
    RowReader::Description description{name, part.width(), part.height(), part.channels(), part.metadata()};
    part.tell(description);
    return std::make_unique<ExrRows>(std::move(description), std::move(part));
  });
}

}  // namespace mirrorball
