#include "mirrorball/environment/file/map_form.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/projection/openexr_registration.h"
#include "mirrorball/image/filter.h"

namespace mirrorball {
namespace {

Image sideBySide(const Image& left, const Image& right) {
  Image picture(left.width() + right.width(), left.height(), left.channels());
  for (int y = 0; y < picture.height(); ++y) {
    std::copy(left.row(y).begin(), left.row(y).end(), picture.texel(0, y));
    std::copy(right.row(y).begin(), right.row(y).end(), picture.texel(left.width(), y));
  }
  return picture;
}

ImageSet halves(const Image& picture) {
  ImageSet images(1, 2);
  const int side = picture.height();
  for (int face = 0; face < 2; ++face) {
    Image& image = images.at(0, face) = Image(side, side, picture.channels());
    for (int y = 0; y < side; ++y) std::copy_n(picture.texel(face * side, y), image.row(y).size(), image.texel(0, y));
  }
  return images;
}

/// How far right of a panorama's centre a direction of the horizon lies, in quarters of the circle: 0 … 3.
int quartersTo(SignedAxis centre) {
  switch (centre) {
    case SignedAxis::minus_x:
      return 1;
    case SignedAxis::minus_z:
      return 2;
    case SignedAxis::plus_x:
      return 3;
    default:
      assert(centre == SignedAxis::plus_z);
      return 0;
  }
}

/// A panorama whose columns have moved to the left by that many quarters of the circle. Where that is no whole number
/// of columns, as of an odd height, its rows are resampled.
Image turned(Image image, int quarters) {
  const int columns = quarters * image.width();
  if (columns % 4 == 0) {
    const std::ptrdiff_t samples = std::ptrdiff_t{columns} / 4 * image.channels();
    for (int y = 0; y < image.height(); ++y)
      std::rotate(image.row(y).begin(), image.row(y).begin() + samples, image.row(y).end());
    return image;
  }
  constexpr std::size_t kRowsPerPiece = 16;
  Image moved = Image::withoutValues(image.width(), image.height(), 3);
  parallelFor(std::size_t(image.height()), kRowsPerPiece, [&](std::size_t begin, std::size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const glm::vec2 position(static_cast<float>(x) + 0.5f + 0.25f * static_cast<float>(columns), 0.5f);
        const auto around = [&](int column, int) {
          return glm::vec4(rgbAt(image, (column + image.width()) % image.width(), y), 1.0f);
        };
        const glm::vec4 light = bicubic(position, around);
        std::copy_n(&light.x, 3, moved.texel(x, y));
      }
  });
  return moved;
}

/// Turns every image of a panorama's.
ImageSet turned(ImageSet images, int quarters) {
  forEachImage(images, [&](Image& image) { image = turned(std::move(image), quarters); });
  return images;
}

/// A cross is a cube unfolded from its slot +Z, with the slots ±X and ±Y where our table has them. Where images are
/// mirrored, as pictures seen from inside are, +Z has its neighbours on the other side: then the two slots exchange
/// their cells, and the cross still goes on across its edges. Its own inverse.
void exchangeInCross(const MapForm& form, ImageSet& images) {
  if (form.layout != CubeLayout::hcross && form.layout != CubeLayout::vcross && form.layout != CubeLayout::lecture)
    return;
  const std::array<FaceFrame, 6>& slots = form.arrangement.slots;
  if (slots[4].right == slots[1].centre) std::swap(images.at(0, 0), images.at(0, 1));
  if (slots[4].down == slots[2].centre) std::swap(images.at(0, 2), images.at(0, 3));
}

}  // namespace

std::string textOf(const MapForm& form) {
  std::string text = textOf(form.projection);
  if (faceCount(form.projection) == 6) {
    text += ", " + std::string(nameOf(form.layout));
    if (const std::string arrangement = textOf(form.arrangement); !arrangement.empty()) text += ", " + arrangement;
  }
  if (form.centre != SignedAxis::plus_z) text += ", centred on " + std::string(nameOf(form.centre));
  if (form.has_texels_on_edges) text += ", OpenEXR's texels (resampled)";
  return text;
}

ImageSet imagesOf(EnvironmentMap map, const MapForm& form) {
  if (form.has_texels_on_edges) {
    MapForm rest = form;
    rest.has_texels_on_edges = false;
    return imagesOf(toOpenExrRegistration(map), rest);
  }
  return imagesOf(std::move(map).takeImages(), form);
}

ImageSet imagesOf(ImageSet levels, const MapForm& form) {
  assert(!form.has_texels_on_edges);
  if (form.centre != SignedAxis::plus_z) return turned(std::move(levels), quartersTo(form.centre));
  if (faceCount(form.projection) == 6) return arranged(std::move(levels), form.arrangement);
  return levels;
}

EnvironmentMap mapOfImages(ImageSet images, const MapForm& form) {
  MapForm rest = form;
  rest.has_texels_on_edges = false;
  EnvironmentMap map(form.projection, levelsOfImages(std::move(images), rest));
  if (form.has_texels_on_edges) return fromOpenExrRegistration(map);
  return map;
}

ImageSet levelsOfImages(ImageSet images, const MapForm& form) {
  assert(!form.has_texels_on_edges);
  if (form.centre != SignedAxis::plus_z) return turned(std::move(images), 4 - quartersTo(form.centre));
  if (faceCount(form.projection) == 6) return restored(std::move(images), form.arrangement);
  return images;
}

Image pictureOf(EnvironmentMap map, const MapForm& form) {
  return pictureOfImages(imagesOf(std::move(map), form), form);
}

Image pictureOfImages(ImageSet images, const MapForm& form) {
  switch (images.faces()) {
    case 6:
      exchangeInCross(form, images);
      return composeLayout(images, form.layout);
    case 2:
      return sideBySide(images.at(0, 0), images.at(0, 1));
    default:
      return std::move(images.at(0, 0));
  }
}

Result<ImageSet> imagesInPicture(Image picture, const MapForm& form) {
  switch (faceCount(form.projection)) {
    case 6: {
      MIRRORBALL_TRY(images, splitLayout(picture, form.layout));
      exchangeInCross(form, images);
      return images;
    }
    case 2:
      return halves(picture);
    default:
      return ImageSet(std::move(picture));
  }
}

Result<EnvironmentMap> mapOfPicture(Image picture, const MapForm& form) {
  MIRRORBALL_TRY(images, imagesInPicture(std::move(picture), form));
  return mapOfImages(std::move(images), form);
}

}  // namespace mirrorball
