#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/observer.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/projection/projection.h"
#include "mirrorball/environment/projection/smooth_region.h"
#include "mirrorball/image/filter.h"
#include "mirrorball/image/image_set.h"
#include "mirrorball/image/value_counts.h"

namespace mirrorball {

/// Rows of an image, from `begin` to before `end`.
struct RowRange {
  int begin = 0;
  int end = 0;

  int count() const { return end - begin; }
};

/// Light from every direction, held in images: one, a cube's six faces in the order +X −X +Y −Y +Z −Z, or the front and
/// the back of a paraboloid map.
class EnvironmentMap {
 public:
  EnvironmentMap() = default;
  /// images   one level; faceCount(projection) images of one size that fits the projection
  EnvironmentMap(Projection projection, ImageSet images);

  /// A panorama of which only a window of rows is in memory: at first none. `radiance` may be called only if the window
  /// contains the row of the direction and two rows on either side.
  ///
  /// height     of the whole panorama
  /// capacity   the most rows that it will hold at a time
  static EnvironmentMap windowOfPanorama(int height, int channels, int capacity);
  /// Which rows of the images are in memory: all of them, except with such a window.
  RowRange rows() const { return rows_; }
  /// Takes the rows that follow, as many as there is room for.
  void appendRows(const Image& rows);
  /// Forgets the rows before that one.
  void dropRowsBefore(int row);

  Projection projection() const { return projection_; }
  const Image& face(int index) const { return images_.at(0, index); }
  Image& face(int index) { return images_.at(0, index); }
  int faces() const { return images_.faces(); }
  const ImageSet& images() const { return images_; }
  /// The images of a map that is not needed any more.
  ImageSet takeImages() && { return std::move(images_); }

  /// A face's side, a disc's diameter, a square's side, a panorama's height.
  int size() const { return extent_.y; }

  /// panoramaRowBends of its height; empty unless it is a panorama.
  std::span<const float> rowBends() const { return row_bends_; }

  /// The size of each whole image, in texels.
  glm::ivec2 extent() const { return extent_; }

  /// The radiance that arrives from `direction` (unit), interpolated across every seam, pole, fold and cube edge;
  /// nothing from outside a disc is mixed in. For a direction that the map does not cover: behind a photographed ball,
  /// the radiance at the nearest point of the rim; in the other half of a hemioctahedral map, none.
  glm::vec3 radiance(glm::vec3 direction, Interpolation interpolation = Interpolation::bilinear) const;

  /// The same, and between which texels it was interpolated.
  struct Interpolated {
    glm::vec3 radiance;
    TexelRange texels;
  };
  Interpolated interpolated(glm::vec3 direction, Interpolation interpolation) const;

 private:
  float rowBendAt(float y) const;
  glm::vec2 keepingLightOfRows(glm::vec2 position) const;
  std::optional<glm::vec3> insideImage(int face, glm::vec2 position) const;
  glm::vec4 fetch(int face, int x, int y) const;
  glm::vec4 fetchEquirect(int x, int y) const;
  glm::vec4 fetchFolded(int x, int y) const;
  glm::vec4 fetchCovered(int face, int x, int y) const;
  glm::vec4 fetchTowards(int face, int x, int y) const;
  Interpolated betweenTexels(int face, glm::vec2 position, Interpolation interpolation) const;
  Interpolated cubicOnChart(const MapPosition& place, glm::vec2 position) const;
  glm::vec4 fetchInRegion(const SmoothRegion& region, int x, int y) const;
  glm::vec3 cubicThrough(int face, const CubicStencil& texels, glm::vec3 straight) const;

  Projection projection_ = Projection::equirect;
  bool has_disc_ = false;
  glm::ivec2 extent_{0};
  RowRange rows_;
  std::vector<float> row_bends_;
  ImageSet images_;
};

/// Raises light below 0, which sharpening filters and half floats leave in files, to 0.
///
/// returns  how many values of red, green and blue there were
std::size_t raiseNegativeLight(EnvironmentMap& map);
std::size_t raiseNegativeLight(Image& image);

/// The same, which a remark tells, of light that can be summed over the whole sphere.
///
/// returns  counts of the map as it was
/// errors   out_of_range: a value is so bright that such a sum would not be finite
Result<ValueCounts> checkLight(EnvironmentMap& map, const Observer& observer);

}  // namespace mirrorball
