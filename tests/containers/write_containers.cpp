// usage: write_containers FOLDER
//
// Writes textures of every format, and files.json, which says what must be found in them.

#include <cstdio>
#include <filesystem>
#include <string>

#include "mirrorball/codec/bc6h/bc6h.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/codec/texture/texture_testing.h"

namespace {

using namespace mirrorball;

struct File {
  std::string name;
  const char* format;
  ImageSet images;
  TextureWriteOptions options;
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

/// The bytes of every block, by level, layer, face and row of blocks. Which texels they stand for is another matter,
/// which bc6h_parity_test holds to a driver.
std::string blockList(const ImageSet& images) {
  std::string list;
  forEachImage(images, [&](const Image& image) {
    Bytes blocks(std::size_t((image.width() + 3) / 4) * std::size_t((image.height() + 3) / 4) * 16);
    encodeBc6h(image.samples(), image.channels(), image.width(), blocks);
    for (const std::uint8_t byte : blocks) list += (list.empty() ? "" : ",") + std::to_string(byte);
  });
  return list;
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
         (file.options.format == TexelFormat::bc6h ? blockList(images) : texelList(images)) + "]}";
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
  } kFormats[] = {
      {TexelFormat::half, "half"},         {TexelFormat::float32, "float32"}, {TexelFormat::b10g11r11, "b10g11r11"},
      {TexelFormat::e5b9g9r9, "e5b9g9r9"}, {TexelFormat::rg_half, "rg_half"}, {TexelFormat::rg_float32, "rg_float32"},
      {TexelFormat::bc6h, "bc6h"}};
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
    list += (list.empty() ? "[" : ",\n") + describe(file);
  }
  list += "]\n";
  return writeFile(folder / "files.json", mirrorball::testing::bytesOf(list)) ? 0 : 1;
}
