// Of the built-in heights, and of what rays meet of heights.

#include "parity/case_rows.h"

namespace mirrorball::parity {
namespace {

// Heights, whose slopes are counted in 64ths: the finest grains have 72 cells a unit, and slopes that change as fast
// show the rounding of the place.
const Case kReliefCases[] = {
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

    // height_map
    PARITY(placeOnMap, unit, kTight, vec4(placeOnMap(vec2(p), vec2(32.0f, 16.0f)), 0.0f, 0.0f)),
    PARITY(heightTexel, unit, kTight,
           vec4(heightTexel(MAKE(SmoothMap)(32.0f), MAKE(HeightMap)(vec2(32.0f, 16.0f), kWrapRepeat, 5),
                            floor(90.0f * vec2(p) - 40.0f)),
                0.0f, 0.0f)),
    PARITY(patchCorners, unit, kTight,
           patchCorners(MAKE(SmoothMap)(32.0f), MAKE(HeightMap)(vec2(32.0f, 16.0f), kWrapClampToEdge, 5),
                        floor(90.0f * vec2(p) - 40.0f))),
    PARITY(heightOfPatch, unit, kTight, vec4(heightOfPatch(p, vec2(q)))),
    PARITY(heightAt, unit, kTight,
           vec4(heightAt(MAKE(SmoothMap)(32.0f), MAKE(HeightMap)(vec2(32.0f, 16.0f), kWrapRepeat, 5),
                         29.3f * vec2(p) + 0.1f))),

    PARITY(sizeOfLevel, unit, kExact,
           vec4(vec2(sizeOfLevel(MAKE(HeightMap)(vec2(13.0f, 7.0f), 0, 3), int(3.9375f * p.x))), 0.0f, 0.0f)),
    PARITY(placeOfLevel, unit, kExact,
           vec4(vec2(placeOfLevel(MAKE(HeightMap)(q.x < 0.5f ? vec2(13.0f, 7.0f) : vec2(7.0f, 13.0f), 0, 3),
                                  int(3.9375f * p.x))),
                0.0f, 0.0f)),

    // exact_search
    PARITY(hitOfPatch, unit, kTight,
           vec4(hitOfPatch(0.5f * p, vec3(q.x, q.y, 0.75f + q.z), vec3(r.x, r.y, -0.25f - r.z), true))),
    PARITY(heightCellAt, unit, kTight,
           vec4(heightCellAt(MAKE(SmoothMap)(32.0f), MAKE(HeightMap)(vec2(32.0f, 16.0f), kWrapRepeat, 5),
                             90.0f * vec2(p) - 40.3f, 3)
                    .low,
                heightCellAt(MAKE(SmoothMap)(32.0f), MAKE(HeightMap)(vec2(32.0f, 16.0f), kWrapRepeat, 5),
                             90.0f * vec2(p) - 40.3f, 3)
                    .high)),
    PARITY(shareAtEdge, unit, kTight,
           vec4(shareAtEdge(vec2(p), vec2(q) - 0.45f, MAKE(HeightCell)(vec2(-0.25f), vec2(1.25f), 0.0f)))),
    PARITY(exactSearch, unit, kTight,
           vec4(exactSearch(MAKE(SmoothMap)(32.0f), MAKE(HeightMap)(vec2(32.0f, 16.0f), kWrapClampToEdge, 0),
                            vec3(31.0f * p.x, 15.0f * p.y, 1.25f), vec3(31.0f * q.x, 15.0f * q.y, -0.25f), false))),

    PARITY(slopeOfPatch, unit, kTight, vec4(slopeOfPatch(p, vec2(q)), 0.0f, 0.0f)),

    // horizon
    PARITY(horizonSlope, unit, kExact, vec4(horizonSlope(MAKE(Horizons)(p, q), int(7.9375f * r.x)))),
    PARITY(alongAzimuth, unit, kTranscendental, vec4(alongAzimuth(testGround(p), int(7.9375f * r.x)), 0.0f)),
    PARITY(sliceAbove, unit, kTranscendental,
           vec4(sliceAbove(testGround(p), normalize(vec3(0.5f * q.x, 0.5f * r.y, 1.0f)), vec3(0.6f, -0.8f, 0.0f), 0.75f,
                           4.0f * q.z - 2.0f)
                    .direction,
                sliceAbove(testGround(p), normalize(vec3(0.5f * q.x, 0.5f * r.y, 1.0f)), vec3(0.6f, -0.8f, 0.0f), 0.75f,
                           4.0f * q.z - 2.0f)
                    .share)),
    PARITY(slicesOfSky, unit, kTranscendental,
           vec4(slicesOfSky(testGround(p), MAKE(Horizons)(q, r), normalize(vec3(0.5f * q.x, 0.5f * r.y, 1.0f)),
                            int(7.9375f * r.w))
                    .visible.direction,
                slicesOfSky(testGround(p), MAKE(Horizons)(q, r), normalize(vec3(0.5f * q.x, 0.5f * r.y, 1.0f)),
                            int(7.9375f * r.w))
                    .visible.share)),
    PARITY(slopeTowards, unit, kTranscendental,
           vec4(slopeTowards(MAKE(Horizons)(q, r), vec2(p) - vec2(0.43f, 0.57f), 0.5f))),
    PARITY(lobeOverHorizons, unit, kTranscendental,
           vec4(lobeOverHorizons(testGround(p), MAKE(Horizons)(q, r), vec3(0.0f, 0.0f, 1.0f),
                                 normalize(vec3(q.x - 0.43f, r.y - 0.57f, 0.25f + p.z)), r.z))),

    // relief_search, over a ramp
    PARITY(depthAt, unit, kTight,
           vec4(depthAt(MAKE(SmoothMap)(32.0f), MAKE(HeightMap)(vec2(32.0f, 16.0f), kWrapClampToEdge, 5),
                        MAKE(ReliefRay)(20.0f * vec2(p), vec2(q)), r.x))),
    PARITY(parallaxDepth, unit, kTight,
           vec4(parallaxDepth(MAKE(SmoothMap)(32.0f), MAKE(HeightMap)(vec2(32.0f, 16.0f), kWrapClampToEdge, 5),
                              MAKE(ReliefRay)(20.0f * vec2(p), vec2(q)), r.x))),
    PARITY(firstStepBelow, unit, kTight,
           vec4(firstStepBelow(MAKE(SmoothMap)(32.0f), MAKE(HeightMap)(vec2(32.0f, 16.0f), kWrapClampToEdge, 5),
                               MAKE(ReliefRay)(20.0f * vec2(p), 8.0f * vec2(q) + 0.37f), 13)
                    .depth_below)),
    PARITY(steepDepth, unit, kTight,
           vec4(steepDepth(MAKE(SmoothMap)(32.0f), MAKE(HeightMap)(vec2(32.0f, 16.0f), kWrapClampToEdge, 5),
                           MAKE(ReliefRay)(20.0f * vec2(p), 8.0f * vec2(q) + 0.37f), 13))),
    PARITY(occlusionDepth, unit, kTight,
           vec4(occlusionDepth(MAKE(SmoothMap)(32.0f), MAKE(HeightMap)(vec2(32.0f, 16.0f), kWrapClampToEdge, 5),
                               MAKE(ReliefRay)(20.0f * vec2(p), 8.0f * vec2(q) + 0.37f), 13))),
    PARITY(binaryDepth, unit, kTight,
           vec4(binaryDepth(MAKE(SmoothMap)(32.0f), MAKE(HeightMap)(vec2(32.0f, 16.0f), kWrapClampToEdge, 5),
                            MAKE(ReliefRay)(20.0f * vec2(p), 8.0f * vec2(q) + 0.37f), 13))),
    PARITY(heightAndCone, unit, kTight,
           vec4(heightAndCone(MAKE(SmoothMap)(32.0f), MAKE(HeightMap)(vec2(32.0f, 16.0f), kWrapClampToEdge, 5),
                              20.0f * vec2(p)),
                0.0f, 0.0f)),
    PARITY(coneDepth, unit, kTight,
           vec4(coneDepth(MAKE(SmoothMap)(32.0f), MAKE(HeightMap)(vec2(32.0f, 16.0f), kWrapClampToEdge, 5),
                          MAKE(ReliefRay)(20.0f * vec2(p), vec2(q)), 3))),

    // relief_prism
    PARITY(placeInPrism, unit, kTight, vec4(placeInPrism(testPrism(p), vec3(q)), 0.0f)),
    PARITY(coordinatesInPrism, unit, kTight,
           vec4(coordinatesInPrism(testPrism(p), placeInPrism(testPrism(p), vec3(q)), vec3(0.5f)), 0.0f)),
    PARITY(slabOfPrism, unit, kTight, vec4(slabOfPrism(testPrism(p)), 0.0f, 0.0f)),
    PARITY(clippedWay, unit, kTight,
           vec4(clippedWay(MAKE(WayInPrism)(0.125f, 0.875f, false), 2.0f * p.x - 0.97f, 2.0f * q.x - 0.97f, true).first,
                clippedWay(MAKE(WayInPrism)(0.125f, 0.875f, false), 2.0f * p.x - 0.97f, 2.0f * q.x - 0.97f, true).last,
                0.0f, 0.0f)),
    PARITY(wayInPrism, unit, kTight,
           vec4(wayInPrism(testPrism(p), 1.5f * vec3(q) - 0.23f, 1.5f * vec3(r) - 0.21f, false).first)),
    PARITY(piecesOfRay, unit, kTight, vec4(piecesOfRay(testPrism(p)))),
    PARITY(onHeightMap, unit, kTight, vec4(onHeightMap(testPrism(p), vec3(q)), 0.0f)),
    PARITY(onBentRay, unit, kTranscendental,
           vec4(onBentRay(MAKE(SmoothMap)(32.0f), MAKE(HeightMap)(vec2(32.0f, 16.0f), kWrapClampToEdge, 0),
                          testPrism(p), vec3(0.2f + 0.3f * q.x, 0.2f + 0.3f * q.y, 1.0f), vec3(0.0f, 0.0f, -1.0f),
                          MAKE(ReliefHit)(1.25f, vec3(0.3f, 0.3f, 0.5f)), vec3(0.0f, 0.0f, -2.0f))
                    .distance)),
    PARITY(hitOfPrism, unit, kTranscendental,
           vec4(hitOfPrism(MAKE(SmoothMap)(32.0f), MAKE(HeightMap)(vec2(32.0f, 16.0f), kWrapClampToEdge, 0),
                           testPrism(p), vec3(0.2f + 0.3f * q.x, 0.2f + 0.3f * q.y, 1.0f),
                           normalize(vec3(0.2f * r.x - 0.1f, 0.2f * r.y - 0.1f, -1.0f)), 0.5f, 2.0f)
                    .distance)),
    PARITY(boxOfPrism, unit, kTight, vec4(boxOfPrism(testPrism(p)).high, boxOfPrism(testPrism(p)).low.x)),
    PARITY(wayThroughPrismBox, unit, kTight,
           vec4(wayThroughPrismBox(boxOfPrism(testPrism(p)), vec3(q) + vec3(0.0f, 0.0f, 2.0f),
                                   normalize(vec3(r.x - 0.47f, r.y - 0.47f, -1.0f))),
                0.0f, 0.0f)),
};

}  // namespace

std::span<const Case> reliefCases() { return kReliefCases; }

}  // namespace mirrorball::parity
