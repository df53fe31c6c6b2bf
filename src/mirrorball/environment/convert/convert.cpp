#include "mirrorball/environment/convert/convert.h"

#include <algorithm>
#include <cmath>

#include "mirrorball/environment/convert/conversion.h"
#include "mirrorball/environment/convert/parallel_conversion.h"

namespace mirrorball {
namespace {

/// A rotation about an axis of the world, right-handed.
glm::mat3 aboutAxis(int axis, float angle_rad) {
  const int next = (axis + 1) % 3;
  const int after = (axis + 2) % 3;
  glm::mat3 rotation(1.0f);
  rotation[next][next] = rotation[after][after] = std::cos(angle_rad);
  rotation[next][after] = std::sin(angle_rad);
  rotation[after][next] = -std::sin(angle_rad);
  return rotation;
}

}  // namespace

glm::mat3 centredOn(glm::vec3 direction) {
  constexpr glm::vec3 kUp(0.0f, 1.0f, 0.0f);
  const glm::vec3 across = glm::cross(kUp, direction);
  const bool is_vertical = glm::dot(across, across) < 1e-12f;
  const glm::vec3 x = is_vertical ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::normalize(across);
  return {x, glm::cross(direction, x), direction};
}

glm::mat3 turnedBy(float yaw_rad, float pitch_rad, float roll_rad) {
  return aboutAxis(1, yaw_rad) * aboutAxis(0, pitch_rad) * aboutAxis(2, roll_rad);
}

glm::mat3 sourceFromRotated(std::vector<float> angles_deg) {
  angles_deg.resize(3, 0.0f);
  return glm::transpose(
      turnedBy(glm::radians(angles_deg[0]), glm::radians(angles_deg[1]), glm::radians(angles_deg[2])));
}

int convertedChannels(Projection projection) { return hasDisc(projection) ? 4 : 3; }

Result<ImageSet> imagesFor(Projection projection, int size) {
  const glm::ivec2 extent = imageSize(projection, size);
  MIRRORBALL_TRY_VOID(withName("the converted map", checkDimensions(extent.x, extent.y)));
  ImageSet images(1, faceCount(projection));
  const int channels = convertedChannels(projection);
  MIRRORBALL_TRY_VOID(withName("the converted map", checkImageMemory(extent.x, extent.y, channels * images.faces())));
  forEachImage(images, [&](Image& image) { image = Image::withoutValues(extent.x, extent.y, channels); });
  return images;
}

TakeTexels copyInto(ImageSet& images) {
  return [&images](int face, glm::ivec2 begin, const Image& texels) -> Result<void> {
    for (int y = 0; y < texels.height(); ++y)
      std::copy(texels.row(y).begin(), texels.row(y).end(), images.at(0, face).texel(begin.x, begin.y + y));
    return {};
  };
}

Result<void> convertByStrips(const Environment& source, Projection to, int size, const Resampling& resampling,
                             const TakeTexels& take, const ProgressFunction& progress) {
  const Conversion conversion(to, size, resampling);
  MIRRORBALL_TRY_VOID(withName("the converted map", checkDimensions(conversion.extent().x, conversion.extent().y)));
  const std::vector<Strip> strips = conversion.strips();
  ParallelConversion work(conversion, take, progress, strips.size());
  return work.run(source, strips);
}

Result<EnvironmentMap> convert(const Environment& source, Projection to, int size, const Resampling& resampling,
                               const ProgressFunction& progress) {
  MIRRORBALL_TRY(images, imagesFor(to, size));
  MIRRORBALL_TRY_VOID(convertByStrips(source, to, size, resampling, copyInto(images), progress));
  return EnvironmentMap(to, std::move(images));
}

}  // namespace mirrorball
