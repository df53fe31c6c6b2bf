#include "mirrorball/image/fourier_transform.h"

#include <cstddef>
#include <cstdint>
#include <numbers>

#include <kiss_fft.h>

namespace mirrorball {
namespace {

using Complex = std::complex<float>;
static_assert(sizeof(Complex) == sizeof(kiss_fft_cpx));

int maxPrimeFactor(int number) {
  int max = 1;
  for (int factor = 2; factor * factor <= number; ++factor)
    for (; number % factor == 0; number /= factor) max = factor;
  return number > 1 ? number : max;
}

}  // namespace

/// With 2kn = k² + n² − (k − n)² a transform is a convolution with e^(±iπ n² / length), which is a product of
/// transforms of another, quick length.
struct FourierTransform::Chirp {
  FourierTransform forward;
  FourierTransform back;
  std::vector<Complex> factors;   ///< e^(∓iπ n² / length)
  std::vector<Complex> spectrum;  ///< of their conjugates, over the quick length

  Chirp(int length, bool is_inverse) : Chirp(length, is_inverse, quickLength(2 * length - 1)) {}

  void run(const std::vector<Complex>& in, std::vector<Complex>& out) const {
    std::vector<Complex> here(spectrum.size());
    std::vector<Complex> there(spectrum.size());
    for (std::size_t n = 0; n < factors.size(); ++n) here[n] = in[n] * factors[n];
    forward.run(here, there);
    for (std::size_t k = 0; k < spectrum.size(); ++k) there[k] *= spectrum[k];
    back.run(there, here);
    for (std::size_t k = 0; k < factors.size(); ++k) out[k] = here[k] * factors[k];
  }

 private:
  Chirp(int length, bool is_inverse, int quick)
      : forward(quick, false), back(quick, true), spectrum(std::size_t(quick)) {
    std::vector<Complex> conjugates(spectrum.size());
    for (std::int64_t n = 0; n < length; ++n) {
      const double turns = static_cast<double>(n * n % (2 * length)) / length;  // of π, few, so that none is lost
      factors.push_back(Complex(std::polar(1.0, (is_inverse ? 1.0 : -1.0) * std::numbers::pi * turns)));
      const Complex conjugate = std::conj(factors.back()) / static_cast<float>(quick);
      conjugates[std::size_t(n)] = conjugate;
      if (n > 0) conjugates[std::size_t(quick - n)] = conjugate;
    }
    forward.run(conjugates, spectrum);
  }
};

FourierTransform::FourierTransform(int length, bool is_inverse) {
  constexpr int kMaxQuickFactor = 13;  // the library takes as many steps a number as a factor is large
  if (maxPrimeFactor(length) > kMaxQuickFactor)
    chirp_ = std::make_unique<Chirp>(length, is_inverse);
  else
    plan_.reset(kiss_fft_alloc(length, is_inverse, nullptr, nullptr));
}

FourierTransform::~FourierTransform() = default;

void FourierTransform::Free::operator()(kiss_fft_state* plan) const { kiss_fft_free(plan); }

void FourierTransform::run(const std::vector<Complex>& in, std::vector<Complex>& out) const {
  if (chirp_) return chirp_->run(in, out);
  kiss_fft(plan_.get(), reinterpret_cast<const kiss_fft_cpx*>(in.data()), reinterpret_cast<kiss_fft_cpx*>(out.data()));
}

int quickLength(int min) {
  int length = min + min % 2;
  while (maxPrimeFactor(length) > 5) length += 2;
  return length;
}

}  // namespace mirrorball
