#include "mirrorball/codec/tiff/tiff_window.h"

#include <cmath>
#include <cstdint>

#include "mirrorball/codec/picture_window.h"

namespace mirrorball {
namespace {

constexpr const char* kFullImage = "its full image";

/// A number of texels: without a resolution positions count texels, as OpenImageIO reads and wrote them.
double texelsFrom(TIFF* tiff, std::uint32_t position_tag, std::uint32_t resolution_tag) {
  float position = 0.0f, resolution = 0.0f;
  if (TIFFGetField(tiff, position_tag, &position) == 0) return 0.0;
  if (TIFFGetField(tiff, resolution_tag, &resolution) == 0 || !(resolution > 0.0f)) resolution = 1.0f;
  return std::round(double(position) * double(resolution));
}

/// Whether some texel of a page lies in the larger picture, along one of the two axes.
bool meets(double corner, int size, std::uint32_t whole) { return corner + size > 0.0 && corner < double(whole); }

}  // namespace

Result<TiffWindow> readTiffWindow(const TiffFile& file, glm::ivec2 size) {
  TIFF* tiff = file.get();
  std::uint32_t width = 0, height = 0;
  if (TIFFGetField(tiff, TIFFTAG_PIXAR_IMAGEFULLWIDTH, &width) == 0 ||
      TIFFGetField(tiff, TIFFTAG_PIXAR_IMAGEFULLLENGTH, &height) == 0 || width == 0 || height == 0)
    return TiffWindow{};
  const double x = texelsFrom(tiff, TIFFTAG_XPOSITION, TIFFTAG_XRESOLUTION);
  const double y = texelsFrom(tiff, TIFFTAG_YPOSITION, TIFFTAG_YRESOLUTION);
  if (!meets(x, size.x, width) || !meets(y, size.y, height)) return TiffWindow{.oddity = noTexelText(kFullImage)};
  MIRRORBALL_TRY_VOID(checkWholePicture(width, height, kFullImage, file.size()));
  const PictureWindow window{
      .whole = {int(width), int(height)}, .corner = {int(x), int(y)}, .source = kFullImage, .size = size};
  if (window.whole == size && window.corner == glm::ivec2(0)) return TiffWindow{};
  return TiffWindow{window, windowText(window)};
}

}  // namespace mirrorball
