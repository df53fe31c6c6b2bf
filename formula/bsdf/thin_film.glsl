// A thin film on a surface: light that its upper and its lower side reflect interferes, and so the colours of soap
// bubbles, oil and tempered steel change with the angle (KHR_materials_iridescence; Belcour & Barla 2017, "A practical
// extension to microfacet theory for the modeling of varying iridescence").
//
// The film's upper side reflects the amplitude a, its lower side ρ e^{iφ}; a wave that goes down and up once more lags
// by δ = 2π D / λ, D = 2 n d cos θ being the difference of the ways in a film of index n and thickness d. All orders
// together reflect (Airy 1833)
//   R = (a² + ρ² + 2 a ρ cos ψ) / (1 + q² + 2 q cos ψ),  ψ = δ + φ,  q = a ρ
//     = 1 − (1 − a²) (1 − ρ²) / (1 + q² + 2 q cos ψ)
//     = 1 − (1 − a²) (1 − ρ²) / (1 − q²) · (1 + 2 Σ (−q)^m cos m ψ),  m = 1, 2, …
// In the light of a channel each cos m ψ becomes its mean over the wavelengths that the channel sees.
// Needs: color, constants.

const int kSpectralOrders = 3;  // that are weighed over all wavelengths
const float kNoAngle = 1e-20f;  // makes the angle of what is not reflected 0, which GLSL leaves open

// The CIE's matching functions as bells over the wave number 1 / λ: their middles [1/µm] and variances (Belcour & Barla
// 2017, supplemental material); red has a second one.
const vec3 kBellMiddles = vec3(1.6810f, 1.7953f, 2.2084f);
const vec3 kBellVariances = vec3(4.3278e-3f, 9.3046e-3f, 6.6121e-3f);

// The means of cos(2π D / λ) and sin(2π D / λ) in red, green and blue light.
struct SpectrumMean {
  vec3 cosine;
  vec3 sine;
};

// For a difference D of the ways [µm].
FN SpectrumMean meanOverSpectrum(float difference) {
  const vec3 height = vec3(0.84642f, 1.00002f, 1.00089f);
  const vec3 white = vec3(1.2050f, 0.9482f, 0.9098f);  // of those heights, in Rec.709
  float phase = 6.2831853f * difference;
  vec3 bells = height * exp(-kBellVariances * (phase * phase));
  float second = 0.15384f * exp(-4.5282e-3f * phase * phase);
  vec3 cosines = bells * cos(kBellMiddles * phase) + vec3(second * cos(2.2399f * phase), 0.0f, 0.0f);
  vec3 sines = bells * sin(kBellMiddles * phase) + vec3(second * sin(2.2399f * phase), 0.0f, 0.0f);
  return MAKE(SpectrumMean)(rec709FromXyz(cosines) / white, rec709FromXyz(sines) / white);
}

// How one polarisation is reflected: the amplitude a of the upper side, ρ of the lower one, and the phase that the
// lower side adds, per channel.
struct FilmSides {
  float a;
  vec3 rho;
  vec3 shift;
};

// The sum of q^m cos m ψ over all m > kSpectralOrders, which count where both sides reflect much. All light of a
// channel is taken for its middle wavelength, but fades with the difference as the first of those orders does.
//   q            at least 0
FN vec3 higherOrders(vec3 q, vec3 shift, float difference) {
  float phase = 6.2831853f * difference;
  float order = float(kSpectralOrders + 1);
  vec3 psi = kBellMiddles * phase + shift;
  vec3 first = pow(q, vec3(order)) * exp(-kBellVariances * (order * phase * order * phase));
  vec3 below = max(vec3(1.0f) + q * (q - 2.0f * cos(psi)), vec3(1e-6f));
  return first * (cos(order * psi) - q * cos((order - 1.0f) * psi)) / below;
}

// The sum over the orders, 1 + 2 Σ (−q)^m cos m ψ, of one polarisation but for the orders that are weighed over all
// wavelengths. Half a turn stands for the sign of −q.
FN vec3 sumWithoutSpectrum(FilmSides sides, float difference) {
  vec3 shift = sides.a < 0.0f ? sides.shift : sides.shift + kPi;
  return vec3(1.0f) + 2.0f * higherOrders(abs(sides.a) * sides.rho, shift, difference);
}

// One of the orders that are.
FN vec3 spectralOrder(FilmSides sides, int m, SpectrumMean mean) {
  vec3 turned = float(m) * sides.shift;
  vec3 q = sides.a * sides.rho;
  vec3 strength = q * q;  // of the second
  if (m == 1) strength = -q;
  if (m == 3) strength = -q * q * q;
  return 2.0f * strength * (mean.cosine * cos(turned) - mean.sine * sin(turned));
}

FN vec3 reflectanceOfSum(FilmSides sides, vec3 sum) {
  vec3 q = sides.a * sides.rho;
  vec3 both = (1.0f - sides.a * sides.a) * (vec3(1.0f) - sides.rho * sides.rho);
  vec3 passes = both / max(vec3(1.0f) - q * q, vec3(1e-6f));
  return clamp(vec3(1.0f) - passes * sum, vec3(0.0f), vec3(1.0f));
}

// The reflectance of a film in air, for unpolarised light.
//   cosine      of the ray outside, in [0, 1]
//   film_ior    index of the film, at least 1
//   thickness   µm
//   n, k        complex index below the film, per channel; k = 0 for a dielectric
//   from        Fresnel's amplitudes with cosines n cos θ that may be complex: Born & Wolf, Principles of Optics, 14.2
FN vec3 filmReflectance(float cosine, float film_ior, float thickness, vec3 n, vec3 k) {
  cosine = max(cosine, 1e-4f);  // along the surface a film of index 1 would be 0 / 0
  float sine2 = 1.0f - cosine * cosine;
  float inner = sqrt(max(film_ior * film_ior - sine2, 0.0f));  // n cos θ in the film
  float difference = 2.0f * thickness * inner;
  // n cos θ below it: the root of m² − sin² θ, with the index m = n + ik.
  vec3 m_re = n * n - k * k;
  vec3 m_im = 2.0f * n * k;
  vec3 z = m_re - sine2;
  vec3 size = sqrt(z * z + m_im * m_im);
  vec3 re = sqrt(max(size + z, vec3(0.0f)) / 2.0f);
  vec3 im = sqrt(max(size - z, vec3(0.0f)) / 2.0f);
  // Perpendicular: (inner − below) / (inner + below).
  vec3 rho2 = ((inner - re) * (inner - re) + im * im) / max((inner + re) * (inner + re) + im * im, vec3(1e-12f));
  vec3 shift = atan(-2.0f * inner * im, inner * inner - re * re - im * im + kNoAngle);
  FilmSides s = MAKE(FilmSides)((cosine - inner) / (cosine + inner), sqrt(rho2), shift);
  // Parallel: (m² inner − n² below) / (m² inner + n² below), n being the film's index.
  float film2 = film_ior * film_ior;
  vec3 p_re = m_re * inner;
  vec3 p_im = m_im * inner;
  vec3 q_re = film2 * re;
  vec3 q_im = film2 * im;
  vec3 difference2 = (p_re - q_re) * (p_re - q_re) + (p_im - q_im) * (p_im - q_im);
  vec3 sum2 = (p_re + q_re) * (p_re + q_re) + (p_im + q_im) * (p_im + q_im);
  rho2 = difference2 / max(sum2, vec3(1e-12f));
  shift = atan(2.0f * (p_im * q_re - p_re * q_im), p_re * p_re + p_im * p_im - q_re * q_re - q_im * q_im + kNoAngle);
  FilmSides p = MAKE(FilmSides)((film2 * cosine - inner) / (film2 * cosine + inner), sqrt(rho2), shift);

  vec3 sum_s = sumWithoutSpectrum(s, difference);
  vec3 sum_p = sumWithoutSpectrum(p, difference);
  for (int m = 1; m <= kSpectralOrders; ++m) {
    SpectrumMean mean = meanOverSpectrum(float(m) * difference);
    sum_s += spectralOrder(s, m, mean);
    sum_p += spectralOrder(p, m, mean);
  }
  return (reflectanceOfSum(s, sum_s) + reflectanceOfSum(p, sum_p)) / 2.0f;
}

// The real index of what reflects f0 at normal incidence, for a metal of which no more is known.
FN vec3 iorOfReflectance(vec3 f0) {
  vec3 amplitude = sqrt(clamp(f0, vec3(0.0f), vec3(0.9999f)));
  return (vec3(1.0f) + amplitude) / (vec3(1.0f) - amplitude);
}
