#include "mirrorball/codec/texture/zstandard.h"

#include <algorithm>
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

Result<Bytes> packZstandard(std::span<const std::uint8_t> bytes, int level, const ProgressFunction& progress) {
  // What one worker compresses at a time, and what is handed on before somebody may ask to stop: at level 19 a core
  // takes some five seconds for a job, where a library left to itself makes jobs four times as large.
  constexpr int kJob = 8 << 20;
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  const std::unique_ptr<ZSTD_CCtx, FreeContext> context(ZSTD_createCCtx());
  if (!context) return fail(ErrorCode::too_large, "not enough memory for Zstandard");
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level);
  // A library built without threads refuses these and compresses on one core. At least one worker even on one core, so
  // that the bytes are the same everywhere.
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_nbWorkers, threadLimit());
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_jobSize, kJob);
  ZSTD_CCtx_setPledgedSrcSize(context.get(), bytes.size());
  Bytes packed(ZSTD_compressBound(bytes.size()));
  ZSTD_outBuffer out{packed.data(), packed.size(), 0};
  for (std::size_t taken = 0, unwritten = 1; taken < bytes.size() || unwritten != 0;) {
    const std::span<const std::uint8_t> piece = bytes.subspan(taken, std::min(kPiece, bytes.size() - taken));
    ZSTD_inBuffer in{piece.data(), piece.size(), 0};
    const bool is_last = taken + piece.size() == bytes.size();
    unwritten = ZSTD_compressStream2(context.get(), &out, &in, is_last ? ZSTD_e_end : ZSTD_e_continue);
    if (ZSTD_isError(unwritten))
      return fail(ErrorCode::too_large, std::string("Zstandard could not compress: ") + ZSTD_getErrorName(unwritten));
    taken += in.pos;
    if (progress && !progress(taken, bytes.size()))
      return fail(ErrorCode::interrupted, "interrupted; nothing was written");
  }
  packed.resize(out.pos);
  return packed;
}

}  // namespace mirrorball
