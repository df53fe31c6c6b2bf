#include "mirrorball/codec/exr/exr.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <half.h>

#include "mirrorball/base/parallel.h"
#include "mirrorball/codec/exr/exr_chroma.h"
#include "mirrorball/codec/exr/exr_part.h"
#include "mirrorball/codec/exr/exr_rows.h"
#include "mirrorball/codec/exr/exr_sizes.h"
#include "mirrorball/codec/exr/exr_stream.h"

namespace mirrorball {
namespace {

/// All rows, in blocks between which the progress is reported; no compression packs more rows together.
Result<void> readRows(const ExrPart& part, const ProgressFunction& progress, Image& image) {
  constexpr int kRowsOfBlock = 256;
  ProgressCounter rows(progress, std::size_t(part.height()));
  for (int first = 0; first < part.height() && !rows.stopped(); first += kRowsOfBlock) {
    const int count = std::min(kRowsOfBlock, part.height() - first);
    part.readRows(first, count, image.row(first).data());
    rows.advance(std::size_t(count));
  }
  return rows.result();
}

Result<DecodedImage> decode(std::span<const std::uint8_t> bytes, const ImageReadOptions& options) {
  MIRRORBALL_TRY_VOID(checkExrSizes(bytes, bytes.size()));
  MIRRORBALL_TRY(part, ExrPart::open(std::make_unique<ExrInput>(bytes), bytes.size(), options.layer));
  MIRRORBALL_TRY_VOID(checkImageMemory(part.width(), part.height(), part.channels()));
  DecodedImage decoded;
  if (part.hasChroma()) {
    decoded.image = Image(part.width(), part.height(), part.channels());
    readExrChroma(bytes, part, decoded.image);
  } else {
    decoded.image = Image::withoutValues(part.width(), part.height(), part.channels());
    MIRRORBALL_TRY_VOID(readRows(part, options.progress, decoded.image));
  }
  const CodedColor color{.transfer = Transfer::linear, .primaries = part.primaries()};
  decoded.metadata = part.metadata();
  decoded.format = part.describe();
  part.tell(decoded);
  if (options.as == ReadAs::light) {
    decoded.is_converted = convertToRec709(decoded.image, color.primaries);
    decoded.color = describeColor(color, decoded.image.channels());
  } else {
    tellUnapplied(statedSpace(color, decoded.image.channels()), decoded.oddities);
    decoded.color = kAsStored;
  }
  return decoded;
}

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

Imf::Chromaticities chromaticitiesIn(const Primaries& primaries) {
  const auto point = [](glm::dvec2 xy) { return Imath::V2f(float(xy.x), float(xy.y)); };
  return {point(primaries.red), point(primaries.green), point(primaries.blue), point(primaries.white)};
}

Imf::Header headerFor(const Image& image, const ImageWriteOptions& options) {
  Imf::Header header(image.width(), image.height());
  header.compression() = Imf::ZIP_COMPRESSION;
  // Those of Rec.709 too: they are what a file without them means, but not all readers know.
  if (image.channels() >= 3) Imf::addChromaticities(header, chromaticitiesIn(chromaticitiesOf(options.primaries)));
  for (const auto& [key, value] : options.metadata) {
    if (key == "envmap")
      Imf::addEnvmap(header, value == "cube" ? Imf::ENVMAP_CUBE : Imf::ENVMAP_LATLONG);
    else
      header.insert(key, Imf::StringAttribute(value));
  }
  return header;
}

/// The samples of images in the type of a file, while it is written.
class ChannelWriter {
 public:
  ChannelWriter(Imf::Header& header, bool is_half) : header_(header), is_half_(is_half) {}

  /// Adds an image's channels.
  ///
  /// prefix   "albedo." or nothing
  /// letters  of each channel
  void add(const Image& image, const std::string& prefix, std::string_view letters) {
    const Imf::PixelType type = is_half_ ? Imf::HALF : Imf::FLOAT;
    const std::size_t sample_size = is_half_ ? sizeof(half) : sizeof(float);
    const void* samples =
        is_half_ ? static_cast<const void*>(halves_.emplace_back(halvesOf(image)).data()) : image.samples().data();
    const std::size_t texel_size = sample_size * std::size_t(image.channels());
    for (std::size_t c = 0; c < letters.size(); ++c) {
      const std::string channel = prefix + letters[c];
      header_.channels().insert(channel, Imf::Channel(type));
      frame_.insert(channel,
                    Imf::Slice::Make(type, static_cast<const char*>(samples) + c * sample_size, header_.dataWindow(),
                                     texel_size, texel_size * std::size_t(image.width())));
    }
  }

  const Imf::FrameBuffer& frame() const { return frame_; }

 private:
  Imf::Header& header_;
  bool is_half_;
  Imf::FrameBuffer frame_;
  std::deque<std::vector<half>> halves_;
};

Bytes encode(const Image& image, const ImageWriteOptions& options) {
  Imf::Header header = headerFor(image, options);
  ChannelWriter channels(header, options.half);
  channels.add(image, "",
               image.channels() == 1 ? "Y" : std::string_view("RGBA").substr(0, std::size_t(image.channels())));
  for (const ImageLayer& layer : options.layers) channels.add(layer.image, layer.name + ".", layer.channels);
  ExrOutput stream;
  {
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(channels.frame());
    file.writePixels(image.height());
  }  // which writes the table of offsets
  return stream.takeBytes();
}

}  // namespace

Result<DecodedImage> decodeExr(std::span<const std::uint8_t> bytes, const ImageReadOptions& options) {
  return decodingExr<DecodedImage>([&] { return decode(bytes, options); });
}

Result<Bytes> encodeExr(const Image& image, const ImageWriteOptions& options) {
  try {
    useExrThreads();
    return encode(image, options);
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::too_large, "not enough memory to encode it");
  } catch (const std::exception& exception) {
    return fail(ErrorCode::io, "cannot be encoded as OpenEXR: " + reasonOf(exception));
  }
}

FormatCodec exrCodec() { return {.decode = decodeExr, .open_rows = openExrRows, .encode = encodeExr}; }

}  // namespace mirrorball
