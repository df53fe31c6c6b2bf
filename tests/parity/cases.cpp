// Of light: projections, prefiltering, colour, sky.

#include <vector>

#include "parity/case_rows.h"

namespace mirrorball::parity {
namespace {

const Case kCases[] = {
    // blur
    PARITY(chainLight, direction, kTight,
           chainLight(MAKE(Blur)(0, 1.0f, 6.0f, 32.0f), MAKE(SmoothCube)(3.0f), vec3(p), r.x, 4.0f * r.y)),
    PARITY(prefilteredLight, direction, kTight,
           prefilteredLight(MAKE(Blur)(0, 1.0f, 6.0f, 32.0f), MAKE(SmoothCube)(2.0f), MAKE(SmoothCube)(3.0f), vec3(p),
                            r.x, 4.0f * r.y)),
    PARITY(roughnessOverPatch, unit, kTight, vec4(roughnessOverPatch(p.x, 0.1f * p.y), 0.0f, 0.0f, 0.0f)),
    PARITY(coneRay, unit, kTranscendental, vec4(coneRay(0.0625f + p.x, int(63.9375f * p.y), 64), 0.0f)),
    // The sum of 64 rays in a cube that is as bright as its direction.
    PARITY(coneLight, direction, kTranscendental, coneLight(MAKE(SmoothCube)(2.0f), vec3(p), 0.25f + 0.5f * r.x, r.y)),
    PARITY(blurredLight, direction, kTranscendental,
           blurredLight(MAKE(Blur)(int(1.9375f * r.w), 1.0f, 6.0f, 32.0f), MAKE(SmoothCube)(2.0f),
                        MAKE(SmoothCube)(3.0f), vec3(p), r.x, 4.0f * r.y)),

    // box
    PARITY(wayThroughBox, direction, kTight,
           vec4(wayThroughBox(vec3(-0.5f), vec3(0.25f), vec3(q), normalize(vec3(p) + vec3(3.0f))), 0.0f, 0.0f)),

    // bright_light
    PARITY(brightness, light, kExact, vec4(brightness(vec3(p)), 0.0f, 0.0f, 0.0f)),
    // The difference of two nearly equal lights.
    PARITY(lightAbove, light, kTranscendental, vec4(lightAbove(vec3(p), q.x), 0.0f)),
    PARITY(thresholdsExceeded, light, kExact, thresholdsExceeded(vec3(p), q)),
    PARITY(firstWithin, light, kExact, vec4(float(firstWithin(p, 64.0f)), 0.0f, 0.0f, 0.0f)),
    PARITY(coarseThresholds, light, kExact, coarseThresholds(p.x)),
    PARITY(fineThresholds, light, kTight, fineThresholds(coarseThresholds(0.125f), p, 64.0f)),

    // color
    PARITY(linearFromSrgb1, unit, kTranscendental, vec4(linearFromSrgb1(p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(srgbFromLinear1, unit, kTranscendental, vec4(srgbFromLinear1(p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(linearFromSrgb, unit, kTranscendental, vec4(linearFromSrgb(vec3(p)), 0.0f)),
    PARITY(srgbFromLinear, light, kTranscendental, vec4(srgbFromLinear(vec3(p)), 0.0f)),
    PARITY(luminance, light, kTight, vec4(luminance(vec3(p)), 0.0f, 0.0f, 0.0f)),
    PARITY(rec709FromXyz, light, kTight, vec4(rec709FromXyz(vec3(p)), 0.0f)),
    PARITY(toneMapLinear, light, kExact, vec4(toneMapLinear(vec3(p)), 0.0f)),
    PARITY(toneMapReinhard, light, kTight, vec4(toneMapReinhard(vec3(p)), 0.0f)),
    PARITY(toneMapAces, light, kTight, vec4(toneMapAces(vec3(p)), 0.0f)),
    PARITY(toneMapNeutral, light, kTight, vec4(toneMapNeutral(vec3(p)), 0.0f)),
    PARITY(agxContrast, unit, kTight, vec4(agxContrast(p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(agxEncoded, light, kTranscendental, vec4(agxEncoded(p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(toneMapAgx, light, kTranscendental, vec4(toneMapAgx(vec3(p)), 0.0f)),
    PARITY(toneMap, light, kTranscendental, vec4(toneMap(int(4.9375f * r.x), vec3(p)), 0.0f)),
    PARITY(displayLight, light, kTranscendental, displayLight(vec4(vec3(p), r.y), 0.25f + r.z, int(4.9375f * r.x))),
    PARITY(laidOver, unit, kTight, laidOver(p, q)),
    PARITY(encodedPicture, unit, kTranscendental, encodedPicture(vec4(vec3(p) * r.y, r.y))),
    PARITY(displayed, light, kTranscendental, displayed(vec4(vec3(p), r.y), 0.25f + r.z, int(4.9375f * r.x))),

    // dither
    PARITY(ditherLevel, unit, kExact,
           vec4(float(ditherLevel(ivec2(int(4096.0f * p.x), int(2048.0f * p.y)))), 0.0f, 0.0f, 0.0f)),
    PARITY(ditherThreshold, unit, kExact, vec4(ditherThreshold(int(63.9375f * p.x)), 0.0f, 0.0f, 0.0f)),
    PARITY(dithered, unit, kExact, vec4(dithered(vec3(q), ivec2(int(4096.0f * p.x), int(2048.0f * p.y))), 0.0f)),

    // cube
    PARITY(cubeFace, direction, kExact, vec4(float(cubeFace(vec3(p))), 0.0f, 0.0f, 0.0f)),
    PARITY(cubeProjected, direction, kExact, vec4(cubeProjected(int(5.9375f * r.x), vec3(p)), 0.0f)),
    PARITY(cubeCoordinates, direction, kTight, vec4(cubeCoordinates(cubeFace(vec3(p)), vec3(p)), 0.0f, 0.0f)),
    PARITY(cubePoint, unit, kExact, vec4(cubePoint(int(5.9375f * r.x), vec2(p)), 0.0f)),
    PARITY(cubeDirection, unit, kTight, vec4(cubeDirection(int(5.9375f * r.x), vec2(p)), 0.0f)),
    PARITY(cubeCornerSolidAngle, unit, kTranscendental,
           vec4(cubeCornerSolidAngle(2.0f * p.x - 1.0f, 2.0f * p.y - 1.0f), 0.0f, 0.0f, 0.0f)),
    PARITY(cubeRectangleSolidAngle, unit, kTranscendental,
           vec4(cubeRectangleSolidAngle(p.x - 1.0f, p.y - 1.0f, p.z, p.w), 0.0f, 0.0f, 0.0f)),
    PARITY(cubeTexelSolidAngle, unit, kTight,
           vec4(cubeTexelSolidAngle(vec2(p), 4.0f + 1024.0f * r.x), 0.0f, 0.0f, 0.0f)),
    PARITY(cubeTangent, direction, kTight, vec4(cubeTangent(cubeFace(vec3(p)), vec3(p)), 0.0f)),

    // equiangular_cube
    PARITY(equiangular, unit, kTranscendental, vec4(equiangular(2.0f * p.x - 1.0f), 0.0f, 0.0f, 0.0f)),
    PARITY(equiangularCubeCoordinates, direction, kTranscendental,
           vec4(equiangularCubeCoordinates(cubeFace(vec3(p)), vec3(p)), 0.0f, 0.0f)),
    PARITY(equiangularCubePoint, unit, kTranscendental, vec4(equiangularCubePoint(int(5.9375f * r.x), vec2(p)), 0.0f)),
    PARITY(equiangularCubeDirection, unit, kTranscendental,
           vec4(equiangularCubeDirection(int(5.9375f * r.x), vec2(p)), 0.0f)),

    // harmonics
    PARITY(harmonicOfBand3, direction, kTight,
           vec4(harmonicOfBand3(9 + int(6.9375f * r.x), vec3(p)), 0.0f, 0.0f, 0.0f)),
    PARITY(harmonicOfBand4, direction, kTight,
           vec4(harmonicOfBand4(16 + int(8.9375f * r.x), vec3(p)), 0.0f, 0.0f, 0.0f)),
    PARITY(harmonic, direction, kTight, vec4(harmonic(int(24.9375f * r.x), vec3(p)), 0.0f, 0.0f, 0.0f)),
    PARITY(cosineLobeBand, unit, kTight, vec4(cosineLobeBand(int(4.9375f * r.x)), 0.0f, 0.0f, 0.0f)),
    PARITY(harmonicWindow, unit, kTranscendental, vec4(harmonicWindow(int(4.9375f * r.x), 4), 0.0f, 0.0f, 0.0f)),

    // grid_random
    PARITY(gridRandom, unit, kExact, vec4(gridRandom(ivec3(vec3(p) * 2048.0f - 1024.0f)), 0.0f)),

    // mip_mapping
    PARITY(lodOfRoughness, unit, kTight, vec4(lodOfRoughness(p.x, 8.0f * p.y), 0.0f, 0.0f, 0.0f)),
    PARITY(roughnessOfLod, unit, kTight, vec4(roughnessOfLod(8.0f * p.x, 8.0f), 0.0f, 0.0f, 0.0f)),

    // mip_taps
    PARITY(lodOfFootprint, direction, kTranscendental, vec4(lodOfFootprint(8.0f * r.x, vec3(p)), 0.0f, 0.0f, 0.0f)),
    PARITY(tapDirection, direction, kTight, vec4(tapDirection(vec3(p), vec3(q), vec3(r), vec2(r) * 0.7f), 0.0f)),

    // mirror_ball
    // Newton's steps forgive their own rounding; k up to 0.97.
    PARITY(mirrorBallPosition, direction, kTight, vec4(mirrorBallPosition(vec3(p), 0.96875f * r.x), 0.0f, 0.0f)),
    PARITY(mirrorBallDirection, unit, kTight, vec4(mirrorBallDirection(vec2(p), 0.96875f * r.x), 0.0f)),
    PARITY(mirrorBallCovers, direction, kExact, vec4(float(mirrorBallCovers(vec3(p), r.x)), 0.0f, 0.0f, 0.0f)),
    PARITY(mirrorBallBlindSolidAngle, unit, kTight, vec4(mirrorBallBlindSolidAngle(p.x), 0.0f, 0.0f, 0.0f)),

    // octahedral
    PARITY(octahedralSide, direction, kExact, vec4(octahedralSide(vec2(p)), 0.0f, 0.0f)),
    PARITY(octahedralFolded, direction, kExact, vec4(octahedralFolded(vec2(p)), 0.0f, 0.0f)),
    PARITY(octahedralPosition, direction, kTight, vec4(octahedralPosition(vec3(p)), 0.0f, 0.0f)),
    PARITY(octahedralPoint, unit, kTight, vec4(octahedralPoint(vec2(p)), 0.0f)),
    PARITY(octahedralDirection, unit, kTight, vec4(octahedralDirection(vec2(p)), 0.0f)),
    PARITY(hemioctahedralPosition, direction, kTight, vec4(hemioctahedralPosition(vec3(p)), 0.0f, 0.0f)),
    PARITY(hemioctahedralDirection, unit, kTight, vec4(hemioctahedralDirection(vec2(p)), 0.0f)),
    PARITY(equalAreaPosition, direction, kTranscendental, vec4(equalAreaPosition(vec3(p)), 0.0f, 0.0f)),
    PARITY(equalAreaDirection, unit, kTranscendental, vec4(equalAreaDirection(vec2(p)), 0.0f)),

    // paraboloid
    PARITY(paraboloidFace, direction, kExact, vec4(float(paraboloidFace(vec3(p))), 0.0f, 0.0f, 0.0f)),
    PARITY(paraboloidPosition, direction, kTight,
           vec4(paraboloidPosition(paraboloidFace(vec3(p)), vec3(p)), 0.0f, 0.0f)),
    PARITY(paraboloidDirection, unit, kTight, vec4(paraboloidDirection(int(1.9375f * r.x), vec2(p)), 0.0f)),

    // projection
    // u as a point of the circle: next to u = 0 the last bit decides between 0 and 1.
    PARITY(equirectPosition, direction, kTranscendental,
           vec4(cos(kTwoPi* equirectPosition(vec3(p)).x), sin(kTwoPi* equirectPosition(vec3(p)).x),
                equirectPosition(vec3(p)).y, 0.0f)),
    PARITY(equirectDirection, unit, kTranscendental, vec4(equirectDirection(vec2(p)), 0.0f)),
    PARITY(equirectTexelSolidAngle, unit, kTranscendental,
           vec4(equirectTexelSolidAngle(p.x, p.y, 4.0f), 0.0f, 0.0f, 0.0f)),
    PARITY(angularPosition, direction, kTranscendental, vec4(angularPosition(vec3(p)), 0.0f, 0.0f)),
    PARITY(angularDirection, unit, kTranscendental, vec4(angularDirection(vec2(p)), 0.0f)),
    PARITY(insideDisc, unit, kExact, vec4(float(insideDisc(vec2(p))), 0.0f, 0.0f, 0.0f)),

    // glossy_ground
    PARITY(aboveGround, direction, kExact, vec4(aboveGround(vec3(p)), 0.0f)),
    PARITY(mirroredByGround, unit, kTranscendental,
           vec4(mirroredByGround(normalize(vec3(p.x, -0.1f - p.y, p.z)), 0.1f + 0.5f * q.z, vec2(q)), 0.0f)),
    PARITY(shareMirroredByGround, unit, kTranscendental,
           vec4(shareMirroredByGround(normalize(vec3(p.x, -0.1f - p.y, p.z)), normalize(vec3(q.x, 0.1f + q.y, q.z)),
                                      r.x))),
    PARITY(solidAngleMirroredByGround, unit, kTranscendental,
           vec4(solidAngleMirroredByGround(normalize(vec3(p.x, -0.1f - p.y, p.z)),
                                           normalize(vec3(q.x, 0.1f + q.y, q.z)), 0.25f + r.x, 64.0f))),
    // The map's depth grows from the left to the right.
    PARITY(isBehindPicture, unit, kExact,
           vec4(float(isBehindPicture(MAKE(SmoothMap)(64.0f), vec3(64.0f * p.x, 32.0f * p.y, q.x))), 0.0f, 0.0f, 0.0f)),
    PARITY(hitInMirrorPicture, unit, kTight,
           vec4(hitInMirrorPicture(MAKE(SmoothMap)(64.0f), vec3(8.5f, 8.5f, 0.0625f * p.x), vec3(24.5f, 12.5f, 0.75f)),
                0.0f)),

    // captured_sight, proxy_mesh, proxy_shape, proxy_sight
    PARITY(hitOfMesh, direction, kTranscendental,
           vec4(hitOfMesh(MAKE(SmallTree)(0.5f + p.w), vec3(0.0f, 0.0f, -3.0f),
                          normalize(vec3(0.25f * p.x, 0.25f * p.y, 2.0f)))
                    .place,
                hitOfMesh(MAKE(SmallTree)(0.5f + p.w), vec3(0.0f, 0.0f, -3.0f),
                          normalize(vec3(0.25f * p.x, 0.25f * p.y, 2.0f)))
                    .normal.z)),
    PARITY(withinBox, direction, kExact, vec4(withinBox(vec3(-0.5f), vec3(0.25f), vec3(p)), 0.0f)),
    PARITY(wayOut, direction, kTight,
           vec4(wayOut(-2.0f, 3.0f, p.x, p.y) < 1e17f ? wayOut(-2.0f, 3.0f, p.x, p.y) : 0.0f)),
    PARITY(hitOfBox, direction, kTight,
           vec4(hitOfBox(vec3(-0.5f, -0.75f, -0.25f), vec3(1.0f, 2.0f, 3.0f), vec3(q), vec3(p)).place,
                hitOfBox(vec3(-0.5f, -0.75f, -0.25f), vec3(1.0f, 2.0f, 3.0f), vec3(q), vec3(p)).distance)),
    PARITY(withinSphere, direction, kTight, vec4(withinSphere(vec3(0.25f), 0.5f, vec3(p)), 0.0f)),
    PARITY(hitOfSphere, direction, kTight, vec4(hitOfSphere(vec3(0.25f), 2.0f, vec3(q), vec3(p)).place, 0.0f)),
    PARITY(withinDome, direction, kTight, vec4(withinDome(vec3(0.25f), 0.5f, -0.125f, vec3(p)), 0.0f)),
    // The ground is met from far above where a ray is nearly level.
    PARITY(hitOfGround, direction, kTranscendental,
           vec4(hitOfGround(vec3(0.0f, 0.5f, 0.0f), 4.0f, -1.0f, vec3(q), vec3(p)).place, 0.0f)),
    PARITY(shadowedGround, light, kTight, vec4(shadowedGround(vec3(p), vec3(q), vec3(r) / (vec3(r) + 1.0f)), 0.0f)),
    PARITY(sightOfProxy, direction, kTight,
           vec4(sightOfProxy(MAKE(ProxyHit)(2.0f * vec3(p), vec3(0.0f, 1.0f, 0.0f), 1.0f + r.x, false), 0.25f * vec3(q),
                             normalize(vec3(p.x, 0.75f, p.z)))
                    .direction,
                sightOfProxy(MAKE(ProxyHit)(2.0f * vec3(p), vec3(0.0f, 1.0f, 0.0f), 1.0f + r.x, false), 0.25f * vec3(q),
                             normalize(vec3(p.x, 0.75f, p.z)))
                    .enlargement)),
    PARITY(roughnessBeyondProxy, unit, kTight, vec4(roughnessBeyondProxy(p.x, 4.0f * p.y))),
    // Of a smooth cube a ray may graze what it meets, and then its share is a root of rounded numbers.
    PARITY(behindCaptured, direction, kTight,
           vec4(behindCaptured(MAKE(SmoothCube)(0.5f), vec3(q), vec3(p), 0.5f + 0.5f * r.x))),
    PARITY(shareOfHit, direction, kTranscendental,
           vec4(shareOfHit(MAKE(SmoothCube)(1.0f), vec3(0.25f, 0.125f * p.y, 0.0f),
                           vec3(0.25f, 0.125f * p.x, 0.125f * p.z)))),
    PARITY(capturedSight, direction, kTranscendental,
           vec4(capturedSight(MAKE(SmoothCube)(1.0f), vec3(0.25f, 0.125f * q.y, 0.0f), normalize(vec3(1.0f, p.y, p.z)))
                    .direction,
                capturedSight(MAKE(SmoothCube)(1.0f), vec3(0.25f, 0.125f * q.y, 0.0f), normalize(vec3(1.0f, p.y, p.z)))
                    .enlargement)),
    PARITY(nearestToCapture, direction, kTight, vec4(nearestToCapture(vec3(q), vec3(p), vec3(r)), 0.0f)),

    // sampling
    PARITY(evenPoint, unit, kTight, vec4(evenPoint(vec2(p), 64.0f * q.x), 0.0f, 0.0f)),
    PARITY(sampleOffset, unit, kTight, vec4(sampleOffset(int(1024.0f * p.x), 1025), 0.0f, 0.0f)),
    PARITY(partOfLobe, unit, kExact,
           vec4(float(partOfLobe(int(3.9375f * p.x), 4, int(7.9375f * p.y), 8)),
                float(partOfLobe(int(5.9375f * p.x), 6, int(8.9375f * p.y), 9)),
                float(partOfLobe(int(3.9375f * p.x), 4, int(1.9375f * p.y), 2)), 0.0f)),
    PARITY(placeInStratum, unit, kTight, vec4(placeInStratum(int(15.9375f * p.x), vec2(q)), 0.0f, 0.0f)),
    PARITY(sampleFootprint, direction, kTight,
           vec4(sampleFootprint(vec3(p), vec3(q), 1.0f + 16.0f * r.y), 0.0f, 0.0f, 0.0f)),
    PARITY(footprintLod, unit, kTight, vec4(footprintLod(p.x, 1.0f + 2048.0f * r.x), 0.0f, 0.0f, 0.0f)),

    // flat_cube, of a picture of 48 × 24 texels
    PARITY(flatSize, unit, kExact, vec4(float(flatSize(MAKE(SmoothMap)(48.0f), int(2.9375f * p.x))), 0.0f, 0.0f, 0.0f)),
    PARITY(flatTexel, unit, kExact,
           flatTexel(MAKE(SmoothMap)(64.0f), int(5.9375f * r.x), ivec2(int(40.0f * p.x) - 10, int(40.0f * p.y) - 10),
                     int(2.9375f * q.x))),
    PARITY(flatNearest, direction, kExact, flatNearest(MAKE(SmoothMap)(64.0f), vec3(p), int(2.9375f * r.x))),
    PARITY(flatBilinear, direction, kTight, flatBilinear(MAKE(SmoothMap)(64.0f), vec3(p), int(2.9375f * r.x))),
    PARITY(flatLastLevel, unit, kExact, vec4(flatLastLevel(MAKE(SmoothMap)(64.0f)), 0.0f, 0.0f, 0.0f)),
    PARITY(flatNearestLod, direction, kExact, flatNearestLod(MAKE(SmoothMap)(64.0f), vec3(p), 5.0f * r.x)),
    PARITY(flatTrilinear, direction, kTight, flatTrilinear(MAKE(SmoothMap)(64.0f), vec3(p), 5.0f * r.x)),

    // ground
    PARITY(groundPlace, direction, kTight, vec4(groundPlace(vec3(p.x, -0.0625f - abs(p.y), p.z)), 0.0f, 0.0f)),
    PARITY(groundNoise, unit, kTight, vec4(groundNoise(vec2(p) * 64.0f - 32.0f), 0.0f, 0.0f, 0.0f)),
    PARITY(groundDetail, unit, kTight, vec4(groundDetail(5.0f * p.x, p.y, 0.0625f), 0.0f, 0.0f, 0.0f)),
    PARITY(groundOctave, unit, kTranscendental,
           vec4(groundOctave(vec2(p) * 8.0f, 0.25f + p.w, 2.0f, p.z, 0.0039f), 0.0f, 0.0f, 0.0f)),
    PARITY(groundPattern, unit, kTranscendental, vec4(groundPattern(vec2(p) * 8.0f, p.z, 0.0039f), 0.0f, 0.0f)),
    PARITY(groundAlbedo, unit, kTight, vec4(groundAlbedo(vec2(p) - 0.5f), 0.0f)),
    PARITY(groundRadiance, direction, kTranscendental,
           vec4(groundRadiance(vec3(p.x, -0.0625f - abs(p.y), p.z), vec3(q), vec3(r), vec3(r.w), vec3(0.5f), 0.0625f),
                0.0f)),

    // sky
    PARITY(moleculeDepth, unit, kTight, vec4(moleculeDepth(0.375f + 0.375f * p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(hazeDepth, unit, kTranscendental,
           vec4(hazeDepth(0.375f + 0.375f * p.x, 2.0f + 8.0f * p.y), 0.0f, 0.0f, 0.0f)),
    PARITY(ozoneDepth, unit, kTranscendental, vec4(ozoneDepth(0.375f + 0.375f * p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(ozoneDensity, unit, kTight, vec4(ozoneDensity(64.0f * p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(heightAlong, direction, kTight, vec4(heightAlong(64.0f, p.y, 256.0f * r.x), 0.0f, 0.0f, 0.0f)),
    PARITY(distanceToTop, direction, kTight, vec4(distanceToTop(64.0f * r.x, abs(p.y)), 0.0f, 0.0f, 0.0f)),
    PARITY(distanceToGround, direction, kTight, vec4(distanceToGround(1.0f + r.x, -abs(p.y)), 0.0f, 0.0f, 0.0f)),
    PARITY(scaledErfc, unit, kTight, vec4(scaledErfc(16.0f * p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(airMass, direction, kTranscendental,
           vec4(airMass(32.0f * r.x, 0.5f * p.w - 0.0625f, 8.0f), 0.0f, 0.0f, 0.0f)),
    PARITY(ozoneColumn, direction, kTranscendental, vec4(ozoneColumn(32.0f * r.x, p.y), 0.0f, 0.0f, 0.0f)),
    PARITY(columnsTowardsSun, direction, kTranscendental, vec4(columnsTowardsSun(32.0f * r.x, abs(p.y)), 0.0f)),
    PARITY(sunAboveHorizon, unit, kTight, vec4(sunAboveHorizon(0.0f, 0.015625f * (p.x - 0.5f)), 0.0f, 0.0f, 0.0f)),
    PARITY(moleculePhase, direction, kTight, vec4(moleculePhase(p.y), 0.0f, 0.0f, 0.0f)),
    PARITY(hazePhase, direction, kTight, vec4(hazePhase(p.y), 0.0f, 0.0f, 0.0f)),
    PARITY(sunSpectrum, unit, kTranscendental, vec4(sunSpectrum(0.375f + 0.375f * p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(xyzD65FromD55, light, kTight, vec4(xyzD65FromD55(vec3(p)), 0.0f)),

    // sphere_map
    PARITY(sphereMapCoordinates, direction, kTight, vec4(sphereMapCoordinates(vec3(p)), 0.0f, 0.0f)),
    PARITY(sphereMapCoordinatesOfNormal, direction, kTight, vec4(sphereMapCoordinatesOfNormal(vec3(p)), 0.0f, 0.0f)),
    PARITY(sphereMapTextureMatrix, direction, kTight, sphereMapTextureMatrix(mat3(vec3(p), vec3(q), vec3(r))) * r),
    PARITY(sphereMapNormal, unit, kTight, vec4(sphereMapNormal(vec2(p)), 0.0f)),
    PARITY(sphereMapDirection, unit, kTight, vec4(sphereMapDirection(vec2(p)), 0.0f)),
};

}  // namespace

std::span<const Case> allCases() {
  static const std::vector<Case> all = [] {
    std::vector<Case> cases(std::begin(kCases), std::end(kCases));
    for (const std::span<const Case> more : {surfaceCases(), reliefCases()}) {
      cases.insert(cases.end(), more.begin(), more.end());
    }
    return cases;
  }();
  return all;
}

}  // namespace mirrorball::parity
