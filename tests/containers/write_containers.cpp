// usage: write_containers FOLDER
//
// Writes textures of every format, and files.json, which says what must be found in them.

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <random>
#include <string>

#include "mirrorball/codec/texture/stored_format.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/codec/texture/texture_testing.h"
#include "mirrorball/codec/uastc_hdr/uastc_hdr_block.h"
#include "mirrorball/codec/uastc_hdr/uastc_hdr_levels.h"
#include "mirrorball/image/small_float.h"

namespace {

using namespace mirrorball;

struct File {
  std::string name;
  const char* format;
  ImageSet images;
  TextureWriteOptions options;
  Bytes blocks = {};  ///< that take the place of the images' where there are some
};

/// Every texel as red, green, blue and alpha, by level, layer, face and row.
std::string texelList(const ImageSet& images) {
  std::string list;
  forEachImage(images, [&](const Image& image) {
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const glm::vec4 texel = rgbaAt(image, x, y);
        for (int c = 0; c < 4; ++c) list += (list.empty() ? "" : ",") + std::to_string(texel[c]);
      }
  });
  return list;
}

std::size_t sizeOfBlocks(const Image& image) {
  return std::size_t((image.width() + 3) / 4) * std::size_t((image.height() + 3) / 4) * 16;
}

/// The bytes of every block, by level, layer, face and row of blocks. Which texels those of BC6H stand for is another
/// matter, which bc6h_parity_test holds to a driver.
Bytes blocksOf(const File& file) {
  if (!file.blocks.empty()) return file.blocks;
  Bytes all;
  forEachImage(file.images, [&](const Image& image) {
    Bytes blocks(sizeOfBlocks(image));
    packTexels(file.options.format, image.samples(), image.channels(), image.width(), blocks);
    all.insert(all.end(), blocks.begin(), blocks.end());
  });
  return all;
}

template <typename Numbers>
std::string numberList(const Numbers& numbers) {
  std::string list;
  for (const auto number : numbers) list += (list.empty() ? "" : ",") + std::to_string(number);
  return list;
}

/// The red, green and blue of every texel that our decoder makes of blocks, as the bits of half floats.
std::string decodedHalves(const File& file) {
  const Bytes blocks = blocksOf(file);
  std::vector<std::uint16_t> all;
  std::size_t at = 0;
  forEachImage(file.images, [&](const Image& image) {
    const StoredFormat format = storedFormat(file.options.format);
    const std::size_t row = std::size_t((image.width() + 3) / 4) * 16;
    const auto decoded = unpackTexels(format, blocks.data() + at, row, image.width(), image.height());
    std::vector<std::uint16_t> halves(decoded->samples().size());
    halvesFromFloats(decoded->samples(), halves);
    all.insert(all.end(), halves.begin(), halves.end());
    at += sizeOfBlocks(image);
  });
  return numberList(all);
}

/// Blocks of every kind and in every partition, 64 of each kind.
Bytes blocksOfEveryKind() {
  std::mt19937 random(7);
  const auto below = [&](std::size_t bound) { return random() % bound; };
  Bytes all;
  for (std::size_t kind = 0; kind <= kUastcHdrModes.size(); ++kind)
    for (int count = 0; count < 64;) {
      UastcHdrBlock block{.is_solid = kind == kUastcHdrModes.size()};
      for (std::uint16_t& channel : block.color) channel = static_cast<std::uint16_t>(below(0x7c00));
      block.mode = static_cast<std::uint8_t>(block.is_solid ? 0 : kind);
      const UastcHdrMode& mode = kUastcHdrModes[block.mode];
      if (mode.subsets == 2) block.partition = static_cast<std::uint8_t>(below(kUastcHdrPartitions.size()));
      for (std::size_t i = 0; i < std::size_t(mode.numbers()); ++i)
        block.colors[i] = endpointLevels(mode.endpoints).values[below(std::size_t(mode.endpoints))];
      for (std::uint8_t& weight : block.weights) weight = static_cast<std::uint8_t>(below(std::size_t(mode.weights)));
      std::array<std::uint8_t, 16> bytes;
      writeUastcHdrBlock(block, bytes);
      if (!readUastcHdrBlock(bytes)) continue;  // not all random ends are finite light
      all.insert(all.end(), bytes.begin(), bytes.end());
      ++count;
    }
  return all;
}

/// What is hard to encode: on the left light of many octaves, on the right suns beside the dark, and black.
Image extremes(int width, int height) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> exponent(-14.0f, 15.9f);
  Image image(width, height, 3, 0.0f);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool is_sun = random() % 7 == 0;
      for (int c = 0; c < 3; ++c)
        image.texel(x, y)[c] = 2 * x < width    ? std::exp2(exponent(random))
                               : y < height / 4 ? 0.0f
                               : is_sun         ? 6e4f
                                                : 0.01f;
    }
  return image;
}

/// Formats of two channels drop it.
void removeBlue(ImageSet& images) {
  forEachImage(images, [](Image& image) {
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) image.texel(x, y)[2] = 0.0f;
  });
}

std::string describe(const File& file) {
  const auto number = [](const char* key, int value) {
    return std::string(",\"") + key + "\":" + std::to_string(value);
  };
  const ImageSet& images = file.images;
  return "{\"name\":\"" + file.name + "\",\"format\":\"" + file.format + "\"" +
         number("width", images.at(0, 0).width()) + number("height", images.at(0, 0).height()) +
         number("levels", images.levels()) + number("layers", images.layers()) + number("faces", images.faces()) +
         number("zstandard", file.options.zstandard_level) + ",\"texels\":[" +
         (blockSide(storedFormat(file.options.format)) > 1 ? numberList(blocksOf(file)) : texelList(images)) + "]" +
         (file.options.format == TexelFormat::uastc_hdr ? ",\"halves\":[" + decodedHalves(file) + "]" : "") + "}";
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", arguments[0]);
    return 2;
  }
  constexpr struct {
    TexelFormat format;
    const char* name;
  } kFormats[] = {{TexelFormat::half, "half"},           {TexelFormat::float32, "float32"},
                  {TexelFormat::b10g11r11, "b10g11r11"}, {TexelFormat::e5b9g9r9, "e5b9g9r9"},
                  {TexelFormat::rg_half, "rg_half"},     {TexelFormat::rg_float32, "rg_float32"},
                  {TexelFormat::bc6h, "bc6h"},           {TexelFormat::uastc_hdr, "uastc_hdr"}};
  std::vector<File> files;
  const auto add = [&](const std::string& name, const char* format, ImageSet images,
                       const TextureWriteOptions& options) {
    if (std::string(format).starts_with("rg_")) removeBlue(images);
    files.push_back({name, format, std::move(images), options});
  };
  for (const auto& [format, format_name] : kFormats) {
    const std::string name = format_name;
    const TextureWriteOptions plain{.format = format, .metadata = {{"envmap", "cube"}}};
    TextureWriteOptions packed = plain;
    packed.zstandard_level = 5;
    const ImageSet cube = mirrorball::testing::textureOf(3, 6, 1, 3, 4, 4);
    add(name + "_cube.ktx2", format_name, cube, plain);
    add(name + "_cube_zstandard.ktx2", format_name, cube, packed);
    add(name + "_cube_array.ktx2", format_name, mirrorball::testing::textureOf(2, 6, 3, 3, 5, 5), plain);
    add(name + "_picture.ktx2", format_name, mirrorball::testing::textureOf(1, 1, 1, 3, 7, 3), plain);
    add(name + "_picture_zstandard.ktx2", format_name, mirrorball::testing::textureOf(3, 1, 1, 3, 7, 5), packed);
  }
  // parse-dds reads cubes of this format with all levels.
  add("float32_cube.dds", "float32", mirrorball::testing::textureOf(4, 6, 1, 4, 8, 8),
      {.format = TexelFormat::float32});

  add("bc6h_cube.dds", "bc6h", mirrorball::testing::textureOf(4, 6, 1, 3, 8, 8), {.format = TexelFormat::bc6h});
  add("bc6h_picture.dds", "bc6h", mirrorball::testing::textureOf(1, 1, 1, 3, 12, 8), {.format = TexelFormat::bc6h});

  const TextureWriteOptions uastc{.format = TexelFormat::uastc_hdr, .metadata = {{"envmap", "cube"}}};
  add("uastc_hdr_extremes.ktx2", "uastc_hdr", ImageSet(extremes(256, 128)), uastc);
  add("uastc_hdr_kinds.ktx2", "uastc_hdr", ImageSet(Image(4 * 64, 4 * 24, 3, 1.0f)), uastc);
  files.back().blocks = blocksOfEveryKind();

  // What Filament reads, with the harmonics of its irradiance.
  std::string harmonics = "0";
  for (int i = 1; i < 27; ++i) harmonics += " " + std::to_string(i) + ".5";
  for (const auto& [format, format_name] : kFormats)
    if (format == TexelFormat::half || format == TexelFormat::float32 || format == TexelFormat::b10g11r11 ||
        format == TexelFormat::bc6h)
      add(std::string(format_name) + "_cube.ktx", format_name, mirrorball::testing::textureOf(3, 6, 1, 3, 16, 16),
          {.format = format, .metadata = {{"mirrorball:projection", "cube"}, {"sh", harmonics}}});

  const std::filesystem::path folder = arguments[1];
  std::string list;
  for (const File& file : files) {
    const auto written = writeImageSet(folder / file.name, file.images, file.options);
    if (!written) {
      std::fprintf(stderr, "%s\n", written.error().message.c_str());
      return 1;
    }
    // Of these there is one image, whose texels are the end of the file.
    if (!file.blocks.empty()) {
      Bytes bytes = *readFile(folder / file.name);
      std::copy(file.blocks.begin(), file.blocks.end(), bytes.end() - static_cast<std::ptrdiff_t>(file.blocks.size()));
      if (!writeFile(folder / file.name, bytes)) return 1;
    }
    list += (list.empty() ? "[" : ",\n") + describe(file);
  }
  list += "]\n";
  return writeFile(folder / "files.json", mirrorball::testing::bytesOf(list)) ? 0 : 1;
}
