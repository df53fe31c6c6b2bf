// Of the built-in heights.

#include "parity/case_rows.h"

namespace mirrorball::parity {
namespace {

// Heights, whose slopes are counted in 64ths: the finest grains have 72 cells a unit, and slopes that change as fast
// show the rounding of the place.
const Case kCases[] = {
    // dual
    PARITY(dualOfFiner, unit, kExact, vec4(dualOfFiner(vec3(p), 8.0f), 0.0f)),
    PARITY(dualProduct, unit, kTight, vec4(dualProduct(vec3(p), vec3(q)), 0.0f)),
    PARITY(dualSmoothstep, unit, kTight,
           vec4(dualSmoothstep(r.x < 0.5f ? 0.25f : 0.75f, r.x < 0.5f ? 0.75f : 0.25f, vec3(p)), 0.0f)),
    PARITY(dualMaximum, unit, kTight, vec4(dualMaximum(vec3(p), vec3(q), 0.0625f + r.x), 0.0f)),

    // relief_noise
    PARITY(cellRandom, unit, kExact,
           vec4(cellRandom(ivec2(int(35.0f * p.x) - 12, int(23.0f * p.y) - 8), ivec2(12, 8), int(7.0f * r.x)), 0.0f)),
    PARITY(cornerPlane, unit, kTight,
           vec4(cornerPlane(ivec2(int(8.0f * p.x), int(8.0f * p.y)), vec2(q), 8, int(7.0f * r.x)), 0.0f)),
    PARITY(reliefNoise, unit, kTight, vec4(reliefNoise(8.0f * vec2(p), 8, int(7.0f * r.x)), 0.0f)),
    PARITY(scatteredPoint, unit, kTight,
           vec4(scatteredPoint(8.0f * vec2(p), int(3.9375f * r.x), r.y < 0.5f ? 2 : 3, r.z, 8, 1), 0.0f)),

    // orange_skin
    PARITY(poresHeight, unit, kTight, vec4(poresHeight(8.0f * vec2(p), 8, 1), 0.0f)),
    PARITY(orangeSkinHeight, unit, kTranscendental,
           vec4(orangeSkinHeight(vec2(p)) * vec3(0.015625f, 0.015625f, 1.0f), 0.0f)),

    // brick
    PARITY(brickHeight, unit, kTranscendental, vec4(brickHeight(vec2(p)) * vec3(0.015625f, 0.015625f, 1.0f), 0.0f)),

    // cobbles
    PARITY(cobblesHeight, unit, kTranscendental, vec4(cobblesHeight(vec2(p)) * vec3(0.015625f, 0.015625f, 1.0f), 0.0f)),

    // weave
    PARITY(strandHeight, unit, kTranscendental,
           vec4(strandHeight(p.x - 0.5f, 8.0f * p.y, r.x < 0.5f ? -1.0f : 1.0f) * vec3(0.125f, 0.125f, 1.0f), 0.0f)),
    PARITY(weaveHeight, unit, kTranscendental, vec4(weaveHeight(vec2(p)) * vec3(0.015625f, 0.015625f, 1.0f), 0.0f)),

    // hammered
    PARITY(hammeredHeight, unit, kTranscendental,
           vec4(hammeredHeight(vec2(p)) * vec3(0.015625f, 0.015625f, 1.0f), 0.0f)),

    // waves
    PARITY(waveNumber, unit, kExact, waveNumber(int(14.9375f * r.x))),
    PARITY(wavesHeight, unit, kTranscendental, vec4(wavesHeight(vec2(p)) * vec3(0.015625f, 0.015625f, 1.0f), 0.0f)),

    // builtin_height, of tiles around the first
    PARITY(builtinHeight, unit, kTranscendental,
           vec4(builtinHeight(int(7.9375f * r.x), 4.0f * vec2(q) - 2.0f) * vec3(0.015625f, 0.015625f, 1.0f), 0.0f)),
};

}  // namespace

std::span<const Case> reliefCases() { return kCases; }

}  // namespace mirrorball::parity
