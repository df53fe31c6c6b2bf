#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/convert/sample_batch.h"
#include "mirrorball/environment/environment.h"

namespace mirrorball {

/// A rectangle of a target's texels that is converted as one piece of work: as wide as the target, but for very large
/// ones, so that its rows follow each other in a file.
struct Piece {
  int face = 0;
  glm::ivec2 begin{0};
  glm::ivec2 end{0};

  glm::ivec2 size() const { return end - begin; }
};

/// One conversion: what every piece of it needs to know.
class Conversion {
 public:
  Conversion(Projection to, int size, const Resampling& resampling)
      : to_(to), has_disc_(hasDisc(to)), extent_(imageSize(to, size)), resampling_(resampling) {}

  Projection to() const { return to_; }
  glm::ivec2 extent() const { return extent_; }
  const glm::mat3& sourceFromTarget() const { return resampling_.source_from_target; }
  /// All pieces of the target, in the order of its texels.
  std::vector<Piece> pieces() const;
  int channels() const { return convertedChannels(to_); }

  /// Converts one piece.
  ///
  /// source   light; of a panorama of which only some rows are there, all rows that the piece needs
  /// texels   of the piece's size; every sample of it is set
  void fill(const Environment& source, const Piece& piece, Image& texels) const;

 private:
  struct Row;
  struct Tile;

  void lookUp(const Environment& source, Interpolation interpolation, PointBatch& batch, LightBatch& light) const;
  void fillCentres(const Environment& source, const Tile& tile, glm::ivec2 origin, Image& texels) const;
  void fillTile(const Environment& source, const Tile& tile, glm::ivec2 origin, Image& texels) const;
  void addPoint(const Environment& source, Row& row, int face, int texel, glm::vec2 uv,
                Interpolation interpolation) const;
  void gather(const Environment& source, Row& row, Interpolation interpolation) const;

  Projection to_;
  bool has_disc_;
  glm::ivec2 extent_;
  Resampling resampling_;
};

}  // namespace mirrorball
