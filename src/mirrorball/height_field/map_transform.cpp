#include "mirrorball/height_field/map_transform.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace mirrorball {

using Complex = std::complex<float>;

MapTransform::MapTransform(int length, MapEdges edges)
    : length_(std::size_t(length)), edges_(edges), forward_(length, false), inverse_(length, true) {
  if (edges != MapEdges::clamped) return;
  for (int k = 0; k < length; ++k)
    quarter_waves_.push_back(Complex(std::polar(1.0, -std::numbers::pi * k / (2.0 * length))));
}

MapTransform::Work MapTransform::makeWork() const {
  return {std::vector<Complex>(length_), std::vector<Complex>(length_)};
}

double MapTransform::angle(int index) const {
  return (edges_ == MapEdges::tiled ? 2.0 : 1.0) * std::numbers::pi * index / static_cast<double>(length_);
}

/// With Z the transform of a + i b, that of a is A = (Z_k + Z*_−k) / 2 and that of b is B = (Z_k − Z*_−k) / 2i;
/// Hartley's of either is its real less its imaginary part.
void MapTransform::hartley(float* first, float* second, float scale, Work& work) const {
  for (std::size_t n = 0; n < length_; ++n) work.before[n] = {first[n], second[n]};
  forward_.run(work.before, work.after);
  const float half = 0.5f * scale;
  for (std::size_t k = 0; k < length_; ++k) {
    const Complex here = work.after[k];
    const Complex beside = work.after[indexBeside(k)];
    first[k] = half * (here.real() + beside.real() - here.imag() + beside.imag());
    second[k] = half * (here.imag() + beside.imag() + here.real() - beside.real());
  }
}

/// Makhoul's order of numbers, even ones up and odd ones down, makes V of them with C_k = Re(e^(−iπk/2n) V_k).
void MapTransform::forward(float* first, float* second, Work& work) const {
  if (edges_ == MapEdges::tiled) return hartley(first, second, 1.0f, work);
  for (std::size_t n = 0; n < length_; ++n) {
    const std::size_t to = n % 2 == 0 ? n / 2 : length_ - 1 - n / 2;
    work.before[to] = {first[n], second[n]};
  }
  forward_.run(work.before, work.after);
  for (std::size_t k = 0; k < length_; ++k) {
    const Complex here = work.after[k];
    const Complex beside = std::conj(work.after[indexBeside(k)]);
    const Complex wave = quarter_waves_[k];
    const Complex sum = 0.5f * (here + beside);
    const Complex difference = 0.5f * (here - beside);  // of the second row, times i
    first[k] = wave.real() * sum.real() - wave.imag() * sum.imag();
    second[k] = wave.real() * difference.imag() + wave.imag() * difference.real();
  }
}

/// V_k = e^(iπk/2n) (C_k − i C_(n−k)), with C_n = 0.
void MapTransform::inverse(float* first, float* second, Work& work) const {
  const float scale = 1.0f / static_cast<float>(length_);
  if (edges_ == MapEdges::tiled) return hartley(first, second, scale, work);
  for (std::size_t k = 0; k < length_; ++k) {
    const Complex wave = scale * std::conj(quarter_waves_[k]);
    const std::size_t beside = indexBeside(k);
    const Complex of_first(first[k], k == 0 ? 0.0f : -first[beside]);
    const Complex of_second(second[k], k == 0 ? 0.0f : -second[beside]);
    // wave · (of_first + i of_second), without the library's care for infinities
    const Complex sum(of_first.real() - of_second.imag(), of_first.imag() + of_second.real());
    work.before[k] = {wave.real() * sum.real() - wave.imag() * sum.imag(),
                      wave.real() * sum.imag() + wave.imag() * sum.real()};
  }
  inverse_.run(work.before, work.after);
  for (std::size_t n = 0; n < length_; ++n) {
    const Complex value = work.after[n % 2 == 0 ? n / 2 : length_ - 1 - n / 2];
    first[n] = value.real();
    second[n] = value.imag();
  }
}

}  // namespace mirrorball
