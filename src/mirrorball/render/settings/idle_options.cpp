#include "mirrorball/render/settings/idle_options.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "mirrorball/base/option.h"

namespace mirrorball {
namespace {

template <typename Question>
bool anyMaterial(const Scene& scene, Question question) {
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    if (question(materialOf(scene, i))) return true;
  return false;
}

bool transmitsLight(const Scene& scene) {
  return anyMaterial(scene, [](const Material& m) { return m.transmission > 0.0f; });
}

bool hasGlass(const Scene& scene) {
  return anyMaterial(scene, [](const Material& m) { return isBody(m); });
}

bool disperses(const Scene& scene) {
  return anyMaterial(scene, [](const Material& m) { return isBody(m) && m.dispersion > 0.0f; });
}

bool absorbs(const Scene& scene) {
  return anyMaterial(scene, [](const Material& m) {
    return isBody(m) && m.attenuation_distance > 0.0f && m.attenuation_color != glm::vec3(1.0f);
  });
}

bool goesInSteps(ReliefKind kind) { return kind >= ReliefKind::steep && kind <= ReliefKind::cone; }

/// One option, and what keeps it from acting.
struct Idle {
  std::string_view option;
  std::string_view why;
  bool (*acts)(const Scene&, const FrameSettings&);
};

constexpr auto kIdle = std::to_array<Idle>({
    {"light-intensity", "the model has no lights of its own",
     [](const Scene& scene, const FrameSettings&) { return !scene.lights.empty(); }},
    {"refraction", "no surface lets light through; {option:set} transmission=1 makes it do so",
     [](const Scene& scene, const FrameSettings&) { return transmitsLight(scene); }},
    {"behind", "no surface lets light through; {option:set} transmission=1 makes it do so",
     [](const Scene& scene, const FrameSettings&) { return transmitsLight(scene); }},
    {"inner-bounces",
     "light is followed inside of bodies by {option:refraction} traced, where a surface lets light through",
     [](const Scene& scene, const FrameSettings& settings) {
       return hasGlass(scene) && settings.refraction >= RefractionKind::traced;
     }},
    {"dispersion", "no surface disperses the light that it lets through; {option:set} dispersion=1 makes it do so",
     [](const Scene& scene, const FrameSettings&) { return disperses(scene); }},
    {"wavelengths", "they are drawn by {option:dispersion} spectral",
     [](const Scene& scene, const FrameSettings& settings) {
       return settings.dispersion == DispersionKind::spectral && disperses(scene);
     }},
    {"sampling", "only pictures of a display's light with more samples than three leave some out",
     [](const Scene&, const FrameSettings& settings) {
       return settings.resolve == Resolve::display && settings.samples > 3;
     }},
    {"lobe-taps", "they are read of light that is prefiltered: {option:blur} exact or gpu",
     [](const Scene&, const FrameSettings& settings) { return settings.blur <= BlurKind::gpu; }},
    {"relief-steps", "only {option:relief} steep, occlusion, linear-binary and cone go in steps",
     [](const Scene&, const FrameSettings& settings) { return goesInSteps(settings.relief); }},
    {"sun",
     "suns stay in the map with a near {option:proxy}, and where light is looked up in other ways than by reflection",
     [](const Scene&, const FrameSettings& settings) { return settings.canSplitSuns(); }},
    {"probe-size", "there are no probes; {option:probes} N makes some",
     [](const Scene&, const FrameSettings& settings) { return settings.probes != 0; }},
    {"probe-bounces", "there are no probes; {option:probes} N makes some",
     [](const Scene&, const FrameSettings& settings) { return settings.probes != 0; }},
});

}  // namespace

std::vector<std::string> idleOptions(const Scene& scene, const FrameSettings& settings,
                                     const std::set<std::string_view>& given) {
  std::vector<std::string> lines;
  if (scene.empty()) return lines;
  for (const Idle& idle : kIdle)
    if (given.contains(idle.option) && !idle.acts(scene, settings))
      lines.push_back(changesNothing(std::array{"{option:" + std::string(idle.option) + "}"}, idle.why));
  if (settings.refraction == RefractionKind::single && absorbs(scene))
    lines.emplace_back(
        "{option:refraction} single knows of no way through glass, and so of no absorption; image-space does");
  return lines;
}

}  // namespace mirrorball
