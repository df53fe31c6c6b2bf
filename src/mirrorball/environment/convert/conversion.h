#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/convert/sample_batch.h"
#include "mirrorball/environment/convert/supersampling.h"
#include "mirrorball/environment/environment.h"

namespace mirrorball {

/// A rectangle of a target's texels that is converted as one unit of work: as wide as the target, but for very large
/// ones, so that its rows follow each other in a file.
struct Strip {
  int face = 0;
  glm::ivec2 begin{0};
  glm::ivec2 end{0};

  glm::ivec2 size() const { return end - begin; }
};

/// One conversion: what every strip of it needs to know.
class Conversion {
 public:
  Conversion(Projection to, int size, const Resampling& resampling)
      : to_(to), has_disc_(hasDisc(to)), extent_(imageSize(to, size)), resampling_(resampling) {}

  Projection to() const { return to_; }
  glm::ivec2 extent() const { return extent_; }
  const glm::mat3& sourceFromTarget() const { return resampling_.source_from_target; }
  /// All strips of the target, in the order of its texels.
  std::vector<Strip> strips() const;
  int channels() const { return convertedChannels(to_); }

  /// Converts one strip.
  ///
  /// source   light; of a panorama of which only some rows are there, all rows that the strip needs
  /// texels   of the strip's size; every sample of it is set
  void fill(const Environment& source, const Strip& strip, Image& texels) const;

 private:
  struct Tile;
  struct TileLight;
  struct Border;
  class PointSums;

  bool isOnSameGrid(const Environment& source) const;
  bool append(int face, glm::vec2 uv, PointBatch& batch) const;
  void lookUp(const Environment& source, Interpolation interpolation, PointBatch& batch, LightBatch& light) const;
  void lookUpCentres(const Environment& source, const Tile& tile, TileLight& light) const;
  void lookUpMeans(const Environment& source, const Tile& tile, glm::ivec2 points, Interpolation interpolation,
                   TileLight& light) const;
  static float brightness(const glm::vec4& light);
  bool seesBorder(const Tile& tile, const PointsPerTexel& points, const TileLight& light) const;
  Border lookUpBorder(const Environment& source, const Tile& tile, const PointsPerTexel& points) const;
  static bool hasSun(const Tile& tile, const TileLight& light, const Border& border);
  static bool isBesideSun(const Tile& tile, glm::ivec2 texel, const TileLight& light, const Border& border);
  void lookUpBesideSuns(const Environment& source, const Tile& tile, const PointsPerTexel& points,
                        TileLight& light) const;
  void fillTile(const Environment& source, const Tile& tile, glm::ivec2 origin, Image& texels) const;

  Projection to_;
  bool has_disc_;
  glm::ivec2 extent_;
  Resampling resampling_;
};

}  // namespace mirrorball
