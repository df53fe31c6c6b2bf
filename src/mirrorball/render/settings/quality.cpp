#include "mirrorball/render/settings/quality.h"

#include <algorithm>

#include "mirrorball/base/range.h"

namespace mirrorball {
namespace {

/// Rougher surfaces show of their neighbours no more than what vertices know.
constexpr float kPolished = 0.3f;
constexpr std::size_t kManyTriangles = 4'000'000;

bool always(const SceneTraits&) { return true; }
bool letsLightThrough(const SceneTraits& traits) { return traits.lets_light_through; }
bool hidesItself(const SceneTraits& traits) { return traits.hides_itself && traits.can_trace_rays && !traits.is_huge; }
bool mirrorsItself(const SceneTraits& traits) {
  return traits.is_polished && (traits.hides_itself || traits.has_objects) && traits.can_trace_rays && !traits.is_huge;
}
bool mirrorsWithoutRays(const SceneTraits& traits) {
  return traits.is_polished && traits.has_objects && !traits.can_trace_rays && !traits.is_huge;
}

bool hasStrongSun(const SceneTraits& traits) { return traits.has_strong_sun; }

/// The classic techniques: they reflect the environment alone, and show triangles as they are, which cannot be cut.
constexpr auto kClassicTechniques =
    std::to_array<std::string_view>({"mapping", "reflect-at", "texgen", "texture-matrix", "lookup", "blur"});
/// They say themselves what surfaces show in place of what is reflected.
constexpr auto kShowsOtherwise = std::to_array<std::string_view>({"occlusion", "self-reflection", "probes"});
constexpr auto kOccludesOtherwise = std::to_array<std::string_view>({"self-reflection", "probes"});
/// How light is followed where not all of it is.
constexpr auto kRefractsOtherwise = std::to_array<std::string_view>({"refraction"});

constexpr auto kChoices = std::to_array<QualityChoice>({
    {.option = "sun", .values = {"", "split", "split"}, .suits = hasStrongSun},
    {.option = "refraction", .values = {"", "auto", "traced"}, .suits = letsLightThrough},
    {.option = "inner-bounces", .values = {"", "", "8"}, .suits = letsLightThrough, .left_to = kRefractsOtherwise},
    {.option = "behind", .values = {"", "screen", "screen"}, .suits = letsLightThrough},
    {.option = "occlusion",
     .values = {"", "vertex", "vertex"},
     .suits = hidesItself,
     .left_to = kOccludesOtherwise,
     .is_left_to_classics = true},
    {.option = "self-reflection",
     .values = {"", "yes", "yes"},
     .suits = mirrorsItself,
     .left_to = kShowsOtherwise,
     .is_left_to_classics = true},
    {.option = "probes",
     .values = {"", "auto", "auto"},
     .suits = mirrorsWithoutRays,
     .left_to = kShowsOtherwise,
     .is_left_to_classics = true},
    {.option = "probe-bounces",
     .values = {"", "", "4"},
     .suits = mirrorsWithoutRays,
     .left_to = kShowsOtherwise,
     .is_left_to_classics = true},
    {.option = "samples", .values = {"", "", "16"}, .suits = always},
});

const auto kQualityOptions = std::to_array<Option<QualityRequest>>({
    {{.name = "quality",
      .choices = "draft|good|best",
      .help = "how much the options that are not given do for the picture: draft is the fastest; good lets glass show "
              "what is behind it, objects hide and mirror each other, and the sun throw shadows, where there is any of "
              "that; best also takes more samples and traces through all glass",
      .group = "Look",
      .is_daily = true},
     choiceField<&QualityRequest::quality>},
});

bool isAnyGiven(std::span<const std::string_view> names, const std::set<std::string_view>& given) {
  return std::any_of(names.begin(), names.end(), [&](std::string_view name) { return given.contains(name); });
}

/// Of some options those that ask for something: a classic technique at its default asks for nothing, and no probes
/// show nothing.
std::set<std::string_view> sayingOtherwise(std::set<std::string_view> options, const FrameSettings& settings) {
  for (const Option<FrameSettings>& option : frameOptions())
    if (contains(kClassicTechniques, option.text.name) && written(option, settings) == written(option, FrameSettings()))
      options.erase(option.text.name);
  if (settings.probes == 0) options.erase("probes");
  return options;
}

/// "{option:self-reflection}", "{option:behind} screen"
std::string asGiven(const Option<FrameSettings>& option, std::string_view value) {
  const std::string name = "{option:" + std::string(option.text.name) + "}";
  return option.isFlag() ? name : name + " " + std::string(value);
}

}  // namespace

std::span<const Option<QualityRequest>> qualityOptions() { return kQualityOptions; }

SceneTraits traitsOf(const Scene& scene) {
  SceneTraits traits{.has_objects = scene.instances.size() > 1};
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Material& material = materialOf(scene, i);
    triangles += scene.meshes[std::size_t(scene.instances[i].mesh)]->indices.size() / 3;
    traits.lets_light_through = traits.lets_light_through || material.transmission > 0.0f;
    const bool has_polished_coat = material.clearcoat > 0.0f && material.clearcoat_roughness < kPolished;
    traits.is_polished =
        traits.is_polished || (!material.unlit && (material.perceptual_roughness < kPolished || has_polished_coat ||
                                                   material.roughness_map.texture >= 0));
  }
  traits.is_huge = triangles > kManyTriangles;
  return traits;
}

std::span<const QualityChoice> qualityChoices() { return kChoices; }

bool dependsOnHiding(Quality quality, SceneTraits traits, const std::set<std::string_view>& given,
                     const FrameSettings& settings) {
  const auto chosen = [&](bool hides_itself) {
    traits.hides_itself = hides_itself;
    FrameSettings filled = settings;
    return fillIn(quality, traits, given, filled);
  };
  return chosen(true) != chosen(false);
}

bool dependsOnSun(Quality quality, const std::set<std::string_view>& given, const FrameSettings& settings) {
  FrameSettings filled = settings;
  fillIn(quality, {.has_strong_sun = true}, given, filled);
  return filled.sun != settings.sun;
}

std::string fillIn(Quality quality, const SceneTraits& traits, const std::set<std::string_view>& given,
                   FrameSettings& settings) {
  std::string chosen;
  const std::set<std::string_view> saying = sayingOtherwise(given, settings);
  for (const QualityChoice& choice : kChoices) {
    const std::string_view value = choice.values[static_cast<std::size_t>(quality)];
    if (value.empty() || given.contains(choice.option) || !choice.suits(traits) || isAnyGiven(choice.left_to, saying))
      continue;
    if (choice.is_left_to_classics && isAnyGiven(kClassicTechniques, saying)) continue;
    if (choice.option == "probe-bounces" && settings.probes == 0) continue;
    if (choice.option == "sun" && !settings.canSplitSuns()) continue;
    const auto option = findBy(frameOptions(), choice.option, [](const auto& each) { return each.text.name; });
    if (option == frameOptions().end() || !assign(*option, settings, value)) continue;
    chosen += (chosen.empty() ? "" : " ") + asGiven(*option, value);
  }
  if (settings.self_reflection) settings.occlusion = OcclusionKind::vertex;
  return chosen;
}

}  // namespace mirrorball
