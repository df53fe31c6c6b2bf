#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// An image that is read from its file some rows at a time, from the top down, so that it is never in memory as a
/// whole.
class RowReader {
 public:
  /// What is known before any texel is read.
  struct Description {
    std::string name;  ///< the file's
    int width = 0;
    int height = 0;
    int channels = 3;
    Metadata metadata = {};
    std::optional<PictureWindow> window = {};  ///< this and the rest as in DecodedImage
    std::vector<PictureLayer> layers = {};
    std::string layer = {};
    std::string layer_guess = {};
    std::vector<std::string> oddities = {};
  };

  virtual ~RowReader() = default;

  const Description& description() const { return description_; }

  /// Finds what of the file is missing, where its header does not show it, and adds that to the description's oddities.
  /// The first read() does it too.
  ///
  /// errors   io; bad_file; too_large
  /// cost     of Radiance HDR: reads the whole file
  Result<void> survey();

  /// Goes to a row, at which the next read() begins.
  void goTo(int row) { next_row_ = row; }

  /// Reads the next rows: linear light, Rec.709, as readImage gives it.
  ///
  /// count    at most as many as are left
  /// errors   as survey's
  /// cost     as readImage's, on all cores; memory for those rows, and their bytes in the file
  Result<Image> read(int count);

 protected:
  explicit RowReader(Description description) : description_(std::move(description)) {}

 private:
  virtual Result<void> surveyFile(std::vector<std::string>& /*oddities*/) { return {}; }
  virtual Result<Image> readRows(int first, int count) = 0;

  Description description_;
  bool is_surveyed_ = false;
  int next_row_ = 0;
};

/// Opens a .exr or .hdr for reading by rows.
///
/// options  of which the layer counts
/// returns  nullptr if that is not possible and readImage is needed: other formats, luminance and chroma, Radiance
///          pictures whose lines do not run from the top down and from left to right
/// errors   not_found (also no layer of that name; lists them); io; bad_file; too_large; unsupported
Result<std::unique_ptr<RowReader>> openRows(const std::filesystem::path& path, const ImageReadOptions& options = {});

}  // namespace mirrorball
