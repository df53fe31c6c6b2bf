#include "mirrorball/scene/material/optical_constants.h"

#include <array>

#include "formula/bsdf.h"

namespace mirrorball {
namespace {

// Fraunhofer's lines [µm].
constexpr float kLineC = 0.6562725f;
constexpr float kLineD = 0.5875618f;
constexpr float kLineF = 0.4861327f;

// Johnson & Christy 1972, "Optical constants of the noble metals", Physical Review B 6; 1974, "Optical constants of
// transition metals", Physical Review B 9. Rakić 1995, "Algorithm for the determination of intrinsic optical
// constants of metal films: application to aluminum", Applied Optics 34. Rakić et al. 1998, "Optical properties of
// metallic films for vertical-cavity optoelectronic devices", Applied Optics 37, Brendel & Bormann's model. All as
// refractiveindex.info tabulates them.
constexpr auto kMetals = std::to_array<MeasuredMetal>({
    {"aluminium", {1.558f, 1.015f, 0.633f}, {7.712f, 6.627f, 5.454f}, "Rakić 1995"},
    {"chromium", {3.107f, 3.181f, 2.323f}, {3.331f, 3.329f, 3.135f}, "Johnson & Christy 1974"},
    {"copper", {0.238f, 1.007f, 1.240f}, {3.626f, 2.582f, 2.393f}, "Johnson & Christy 1972"},
    {"gold", {0.156f, 0.424f, 1.383f}, {3.602f, 2.472f, 1.916f}, "Johnson & Christy 1972"},
    {"iron", {2.911f, 2.950f, 2.584f}, {3.089f, 2.932f, 2.767f}, "Johnson & Christy 1974"},
    {"nickel", {1.990f, 1.921f, 1.729f}, {4.209f, 3.616f, 2.944f}, "Johnson & Christy 1974"},
    {"platinum", {2.376f, 2.085f, 1.845f}, {4.265f, 3.715f, 3.136f}, "Rakić et al. 1998"},
    {"silver", {0.052f, 0.060f, 0.040f}, {4.409f, 3.597f, 2.648f}, "Johnson & Christy 1972"},
    {"titanium", {2.741f, 2.542f, 2.267f}, {3.814f, 3.435f, 3.038f}, "Johnson & Christy 1974"},
    {"tungsten", {3.652f, 3.506f, 3.313f}, {2.795f, 2.758f, 2.605f}, "Rakić et al. 1998"},
});

// Schott's catalogue of optical glass: b1 to b3 and c1 to c3 of a data sheet. Malitson 1965, "Interspecimen
// comparison of the refractive index of fused silica", JOSA 55. Daimon & Masumura 2002, "High-accuracy measurements
// of the refractive index and its temperature coefficient of calcium fluoride …", Applied Optics 41, at 20 °C.
// Malitson & Dodge 1972, "Refractive index and birefringence of synthetic sapphire", JOSA 62: the ordinary ray. Peter
// 1923, "Über Brechungsindizes und Absorptionskonstanten des Diamanten zwischen 644 und 226 mµ", Zeitschrift für
// Physik 15. Daimon & Masumura 2007, "Measurement of the refractive index of distilled water from the near-infrared
// region to the ultraviolet region", Applied Optics 46, at 20 °C, against vacuum as the formula has it.
constexpr auto kGlasses = std::to_array<MeasuredGlass>({
    {"bk7",
     {1.03961212f, 0.231792344f, 1.01046945f, 0.0f},
     {0.00600069867f, 0.0200179144f, 103.560653f, 0.0f},
     "Schott, N-BK7"},
    {"f2",
     {1.34533359f, 0.209073176f, 0.937357162f, 0.0f},
     {0.00997743871f, 0.0470450767f, 111.886764f, 0.0f},
     "Schott, F2"},
    {"sf11",
     {1.73848403f, 0.311168974f, 1.17490871f, 0.0f},
     {0.0136068604f, 0.0615960463f, 121.922711f, 0.0f},
     "Schott, SF11"},
    {"fused-silica",
     {0.6961663f, 0.4079426f, 0.8974794f, 0.0f},
     {0.00467914826f, 0.0135120631f, 97.9340025f, 0.0f},
     "Malitson 1965"},
    {"fluorite",
     {0.443749998f, 0.444930066f, 0.150133991f, 8.85319946f},
     {0.00178027854f, 0.00788536061f, 0.0124119491f, 2752.28175f},
     "Daimon & Masumura 2002"},
    {"sapphire",
     {1.4313493f, 0.65054713f, 5.3414021f, 0.0f},
     {0.0052799261f, 0.0142382647f, 325.017834f, 0.0f},
     "Malitson & Dodge 1972"},
    {"diamond", {0.3306f, 4.3356f, 0.0f, 0.0f}, {0.030625f, 0.011236f, 0.0f, 0.0f}, "Peter 1923"},
    {"water",
     {0.5684027565f, 0.1726177391f, 0.02086189578f, 0.1130748688f},
     {0.005101829712f, 0.01821153936f, 0.02620722293f, 10.69792721f},
     "Daimon & Masumura 2007"},
});

float iorAt(const MeasuredGlass& glass, float wavelength) {
  return formula::iorOfSellmeier(glass.b, glass.c, wavelength);
}

}  // namespace

std::span<const MeasuredMetal> measuredMetals() { return kMetals; }

std::span<const MeasuredGlass> measuredGlasses() { return kGlasses; }

float iorOf(const MeasuredGlass& glass) { return iorAt(glass, kLineD); }

float abbeNumberOf(const MeasuredGlass& glass) {
  return (iorOf(glass) - 1.0f) / (iorAt(glass, kLineF) - iorAt(glass, kLineC));
}

}  // namespace mirrorball
