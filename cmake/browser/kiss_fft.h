#pragma once

// In place of the header of that name in builds for browsers: the functions of KISS FFT's C interface that
// image/fourier_transform.cpp calls, by its C++ class, which is a header alone and so needs no library for WebAssembly.

#include <cstddef>
#include <kissfft.hh>

struct kiss_fft_cpx {
  float r;
  float i;
};

struct kiss_fft_state {
  kissfft<float> plan;
};

inline kiss_fft_state* kiss_fft_alloc(int length, int is_inverse, void*, std::size_t*) {
  return new kiss_fft_state{kissfft<float>(static_cast<std::size_t>(length), is_inverse != 0)};
}

inline void kiss_fft_free(kiss_fft_state* state) { delete state; }

inline void kiss_fft(kiss_fft_state* state, const kiss_fft_cpx* in, kiss_fft_cpx* out) {
  state->plan.transform(reinterpret_cast<const std::complex<float>*>(in), reinterpret_cast<std::complex<float>*>(out));
}
