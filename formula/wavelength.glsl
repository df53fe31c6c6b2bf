// Light of one wavelength, and what it counts for in the red, green and blue of a picture.
// Needs: color. Wavelengths are in µm.

// Two halves of a bell, one on either side of its middle.
FN float unevenBell(float x, float middle, float below, float above) {
  float t = (x - middle) / (x < middle ? below : above);
  return exp(-0.5f * t * t);
}

// The CIE's colour matching functions of 1931 (Wyman, Sloan & Shirley 2013, "Simple analytic approximations to the CIE
// XYZ color matching functions", multi-lobe fit).
FN vec3 xyzOfWavelength(float wavelength) {
  float nm = 1000.0f * wavelength;
  return vec3(1.056f * unevenBell(nm, 599.8f, 37.9f, 31.0f) + 0.362f * unevenBell(nm, 442.0f, 16.0f, 26.7f) -
                  0.065f * unevenBell(nm, 501.1f, 20.4f, 26.2f),
              0.821f * unevenBell(nm, 568.8f, 46.9f, 40.5f) + 0.286f * unevenBell(nm, 530.9f, 16.3f, 31.1f),
              1.217f * unevenBell(nm, 437.0f, 11.8f, 36.0f) + 0.681f * unevenBell(nm, 459.0f, 26.0f, 13.8f));
}

const float kShortestWavelength = 0.36f;
const float kLongestWavelength = 0.83f;

// What a wavelength counts for in red, green and blue (Rec.709): 1 in the mean over all wavelengths, so that light
// which is not dispersed stays as it is. Pure colours lie outside of Rec.709, so that some weights are negative.
FN vec3 wavelengthWeight(float wavelength) {
  const vec3 mean = vec3(0.2730535f, 0.2160506f, 0.2066317f);  // of the fit, from the shortest to the longest
  return rec709FromXyz(xyzOfWavelength(wavelength)) / mean;
}

// Chooses a wavelength about as often as eyes see it, by a density of 1 / cosh² (Radziszewski, Boryczko & Alda 2009,
// "An improved technique for full spectral rendering").
FN float sampleWavelength(float u) { return 0.538f - atanh(0.85691062f - 1.82750197f * u) / 7.2f; }

// Its density [1/µm].
FN float pdfWavelength(float wavelength) {
  float c = cosh(7.2f * (wavelength - 0.538f));
  return 7.2f / 1.82750197f / (c * c);
}

// What light of a wavelength counts for that has been chosen so: 1 in the mean over all choices.
FN vec3 shareOfWavelength(float wavelength) {
  return wavelengthWeight(wavelength) / ((kLongestWavelength - kShortestWavelength) * pdfWavelength(wavelength));
}

// The most wavelengths that a pixel is drawn of at a time, and how many sets of them its neighbours have.
const int kMostWavelengths = 16;
const int kWavelengthSets = 16;

// Which set a pixel has: Bayer's matrix of 4 × 4 (Bayer 1973, "An optimum method for two-level rendition of
// continuous-tone pictures"), by which pixels side by side are as different as they can be.
FN int wavelengthSetOfPixel(int x, int y) {
  int differs = x ^ y;
  return ((differs & 1) << 3) | ((y & 1) << 2) | (differs & 2) | ((y >> 1) & 1);
}
