#include "mirrorball/codec/exr_rows.h"

#include <algorithm>
#include <exception>
#include <new>

#include "mirrorball/codec/exr_part.h"
#include "mirrorball/codec/exr_sizes.h"
#include "mirrorball/codec/exr_stream.h"

namespace mirrorball {
namespace {

/// Room for the headers of any real file, previews included.
constexpr std::uint64_t kMostHeaderBytes = std::uint64_t{1} << 24;

/// Runs what calls OpenEXR, whose errors are exceptions.
template <typename Value, typename Work>
Result<Value> withoutExceptions(const std::string& name, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::too_large, name + ": not enough memory to decode it");
  } catch (const std::exception& exception) {
    return fail(ErrorCode::bad_file, name + ": is a damaged OpenEXR file: " + reasonOf(exception));
  }
}

class ExrRows : public RowReader {
 public:
  ExrRows(Description description, ExrPart part, std::string name)
      : RowReader(std::move(description)), part_(std::move(part)), name_(std::move(name)) {}

  Result<Image> read(int count) override {
    return withoutExceptions<Image>(name_, [&] {
      Image rows = Image::withoutValues(part_.width(), count, part_.channels());
      part_.readRows(next_, count, rows.samples().data());
      next_ += count;
      convertToRec709(rows, part_.primaries());
      return rows;
    });
  }

 private:
  ExrPart part_;
  std::string name_;
  int next_ = 0;
};

}  // namespace

Result<std::unique_ptr<RowReader>> openExrRows(FileReader file, const std::string& name) {
  Bytes begin(std::min(file.size(), kMostHeaderBytes));
  MIRRORBALL_TRY_VOID(file.readAt(0, begin));
  MIRRORBALL_TRY_VOID(checkExrSizes(begin, file.size(), name));
  return withoutExceptions<std::unique_ptr<RowReader>>(name, [&]() -> Result<std::unique_ptr<RowReader>> {
    MIRRORBALL_TRY(part, ExrPart::open(std::make_unique<ExrFileInput>(std::move(file), name), name));
    if (part.hasChroma()) return nullptr;
    RowReader::Description description{part.width(), part.height(), part.channels(), part.metadata(), part.describe()};
    return std::make_unique<ExrRows>(std::move(description), std::move(part), name);
  });
}

}  // namespace mirrorball
