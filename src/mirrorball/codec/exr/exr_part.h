#pragma once

#include <cstdint>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include <ImfIO.h>
#include <ImfMultiPartInputFile.h>

#include "mirrorball/base/result.h"
#include "mirrorball/codec/color/primaries.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// The channels of an OpenEXR file that are its image: those of the first part that has colour, R G B (A), else
/// luminance and chroma, else Y; in no layer or in the first that has them.
class ExrPart {
 public:
  /// Opens a file whose sizes have been checked (checkExrSizes). Errors in its structure throw, as OpenEXR does.
  ///
  /// errors   unsupported (no colour); bad_file (part of the texels is missing)
  static Result<ExrPart> open(std::unique_ptr<Imf::IStream> stream);

  int width() const;
  int height() const;
  /// 1, 3 or 4; Y with A becomes 4.
  int channels() const;
  /// Luminance and subsampled chroma, which `readRows` does not read.
  bool hasChroma() const { return channels_.size() >= 3 && channels_[1] == "RY"; }
  bool hasAlpha() const { return channels_.back() == "A"; }
  /// The layer's name, without a dot; empty for the plain channels.
  std::string layer() const { return layer_.substr(0, layer_.find_last_of('.')); }
  const Imf::Header& header() const { return file_->header(part_); }

  Metadata metadata() const;
  /// What the file states of its colour, if anything.
  std::optional<Primaries> primaries() const;
  /// "OpenEXR, half, DWAB"
  std::string describe() const;

  /// Reads rows as floats, alpha premultiplied, primaries as the file has them. Throws, as OpenEXR does.
  ///
  /// samples  of `count` rows, `channels()` a texel
  void readRows(int first, int count, float* samples) const;

 private:
  std::unique_ptr<Imf::IStream> stream_;
  std::unique_ptr<Imf::MultiPartInputFile> file_;
  int part_ = 0;
  std::string layer_;                  // with its final dot
  std::vector<std::string> channels_;  // without the layer: Y; R G B; R G B A; Y A; Y RY BY
};

/// What OpenEXR says is wrong, in one line.
std::string reasonOf(const std::exception& exception);

/// Runs what reads through OpenEXR, whose errors are exceptions.
///
/// errors   too_large (memory); bad_file; else what `work` returns
template <typename Value, typename Work>
Result<Value> decodingExr(const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::too_large, "not enough memory to decode it");
  } catch (const std::exception& exception) {
    return fail(ErrorCode::bad_file, "is a damaged OpenEXR file: " + reasonOf(exception));
  }
}

}  // namespace mirrorball
