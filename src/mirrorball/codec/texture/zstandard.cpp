#include "mirrorball/codec/texture/zstandard.h"

#include <memory>
#include <string>

#include <zstd.h>

#include "mirrorball/base/parallel.h"
#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

struct FreeContext {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
};

}  // namespace

Result<void> checkZstandard() { return {}; }

Result<void> unpackZstandard(std::span<const std::uint8_t> packed, std::span<std::uint8_t> to) {
  const std::size_t count = ZSTD_decompress(to.data(), to.size(), packed.data(), packed.size());
  if (ZSTD_isError(count))
    return fail(ErrorCode::bad_file, std::string("is not sound Zstandard data: ") + ZSTD_getErrorName(count));
  if (count != to.size())
    return fail(ErrorCode::bad_file, "unpacks to " + counted(count, "byte") + " instead of " +
                                         std::to_string(to.size()) + "; the file is damaged");
  return {};
}

Result<Bytes> packZstandard(std::span<const std::uint8_t> bytes, int level) {
  const std::unique_ptr<ZSTD_CCtx, FreeContext> context(ZSTD_createCCtx());
  if (!context) return fail(ErrorCode::too_large, "not enough memory for Zstandard");
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level);
  // A library built without threads refuses this and compresses on one core. At least one worker even on one core, so
  // that the bytes are the same everywhere.
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_nbWorkers, threadLimit());
  Bytes packed(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress2(context.get(), packed.data(), packed.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(size))
    return fail(ErrorCode::too_large, std::string("Zstandard could not compress: ") + ZSTD_getErrorName(size));
  packed.resize(size);
  return packed;
}

}  // namespace mirrorball
