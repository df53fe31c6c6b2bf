#include "mirrorball/photo/merge.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/base/range.h"
#include "mirrorball/base/size_text.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/color/coded_color.h"
#include "mirrorball/codec/color/primaries.h"

namespace mirrorball {
namespace {

using CodesOfAll = std::vector<const Image8*>;

/// What the photographs say about one channel of one pixel.
struct Evidence {
  double weighted = 0.0;
  double weights = 0.0;

  void add(double light, double trust, double exposure) {
    weighted += trust * exposure * light;
    weights += trust * exposure * exposure;
  }
};

double trustIn(double code) { return code >= kFirstClippedCode ? 0.0 : trustInCode(code); }

/// Whether the codes of two photographs mean the same light, by whatever each file states or leaves out.
bool haveSameColors(const CodedColor& a, const CodedColor& b) {
  if (isSrgb(a) || isSrgb(b)) return isSrgb(a) && isSrgb(b);
  const auto conversion = [](const CodedColor& color) {
    return color.primaries ? rec709FromPrimaries(*color.primaries) : std::nullopt;
  };
  constexpr double kRounded = 0.01;  // of a gamma that one file has as a fraction and another as a decimal
  return a.transfer == b.transfer && (a.transfer != Transfer::gamma || std::abs(a.gamma - b.gamma) < kRounded) &&
         conversion(a) == conversion(b);
}

Result<void> checkSeries(std::span<const Photograph> photographs) {
  const Photograph& first = photographs.front();
  for (const Photograph& photograph : photographs) {
    if (photograph.width() != first.width() || photograph.height() != first.height())
      return fail(ErrorCode::bad_shape,
                  photograph.name + ": is " + sizeText({photograph.width(), photograph.height()}) + ", but " +
                      first.name + " is " + sizeText({first.width(), first.height()}) + "; a series has one size");
    if (!haveSameColors(photograph.color, first.color))
      return fail(ErrorCode::bad_shape, photograph.name + ": says of its colours " +
                                            describeColor(photograph.color, 3) + ", but " + first.name + " " +
                                            describeColor(first.color, 3) + "; a series has the same");
    if (photographs.size() > 1 && !photograph.light.empty() && !photograph.is_clipped_at_1)
      return fail(ErrorCode::usage,
                  photograph.name +
                      ": is linear light that does not say where the camera clipped it; give it alone, or a " +
                      "series of integers");
  }
  return {};
}

Result<std::vector<double>> exposuresOf(std::span<const Photograph> photographs, const MergeOptions& options) {
  if (photographs.size() == 1) return std::vector<double>{1.0};
  std::vector<double> exposures = options.exposures;
  if (exposures.empty()) {
    MIRRORBALL_TRY(read, exposuresFromExif(photographs));
    exposures = std::move(read);
  }
  if (exposures.size() != photographs.size())
    return fail(ErrorCode::usage, countedAre(exposures.size(), "exposure") + " given for " +
                                      counted(photographs.size(), "photograph") + "; give one each");
  const auto [shortest, longest] = std::minmax_element(exposures.begin(), exposures.end());
  const double min = *shortest;
  const double max = *longest;
  if (max / min < 1.05)
    return fail(ErrorCode::usage,
                "all photographs have the exposure " + formatNumber(min) + " s; a series has different ones",
                FixHint::give_exposures);
  return exposures;
}

/// The one with the middle exposure, of two the brighter: so that a map is not opened black.
std::size_t referenceOf(std::span<const double> exposures) {
  std::vector<std::size_t> order(exposures.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  sortUpBy(order, [&](std::size_t i) { return exposures[i]; });
  return order[order.size() / 2];
}

std::string nameOf(ResponseKind kind) {
  return kind == ResponseKind::srgb    ? "assumed sRGB"
         : kind == ResponseKind::gamma ? "assumed gamma 2.2"
                                       : "assumed linear";
}

/// The samples of a series of codes, whose light a response says.
struct ResponseSamples {
  const CodesOfAll& codes;
  const Response& response;

  std::size_t count() const { return codes.size(); }
  double code(std::size_t photograph, int x, int y, std::size_t c) const { return codes[photograph]->texel(x, y)[c]; }
  double light(std::size_t photograph, int x, int y, std::size_t c) const {
    return response.light[c][codes[photograph]->texel(x, y)[c]];
  }
};

/// The samples of a series of linear codes, which are its light.
struct LinearSamples {
  std::span<const Photograph> photographs;

  std::size_t count() const { return photographs.size(); }
  double code(std::size_t photograph, int x, int y, std::size_t c) const { return 255.0 * light(photograph, x, y, c); }
  double light(std::size_t photograph, int x, int y, std::size_t c) const {
    const Image& image = photographs[photograph].light;
    return image.texel(x, y)[image.channels() < 3 ? 0 : c];
  }
};

/// How many pixels of a row all photographs clip or leave black.
struct RowCounts {
  std::size_t clipped = 0;
  std::size_t black = 0;
};

template <typename Samples>
RowCounts mergeRow(const Samples& samples, std::span<const double> exposures, int y, Image& light) {
  const std::size_t shortest = std::size_t(std::min_element(exposures.begin(), exposures.end()) - exposures.begin());
  const std::size_t longest = std::size_t(std::max_element(exposures.begin(), exposures.end()) - exposures.begin());
  RowCounts counts;
  for (int x = 0; x < light.width(); ++x) {
    bool clipped = false;
    bool black = false;
    for (std::size_t c = 0; c < 3; ++c) {
      Evidence evidence;
      for (std::size_t p = 0; p < samples.count(); ++p)
        evidence.add(samples.light(p, x, y, c), trustIn(samples.code(p, x, y, c)), exposures[p]);
      const bool too_bright = samples.code(shortest, x, y, c) >= kFirstClippedCode;
      const bool too_dark = samples.code(longest, x, y, c) <= 0.0;
      clipped |= too_bright;
      black |= too_dark;
      double value = evidence.weights > 0.0 ? evidence.weighted / evidence.weights : 0.0;
      if (too_bright) value = samples.light(shortest, x, y, c) / exposures[shortest];
      if (too_dark) value = samples.light(longest, x, y, c) / exposures[longest];
      light.texel(x, y)[c] = static_cast<float>(value);
    }
    counts.clipped += clipped;
    counts.black += black;
  }
  return counts;
}

template <typename Samples>
void mergeSamples(const Samples& samples, std::span<const double> exposures, glm::ivec2 size,
                  MergedPhotographs& merged) {
  merged.light = Image(size.x, size.y, 3);
  const std::size_t rows = std::size_t(size.y);
  std::vector<RowCounts> counts(rows);
  parallelFor(rows, 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y)
      counts[y] = mergeRow(samples, exposures, static_cast<int>(y), merged.light);
  });
  for (const RowCounts& row : counts) {
    merged.clipped += row.clipped;
    merged.black += row.black;
  }
}

/// How many stops each photograph is brighter than its exposure says, against the one that it agrees with best: the
/// median over the places that both show. One that is wrong agrees with none, and all others with one another.
std::vector<double> contradictions(const CodesOfAll& codes, std::span<const double> exposures,
                                   const Response& response) {
  const std::size_t count = codes.size();
  std::vector<std::vector<double>> stops(count * count);
  forEachSmoothPlace(codes, [&](std::span<const std::array<double, 3>> mean) {
    constexpr double kMinTrust = 0.1;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t p = 0; p < count; ++p)
        for (std::size_t other = 0; other < p; ++other) {
          const auto code = [&](std::size_t i) { return static_cast<int>(std::lround(mean[i][c])); };
          if (std::min(trustIn(code(p)), trustIn(code(other))) < kMinTrust) continue;
          const auto light = [&](std::size_t i) { return response.light[c][std::size_t(code(i))] / exposures[i]; };
          stops[p * count + other].push_back(std::log2(light(p) / light(other)));
        }
  });
  std::vector<double> min_stops(count, 1e9);
  for (std::size_t p = 0; p < count; ++p)
    for (std::size_t other = 0; other < p; ++other) {
      std::vector<double>& of_pair = stops[p * count + other];
      if (of_pair.empty()) continue;
      const auto middle = of_pair.begin() + std::ptrdiff_t(of_pair.size() / 2);
      std::nth_element(of_pair.begin(), middle, of_pair.end());
      if (std::abs(*middle) < std::abs(min_stops[p])) min_stops[p] = *middle;
      if (std::abs(*middle) < std::abs(min_stops[other])) min_stops[other] = -*middle;
    }
  // Those that share no place with any other contradict none.
  std::replace(min_stops.begin(), min_stops.end(), 1e9, 0.0);
  return min_stops;
}

double maxStops(const std::vector<double>& stops) {
  double result = 0.0;
  for (const double stop : stops) result = std::max(result, std::abs(stop));
  return result;
}

/// The response that the options ask for; of a single photograph of which they ask for none, sRGB's.
Result<Response> responseOf(const CodesOfAll& codes, std::span<const double> exposures, const MergeOptions& options) {
  if (options.known) return *options.known;
  if (codes.size() > 1 && !options.response) return recoverResponse(codes, exposures);
  return assumedResponse(options.response.value_or(ResponseKind::srgb));
}

/// How far each photograph lies off the others. One that is wrong makes its neighbours look wrong too, and bends the
/// recovered response: so where there is a contradiction, each is left out in turn, and the one without which the rest
/// agree best is held against that rest.
std::vector<double> namedContradictions(const CodesOfAll& codes, const std::vector<double>& exposures,
                                        const Response& response, const MergeOptions& options) {
  std::vector<double> stops = contradictions(codes, exposures, response);
  // Of two, neither is the odd one out; and for any two exposures some response makes them agree.
  const std::size_t min_count = options.response || options.known ? 3 : 4;
  if (maxStops(stops) < kContradiction_stops / 2.0 || codes.size() < min_count) return stops;
  double min_stops = maxStops(stops);
  for (std::size_t odd = 0; odd < codes.size(); ++odd) {
    CodesOfAll rest = codes;
    std::vector<double> rest_exposures = exposures;
    rest.erase(rest.begin() + std::ptrdiff_t(odd));
    rest_exposures.erase(rest_exposures.begin() + std::ptrdiff_t(odd));
    const auto of_rest = responseOf(rest, rest_exposures, options);
    if (!of_rest) continue;
    const std::vector<double> rest_stops = contradictions(rest, rest_exposures, *of_rest);
    if (maxStops(rest_stops) >= min_stops) continue;
    min_stops = maxStops(rest_stops);
    const double off = contradictions(codes, exposures, *of_rest)[odd];
    stops = rest_stops;
    stops.insert(stops.begin() + std::ptrdiff_t(odd), off);
  }
  return stops;
}

/// As namedContradictions; but where few shades are in the scene, a recovered response may bend so far that it agrees
/// with a wrong exposure. So what disagrees by more than a stop under sRGB counts too, as long as the others agree:
/// then it is not the camera's curve that is unlike sRGB's.
std::vector<double> allContradictions(const CodesOfAll& codes, const std::vector<double>& exposures,
                                      const Response& response, const MergeOptions& options) {
  const std::vector<double> stops = namedContradictions(codes, exposures, response, options);
  const bool is_recovered = codes.size() > 2 && !options.response && !options.known;
  if (!is_recovered || maxStops(stops) > kContradiction_stops) return stops;
  MergeOptions assumed = options;
  assumed.response = ResponseKind::srgb;
  const auto by_srgb = namedContradictions(codes, exposures, assumedResponse(ResponseKind::srgb), assumed);
  const auto contradicts = [](double stop) { return std::abs(stop) > kContradiction_stops; };
  const bool is_one = std::count_if(by_srgb.begin(), by_srgb.end(), contradicts) == 1;
  return is_one && maxStops(by_srgb) > 2.0 * kContradiction_stops ? by_srgb : stops;
}

/// Linear codes rounded to 8 bits, by which photographs are held against each other, or another response is found.
Image8 roundedCodes(const Image& light) {
  Image8 codes = Image8::withoutValues(light.width(), light.height(), 4);
  for (int y = 0; y < light.height(); ++y)
    for (int x = 0; x < light.width(); ++x) {
      const glm::vec3 color = glm::clamp(rgbAt(light, x, y), 0.0f, 1.0f) * 255.0f + 0.5f;
      for (int c = 0; c < 3; ++c) codes.texel(x, y)[c] = static_cast<std::uint8_t>(color[c]);
      codes.texel(x, y)[3] = 255;
    }
  return codes;
}

/// Codes whose light a response says, of a camera or of the options.
///
/// exposures  1 is the reference's
Result<void> mergeCodes(const CodesOfAll& codes, const std::vector<double>& exposures, const CodedColor& color,
                        const MergeOptions& options, MergedPhotographs& merged) {
  MIRRORBALL_TRY(response, responseOf(codes, exposures, options));
  merged.response = nameOf(options.response.value_or(ResponseKind::srgb));
  if (options.known) merged.response = "the first side's";
  if (!options.known && !options.response && codes.size() > 1) {
    merged.response = "recovered";
    merged.curve = response;
  }
  if (!options.known && !options.response && codes.size() == 1 && color.transfer == Transfer::gamma) {
    response = responseOfPower(color.gamma);
    merged.response = "the file's gamma " + formatNumber(std::round(color.gamma * 1e3) / 1e3);
  }
  const glm::ivec2 size(codes.front()->width(), codes.front()->height());
  mergeSamples(ResponseSamples{codes, response}, exposures, size, merged);
  merged.contradicts_stops = allContradictions(codes, exposures, response, options);
  return {};
}

/// Linear codes, which are light already.
///
/// codes      of the photographs, rounded
/// exposures  1 is the reference's
void mergeLinear(std::span<const Photograph> photographs, const CodesOfAll& codes, const std::vector<double>& exposures,
                 MergedPhotographs& merged) {
  merged.response = "linear light";
  const glm::ivec2 size(photographs.front().width(), photographs.front().height());
  mergeSamples(LinearSamples{photographs}, exposures, size, merged);
  merged.contradicts_stops = namedContradictions(codes, exposures, assumedResponse(ResponseKind::linear),
                                                 {.exposures = {}, .response = ResponseKind::linear});
}

/// Whether it is the merged light by itself.
bool isMergedLight(const Photograph& photograph) { return !photograph.light.empty() && !photograph.is_clipped_at_1; }

/// The merged light, and linear codes that are rounded. They are asked for at once, before any is taken.
Result<void> checkMergeMemory(std::span<const Photograph> photographs) {
  const Photograph& first = photographs.front();
  if (isMergedLight(first)) return checkMemory(first.bytes());
  constexpr std::uint64_t kMergedTexel = 12, kRoundedTexel = 4;  // bytes
  const std::uint64_t rounded = first.is_clipped_at_1 ? photographs.size() * kRoundedTexel : 0;
  return checkMemory((kMergedTexel + rounded) * std::uint64_t(first.width()) * std::uint64_t(first.height()));
}

}  // namespace

Result<MergedPhotographs> mergePhotographs(std::span<const Photograph> photographs, const MergeOptions& options) {
  MIRRORBALL_TRY_VOID(checkSeries(photographs));
  const Photograph& first = photographs.front();
  MergedPhotographs merged;
  MIRRORBALL_TRY_VOID(withName(first.name, checkMergeMemory(photographs)));
  if (isMergedLight(first)) {
    merged.light = first.light;
    merged.contradicts_stops = {0.0};
    merged.response = "linear light";
    return merged;
  }
  MIRRORBALL_TRY(exposures, exposuresOf(photographs, options));
  merged.reference = referenceOf(exposures);
  const double reference = exposures[merged.reference];
  for (double& exposure : exposures) exposure /= reference;

  std::vector<Image8> rounded;
  for (const Photograph& photograph : photographs)
    if (photograph.is_clipped_at_1) rounded.push_back(roundedCodes(photograph.light));
  CodesOfAll codes;
  for (std::size_t i = 0; i < photographs.size(); ++i)
    codes.push_back(rounded.empty() ? &photographs[i].codes : &rounded[i]);
  if (first.is_clipped_at_1 && !options.response)
    mergeLinear(photographs, codes, exposures, merged);
  else
    MIRRORBALL_TRY_VOID(mergeCodes(codes, exposures, first.color, options, merged));
  convertToRec709(merged.light, first.color.primaries);
  return merged;
}

}  // namespace mirrorball
