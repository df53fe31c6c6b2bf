#include "mirrorball/codec/exr/exr_part.h"

#include <algorithm>
#include <array>
#include <exception>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/color/primaries.h"
#include "mirrorball/codec/exr/exr_stream.h"
#include "mirrorball/codec/metadata.h"

namespace mirrorball {
namespace {

/// Which channels of which part are the image.
struct Selection {
  int part = 0;
  std::string layer;                  ///< with its final dot; empty for the plain channels
  std::vector<std::string> channels;  ///< without the layer: Y; R G B; R G B A; Y A; Y RY BY
};

/// The channels `names` in `layer`, if all are there; "A" is added where there is one.
std::optional<std::vector<std::string>> channelsOf(const Imf::ChannelList& list, const std::string& layer,
                                                   std::vector<std::string> names, bool subsampled) {
  const auto usable = [&](const std::string& channel) {
    const Imf::Channel* found = list.findChannel(layer + channel);
    return found && (subsampled || (found->xSampling == 1 && found->ySampling == 1));
  };
  if (!std::all_of(names.begin(), names.end(), usable)) return {};
  if (usable("A")) names.emplace_back("A");
  return names;
}

std::optional<Selection> selectInPart(const Imf::Header& header, int part) {
  if (header.hasType() && Imf::isDeepData(header.type())) return {};
  const Imf::ChannelList& list = header.channels();
  std::vector<std::string> layers{""};
  for (auto channel = list.begin(); channel != list.end(); ++channel) {
    const std::string_view channel_name = channel.name();
    if (channel_name.ends_with(".R") || channel_name.ends_with(".Y"))
      layers.emplace_back(channel_name.substr(0, channel_name.size() - 1));
  }
  for (const std::string& layer : layers) {
    if (auto rgb = channelsOf(list, layer, {"R", "G", "B"}, false)) return Selection{part, layer, std::move(*rgb)};
    // OpenEXR's reader of luminance and chroma takes a file's first part only.
    if (part == 0)
      if (auto chroma = channelsOf(list, layer, {"Y", "RY", "BY"}, true))
        return Selection{part, layer, std::move(*chroma)};
    if (auto grey = channelsOf(list, layer, {"Y"}, false)) return Selection{part, layer, std::move(*grey)};
  }
  return {};
}

/// For the message about a file without colour.
std::string listChannels(const Imf::MultiPartInputFile& file) {
  std::string names;
  const Imf::ChannelList& list = file.header(0).channels();
  for (auto channel = list.begin(); channel != list.end(); ++channel)
    names += (names.empty() ? "" : " ") + std::string(channel.name());
  return names.empty() ? "none" : names;
}

Result<Selection> select(const Imf::MultiPartInputFile& file) {
  for (int part = 0; part < file.parts(); ++part)
    if (auto selection = selectInPart(file.header(part), part)) return std::move(*selection);
  return fail(ErrorCode::unsupported, "has no colour that can be read (its channels: " + excerpt(listChannels(file)) +
                                          "); R G B, Y, or Y RY BY are needed, and no deep data");
}

}  // namespace

Result<ExrPart> ExrPart::open(std::unique_ptr<Imf::IStream> stream) {
  useExrThreads();
  // A file whose table of offsets is unfinished is not mended: its writer did not get to the end.
  constexpr bool kMendOffsets = false;
  auto file = std::make_unique<Imf::MultiPartInputFile>(*stream, Imf::globalThreadCount(), kMendOffsets);
  MIRRORBALL_TRY(selection, select(*file));
  if (!file->partComplete(selection.part))
    return fail(ErrorCode::bad_file, "part of its texels is missing; the file was not written to its end");
  ExrPart part;
  part.stream_ = std::move(stream);
  part.file_ = std::move(file);
  part.part_ = selection.part;
  part.layer_ = std::move(selection.layer);
  part.channels_ = std::move(selection.channels);
  return part;
}

int ExrPart::width() const { return header().dataWindow().max.x - header().dataWindow().min.x + 1; }

int ExrPart::height() const { return header().dataWindow().max.y - header().dataWindow().min.y + 1; }

int ExrPart::channels() const {
  if (hasChroma()) return hasAlpha() ? 4 : 3;
  return channels_.size() == 2 ? 4 : static_cast<int>(channels_.size());
}

void ExrPart::readRows(int first, int count, float* samples) const {
  Imf::InputPart part(*file_, part_);
  Imath::Box2i rows = header().dataWindow();
  rows.min.y += first;
  rows.max.y = rows.min.y + count - 1;
  const bool grey_with_alpha = channels_.size() == 2;

  const std::size_t texel_size = sizeof(float) * std::size_t(channels());
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    const std::size_t target = grey_with_alpha && c == 1 ? 3 : c;
    frame.insert(layer_ + channels_[c],
                 Imf::Slice::Make(Imf::FLOAT, samples + target, rows, texel_size, texel_size * std::size_t(width())));
  }
  part.setFrameBuffer(frame);
  part.readPixels(rows.min.y, rows.max.y);
  if (!grey_with_alpha) return;
  const std::size_t end = std::size_t(width()) * std::size_t(count) * 4;
  for (std::size_t i = 0; i < end; i += 4) samples[i + 1] = samples[i + 2] = samples[i];
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
  const Imf::Channel* channel = header().channels().findChannel(layer_ + channels_.front());
  const char* type = channel->type == Imf::HALF ? "half" : channel->type == Imf::FLOAT ? "float" : "uint";
  const auto compression = static_cast<std::size_t>(header().compression());
  std::string text = std::string("OpenEXR, ") + type + ", " +
                     (compression < kCompressions.size() ? kCompressions[compression] : "unknown");
  if (header().hasTileDescription()) text += ", tiled";
  if (hasChroma()) text += ", luminance and chroma";
  if (!layer_.empty()) text += ", layer " + layer();
  if (part_ > 0) text += ", part " + std::to_string(part_ + 1);
  return text;
}

std::optional<Primaries> ExrPart::primaries() const {
  if (!Imf::hasChromaticities(header())) return {};
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
