#include "mirrorball/codec/exr.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <mutex>
#include <new>
#include <optional>
#include <string_view>
#include <thread>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfOutputFile.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <half.h>

#include "mirrorball/base/parallel.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/exr_sizes.h"
#include "mirrorball/codec/exr_stream.h"
#include "mirrorball/codec/metadata.h"
#include "mirrorball/codec/primaries.h"

namespace mirrorball {
namespace {

/// Which channels of which part are the image.
struct Selection {
  int part = 0;
  std::string layer;                  ///< with its final dot; empty for the plain channels
  std::vector<std::string> channels;  ///< without the layer: Y; R G B; R G B A; Y A; Y RY BY
  bool hasChroma() const { return channels.size() >= 3 && channels[1] == "RY"; }
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

Result<Selection> select(const Imf::MultiPartInputFile& file, const std::string& name) {
  for (int part = 0; part < file.parts(); ++part)
    if (auto selection = selectInPart(file.header(part), part)) return std::move(*selection);
  return fail(ErrorCode::unsupported,
              name + ": has no colour that can be read (its channels: " + printable(listChannels(file)) +
                  "); R G B, Y, or Y RY BY are needed, and no deep data");
}

Image imageFor(const Imath::Box2i& window, int channels) {
  return Image::withoutValues(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, channels);
}

/// Reads Y, R G B or R G B A straight into the image. Y with A has no form of its own there: it
/// becomes R G B A.
Image readPlain(Imf::MultiPartInputFile& file, const Selection& selection) {
  Imf::InputPart part(file, selection.part);
  const Imath::Box2i window = part.header().dataWindow();
  const bool grey_with_alpha = selection.channels.size() == 2;
  Image image = imageFor(window, grey_with_alpha ? 4 : static_cast<int>(selection.channels.size()));

  const std::size_t texel_size = sizeof(float) * std::size_t(image.channels());
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < selection.channels.size(); ++c) {
    const std::size_t target = grey_with_alpha && c == 1 ? 3 : c;
    frame.insert(selection.layer + selection.channels[c],
                 Imf::Slice::Make(Imf::FLOAT, image.samples().data() + target, window, texel_size,
                                  texel_size * std::size_t(image.width())));
  }
  part.setFrameBuffer(frame);
  part.readPixels(window.min.y, window.max.y);
  if (grey_with_alpha)
    for (std::size_t i = 0; i < image.samples().size(); i += 4)
      image.samples()[i + 1] = image.samples()[i + 2] = image.samples()[i];
  return image;
}

/// Reads luminance and subsampled chroma through OpenEXR's own reconstruction filter, which works
/// in half floats.
Image readChroma(std::span<const std::uint8_t> bytes, const std::string& name, const Selection& selection) {
  ExrInput stream(bytes, name);
  const std::string layer = selection.layer.substr(0, selection.layer.find_last_of('.'));
  Imf::RgbaInputFile file(stream, layer);
  const Imath::Box2i window = file.dataWindow();
  const bool has_alpha = selection.channels.back() == "A";
  Image image = imageFor(window, has_alpha ? 4 : 3);

  std::vector<Imf::Rgba> row(std::size_t(image.width()));
  for (int y = 0; y < image.height(); ++y) {
    const int line = window.min.y + y;
    // The frame's base is where texel (0, 0) would be; this slice's arithmetic avoids a pointer
    // outside the row.
    const Imf::Slice slice =
        Imf::Slice::Make(Imf::HALF, row.data(), Imath::Box2i({window.min.x, line}, {window.max.x, line}),
                         sizeof(Imf::Rgba), sizeof(Imf::Rgba) * row.size());
    file.setFrameBuffer(reinterpret_cast<Imf::Rgba*>(slice.base), 1, row.size());
    file.readPixels(line);
    for (int x = 0; x < image.width(); ++x) {
      const Imf::Rgba& from = row[std::size_t(x)];
      float* to = image.texel(x, y);
      to[0] = from.r;
      to[1] = from.g;
      to[2] = from.b;
      if (has_alpha) to[3] = from.a;
    }
  }
  return image;
}

Metadata readMetadata(const Imf::Header& header) {
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

std::optional<Primaries> statedPrimaries(const Imf::Header& header) {
  if (!Imf::hasChromaticities(header)) return {};
  const Imf::Chromaticities& given = Imf::chromaticities(header);
  const auto xy = [](const Imath::V2f& point) { return glm::dvec2(point.x, point.y); };
  return Primaries{xy(given.red), xy(given.green), xy(given.blue), xy(given.white)};
}

/// "OpenEXR, half, DWAB"
std::string describe(const Imf::Header& header, const Selection& selection) {
  constexpr std::array<const char*, 10> kCompressions{"uncompressed", "RLE", "ZIPS", "ZIP",  "PIZ",
                                                      "PXR24",        "B44", "B44A", "DWAA", "DWAB"};
  const Imf::Channel* channel = header.channels().findChannel(selection.layer + selection.channels.front());
  const char* type = channel->type == Imf::HALF ? "half" : channel->type == Imf::FLOAT ? "float" : "uint";
  const auto compression = static_cast<std::size_t>(header.compression());
  std::string text = std::string("OpenEXR, ") + type + ", " +
                     (compression < kCompressions.size() ? kCompressions[compression] : "unknown");
  if (header.hasTileDescription()) text += ", tiled";
  if (selection.hasChroma()) text += ", luminance and chroma";
  if (!selection.layer.empty()) text += ", layer " + selection.layer.substr(0, selection.layer.size() - 1);
  if (selection.part > 0) text += ", part " + std::to_string(selection.part + 1);
  return text;
}

/// OpenEXR begins without threads. With two, ZIP is written in 0.6 and read in half of the time.
void useThreads() {
  static std::once_flag once;
  std::call_once(once, [] {
    constexpr unsigned kMostThreads = 16;  // each takes the memory of two chunks
    if (Imf::globalThreadCount() == 0)
      Imf::setGlobalThreadCount(static_cast<int>(std::min(std::thread::hardware_concurrency(), kMostThreads)));
  });
}

Result<DecodedImage> decode(std::span<const std::uint8_t> bytes, const std::string& name) {
  MIRRORBALL_TRY_VOID(checkExrSizes(bytes, name));
  ExrInput stream(bytes, name);
  // A file whose table of offsets is unfinished is not mended: its writer did not get to the end.
  constexpr bool kMendOffsets = false;
  Imf::MultiPartInputFile file(stream, Imf::globalThreadCount(), kMendOffsets);
  MIRRORBALL_TRY(selection, select(file, name));
  const Imf::Header& header = file.header(selection.part);
  if (!file.partComplete(selection.part))
    return fail(ErrorCode::bad_file,
                name + ": part of its texels is missing; the file was not " + "written to its end");

  DecodedImage decoded;
  decoded.image = selection.hasChroma() ? readChroma(bytes, name, selection) : readPlain(file, selection);
  const std::optional<Primaries> stated = statedPrimaries(header);
  convertToRec709(decoded.image, stated);
  decoded.metadata = readMetadata(header);
  decoded.format = describe(header, selection);
  decoded.color = describeColor(kLinearLight, stated, decoded.image.channels());
  return decoded;
}

/// One line of an exception's text.
std::string reasonOf(const std::exception& exception) { return printable(exception.what()); }

half halfOf(float value) {
  if (std::isfinite(value)) value = std::clamp(value, -float{HALF_MAX}, float{HALF_MAX});
  return half(value);
}

std::vector<half> halvesOf(const Image& image) {
  constexpr std::size_t kSamplesPerPiece = 1 << 16;
  std::vector<half> halves(image.samples().size());
  parallelFor(halves.size(), kSamplesPerPiece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) halves[i] = halfOf(image.samples()[i]);
  });
  return halves;
}

Imf::Header headerFor(const Image& image, const Metadata& metadata) {
  Imf::Header header(image.width(), image.height());
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [key, value] : metadata) {
    if (key == "envmap")
      Imf::addEnvmap(header, value == "cube" ? Imf::ENVMAP_CUBE : Imf::ENVMAP_LATLONG);
    else
      header.insert(key, Imf::StringAttribute(value));
  }
  return header;
}

/// samples  interleaved, of the type that `type` says
Bytes encode(const Image& image, const void* samples, Imf::PixelType type, std::size_t sample_size,
             const Metadata& metadata, const std::string& name) {
  constexpr std::array<const char*, 4> kColors{"R", "G", "B", "A"};
  Imf::Header header = headerFor(image, metadata);
  Imf::FrameBuffer frame;
  const std::size_t texel_size = sample_size * std::size_t(image.channels());
  for (int c = 0; c < image.channels(); ++c) {
    const char* channel = image.channels() == 1 ? "Y" : kColors[std::size_t(c)];
    header.channels().insert(channel, Imf::Channel(type));
    const char* first = static_cast<const char*>(samples) + std::size_t(c) * sample_size;
    frame.insert(channel, Imf::Slice::Make(type, first, header.dataWindow(), texel_size,
                                           texel_size * std::size_t(image.width())));
  }
  ExrOutput stream(name);
  {
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(frame);
    file.writePixels(image.height());
  }  // which writes the table of offsets
  return stream.takeBytes();
}

}  // namespace

bool isExr(std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::uint8_t, 4> kMagic{0x76, 0x2f, 0x31, 0x01};
  return bytes.size() >= kMagic.size() && std::equal(kMagic.begin(), kMagic.end(), bytes.begin());
}

Result<DecodedImage> decodeExr(std::span<const std::uint8_t> bytes, const std::string& name) {
  try {
    useThreads();
    return decode(bytes, name);
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::too_large, name + ": not enough memory to decode it");
  } catch (const std::exception& exception) {
    return fail(ErrorCode::bad_file, name + ": is a damaged OpenEXR file: " + reasonOf(exception));
  }
}

Result<Bytes> encodeExr(const Image& image, const ImageWriteOptions& options, const std::string& name) {
  try {
    useThreads();
    if (options.half) return encode(image, halvesOf(image).data(), Imf::HALF, sizeof(half), options.metadata, name);
    return encode(image, image.samples().data(), Imf::FLOAT, sizeof(float), options.metadata, name);
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::too_large, name + ": not enough memory to encode it");
  } catch (const std::exception& exception) {
    return fail(ErrorCode::io, name + ": cannot be encoded as OpenEXR: " + reasonOf(exception));
  }
}

}  // namespace mirrorball
