#include "mirrorball/codec/exr/exr_chroma.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <half.h>

#include "mirrorball/codec/exr/exr_stream.h"
#include "mirrorball/codec/missing_rows.h"

namespace mirrorball {
namespace {

/// The samples of one channel in all rows of the data window that have some.
class ChannelPlane {
 public:
  ChannelPlane(const Imath::Box2i& window, int sampling)
      : window_(window),
        sampling_(sampling),
        row_samples_(std::size_t((window.max.x - window.min.x + 1) / sampling)),
        samples_(row_samples_ * std::size_t((window.max.y - window.min.y + 1) / sampling)) {}

  int sampling() const { return sampling_; }

  Imf::Slice slice() const {
    return Imf::Slice::Make(Imf::HALF, samples_.data(), window_, /*xStride=*/0, /*yStride=*/0, sampling_, sampling_);
  }

  /// Copies to each row that is missing the nearest one that is not.
  ///
  /// is_missing   for each row of the data window
  void fillMissing(std::span<const std::uint8_t> is_missing) {
    const auto rows = static_cast<int>(samples_.size() / row_samples_);
    const auto isThere = [&](int row) { return is_missing[std::size_t(row) * std::size_t(sampling_)] == 0; };
    int above = -1;  // the last that is there
    int below = 0;   // the next
    for (int row = 0; row < rows; ++row) {
      if (isThere(row)) above = row;
      while (below < rows && (below < row || !isThere(below))) ++below;
      if (isThere(row) || (above < 0 && below == rows)) continue;
      const int from = above < 0 || (below < rows && below - row < row - above) ? below : above;
      std::copy_n(samples_.begin() + std::ptrdiff_t(row_samples_) * from, row_samples_,
                  samples_.begin() + std::ptrdiff_t(row_samples_) * row);
    }
  }

 private:
  Imath::Box2i window_;
  int sampling_;
  std::size_t row_samples_;
  std::vector<half> samples_;
};

/// A file of the same picture that has all rows, for a filter that reads those around each.
Bytes completedFile(const ExrPart& part) {
  const std::span<const std::uint8_t> is_missing = part.missingDataRows();
  const Imath::Box2i& window = part.window().data;
  std::deque<ChannelPlane> planes;
  Imf::FrameBuffer from_file;
  for (const std::string& name : part.layer().channels) {
    const ChannelPlane& plane = planes.emplace_back(window, name == "RY" || name == "BY" ? 2 : 1);
    from_file.insert(part.layer().prefix + name, plane.slice());
  }
  for (std::size_t row = 0; row < is_missing.size();) {
    const std::size_t begin = row;
    while (row < is_missing.size() && is_missing[row] == is_missing[begin]) ++row;
    if (is_missing[begin] == 0)
      part.readFrame(from_file, window.min.y + static_cast<int>(begin), window.min.y + static_cast<int>(row) - 1);
  }
  Imf::Header header(part.window().picture, window);
  header.compression() = Imf::NO_COMPRESSION;
  if (Imf::hasChromaticities(part.header())) Imf::addChromaticities(header, Imf::chromaticities(part.header()));
  Imf::FrameBuffer to_file;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    planes[i].fillMissing(is_missing);
    const int sampling = planes[i].sampling();
    header.channels().insert(part.layer().channels[i], Imf::Channel(Imf::HALF, sampling, sampling));
    to_file.insert(part.layer().channels[i], planes[i].slice());
  }
  ExrOutput stream;
  {
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(to_file);
    file.writePixels(window.max.y - window.min.y + 1);
  }
  return stream.takeBytes();
}

void readFiltered(Imf::RgbaInputFile& file, const ExrPart& part, Image& image) {
  const std::span<const std::uint8_t> is_missing = part.missingDataRows();
  const Imath::Box2i& data = part.window().data;
  const Imath::Box2i& picture = part.window().picture;
  const int left = std::max(data.min.x, picture.min.x);
  const int right = std::min(data.max.x, picture.max.x);

  std::vector<Imf::Rgba> row(std::size_t(part.window().dataWidth()));
  for (int line = std::max(data.min.y, picture.min.y); line <= std::min(data.max.y, picture.max.y); ++line) {
    if (!is_missing.empty() && is_missing[std::size_t(line - data.min.y)] != 0) {
      blackenRow(image, line - picture.min.y);
      continue;
    }
    // The frame's base is where texel (0, 0) would be; this slice's arithmetic avoids a pointer
    // outside the row.
    const Imf::Slice slice = Imf::Slice::Make(Imf::HALF, row.data(),
                                              Imath::Box2i({data.min.x, line}, {data.max.x, line}), sizeof(Imf::Rgba));
    file.setFrameBuffer(reinterpret_cast<Imf::Rgba*>(slice.base), 1, row.size());
    file.readPixels(line);
    for (int x = left; x <= right; ++x) {
      const Imf::Rgba& from = row[std::size_t(x - data.min.x)];
      float* to = image.texel(x - picture.min.x, line - picture.min.y);
      to[0] = from.r;
      to[1] = from.g;
      to[2] = from.b;
      if (part.layer().has_alpha) to[3] = from.a;
    }
  }
}

}  // namespace

void readExrChroma(std::span<const std::uint8_t> bytes, const ExrPart& part, Image& image) {
  const bool is_whole = part.missingDataRows().empty();
  const Bytes completed = is_whole ? Bytes{} : completedFile(part);
  ExrInput stream(is_whole ? bytes : completed);
  const std::string prefix = is_whole ? part.layer().prefix : "";
  Imf::RgbaInputFile file(stream, prefix.substr(0, prefix.find_last_of('.')));
  readFiltered(file, part, image);
}

}  // namespace mirrorball
