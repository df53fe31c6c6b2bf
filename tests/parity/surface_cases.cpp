// Of surfaces and bodies: what they reflect and let through.

#include "parity/case_rows.h"

namespace mirrorball::parity {
namespace {

const Case kSurfaceCases[] = {
    // back_face
    PARITY(curvatureOfPixels, direction, kTight,
           vec4(curvatureOfPixels(vec3(p) + vec3(2.0f), vec3(q), vec3(q) - vec3(2.0f), vec3(r)))),
    PARITY(wayToBackFace, direction, kTight,
           vec4(wayToBackFace(MAKE(BackFace)(2.0f * vec3(p), vec3(p), 0.0f), vec3(0.5f * q.x, 0.0f, 0.0f),
                              normalize(vec3(p) + 0.5f * vec3(q))))),
    PARITY(normalBesideBackFace, direction, kTight,
           vec4(normalBesideBackFace(MAKE(BackFace)(vec3(p), vec3(p), 0.5f * q.w), vec3(p) + 0.25f * vec3(q)), 0.0f)),

    // beam
    PARITY(refractionOfBeam, unit, kTight, vec4(refractionOfBeam(p.x, p.y, 0.5f + q.x, 4.0f * q.y - 2.0f), 0.0f)),
    PARITY(reflectionOfBeam, unit, kTight, vec4(reflectionOfBeam(p.x, p.y, 4.0f * q.y - 2.0f), 0.0f)),
    PARITY(beamBeyond, unit, kTight,
           vec4(beamBeyond(MAKE(Beam)(vec3(p), vec2(r.x, r.y)), vec3(q)).lobe,
                beamBeyond(MAKE(Beam)(vec3(p), vec2(r.x, r.y)), vec3(q)).pixel.x)),
    PARITY(beamAfter, unit, kTight,
           vec4(beamAfter(MAKE(Beam)(vec3(p), vec2(r.x, r.y)), 4.0f * q.x).lobe,
                beamAfter(MAKE(Beam)(vec3(p), vec2(r.x, r.y)), 4.0f * q.x).pixel.y)),
    PARITY(roughnessOfBeam, unit, kTight, vec4(roughnessOfBeam(MAKE(Beam)(vec3(p), vec2(0.0f))), 0.0f, 0.0f, 0.0f)),
    PARITY(footprintOfBeam, unit, kTight,
           vec4(footprintOfBeam(MAKE(Beam)(vec3(p), vec2(4.0f * q.x))), 0.0f, 0.0f, 0.0f)),

    // brdf_table
    PARITY(brdfTableColumn, unit, kTight, vec4(brdfTableColumn(p.x, p.y), 0.0f, 0.0f, 0.0f)),
    PARITY(brdfTableCoordinates, unit, kTight, vec4(brdfTableCoordinates(p.x, p.y, 128.0f), 0.0f, 0.0f)),

    PARITY(sheenAlbedo, unit, kTight, vec4(sheenAlbedo(MAKE(SmoothMap)(16.0f), p.x, p.y), 0.0f, 0.0f, 0.0f)),
    PARITY(brdfTexel, unit, kTight, brdfTexel(MAKE(SmoothMap)(32.0f), p.x, p.y)),
    PARITY(environmentBrdf, unit, kTight, vec4(environmentBrdf(MAKE(SmoothMap)(32.0f), p.x, p.y), 0.0f)),

    // diffuse
    PARITY(evalDiffuse, unit, kTight, vec4(evalDiffuse())),
    PARITY(sampleDiffuse, unit, kTranscendental, vec4(sampleDiffuse(vec2(p)), 0.0f)),
    PARITY(pdfDiffuse, direction, kTight, vec4(pdfDiffuse(vec3(p)))),

    // ggx, from alpha = 1/16
    PARITY(ggxDistribution, direction, kTight, vec4(ggxDistribution(vec2(0.0625f + r.x, 0.0625f + r.w), vec3(p)))),
    PARITY(ggxLambda, direction, kTight, vec4(1.0f / (1.0f + ggxLambda(vec2(0.0625f + r.x, 0.0625f + r.w), vec3(p))))),
    PARITY(ggxMasking, direction, kTight, vec4(ggxMasking(vec2(0.0625f + r.x, 0.0625f + r.w), vec3(p)))),
    PARITY(ggxMaskingShadowing, direction, kTight,
           vec4(ggxMaskingShadowing(vec2(0.0625f + r.x, 0.0625f + r.w), vec3(p), vec3(q)))),
    PARITY(pdfVisibleNormal, direction, kTight,
           vec4(pdfVisibleNormal(vec2(0.0625f + r.x, 0.0625f + r.w), normalize(vec3(p.x, p.y, abs(p.z) + 0.0625f)),
                                 vec3(q)))),
    PARITY(sampleVisibleNormal, direction, kTranscendental,
           vec4(sampleVisibleNormal(vec2(0.0625f + r.x, 0.0625f + r.w), vec3(p.x, p.y, abs(p.z)),
                                    vec2(r.y, r.z) * 0.96875f),
                0.0f)),
    PARITY(evalGgx, direction, kTranscendental,
           vec4(evalGgx(vec2(0.0625f + r.x, 0.0625f + r.w), normalize(vec3(p.x, p.y, abs(p.z) + 0.0625f)),
                        normalize(vec3(q.x, q.y, abs(q.z) + 0.0625f))))),
    PARITY(
        sampleGgx, direction, kTranscendental,
        vec4(sampleGgx(vec2(0.0625f + r.x, 0.0625f + r.w), vec3(p.x, p.y, abs(p.z)), vec2(r.y, r.z) * 0.96875f), 0.0f)),
    PARITY(pdfGgx, direction, kTranscendental,
           vec4(pdfGgx(vec2(0.0625f + r.x, 0.0625f + r.w), normalize(vec3(p.x, p.y, abs(p.z) + 0.0625f)),
                       normalize(vec3(q.x, q.y, abs(q.z) + 0.0625f))))),

    PARITY(stretchedAlpha, unit, kTight, vec4(stretchedAlpha(p.x, q.x), 0.0f, 0.0f)),

    // lobe_row
    PARITY(firstOfRow, unit, kTight, vec4(float(firstOfRow(2 * int(2.5f * p.x))), 0.0f, 0.0f, 0.0f)),
    PARITY(placeInLobeRows, unit, kTight, vec4(placeInLobeRows(int(8.0f * r.x), p.x, p.y), 0.0f, 0.0f)),
    PARITY(lobeOfRow, direction, kTight,
           vec4(lobeOfRow(4.0f * q, r.x, vec3(0.0f, 0.0f, 1.0f), normalize(vec3(p.x, p.y, abs(p.z)))).direction,
                lobeOfRow(4.0f * abs(q), r.x, vec3(0.0f, 0.0f, 1.0f), vec3(p)).perceptual_roughness)),

    // stretched_lobe
    PARITY(tapOfStretchedLobe, direction, kTranscendental,
           vec4(tapOfStretchedLobe(vec2(0.0625f + r.x, 0.0625f + r.w), vec3(p.x, p.y, abs(p.z) + 0.0625f),
                                   0.0625f + 0.875f * r.y, 0.0625f)
                    .normal,
                tapOfStretchedLobe(vec2(0.0625f + r.x, 0.0625f + r.w), vec3(p.x, p.y, abs(p.z) + 0.0625f),
                                   0.0625f + 0.875f * r.y, 0.0625f)
                    .weight)),
    PARITY(
        stretchedShare, direction, kTranscendental,
        vec4(stretchedShare(vec2(0.0625f + r.x, 0.0625f + r.w), vec3(p.x, p.y, abs(p.z) + 0.0625f)), 0.0f, 0.0f, 0.0f)),

    // charlie, of all but the smoothest cloth, where rounding is raised to a high power
    PARITY(alphaOfSheen, unit, kTight, vec4(alphaOfSheen(p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(charlieDistribution, direction, kTranscendental,
           vec4(charlieDistribution(0.125f + 0.875f * r.x, vec3(p)), 0.0f, 0.0f, 0.0f)),
    PARITY(charlieLambdaFit, unit, kTranscendental, vec4(charlieLambdaFit(r.x, 0.0625f + p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(charlieLambda, unit, kTranscendental, vec4(charlieLambda(r.x, 0.0625f + 0.875f * p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(evalCharlie, direction, kTranscendental,
           vec4(evalCharlie(0.125f + 0.875f * r.x, normalize(vec3(p.x, p.y, abs(p.z) + 0.0625f)),
                            normalize(vec3(q.x, q.y, abs(q.z) + 0.0625f))),
                0.0f, 0.0f, 0.0f)),

    PARITY(sheenTap, direction, kTranscendental,
           vec4(sheenTap(0.125f + 0.875f * r.x, normalize(vec3(p.x, p.y, abs(p.z) + 0.0625f)), int(1.9375f * r.y),
                         int(5.9375f * r.z))
                    .light,
                sheenTap(0.125f + 0.875f * r.x, normalize(vec3(p.x, p.y, abs(p.z) + 0.0625f)), int(1.9375f * r.y),
                         int(5.9375f * r.z))
                    .weight)),

    // thin_film
    PARITY(meanOverSpectrum, unit, kTranscendental,
           vec4(meanOverSpectrum(2.0f * p.x).cosine, meanOverSpectrum(2.0f * p.x).sine.y)),
    PARITY(higherOrders, unit, kTranscendental, vec4(higherOrders(0.875f * vec3(q), 4.0f * vec3(r), 0.5f * p.y), 0.0f)),
    PARITY(sumWithoutSpectrum, unit, kTranscendental,
           vec4(sumWithoutSpectrum(MAKE(FilmSides)(1.5f * p.x - 0.75f, 0.875f * vec3(q), 4.0f * vec3(r)), 0.5f * p.y),
                0.0f)),
    PARITY(spectralOrder, unit, kTranscendental,
           vec4(spectralOrder(MAKE(FilmSides)(1.5f * p.x - 0.75f, 0.875f * vec3(q), 4.0f * vec3(r)),
                              1 + int(2.9375f * p.y), MAKE(SpectrumMean)(vec3(0.5f), vec3(0.25f, 0.75f, 0.5f))),
                0.0f)),
    PARITY(reflectanceOfSum, unit, kTight,
           vec4(reflectanceOfSum(MAKE(FilmSides)(1.5f * p.x - 0.75f, 0.875f * vec3(q), vec3(0.0f)), vec3(r)), 0.0f)),
    PARITY(filmReflectance, unit, kTranscendental,
           vec4(filmReflectance(0.0625f + 0.9375f * p.x, 1.0625f + p.y, 0.75f * p.z, vec3(0.25f) + 2.0f * vec3(q),
                                r.w < 0.5f ? vec3(0.0f) : vec3(0.125f) + 3.0f * vec3(r)),
                0.0f)),
    PARITY(iorOfReflectance, unit, kTranscendental, vec4(iorOfReflectance(0.75f * vec3(p)), 0.0f)),

    // height
    PARITY(orangeHeight, unit, kTight, orangeHeight(vec3(p) * 16.0f - 8.0f)),
    PARITY(orangeNormal, direction, kTight, vec4(orangeNormal(vec3(q), vec3(p), 0.01f, 12.0f, 0.75f), 0.0f)),
    PARITY(orangeSlopeShare, direction, kTight, vec4(orangeSlopeShare(4.0f * vec3(p), vec3(q)), 0.0f, 0.0f, 0.0f)),

    // media
    PARITY(entered, unit, kExact, shownMedia(entered(testMedia(p), int(2.9375f * q.x), int(2.9375f * q.y)))),
    PARITY(left, unit, kExact, shownMedia(left(testMedia(p), int(2.9375f * q.x)))),
    PARITY(timesEntered, unit, kExact,
           vec4(float(timesEntered(entered(testMedia(p), 1, 0), int(2.9375f * q.x))), 0.0f, 0.0f, 0.0f)),
    PARITY(heldPriority, unit, kExact, vec4(float(heldPriority(1500 * int(2.9375f * p.x) - 2000)))),
    PARITY(noMedia, unit, kExact, vec4(noMedia().latest + noMedia().earliest)),
    PARITY(wordsOfBody, unit, kExact, vec4(wordsOfBody(testMedia(p).latest, int(2.9375f * q.x)))),
    PARITY(prevailing, unit, kExact,
           vec4(float(prevailing(uint(8.0f * p.x) << kPriorityShift, uint(8.0f * p.y) << kPriorityShift) >>
                      kPriorityShift))),
    PARITY(fillingWord, unit, kExact, vec4(float(fillingWord(testMedia(p)) & kBodyBits))),
    PARITY(isWithinBody, unit, kExact, vec4(isWithinBody(testMedia(p)) ? 1.0f : 0.0f, 0.0f, 0.0f, 0.0f)),
    PARITY(fillingBody, unit, kExact, vec4(float(fillingBody(testMedia(p))), 0.0f, 0.0f, 0.0f)),
    PARITY(hasSurface, unit, kExact,
           vec4(hasSurface(testMedia(p), int(2.9375f * q.x), int(2.9375f * q.y), q.z < 0.5f) ? 1.0f : 0.0f, 0.0f, 0.0f,
                0.0f)),

    // microfacet
    PARITY(widenedRoughness, unit, kTight, vec4(widenedRoughness(p.x, q.x), 0.0f, 0.0f, 0.0f)),
    PARITY(alphaFromPerceptualRoughness, unit, kTight, vec4(alphaFromPerceptualRoughness(p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(multipleScattering, unit, kTight, vec4(multipleScattering(vec3(p), vec3(q), 0.75f * r.x), 0.0f)),
    PARITY(evenFraction, unit, kTight, vec4(evenFraction(p.x, p.y), 0.0f, 0.0f, 0.0f)),
    PARITY(evenFractionBesideRow, unit, kTight, vec4(evenFractionBesideRow(p.x, p.y), 0.0f, 0.0f, 0.0f)),

    // occlusion
    PARITY(visibleSlice, unit, kTranscendental,
           vec4(visibleSlice(1.75f * p.x - 0.875f, 0.125f + q.x, 4.0f * r.x - 2.0f), 0.0f)),

    // optics
    PARITY(besideSurface, direction, kTight, vec4(besideSurface(1000.0f * vec3(p), 2000.0f * r.x, vec3(q)), 0.0f)),
    PARITY(bodyTransmittance, unit, kTranscendental,
           vec4(bodyTransmittance(vec3(p) + vec3(0.0625f), q.x - 0.25f, 2.0f * q.y), 0.0f)),
    PARITY(facingNormal, direction, kTight, vec4(facingNormal(vec3(p), vec3(q)), 0.0f)),
    PARITY(
        refractedDirection, direction, kTight,
        vec4(refractedDirection(vec3(p), dot(vec3(p), vec3(q)) > 0.0f ? -vec3(q) : vec3(q), 0.4f + 2.0f * r.x), 0.0f)),
    PARITY(fresnelDielectric, unit, kTight, vec4(fresnelDielectric(p.x, 0.4f + 2.0f * p.y), 0.0f, 0.0f, 0.0f)),
    PARITY(fresnelDielectricOfChannels, unit, kTight,
           vec4(fresnelDielectricOfChannels(p.x, 0.4f + 2.0f * vec3(q)), 0.0f)),
    PARITY(normalDielectricReflectance, unit, kTight, vec4(normalDielectricReflectance(0.4f + 2.0f * vec3(q)), 0.0f)),
    PARITY(fresnelConductor1, unit, kTight,
           vec4(fresnelConductor1(p.x, 0.1f + 3.0f * p.y, 0.5f + 6.0f * p.z), 0.0f, 0.0f, 0.0f)),
    PARITY(fresnelConductor, unit, kTight, vec4(fresnelConductor(p.x, vec3(q) + 0.1f, vec3(r) * 6.0f + 0.5f), 0.0f)),
    PARITY(fresnelSchlick, unit, kTight, vec4(fresnelSchlick(p.x, vec3(q)), 0.0f)),
    PARITY(fresnelF82, unit, kTight, vec4(fresnelF82(p.x, vec3(q), vec3(r)), 0.0f)),
    PARITY(fresnelEmpirical, unit, kTranscendental,
           vec4(fresnelEmpirical(p.x, p.y, p.z, 1.0f + 5.0f * p.w), 0.0f, 0.0f, 0.0f)),
    PARITY(iorOfChannels, unit, kTight, vec4(iorOfChannels(1.0f + 1.5f * p.x, p.y), 0.0f)),
    PARITY(iorOfCauchy, unit, kTight, vec4(iorOfCauchy(1.0f + 1.5f * p.x, p.y, 0.4f + 0.3f * p.z), 0.0f, 0.0f, 0.0f)),
    PARITY(iorOfSellmeier, unit, kTight,
           vec4(iorOfSellmeier(p, q * 0.03125f, 0.375f + 0.375f * r.x), 0.0f, 0.0f, 0.0f)),
    PARITY(iorAtWavelength, unit, kTight,
           vec4(iorAtWavelength(MAKE(RefractiveIndex)(1.5f, p.y, vec4(0.0f), vec4(0.0f)), 0.375f + 0.375f * r.x),
                iorAtWavelength(MAKE(RefractiveIndex)(1.5f, p.y, p, q * 0.03125f), 0.375f + 0.375f * r.x), 0.0f, 0.0f)),

    // phong
    PARITY(phongMirror, direction, kExact, vec4(phongMirror(vec3(p)), 0.0f)),
    PARITY(evalPhong, direction, kTranscendental, vec4(evalPhong(1.0f + 8.0f * r.x, vec3(p), vec3(q)))),
    PARITY(samplePhong, direction, kTranscendental,
           vec4(samplePhong(1.0f + 8.0f * r.x, vec3(p.x, p.y, abs(p.z)), vec2(r.y, r.z) * 0.96875f), 0.0f)),
    PARITY(pdfPhong, direction, kTranscendental, vec4(pdfPhong(1.0f + 8.0f * r.x, vec3(p), vec3(q)))),

    // reflection_lobe
    PARITY(cosineOfLobe, unit, kTight, vec4(cosineOfLobe(p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(ggxLobe, unit, kTight, vec4(ggxLobe(0.0625f + p.y, p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(logOfOneMinus, unit, kTranscendental, vec4(logOfOneMinus(0.9375f * p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(blinnLobe, unit, kTranscendental, vec4(blinnLobe(32.0f * p.y, 0.9375f * p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(phongLobe, unit, kTranscendental, vec4(phongLobe(1.0f + 32.0f * p.y, p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(charlieLobe, unit, kTranscendental, vec4(charlieLobe(0.0625f + p.y, p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(blinnExponent, unit, kTight, vec4(blinnExponent(0.0625f + p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(phongExponent, unit, kTight, vec4(phongExponent(0.0625f + p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(ggxHalfAngle, unit, kTranscendental, vec4(ggxHalfAngle(p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(mipTexelWidth, unit, kTight,
           vec4(mipTexelWidth(8 + int(1016.0f * p.x), int(10.0f * p.y)), 0.0f, 0.0f, 0.0f)),
    PARITY(lodOfLobe, direction, kTranscendental,
           vec4(lodOfLobe(r.x, 64.0f + 256.0f * r.y, vec3(p)), 0.0f, 0.0f, 0.0f)),

    // slope
    PARITY(heightDifference, unit, kTight,
           vec4(heightDifference(int(3.9375f * r.x), vec3(p), vec3(q), vec3(r)), 0.0f, 0.0f)),
    PARITY(slopeOfDifference, light, kTight,
           vec4(slopeOfDifference(vec2(p.x - p.y, q.x - q.y), 4.0f * r.x), 0.0f, 0.0f)),
    PARITY(normalFromSlope, unit, kTight, vec4(normalFromSlope(vec2(4.0f * p.x - 2.0f, 4.0f * p.y - 2.0f)), 0.0f)),
    PARITY(slopeFromNormal, unit, kTight,
           vec4(slopeFromNormal(vec3(2.0f * p.x - 1.0f, 2.0f * p.y - 1.0f, 0.25f + q.z)), 0.0f, 0.0f)),

    // tangent
    PARITY(alphaOfSpread, unit, kTight, vec4(alphaOfSpread(p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(spreadOfAlpha, unit, kTight, vec4(spreadOfAlpha(p.x, q.x), 0.0f, 0.0f, 0.0f)),
    PARITY(turnedTangent, direction, kTight,
           vec4(turnedTangent(vec4(vec3(p), p.w < 0.5f ? -1.0f : 1.0f), vec3(q), vec2(0.75f, 0.5f)), 0.0f)),
    PARITY(anisotropyTurn, unit, kTranscendental, vec4(anisotropyTurn(vec2(p) * 2.0f - 1.0f, 6.0f * q.x), 0.0f, 0.0f)),
    PARITY(anyTangent, direction, kTight, vec4(anyTangent(vec3(p)), 0.0f)),
    PARITY(
        perturbedNormal, direction, kTight,
        vec4(perturbedNormal(anyTangent(vec3(p)), cross(vec3(p), anyTangent(vec3(p))), vec3(p), r.x - 0.5f, r.y - 0.5f),
             0.0f)),
    PARITY(liftedNormal, direction, kTight,
           vec4(liftedNormal(vec3(q), vec3(r), vec3(p), vec3(p) + 0.25f * vec3(q), vec2(0.375f * q.w, 0.25f)), 0.0f)),
    PARITY(displacedNormal, direction, kTight,
           vec4(displacedNormal(vec3(q), vec3(r), vec3(p), vec2(0.375f * q.w, 0.25f)), 0.0f)),
    PARITY(mappedNormal, direction, kTight,
           vec4(mappedNormal(vec4(anyTangent(vec3(p)) + 0.2f * vec3(p), -1.0f), vec3(p),
                             2.0f * vec3(r.x, r.y, 0.5f + 0.5f * r.z + 0.03125f) - vec3(1.0f), 2.0f * r.w),
                0.0f)),
    PARITY(slopedNormal, direction, kTight,
           vec4(slopedNormal(4.0f * vec3(q), vec3(r), vec3(p), vec2(0.375f * q.w, 0.25f)), 0.0f)),
    PARITY(objectMappedNormal, direction, kTight,
           vec4(objectMappedNormal(mat3(vec3(2.0f, 0.0f, 0.0f), vec3(0.0f, 0.0f, 1.0f), vec3(0.0f, -1.0f, 0.0f)),
                                   vec3(p), vec3(q), 0.25f + 0.25f * r.w),
                0.0f)),
    PARITY(normalFromMap, direction, kTight,
           vec4(normalFromMap(anyTangent(vec3(p)), cross(vec3(p), anyTangent(vec3(p))), vec3(p),
                              2.0f * vec3(r.x, r.y, 0.5f + 0.5f * r.z + 0.03125f) - vec3(1.0f), 2.0f * r.w),
                0.0f)),
    PARITY(decodedNormal, direction, kTight, vec4(decodedNormal(vec3(r), 128.0f * r.w), 0.0f)),
    PARITY(encodedNormal, direction, kTight, vec4(encodedNormal(vec3(q), 128.0f * r.w), 0.0f)),

    // texgen
    PARITY(objectCoordinates, direction, kExact,
           objectCoordinates(MAKE(TexgenPoint)(vec3(r), vec3(q), vec3(p), vec3(q), mat3(vec3(q), vec3(r), vec3(p))))),
    PARITY(placeCoordinates, direction, kExact,
           placeCoordinates(MAKE(TexgenPoint)(vec3(r), vec3(q), vec3(p), vec3(q), mat3(vec3(q), vec3(r), vec3(p))))),
    PARITY(normalCoordinates, direction, kExact,
           normalCoordinates(MAKE(TexgenPoint)(vec3(r), vec3(q), vec3(p), vec3(q), mat3(vec3(q), vec3(r), vec3(p))))),
    PARITY(
        reflectionCoordinates, direction, kTight,
        reflectionCoordinates(MAKE(TexgenPoint)(vec3(r), vec3(q), vec3(p), vec3(q), mat3(vec3(q), vec3(r), vec3(p))))),
    PARITY(sphereCoordinates, direction, kTight,
           sphereCoordinates(MAKE(TexgenPoint)(vec3(r), vec3(q), vec3(p), vec3(q), mat3(vec3(q), vec3(r), vec3(p))))),
    PARITY(coordinatesOfUv, unit, kExact, coordinatesOfUv(vec2(p))),
    PARITY(uvOfCoordinates, unit, kTight, vec4(uvOfCoordinates(p + vec4(0.0f, 0.0f, 0.0f, 0.5f)), 0.0f, 0.0f)),
    PARITY(projectedShare, direction, kExact, vec4(projectedShare(p), 0.0f, 0.0f, 0.0f)),
    PARITY(projectorMatrix, direction, kTight,
           projectorMatrix(vec3(r), vec3(p), vec3(r), 0.5f + q.w) * vec4(vec3(q), 1.0f)),

    // texture_filter, where texels lie up to two maps away from one of 16 x 8
    PARITY(wrappedTexel, unit, kExact,
           vec4(wrappedTexel(floor(64.0f * p.x) - 32.0f, 1.0f + floor(15.0f * p.y), int(2.9375f * r.x)), 0.0f, 0.0f,
                0.0f)),
    PARITY(wrappedFetch, unit, kExact,
           wrappedFetch(MAKE(SmoothMap)(16.0f), floor(64.0f * vec2(p)) - vec2(32.0f), int(3.9375f * r.x),
                        MAKE(MapSampling)(int(2.9375f * r.y), int(2.9375f * r.z), false))),
    PARITY(nearestTexel, unit, kExact,
           nearestTexel(MAKE(SmoothMap)(16.0f), 4.0f * vec2(p) - vec2(2.0f), 1,
                        MAKE(MapSampling)(int(2.9375f * r.y), int(2.9375f * r.z), true))),
    PARITY(bilinearTexels, unit, kTight,
           bilinearTexels(MAKE(SmoothMap)(16.0f), 4.0f * vec2(p) - vec2(2.0f), int(3.9375f * r.x),
                          MAKE(MapSampling)(int(2.9375f * r.y), int(2.9375f * r.z), false))),
    PARITY(
        mapInPixel, unit, kTranscendental,
        mapInPixel(MAKE(SmoothMap)(16.0f), 4.0f * vec2(p) - vec2(2.0f), vec2(0.25f * q.x, 0.0f), vec2(0.0f, 0.5f * q.y),
                   3.0f, MAKE(MapSampling)(int(2.9375f * r.y), int(2.9375f * r.z), r.w < 0.5f), int(3.9375f * r.x))),

    // filter_kind
    PARITY(readsMipLevels, unit, kExact, vec4(readsMipLevels(int(3.9375f * p.x)) ? 1.0f : 0.0f)),
    PARITY(readsAlong, unit, kExact, vec4(float(readsAlong(40.0f * p.x, 4.0f * q.x)))),
    PARITY(placeOfRead, unit, kTight, vec4(placeOfRead(int(15.0f * p.x), 16))),
    PARITY(filteredMap, unit, kTight,
           filteredMap(MAKE(SmoothMap)(16.0f), 4.0f * vec2(p) - vec2(2.0f), max(4.0f * r.x - 1.0f, 0.0f),
                       MAKE(MapSampling)(int(2.9375f * r.y), int(2.9375f * r.z), r.w < 0.5f))),

    // clear_coat
    PARITY(coatMaterial, direction, kExact,
           vec4(coatMaterial(testSurface(p, q, r).material).perceptual_roughness,
                coatMaterial(testSurface(p, q, r).material).ior, coatMaterial(testSurface(p, q, r).material).metallic,
                coatMaterial(testSurface(p, q, r).material).base_color.x)),
    PARITY(coatOf, direction, kTranscendental,
           vec4(coatOf(testSurface(p, q, r), vec3(p), testSurface(p, q, r).normal, vec3(q),
                       vec3(0.25f, 0.5f * r.x, 0.25f * r.x))
                    .reflectance.single_scattering,
                coatOf(testSurface(p, q, r), vec3(p), testSurface(p, q, r).normal, vec3(q),
                       vec3(0.25f, 0.5f * r.x, 0.25f * r.x))
                    .environment_brdf.y)),
    PARITY(underCoat, direction, kTranscendental,
           vec4(underCoat(coatOf(testSurface(p, q, r), vec3(p), testSurface(p, q, r).normal, vec3(q),
                                 vec3(0.25f, 0.5f * r.x, 0.25f * r.x)),
                          r.y, vec3(1.0f, 2.0f, 3.0f), vec3(r)),
                0.0f)),

    // self_occlusion
    PARITY(openingOf, direction, kTranscendental,
           vec4(openingOf(vec3(p), 0.25f * vec3(q), r.x).axis, openingOf(vec3(p), 0.25f * vec3(q), r.x).angle) +
               vec4(openingOf(vec3(p), 0.25f * vec3(q), r.x).occluded_axis,
                    openingOf(vec3(p), 0.25f * vec3(q), r.x).occluded_angle +
                        openingOf(vec3(p), 0.25f * vec3(q), r.x).likeness +
                        openingOf(vec3(p), 0.25f * vec3(q), r.x).is_occluded_by_one)),
    PARITY(angleOfSine, unit, kTranscendental, vec4(angleOfSine(0.99f * p.x))),
    PARITY(angleBetween, direction, kTranscendental, vec4(angleBetween(vec3(p), vec3(q)))),
    PARITY(lobeInOpening, direction, kTranscendental,
           vec4(lobeInOpening(MAKE(Opening)(vec3(p), 1.5f * r.x, vec3(q), 0.6f, 1.0f, r.y), vec3(p), vec3(q), r.y))),
    PARITY(roughnessOfCone, unit, kTranscendental, vec4(roughnessOfCone(1.5f * p.x))),
    PARITY(lightThroughOpening, unit, kTight, vec4(lightThroughOpening(vec3(p), vec3(q), r.x), 0.0f)),
    PARITY(lightBesideOccluded, unit, kTight, vec4(lightBesideOccluded(vec3(p), vec3(q), 0.5f * vec3(q), r.x), 0.0f)),
    PARITY(shareBesideOccluded, unit, kTight,
           vec4(shareBesideOccluded(MAKE(Opening)(vec3(p), 1.5f, vec3(q), 0.6f, p.y, 0.0f), p.x))),

    // shading
    PARITY(hasConductorIndex, direction, kExact,
           vec4(hasConductorIndex(testSurface(p, q, r).material) ? 1.0f : 0.0f, 0.0f, 0.0f, 0.0f)),
    PARITY(bareDielectricReflectance, direction, kTranscendental,
           vec4(bareDielectricReflectance(testSurface(p, q, r).material, p.w, vec3(1.0f + r.x, 1.5f, 2.0f)), 0.0f)),
    PARITY(bareMetalReflectance, direction, kTight,
           vec4(bareMetalReflectance(testSurface(p, q, r).material, p.w), 0.0f)),
    PARITY(smoothReflectance, direction, kTranscendental,
           vec4(smoothReflectance(testSurface(p, q, r).material, 0.0625f + 0.9375f * p.w, vec3(1.0f + r.x, 1.5f, 2.0f),
                                  q.w < 0.5f),
                0.0f)),
    PARITY(dielectricReflectance, direction, kTranscendental,
           vec4(dielectricReflectance(testSurface(p, q, r).material, 0.0625f + 0.9375f * p.w,
                                      vec3(1.0f + r.x, 1.5f, 2.0f)),
                0.0f)),
    PARITY(metalReflectance, direction, kTranscendental,
           vec4(metalReflectance(testSurface(p, q, r).material, 0.0625f + 0.9375f * p.w), 0.0f)),
    PARITY(
        tintedReflectance, direction, kTranscendental,
        vec4(tintedReflectance(testSurface(p, q, r).material, vec3(0.25f + 0.5f * abs(p.y)), vec3(0.25f * r.x)), 0.0f)),
    PARITY(withGreySpecular, direction, kExact,
           vec4(withGreySpecular(testSurface(p, q, r).material).specular_color, 0.0f)),
    PARITY(refractiveIndexOf, unit, kTight,
           vec4(refractiveIndexOf(testSurface(p, q, r).material).ior,
                refractiveIndexOf(testSurface(p, q, r).material).dispersion,
                refractiveIndexOf(testSurface(p, q, r).material).sellmeier_b.x,
                refractiveIndexOf(testSurface(p, q, r).material).sellmeier_c.w)),
    PARITY(atWavelength, unit, kTight,
           vec4(atWavelength(testSurface(p, q, r).material, p.x < 0.25f ? 0.0f : 0.375f + 0.375f * p.y).ior,
                atWavelength(testSurface(p, q, r).material, p.x < 0.25f ? 0.0f : 0.375f + 0.375f * p.y).dispersion,
                0.0f, 0.0f)),
    PARITY(smoothDielectric, direction, kTranscendental,
           vec4(smoothDielectric(testSurface(p, q, r).material, 0.0625f + 0.9375f * p.w), 0.0f)),
    PARITY(firstOfSeveral, unit, kExact, vec4(firstOfSeveral(MAKE(FacetShares)(vec3(p), vec3(q), vec3(r))), 0.0f)),
    PARITY(roughReflectance, direction, kTight,
           vec4(roughReflectance(testSurface(p, q, r), MAKE(FacetShares)(vec3(r), vec3(0.5f * r.x), vec3(r.w)))
                    .single_scattering,
                roughReflectance(testSurface(p, q, r), MAKE(FacetShares)(vec3(r), vec3(0.5f * r.x), vec3(r.w)))
                    .multiple_scattering.x)),
    PARITY(facetsSeen, direction, kTight, vec4(facetsSeen(testSurface(p, q, r), p.w), 0.0f, 0.0f)),
    PARITY(facetShares, direction, kTranscendental,
           vec4(facetShares(testSurface(p, q, r), 0.0625f + 0.9375f * p.w, q.w < 0.5f).seen,
                facetShares(testSurface(p, q, r), 0.0625f + 0.9375f * p.w, q.w < 0.5f).mean.x)),
    PARITY(dielectricOf, direction, kTranscendental,
           vec4(dielectricOf(testSurface(p, q, r), testSurface(p, q, r).material,
                             MAKE(FacetShares)(vec3(r), vec3(0.5f * r.x), vec3(r.y)))
                    .single_scattering,
                dielectricOf(testSurface(p, q, r), testSurface(p, q, r).material,
                             MAKE(FacetShares)(vec3(r), vec3(0.5f * r.x), vec3(r.y)))
                    .multiple_scattering.x)),
    PARITY(inFrame, direction, kTight, vec4(inFrame(testSurface(p, q, r), vec3(p)), 0.0f)),
    PARITY(eyeInFrame, direction, kTight, vec4(eyeInFrame(testSurface(p, q, r), vec3(p)), 0.0f)),
    PARITY(grazingShare, unit, kTight, vec4(grazingShare(vec3(p), vec3(q)), 0.0f)),
    PARITY(aroundMirror, direction, kTranscendental,
           vec4(aroundMirror(seenAlong(testSurface(p, q, r), vec3(p)).reflectance), 0.0f)),
    PARITY(seenAlong, direction, kTranscendental,
           vec4(seenAlong(testSurface(p, q, r), vec3(p)).reflectance.single_scattering.x,
                seenAlong(testSurface(p, q, r), vec3(p)).reflectance.multiple_scattering.y,
                seenAlong(testSurface(p, q, r), vec3(p)).diffuse_albedo.x,
                seenAlong(testSurface(p, q, r), vec3(p)).diffuse_albedo.z)),
    PARITY(seenWithin, direction, kTranscendental,
           vec4(seenWithin(testSurface(p, q, r), vec3(p), 1.0f + 0.5f * r.y).reflectance.single_scattering.x,
                seenWithin(testSurface(p, q, r), vec3(p), 1.0f + 0.5f * r.y).reflectance.grazing.y,
                seenWithin(testSurface(p, q, r), vec3(p), 1.0f + 0.5f * r.y).diffuse_albedo.z,
                seenWithin(testSurface(p, q, r), vec3(p), 1.0f + 0.5f * r.y).material.ior)),
    PARITY(underSheen, unit, kTight, vec4(underSheen(testSurface(p, q, r), vec3(r), vec3(q)), 0.0f)),
    PARITY(coreMaterial, direction, kExact,
           vec4(coreMaterial(testSurface(p, q, r).material, vec3(p), q.w, r.x, vec3(r)).base_color, q.w) +
               vec4(coreMaterial(testSurface(p, q, r).material, vec3(p), q.w, r.x, vec3(r)).emission,
                    coreMaterial(testSurface(p, q, r).material, vec3(p), q.w, r.x, vec3(r)).transmission)),
    PARITY(unlitMaterial, direction, kExact,
           vec4(unlitMaterial(testSurface(p, q, r).material, vec3(r)).emission,
                unlitMaterial(testSurface(p, q, r).material, vec3(r)).specular)),
    PARITY(lightOfRelief, direction, kTranscendental,
           vec4(lightOfRelief(seenAlong(testSurface(p, q, r), vec3(p)), 0.125f + 0.875f * r.x, vec3(r)), 0.0f)),
    PARITY(shadedByEnvironment, direction, kTranscendental,
           vec4(shadedByEnvironment(seenAlong(testSurface(p, q, r), vec3(p)), vec3(r), vec3(0.5f, 1.0f, 2.0f),
                                    vec3(1.0f, r.w, 0.25f), vec3(q)),
                0.0f)),
    PARITY(openMaterial, direction, kExact,
           vec4(openMaterial(testSurface(p, q, r).material).base_color,
                openMaterial(testSurface(p, q, r).material).transmission)),
    PARITY(shadedByPointLight, direction, kTranscendental,
           vec4(shadedByPointLight(seenAlong(testSurface(p, q, r), vec3(p)), vec3(p),
                                   normalize(vec3(0.5f, 0.75f, 0.25f)), vec3(1.0f, 2.0f, 3.0f)),
                0.0f)),

    // lamp: around a place within its range
    PARITY(towardsLamp, direction, kTight,
           vec4(towardsLamp(MAKE(Lamp)(int(3.9375f * r.z), vec3(q), vec3(p), vec3(1.0f), 4.0f, 0.9f, 0.3f),
                            4.0f * vec3(r)),
                0.0f)),
    PARITY(shareInRange, unit, kTight,
           vec4(shareInRange(MAKE(Lamp)(1, vec3(0.0f), vec3(0.0f), vec3(1.0f), r.x < 0.25f ? 0.0f : 2.0f, 1.0f, 0.0f),
                             6.0f * p.x),
                0.0f, 0.0f, 0.0f)),
    PARITY(shareInCone, direction, kTight,
           vec4(shareInCone(MAKE(Lamp)(2, vec3(0.0f), vec3(p), vec3(1.0f), 0.0f, 0.75f, 0.25f), vec3(q)), 0.0f, 0.0f,
                0.0f)),
    PARITY(lampIlluminance, direction, kTranscendental,
           vec4(lampIlluminance(
                    MAKE(Lamp)(1 + int(2.9375f * r.z), vec3(q), vec3(p), vec3(1.0f, 2.0f, 3.0f), 4.0f, 0.9f, 0.3f),
                    4.0f * vec3(r)),
                0.0f)),

    // lamp_shading, of surfaces that are not so smooth that rounding moves their highlight
    PARITY(shadedByPunctualLight, direction, kTranscendental,
           vec4(shadedByPunctualLight(seenAlong(testSurface(p, q, vec4(0.5f + 0.5f * r.x, r.y, r.z, r.w)), vec3(p)),
                                      vec3(p), normalize(vec3(0.5f, 0.75f, 0.25f)), vec3(1.0f, 2.0f, 3.0f)),
                0.0f)),
    PARITY(shadedByLamp, direction, kTranscendental,
           vec4(shadedByLamp(seenAlong(testSurface(p, q, vec4(0.5f + 0.5f * r.x, r.y, r.z, r.w)), vec3(p)), vec3(p),
                             vec3(0.0f),
                             MAKE(Lamp)(int(3.9375f * r.z), vec3(1.5f, 2.0f, 0.75f), vec3(-0.6f, -0.64f, -0.48f),
                                        vec3(1.0f, 2.0f, 3.0f), 4.0f, 0.9f, 0.3f)),
                0.0f)),

    // sun, as wide as a degree or ten
    PARITY(squaredDistance, direction, kTight, vec4(squaredDistance(vec3(p), vec3(q)), 0.0f, 0.0f, 0.0f)),
    PARITY(shownRadius, unit, kTight,
           vec4(shownRadius(MAKE(Sun)(vec3(q), 0.01f + 0.1f * p.x, vec3(1.0f)), 0.01f * p.y), 0.0f, 0.0f, 0.0f)),
    PARITY(shareInDisc, unit, kTight,
           vec4(shareInDisc(p.x, 0.125f + p.y, p.z, 0.0f), shareInDisc(p.x, 0.125f + p.y, 0.0f, 0.25f), 0.0f, 0.0f)),
    PARITY(spanAtEdge, unit, kTight, vec4(spanAtEdge(p.x - p.y, p.z, 0.25f + p.w), 0.0f, 0.0f, 0.0f)),
    PARITY(softenedShare, unit, kTight, vec4(softenedShare(p.x, p.y, 0.25f + p.z, p.w), 0.0f, 0.0f, 0.0f)),
    PARITY(rootOfCircle, unit, kTranscendental, vec4(rootOfCircle(4.0f * p.x, 0.25f + p.y), 0.0f, 0.0f, 0.0f)),
    PARITY(shareInEllipse, unit, kTranscendental,
           vec4(shareInEllipse(vec2(4.0f * p.x, 2.0f * p.y), vec3(0.25f + q.x, 0.2f * q.y, 0.25f + q.z),
                               sqrt((0.25f + q.x) * (0.25f + q.z) - 0.04f * q.y * q.y)),
                0.0f, 0.0f, 0.0f)),
    PARITY(meanCosineOfLobe, unit, kTranscendental, vec4(meanCosineOfLobe(0.9f * p.x), 0.0f, 0.0f, 0.0f)),
    PARITY(sunInLobe, direction, kTranscendental,
           vec4(sunInLobe(MAKE(Sun)(vec3(q), 0.01f + 0.1f * r.x, vec3(1.0f, 2.0f, 3.0f)), vec3(p), 0.25f + 0.625f * r.y,
                          0.01f * r.z),
                0.0f)),
    PARITY(facingDisc, unit, kTight, vec4(facingDisc(p.x - 0.5f, 0.01f + 0.1f * p.y), 0.0f, 0.0f, 0.0f)),
    PARITY(litFrom, direction, kTranscendental,
           vec4(litFrom(seenAlong(testSurface(p, q, vec4(0.5f + 0.5f * r.x, r.y, r.z, r.w)), vec3(p)),
                        normalize(vec3(0.25f, 0.5f, 0.75f)), normalize(vec3(r.x, r.y, 0.5f)), vec3(r.z)),
                0.0f)),
    PARITY(
        discInFacets, direction, kTranscendental,
        vec4(discInFacets(vec2(0.25f + 0.75f * r.x, 0.25f + 0.75f * r.y), normalize(vec3(p.x, p.y, abs(p.z) + 0.125f)),
                          normalize(vec3(q.x, q.y, abs(q.z) + 0.125f)), 0.01f + 0.1f * r.z, 0.05f * r.w),
             0.0f, 0.0f, 0.0f)),
    PARITY(shadedBySun, direction, kTranscendental,
           vec4(shadedBySun(seenAlong(testSurface(p, q, vec4(0.5f + 0.5f * r.x, r.y, r.z, r.w)), vec3(p)), vec3(p),
                            MAKE(Sun)(normalize(vec3(0.5f, 0.75f, 0.25f)), 0.05f, vec3(1.0f, 2.0f, 3.0f)), 0.01f * r.z),
                0.0f)),
    PARITY(shadowTap, unit, kTranscendental, vec4(shadowTap(int(7.9375f * p.x), 8, p.y), 0.0f, 0.0f)),
    PARITY(slopeInShadow, direction, kTight, vec4(slopeInShadow(vec3(p)), 0.0f, 0.0f)),

    // scene_surface
    // Without denormal ones, which drivers may take for 0.
    PARITY(halvesOf, unit, kExact,
           halvesOf((floatBitsToUint(p.x) & 0x3bff3bffu) | 0x04000400u,
                    (floatBitsToUint(p.y) & 0x3bff3bffu) | 0x04000400u)),
    PARITY(cellOfTriangle, unit, kExact,
           vec4(float(cellOfTriangle(vec2(q.x, (1.0f - q.x) * q.y), 1 + int(31.0f * p.x))), 0.0f, 0.0f, 0.0f)),
    PARITY(isMetFromBehind, unit, kExact,
           vec4(isMetFromBehind(MAKE(SmallTree)(1.0f), MAKE(TriangleHit)(1.0f, int(1.9375f * p.x), vec2(q.x, q.y)),
                                vec3(r) - 0.51f)
                    ? 1.0f
                    : 0.0f,
                0.0f, 0.0f, 0.0f)),
    PARITY(
        passesTriangle, unit, kExact,
        vec4(passesTriangle(MAKE(SmallTree)(1.0f),
                            MAKE(TriangleHit)(1.0f, int(1.9375f * p.x), vec2(q.x, (1.0f - q.x) * q.y)), vec3(r) - 0.51f)
                 ? 1.0f
                 : 0.0f,
             0.0f, 0.0f, 0.0f)),
    PARITY(sceneSurfaceAt, unit, kTight,
           vec4(sceneSurfaceAt(MAKE(SmallTree)(1.0f), MAKE(TriangleHit)(1.0f, int(1.9375f * p.x), vec2(q.x, q.y)),
                               vec3(r) - 0.51f)
                    .interreflected,
                1.0f) +
               vec4(sceneSurfaceAt(MAKE(SmallTree)(1.0f), MAKE(TriangleHit)(1.0f, int(1.9375f * p.x), vec2(q.x, q.y)),
                                   vec3(r) - 0.51f)
                            .lit_from +
                        sceneSurfaceAt(MAKE(SmallTree)(1.0f),
                                       MAKE(TriangleHit)(1.0f, int(1.9375f * p.x), vec2(q.x, q.y)), vec3(r) - 0.51f)
                            .emitted,
                    1.0f) +
               sceneSurfaceAt(MAKE(SmallTree)(1.0f), MAKE(TriangleHit)(1.0f, int(1.9375f * p.x), vec2(q.x, q.y)),
                              vec3(r) - 0.51f)
                   .occluded),

    // triangle_tree
    PARITY(leafOf, unit, kExact, vec4(float(leafOf(int(1000.0f * p.x), 1 + int(7.0f * p.y))), 0.0f, 0.0f, 0.0f)),
    PARITY(firstOfLeaf, unit, kExact, vec4(float(firstOfLeaf(-1 - int(1000.0f * p.x))), 0.0f, 0.0f, 0.0f)),
    PARITY(countOfLeaf, unit, kExact, vec4(float(countOfLeaf(-1 - int(1000.0f * p.x))), 0.0f, 0.0f, 0.0f)),
    PARITY(floatsOf, unit, kExact, vec4(floatsOf(floatBitsToUint(p)), 0.0f)),
    PARITY(inverseOf, unit, kTight, vec4(inverseOf(p.x - 0.5f), 0.0f, 0.0f, 0.0f)),
    PARITY(inverseDirection, direction, kTight, vec4(inverseDirection(vec3(p) + vec3(2.0f)), 0.0f)),
    PARITY(entryOfBox, direction, kTranscendental,
           vec4(entryOfBox(uvec4(0u, 0xffff0000u, 0xffffffffu, 0u), vec3(0.5f) - 2.0f * vec3(p),
                           inverseDirection(vec3(p)), 0.0f, 8.0f),
                0.0f, 0.0f, 0.0f)),
    // Through triangles that are wide enough for rounding not to decide whether they are met.
    PARITY(meetingOfTriangle, direction, kTranscendental,
           vec4(meetingOfTriangle(vec3(-9.0f, -9.0f, 1.0f), vec3(9.0f, -9.0f, 1.5f), vec3(0.0f, 9.0f, 1.0f), vec3(0.0f),
                                  normalize(vec3(p.x, p.y, 2.0f)), kNarrowMargin),
                0.0f)),
    PARITY(nearestOfLeaf, direction, kTranscendental,
           vec4(nearestOfLeaf(MAKE(SmallTree)(p.w), 5, leafOf(0, 2), vec3(0.0f, 0.0f, -3.0f),
                              normalize(vec3(0.25f * p.x, 0.25f * p.y, 2.0f)), 0.0f, -1, kNarrowMargin,
                              MAKE(TriangleHit)(9.0f, -1, vec2(0.0f)))
                    .distance)),
    PARITY(
        nearestTriangle, direction, kTranscendental,
        vec4(nearestTriangle(MAKE(SmallTree)(0.5f + p.w), vec3(0.0f, 0.0f, -3.0f),
                             normalize(vec3(0.25f * p.x, 0.25f * p.y, 2.0f)), 0.0f, q.w < 0.5f ? -1 : 0, kNarrowMargin)
                 .distance,
             nearestTriangle(MAKE(SmallTree)(0.5f + p.w), vec3(0.0f, 0.0f, -3.0f),
                             normalize(vec3(0.25f * p.x, 0.25f * p.y, 2.0f)), 0.0f, q.w < 0.5f ? -1 : 0, kNarrowMargin)
                 .barycentric,
             0.0f)),
    PARITY(nearestTriangleBeside, direction, kTranscendental,
           vec4(nearestTriangleBeside(MAKE(SmallTree)(0.5f + p.w), vec3(0.0f, 0.0f, -3.0f),
                                      normalize(vec3(0.25f * p.x, 0.25f * p.y, 2.0f)), 0.0f, -1,
                                      q.w < 0.5f ? 0 : leafOf(0, 1), kNarrowMargin)
                    .distance)),
    PARITY(curvatureAlong, direction, kTight, vec4(curvatureAlong(vec3(p) + vec3(2.0f), vec3(q)), 0.0f, 0.0f, 0.0f)),
    PARITY(
        bodySurfaceAt, unit, kTight,
        vec4(bodySurfaceAt(MAKE(SmallTree)(1.0f), MAKE(TriangleHit)(1.0f, int(1.9375f * p.x), vec2(q.x, q.y))).normal,
             bodySurfaceAt(MAKE(SmallTree)(1.0f), MAKE(TriangleHit)(1.0f, int(1.9375f * p.x), vec2(q.x, q.y)))
                 .curvature)),
    PARITY(bodyAt, unit, kExact,
           vec4(bodyAt(MAKE(SmallTree)(1.0f), int(1.9375f * p.x)).index.ior,
                bodyAt(MAKE(SmallTree)(1.0f), int(1.9375f * p.x)).index.dispersion,
                float(bodyAt(MAKE(SmallTree)(1.0f), int(1.9375f * p.x)).priority),
                bodyAt(MAKE(SmallTree)(1.0f), int(1.9375f * p.x)).index.sellmeier_c.y)),

    // wavelength
    PARITY(unevenBell, unit, kTranscendental, vec4(unevenBell(p.x, 0.5f, 0.125f, 0.25f + p.y), 0.0f, 0.0f, 0.0f)),
    PARITY(xyzOfWavelength, unit, kTranscendental, vec4(xyzOfWavelength(0.375f + 0.375f * p.x), 0.0f)),
    PARITY(wavelengthWeight, unit, kTranscendental, vec4(0.25f * wavelengthWeight(0.36f + 0.47f * p.x), 0.0f)),
    PARITY(sampleWavelength, unit, kTranscendental, vec4(sampleWavelength(p.x))),
    PARITY(pdfWavelength, unit, kTranscendental, vec4(0.25f * pdfWavelength(0.36f + 0.47f * p.x))),
    PARITY(shareOfWavelength, unit, kTranscendental, vec4(0.25f * shareOfWavelength(0.36f + 0.47f * p.x), 0.0f)),
    PARITY(wavelengthSetOfPixel, unit, kExact,
           vec4(float(wavelengthSetOfPixel(int(63.0f * p.x), int(63.0f * p.y))), 0.0f, 0.0f, 0.0f)),
};

}  // namespace

std::span<const Case> surfaceCases() { return kSurfaceCases; }

}  // namespace mirrorball::parity
