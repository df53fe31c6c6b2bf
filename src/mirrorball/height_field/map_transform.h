#pragma once

#include <complex>
#include <vector>

#include "mirrorball/height_field/height_field.h"
#include "mirrorball/image/fourier_transform.h"

namespace mirrorball {

/// A transform of rows of real numbers to real numbers whose basis functions symmetric convolutions only scale: waves
/// that go round with tiled edges (Hartley's transform, cos + sin), and cosines that are even about both ends with
/// clamped ones, beyond which a row goes on as its mirror image (the DCT-II). Safe to use from many threads.
///
/// cost     that of one Fourier transform of `length` complex numbers for two rows
/// from     Hartley 1942; Makhoul 1980, "A fast cosine transform in one and two dimensions", for the DCT
class MapTransform {
 public:
  MapTransform(int length, MapEdges edges);

  /// What a thread needs while it transforms.
  struct Work {
    std::vector<std::complex<float>> before;
    std::vector<std::complex<float>> after;
  };
  Work makeWork() const;

  /// Two rows of `length` numbers at a time, in place; they may be parts of one array.
  void forward(float* first, float* second, Work& work) const;

  /// And back, so that both together change nothing.
  void inverse(float* first, float* second, Work& work) const;

  /// By which angle the basis function `index` goes on from a texel to the next, in [0, 2π).
  double angle(int index) const;

 private:
  std::size_t indexBeside(std::size_t k) const { return k == 0 ? 0 : length_ - k; }
  void hartley(float* first, float* second, float scale, Work& work) const;

  std::size_t length_;
  MapEdges edges_;
  FourierTransform forward_;
  FourierTransform inverse_;
  std::vector<std::complex<float>> quarter_waves_;  // e^(−iπk / 2 length)
};

}  // namespace mirrorball
