#include "mirrorball/environment/picture.h"

#include <algorithm>
#include <cassert>

#include "mirrorball/environment/edge_grid.h"
#include "mirrorball/environment/resample.h"

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

/// A panorama whose columns have moved to the left by that many quarters of the circle. Of an odd height one quarter is
/// no whole number of columns: then it is resampled.
EnvironmentMap turned(const EnvironmentMap& map, int quarters) {
  const int width = imageSize(map.projection(), map.size()).x;
  if (quarters * width % 4 != 0)
    return resampled(Projection::equirect, map.size(), [&](int, glm::ivec2 texel) {
      const glm::vec2 uv = (glm::vec2(texel) + 0.5f) / glm::vec2(width, map.size());
      const float u = glm::fract(uv.x + 0.25f * static_cast<float>(quarters));
      return map.radiance(directionAt(Projection::equirect, {0, {u, uv.y}}), Interpolation::bicubic);
    });
  Image image = map.face(0);
  const std::ptrdiff_t samples = std::ptrdiff_t{quarters} * width / 4 * image.channels();
  for (int y = 0; y < image.height(); ++y)
    std::rotate(image.row(y).begin(), image.row(y).begin() + samples, image.row(y).end());
  return EnvironmentMap(Projection::equirect, ImageSet(std::move(image)));
}

/// A cross is a cube unfolded from its slot +Z, with the slots ±X and ±Y where our table has them. Where images are
/// mirrored, as pictures seen from inside are, +Z has its neighbours on the other side: then the two slots exchange their
/// cells, and the cross still goes on across its edges. Its own inverse.
void exchangeInCross(const MapForm& form, ImageSet& images) {
  if (form.layout != CubeLayout::hcross && form.layout != CubeLayout::vcross && form.layout != CubeLayout::seed) return;
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
    return imagesOf(ontoEdgeGrid(map), rest);
  }
  if (form.centre != SignedAxis::plus_z) return turned(map, quartersTo(form.centre)).takeImages();
  if (faceCount(form.projection) == 6) return arranged(std::move(map).takeImages(), form.arrangement);
  return std::move(map).takeImages();
}

EnvironmentMap mapOfImages(ImageSet images, const MapForm& form) {
  if (faceCount(form.projection) == 6) images = restored(std::move(images), form.arrangement);
  EnvironmentMap map(form.projection, std::move(images));
  if (form.centre != SignedAxis::plus_z) map = turned(map, 4 - quartersTo(form.centre));
  if (form.has_texels_on_edges) return fromEdgeGrid(map);
  return map;
}

Image pictureOf(EnvironmentMap map, const MapForm& form) {
  ImageSet images = imagesOf(std::move(map), form);
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
