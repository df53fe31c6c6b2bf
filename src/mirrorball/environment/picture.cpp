#include "mirrorball/environment/picture.h"

#include <algorithm>

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

}  // namespace

std::string textOf(const MapForm& form) {
  std::string text = textOf(form.projection);
  if (faceCount(form.projection) == 6) text += ", " + std::string(nameOf(form.layout));
  return text;
}

Image pictureOf(const EnvironmentMap& map, const MapForm& form) {
  switch (map.faces()) {
    case 6:
      return composeLayout(map, form.layout);
    case 2:
      return sideBySide(map.face(0), map.face(1));
    default:
      return map.face(0);
  }
}

Result<EnvironmentMap> mapOfPicture(Image picture, const MapForm& form) {
  const int faces = faceCount(form.projection);
  if (faces == 6) return splitLayout(picture, form.layout, form.projection);
  return EnvironmentMap(form.projection, faces == 2 ? halves(picture) : ImageSet(std::move(picture)));
}

}  // namespace mirrorball
