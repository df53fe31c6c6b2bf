#pragma once

#include "mirrorball/base/result.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/gl/texture.h"
#include "mirrorball/render/light/face_drawing.h"
#include "mirrorball/render/light/gpu_prefilter.h"

namespace mirrorball {

/// Light that was captured on the GPU, in the forms that surfaces read: cubes.
struct ProbeLight {
  gl::Texture cube;        ///< with all mip levels
  gl::Texture chain;       ///< GpuPrefilter's, of level 0 and all others
  gl::Texture irradiance;  ///< divided by π
  gl::Texture nearness;    ///< render/surface/nearness_picture.h
};

/// Makes such light from pictures of the faces of a cube. Nothing is read back.
class ProbeFilter {
 public:
  /// size     of the faces
  /// format   of the light: half floats, or 32-bit floats where gl::Context::filtersFloats()
  /// unit     radiance for which a 1 in the cubes stands; in half floats light ends at 65504 of it
  /// errors   too_large; no_gl: the driver cannot draw into floats; unsupported (a shader)
  static Result<ProbeFilter> make(gl::Api api, int size, gl::Format format, float unit);

  int size() const { return size_; }
  gl::Format format() const { return format_; }
  float unit() const { return unit_; }

  /// errors   too_large
  Result<ProbeLight> makeLight() const;

  /// Takes the picture of a cubeFaceCamera as a face of the light; of its nearness as a face of that.
  void setFace(ProbeLight& light, int face, const gl::Texture& picture);
  void setNearness(ProbeLight& light, int face, const gl::Texture& picture);
  /// Makes all else of the faces of the light. The same bits each time.
  ///
  /// cost     GpuPrefilter::run's, and less than that for the rest
  void finish(ProbeLight& light);

  /// Empties a light, and adds a share of another: the blend of filtered light is the filtered blend. Not of nearness.
  void clear(ProbeLight& light);
  void add(ProbeLight& light, const ProbeLight& other, float share);

 private:
  struct Programs {
    gl::Program face, halve, irradiance, share;
  };
  ProbeFilter(int size, gl::Format format, float unit, Programs programs, GpuPrefilter prefilter);
  void drawFace(const gl::Texture& cube, int face, const gl::Texture& picture, float factor, float most);
  void addCube(const gl::Texture& cube, gl::Texture& other, float share);

  int size_;
  gl::Format format_;
  float unit_;
  Programs programs_;
  GpuPrefilter prefilter_;
  FaceDrawing drawing_;
  gl::VertexArray no_vertices_;
};

}  // namespace mirrorball
