#pragma once

#include <complex>
#include <memory>
#include <vector>

struct kiss_fft_state;

namespace mirrorball {

/// A Fourier transform of complex numbers, unscaled: out_k = Σ_n in_n · e^(∓2πi kn / length). Safe to use from many
/// threads.
///
/// cost     n log n steps for any length, some four times as many for one with a prime factor above 13
/// from     Bluestein 1970, "A linear filtering approach to the computation of discrete Fourier transform", for those
class FourierTransform {
 public:
  /// length       at least 1
  /// is_inverse   the sign of the exponent is +
  FourierTransform(int length, bool is_inverse);
  ~FourierTransform();

  /// in, out   length numbers each, not the same
  void run(const std::vector<std::complex<float>>& in, std::vector<std::complex<float>>& out) const;

 private:
  struct Free {
    void operator()(kiss_fft_state* plan) const;
  };
  struct Chirp;

  std::unique_ptr<kiss_fft_state, Free> plan_;
  std::unique_ptr<const Chirp> chirp_;  // where the library would be slow
};

/// The next number from `min` on that is even and a product of 2, 3 and 5, for which Fourier transforms are quick.
int quickLength(int min);

}  // namespace mirrorball
