#include "mirrorball/codec/exr/exr_part.h"

#include <algorithm>
#include <array>
#include <exception>
#include <string_view>

#include <Iex.h>
#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/color/primaries.h"
#include "mirrorball/codec/exr/exr_missing_rows.h"
#include "mirrorball/codec/exr/exr_stream.h"
#include "mirrorball/codec/metadata.h"
#include "mirrorball/codec/missing_rows.h"

namespace mirrorball {
namespace {

ExrPartNames readNames(const Imf::Header& header) {
  ExrPartNames names;
  if (header.hasName()) names.name = header.name();
  if (header.hasView()) names.view = header.view();
  if (Imf::hasMultiView(header)) names.views = Imf::multiView(header);
  names.is_deep = header.hasType() && Imf::isDeepData(header.type());
  const Imf::ChannelList& list = header.channels();
  for (auto channel = list.begin(); channel != list.end(); ++channel)
    names.channels.push_back({channel.name(), channel.channel().xSampling != 1 || channel.channel().ySampling != 1});
  return names;
}

}  // namespace

Result<ExrPart> ExrPart::open(std::unique_ptr<Imf::IStream> stream, std::uint64_t file_size, const std::string& layer) {
  useExrThreads();
  ExrPart part;
  part.stream_ = std::move(stream);
  part.openFile(/*finds_offsets=*/false);
  const std::uint64_t first_chunk = part.stream_->tellg();  // behind the tables of offsets
  std::vector<ExrPartNames> names;
  for (int i = 0; i < part.file_->parts(); ++i) names.push_back(readNames(part.file_->header(i)));
  part.layers_ = exrLayers(names);
  MIRRORBALL_TRY(choice, chooseExrLayer(part.layers_, layer));
  part.choice_ = std::move(choice);
  MIRRORBALL_TRY(window, exrWindow(part.header(), file_size));
  part.window_ = std::move(window);
  MIRRORBALL_TRY_VOID(part.findMissingRows(first_chunk, file_size));
  return part;
}

void ExrPart::openFile(bool finds_offsets) {
  file_.reset();
  stream_->seekg(0);
  file_ = std::make_unique<Imf::MultiPartInputFile>(*stream_, Imf::globalThreadCount(), finds_offsets);
}

bool ExrPart::isTiled() const { return isTiledPart(*file_, layer().part); }

bool ExrPart::hasLastChunk() const {
  const Imath::Box2i& data = window_.data;
  const int rows = rowsInExrChunk(*file_, layer().part);
  const int first = header().lineOrder() == Imf::DECREASING_Y ? 0 : (data.max.y - data.min.y) / rows * rows;
  const int last = std::min(first + rows - 1, data.max.y - data.min.y);
  Imf::InputPart part(*file_, layer().part);
  try {
    if (isTiled()) {
      std::vector<float> texels(std::size_t(channels()) * std::size_t(window_.dataWidth()) *
                                std::size_t(last - first + 1));
      readInto(texels.data(), {{data.min.x, data.min.y + first}, {data.max.x, data.min.y + last}});
    } else {
      const char* packed = nullptr;
      int size = 0;
      part.rawPixelData(data.min.y + first, packed, size);
    }
    return true;
  } catch (const Iex::BaseExc&) {
    return false;
  }
}

Result<void> ExrPart::findMissingRows(std::uint64_t first_chunk, std::uint64_t file_size) {
  const bool has_all_offsets = file_->partComplete(layer().part);
  // Tiles are only read decoded, as many as stand beside each other.
  const int rows = isTiled() ? rowsInExrChunk(*file_, layer().part) : 1;
  MIRRORBALL_TRY_VOID(checkImageMemory(window_.dataWidth(), rows, channels()));
  // Of tiles in no order, which lineOrder calls random, any may have been the last.
  if (has_all_offsets && header().lineOrder() != Imf::RANDOM_Y && hasLastChunk()) return {};
  is_missing_ = missingExrRows(*stream_, *file_, layer().part, first_chunk, file_size);
  // The search has moved the stream, and OpenEXR trusts that it alone does: so the file is opened anew.
  openFile(/*finds_offsets=*/!has_all_offsets);
  if (hasChroma()) {
    dropRowsWithoutChroma();
    // They are completed in memory as a whole (exr_chroma.h).
    MIRRORBALL_TRY_VOID(checkImageMemory(window_.dataWidth(), static_cast<int>(is_missing_.size()), channels()));
  }
  if (missingRows() == height())
    return fail(ErrorCode::bad_file, "none of its rows is whole; the file was not written to its end");
  return {};
}

void ExrPart::dropRowsWithoutChroma() {
  for (std::size_t row = 1; row < is_missing_.size(); row += 2)
    if (is_missing_[row - 1] != 0 && (row + 1 == is_missing_.size() || is_missing_[row + 1] != 0)) is_missing_[row] = 1;
}

bool ExrPart::isMissing(int row) const {
  const int line = window_.picture.min.y + row;
  return !is_missing_.empty() && line >= window_.data.min.y && line <= window_.data.max.y &&
         is_missing_[std::size_t(line - window_.data.min.y)] != 0;
}

int ExrPart::missingRows() const {
  int count = 0;
  for (int row = 0; !is_missing_.empty() && row < height(); ++row) count += isMissing(row) ? 1 : 0;
  return count;
}

std::string ExrPart::rowsRemark() const {
  if (is_missing_.empty()) return {};
  const bool is_from_top = header().lineOrder() != Imf::DECREASING_Y;
  std::vector<std::uint8_t> in_file;
  for (int row = 0; row < height(); ++row) in_file.push_back(isMissing(is_from_top ? row : height() - 1 - row) ? 1 : 0);
  return missingRowsRemark(in_file);
}

int ExrPart::channels() const {
  const std::size_t colors = layer().channels.size() - (layer().has_alpha ? 1 : 0);
  return colors == 1 && !layer().has_alpha ? 1 : layer().has_alpha ? 4 : 3;
}

void ExrPart::readInto(float* texels, const Imath::Box2i& rows) const {
  const std::size_t texel_size = sizeof(float) * std::size_t(channels());
  const std::size_t row_size = texel_size * std::size_t(rows.max.x - rows.min.x + 1);
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < layer().channels.size(); ++c) {
    const bool is_alpha = layer().has_alpha && c + 1 == layer().channels.size();
    frame.insert(layer().prefix + layer().channels[c],
                 Imf::Slice::Make(Imf::FLOAT, texels + (is_alpha ? 3 : c), rows, texel_size, row_size));
  }
  readFrame(frame, rows.min.y, rows.max.y);
}

void ExrPart::readFrame(const Imf::FrameBuffer& frame, int first_line, int last_line) const {
  Imf::InputPart part(*file_, layer().part);
  part.setFrameBuffer(frame);
  part.readPixels(first_line, last_line);
}

void ExrPart::readRows(int first, int count, float* samples) const {
  const std::size_t row_samples = std::size_t(channels()) * std::size_t(width());
  for (int row = first; row < first + count;) {
    const int begin = row;
    const bool is_missing = isMissing(begin);
    while (row < first + count && isMissing(row) == is_missing) ++row;
    float* const to = samples + row_samples * std::size_t(begin - first);
    if (!is_missing) {
      readWholeRows(begin, row - begin, to);
      continue;
    }
    std::fill_n(to, row_samples * std::size_t(row - begin), 0.0f);
    if (channels() == 4)  // black, and opaque
      for (std::size_t i = 3; i < row_samples * std::size_t(row - begin); i += 4) to[i] = 1.0f;
  }
}

void ExrPart::readWholeRows(int first, int count, float* samples) const {
  const auto texel_samples = static_cast<std::size_t>(channels());
  const std::size_t row_samples = texel_samples * std::size_t(width());
  // Texels outside of the data window are not in the file, and neither is the third sample of a layer of two numbers.
  if (!window_.isFull() || layer().channels.size() == 2) std::fill_n(samples, row_samples * std::size_t(count), 0.0f);
  const int top = window_.picture.min.y + first;
  Imath::Box2i rows({window_.picture.min.x, std::max(top, window_.data.min.y)},
                    {window_.picture.max.x, std::min(top + count - 1, window_.data.max.y)});
  if (rows.max.y < rows.min.y) return;
  float* const begin = samples + row_samples * std::size_t(rows.min.y - top);
  if (window_.hasOverscan()) {
    const std::size_t data_samples = texel_samples * std::size_t(window_.dataWidth());
    std::vector<float> data(data_samples * std::size_t(rows.max.y - rows.min.y + 1));
    readInto(data.data(), {{window_.data.min.x, rows.min.y}, {window_.data.max.x, rows.max.y}});
    const int left = std::max(window_.data.min.x, window_.picture.min.x);
    const int right = std::min(window_.data.max.x, window_.picture.max.x);
    for (int y = 0; y <= rows.max.y - rows.min.y; ++y)
      std::copy_n(data.data() + data_samples * std::size_t(y) + texel_samples * std::size_t(left - window_.data.min.x),
                  texel_samples * std::size_t(right - left + 1),
                  begin + row_samples * std::size_t(y) + texel_samples * std::size_t(left - window_.picture.min.x));
  } else {
    readInto(begin, rows);
  }
  if (layer().kind != ExrLayerKind::grey || !layer().has_alpha) return;
  for (std::size_t i = 0; i < row_samples * std::size_t(count); i += 4) samples[i + 1] = samples[i + 2] = samples[i];
}

Metadata ExrPart::metadata() const {
  const Imf::Header& header = this->header();
  Metadata metadata;
  for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
    const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute());
    if (text && isMetadataKey(attribute.name())) metadata[attribute.name()] = text->value();
  }
  if (Imf::hasEnvmap(header)) {
    if (Imf::envmap(header) == Imf::ENVMAP_LATLONG) metadata["envmap"] = "latlong";
    if (Imf::envmap(header) == Imf::ENVMAP_CUBE) metadata["envmap"] = "cube";
  }
  return metadata;
}

std::string ExrPart::describe() const {
  constexpr std::array<const char*, 10> kCompressions{"uncompressed", "RLE", "ZIPS", "ZIP",  "PIZ",
                                                      "PXR24",        "B44", "B44A", "DWAA", "DWAB"};
  const Imf::Channel* channel = header().channels().findChannel(layer().prefix + layer().channels.front());
  const char* type = channel->type == Imf::HALF ? "half" : channel->type == Imf::FLOAT ? "float" : "uint";
  const auto compression = static_cast<std::size_t>(header().compression());
  std::string text = std::string("OpenEXR, ") + type + ", " +
                     (compression < kCompressions.size() ? kCompressions[compression] : "unknown");
  if (isTiled()) text += ", tiled";
  if (hasChroma()) text += ", luminance and chroma";
  if (!layer().is_plain || layer().kind == ExrLayerKind::numbers) text += ", layer " + printable(layer().name);
  if (layer().part > 0) text += ", part " + std::to_string(layer().part + 1);
  return text;
}

std::optional<Primaries> ExrPart::primaries() const {
  if (!Imf::hasChromaticities(header()) || layer().kind == ExrLayerKind::numbers) return {};
  const Imf::Chromaticities& given = Imf::chromaticities(header());
  const auto xy = [](const Imath::V2f& point) { return glm::dvec2(point.x, point.y); };
  return Primaries{xy(given.red), xy(given.green), xy(given.blue), xy(given.white)};
}

std::string reasonOf(const std::exception& exception) {
  // 'Cannot read image file "". Unknown compression type in image header.': our streams have no name.
  constexpr std::string_view kUnnamed = "\"\". ";
  constexpr std::size_t kLongestReason = 200;
  const std::string text = exception.what();
  const std::size_t at = text.rfind(kUnnamed);
  return excerpt(at == std::string::npos ? text : text.substr(at + kUnnamed.size()), kLongestReason);
}

}  // namespace mirrorball
