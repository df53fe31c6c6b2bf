#pragma once

#include <vector>

#include <glm/vec4.hpp>

#include "mirrorball/render/settings/frame_settings.h"

namespace mirrorball {

/// With isSpectral, the wavelengths that shaders/surface/dispersion_spectral.glsl refracts light of:
/// formula::kWavelengthSets sets, one after the other, of which neighbouring pixels have different ones. A set has one
/// wavelength in each of as many equal parts of what formula::sampleWavelength chooses from, so that it holds all
/// colours alike; the sets of a sample lie evenly between each other, and those of the next samples between them. So
/// colours run into each other without bands.
///
/// sample   number of the sample of the frame, from 0
/// returns  for each wavelength its share in red, green and blue, which in each set have the sum 1; its µm. With
///          FrameSettings::wavelength_nm, each set is that wavelength alone
std::vector<glm::vec4> wavelengthSets(const FrameSettings& settings, int sample);

/// Whether light is told apart by its wavelength, and not by its channels.
bool isSpectral(const FrameSettings& settings);

/// How many kinds of light go their own ways through what disperses.
int lightKindsOf(const FrameSettings& settings);

}  // namespace mirrorball
