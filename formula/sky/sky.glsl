// The light of a clear sky: molecules and haze scatter the sun's light, and ozone takes some of its orange away.
// Heights and lengths are in km, heights above the ground; wavelengths in µm; cosines are those of the angle to the
// zenith, at the place in question. Needs: constants.

const float kEarthRadius = 6360.0f;
const float kTopOfAir = 100.0f;
// Over so many km molecules and haze become thinner by e (Nishita et al. 1993, "Display of the earth taking into
// account atmospheric scattering").
const float kMoleculeScale = 8.0f;
const float kHazeScale = 1.2f;
// Of clean air over land: how much of the light that haze stops it scatters, and its asymmetry (Hess, Koepke & Schult
// 1998, "Optical properties of aerosols and clouds", table 4, 0.55 µm).
const float kHazeAlbedo = 0.972f;
const float kHazeAsymmetry = 0.709f;

// The optical depth of all air above the ground: of its molecules (Hansen & Travis 1974, "Light scattering in planetary
// atmospheres"),
FN float moleculeDepth(float wavelength) {
  float w2 = 1.0f / (wavelength * wavelength);
  return 0.008569f * w2 * w2 * (1.0f + w2 * (0.0113f + 0.00013f * w2));
}

// of its haze: Ångström's formula, the coefficient from the turbidity (Preetham, Shirley & Smits 1999, "A practical
// analytic model for daylight", appendix A.1),
FN float hazeDepth(float wavelength, float turbidity) {
  return (0.04608f * turbidity - 0.04586f) * exp(-1.3f * log(wavelength));
}

// and of 300 Dobson units of ozone, 8.07e22 molecules above a square metre. A Gaussian stands for the Chappuis band,
// whose cross section is about 4.9e-25 m² at its height.
FN float ozoneDepth(float wavelength) {
  float x = (wavelength - 0.592f) / 0.050f;
  return 0.0395f * exp(-0.5f * x * x);
}

// The share of the ozone's column that is in a kilometre of height: a tent around 25 km.
FN float ozoneDensity(float height) { return max(1.0f - abs(height - 25.0f) / 15.0f, 0.0f) / 15.0f; }

// The height of a point of a ray that begins at `height`.
FN float heightAlong(float height, float cosine, float distance) {
  float from = kEarthRadius + height;
  // Of the root's difference from `from`, not of the root, which has no digits left for it.
  float change = distance * (distance + 2.0f * from * cosine);
  return height + change / (sqrt(from * from + change) + from);
}

// How far a ray goes until it leaves the air.
FN float distanceToTop(float height, float cosine) {
  float along = (kEarthRadius + height) * cosine;
  float rise = (kTopOfAir - height) * (2.0f * kEarthRadius + kTopOfAir + height);
  return sqrt(along * along + rise) - along;
}

// How far it goes until it meets the ground; -1 where it does not.
FN float distanceToGround(float height, float cosine) {
  float along = (kEarthRadius + height) * cosine;
  float fall = height * (2.0f * kEarthRadius + height);
  float rest = along * along - fall;
  if (cosine >= 0.0f || rest < 0.0f) return -1.0f;
  return fall / (sqrt(rest) - along);
}

// e^(y²) erfc(y) for y ≥ 0, within 0.2 % (Smith & Smith 1972, "Numerical evaluation of Chapman's grazing incidence
// integral ch(X, χ)").
FN float scaledErfc(float y) {
  if (y > 8.0f) return 0.56498823f / (0.06651874f + y);
  return (1.0606963f + 0.55643831f * y) / (1.0619896f + y * (1.7245609f + y));
}

// How many times more air that thins out exponentially lies in a direction than above: Chapman's function,
// after the same.
FN float airMass(float height, float cosine, float scale) {
  float x = (kEarthRadius + height) / scale;
  float level = sqrt(0.5f * kPi * x);
  float up = level * scaledErfc(sqrt(0.5f * x) * abs(cosine));
  if (cosine >= 0.0f) return up;
  // A ray that descends first: both halves of the one through its lowest point, without what is behind.
  float sine = sqrt(max(1.0f - cosine * cosine, 0.0f));
  float descent = x * cosine * cosine / (1.0f + sine);  // x (1 − sine)
  return 2.0f * level * sqrt(sine) * exp(min(descent, 60.0f)) - up;
}

// The ozone that light from the edge of the air meets on its way, in columns of all that is above the ground:
// a thin shell.
FN float ozoneColumn(float height, float cosine) {
  float share = clamp(0.5f - (height - 25.0f) / 30.0f, 0.0f, 1.0f);
  float r = (kEarthRadius + min(height, 25.0f)) / (kEarthRadius + 25.0f);
  return share / sqrt(max(1.0f - (1.0f - cosine * cosine) * r * r, 1e-4f));
}

// The molecules, haze and ozone between a place and the edge of the air, in columns of all that is above the ground.
FN vec3 columnsTowardsSun(float height, float cosine) {
  return vec3(exp(-height / kMoleculeScale) * airMass(height, cosine, kMoleculeScale),
              exp(-height / kHazeScale) * airMass(height, cosine, kHazeScale), ozoneColumn(height, cosine));
}

// How much of the sun stands above the horizon of a place at that height.
FN float sunAboveHorizon(float height, float cosine) {
  float r = kEarthRadius / (kEarthRadius + height);
  float horizon = -sqrt(max(1.0f - r * r, 0.0f));
  return clamp((cosine - horizon) / 0.0093f + 0.5f, 0.0f, 1.0f);
}

// What molecules and haze send on, by the cosine of the angle by which light turns;
// the integral over all directions is 1.
FN float moleculePhase(float cosine) { return 3.0f / (16.0f * kPi) * (1.0f + cosine * cosine); }

// Henyey & Greenstein 1941.
FN float hazePhase(float cosine) {
  const float g = kHazeAsymmetry;
  float x = 1.0f + g * g - 2.0f * g * cosine;
  return (1.0f - g * g) / (4.0f * kPi * x * sqrt(x));
}

// The sun's light outside of the air, up to a factor: Planck's law at 5778 K.
FN float sunSpectrum(float wavelength) {
  float w = wavelength;
  return 1.0f / (w * w * w * w * w * (exp(2.490095f / w) - 1.0f));
}

// What was white under D55, daylight film's light, is white under D65, a display's (Bradford's transform; Lindbloom,
// "Chromatic adaptation").
FN vec3 xyzD65FromD55(vec3 xyz) {
  return vec3(0.9726856f * xyz.x - 0.0135482f * xyz.y + 0.0361731f * xyz.z,
              -0.0167463f * xyz.x + 1.0049102f * xyz.y + 0.0120598f * xyz.z,
              0.0070026f * xyz.x - 0.0116372f * xyz.y + 1.1869548f * xyz.z);
}
