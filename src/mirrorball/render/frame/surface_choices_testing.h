#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "mirrorball/height_field/height_field.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/render/surface/surface_variant.h"
#include "mirrorball/scene/bumpy_pair_testing.h"

namespace mirrorball::testing {

/// What asks for an answer of the surface's shader, as a user would: a material and settings.
struct SurfaceCase {
  Material material;
  FrameSettings settings;
  bool is_in_scene = false;  ///< the scene has worked out what it hides of itself
  bool is_in_body = false;   ///< the eye is
};

struct SurfaceChoice {
  Part part;
  std::uint8_t answer;
  std::string name;
  bool is_white;  ///< alone it gives back all the light of an even sky
  std::function<void(SurfaceCase&)> make;
};

template <typename Answer>
SurfaceChoice choiceOf(Part part, Answer answer, std::string name, bool is_white,
                       std::function<void(SurfaceCase&)> make) {
  return {part, static_cast<std::uint8_t>(answer), std::move(name), is_white, std::move(make)};
}

inline void makeGlass(SurfaceCase& asked, RefractionKind refraction) {
  asked.material.transmission = 1.0f;
  asked.settings.refraction = refraction;
}

inline void makeRelief(SurfaceCase& asked, ReliefKind kind) {
  asked.material.height = HeightKind::map;
  asked.material.height_texture = 0;
  asked.material.height_scale = 0.02f;
  asked.material.height_frequency = 1.0f;
  asked.settings.relief = kind;
}

inline void makeProbe(SurfaceCase& asked) {
  asked.settings.probes = 1;
  asked.settings.probe_size = 8;
  asked.settings.probe_bounces = 1;
}

/// Every answer that is not the usual one, in the order of the questions.
inline const std::vector<SurfaceChoice>& surfaceChoices() {
  using P = Part;
  using Case = SurfaceCase;
  const auto relief = [](ReliefKind kind) { return [kind](Case& asked) { makeRelief(asked, kind); }; };
  const auto proxy = [](const char* written) {
    return [written](Case& asked) { set(asked.settings, "proxy", written); };
  };
  static const std::vector<SurfaceChoice> choices{
      choiceOf(P::point, PointPart::parallax, "relief parallax", true, relief(ReliefKind::parallax)),
      choiceOf(P::point, PointPart::steep, "relief steep", true, relief(ReliefKind::steep)),
      choiceOf(P::point, PointPart::occlusion, "relief occlusion", true, relief(ReliefKind::occlusion)),
      choiceOf(P::point, PointPart::linear_binary, "relief linear-binary", true, relief(ReliefKind::linear_binary)),
      choiceOf(P::point, PointPart::cone, "relief cone", true, relief(ReliefKind::cone)),
      choiceOf(P::point, PointPart::exact, "relief exact", true, relief(ReliefKind::exact)),
      choiceOf(P::coordinates, CoordinatesPart::at_vertex, "reflect at vertex", true,
               [](Case& asked) { asked.settings.reflect_at = ReflectAt::vertex; }),
      choiceOf(P::coordinates, CoordinatesPart::at_triangle, "reflect at triangle", true,
               [](Case& asked) { asked.settings.reflect_at = ReflectAt::triangle; }),
      choiceOf(P::normal, NormalPart::bump, "orange", true,
               [](Case& asked) { asked.material.height = HeightKind::orange; }),
      choiceOf(P::normal, NormalPart::heights, "heights", true, relief(ReliefKind::bump)),
      choiceOf(P::normal, NormalPart::slopes, "slopes", true, [](Case& asked) { asked.material.slope_texture = 0; }),
      choiceOf(P::detail, DetailPart::normal_map, "normal map", true,
               [](Case& asked) { asked.material.normal_map.texture = 0; }),
      choiceOf(P::detail, DetailPart::object_normal_map, "object normal map", true,
               [](Case& asked) {
                 asked.material.normal_map.texture = 1;
                 asked.material.normal_space = NormalSpace::object;
               }),
      choiceOf(P::film, FilmPart::thin, "film", true, [](Case& asked) { asked.material.iridescence = 1.0f; }),
      choiceOf(P::anisotropy, AnisotropyPart::stretched, "anisotropy", true,
               [](Case& asked) { asked.material.anisotropy = 0.6f; }),
      choiceOf(P::sheen, SheenPart::cloth, "sheen", true,
               [](Case& asked) {
                 asked.material.sheen_color = glm::vec3(1.0f);
                 asked.material.sheen_roughness = 0.5f;
               }),
      choiceOf(P::material, MaterialPart::unlit, "unlit", true, [](Case& asked) { asked.material.unlit = true; }),
      choiceOf(P::material, MaterialPart::from_inside, "eye in the body", false,
               [](Case& asked) {
                 asked.is_in_body = true;
                 makeGlass(asked, RefractionKind::traced);
               }),
      choiceOf(P::proxy, ProxyPart::box, "proxy box", true, proxy("box:-3,-3,-3,3,3,3")),
      choiceOf(P::proxy, ProxyPart::sphere, "proxy sphere", true, proxy("sphere:0,0,0,3")),
      choiceOf(P::proxy, ProxyPart::ground, "proxy ground", false, proxy("ground:2")),
      choiceOf(P::proxy, ProxyPart::mesh, "proxy mesh", true, proxy("cube")),
      choiceOf(P::proxy, ProxyPart::captured, "probe", false, makeProbe),
      choiceOf(P::arriving_light, ArrivingLightPart::flat, "lookup flat", true,
               [](Case& asked) { asked.settings.look_up = LightLookUp::flat; }),
      choiceOf(P::arriving_light, ArrivingLightPart::flat_nearest, "lookup flat-nearest", true,
               [](Case& asked) { asked.settings.look_up = LightLookUp::flat_nearest; }),
      choiceOf(P::suns, SunsPart::shadowed, "sun split", false,
               [](Case& asked) { asked.settings.sun = SunKind::split; }),
      choiceOf(P::look_up, LookUpPart::sphere_map, "mapping sphere", true,
               [](Case& asked) { asked.settings.mapping = Mapping::sphere; }),
      choiceOf(P::look_up, LookUpPart::environment, "mapping normal", true,
               [](Case& asked) { asked.settings.mapping = Mapping::normal; }),
      choiceOf(P::dispersion, DispersionPart::spectral, "dispersion", false,
               [](Case& asked) {
                 makeGlass(asked, asked.settings.refraction);
                 asked.material.dispersion = 0.5f;
                 asked.settings.dispersion = DispersionKind::spectral;
               }),
      choiceOf(P::behind, BehindPart::screen, "behind screen", false,
               [](Case& asked) {
                 makeGlass(asked, asked.settings.refraction);
                 asked.settings.behind = BehindKind::screen;
               }),
      choiceOf(P::transmission, TransmissionPart::single, "refraction single", false,
               [](Case& asked) { makeGlass(asked, RefractionKind::single); }),
      choiceOf(P::transmission, TransmissionPart::thin, "thin walled", false,
               [](Case& asked) {
                 makeGlass(asked, RefractionKind::single);
                 asked.material.thin_walled = true;
               }),
      choiceOf(P::transmission, TransmissionPart::image_space, "refraction image-space", false,
               [](Case& asked) { makeGlass(asked, RefractionKind::image_space); }),
      choiceOf(P::transmission, TransmissionPart::traced, "refraction traced", false,
               [](Case& asked) { makeGlass(asked, RefractionKind::traced); }),
      choiceOf(P::sky, SkyPart::occluded, "occlusion", true,
               [](Case& asked) {
                 asked.is_in_scene = true;
                 asked.settings.occlusion = OcclusionKind::vertex;
               }),
      choiceOf(P::sky, SkyPart::occluded_traced, "self-reflection", true,
               [](Case& asked) {
                 asked.is_in_scene = true;
                 asked.settings.occlusion = OcclusionKind::vertex;
                 asked.settings.self_reflection = true;
                 asked.material.perceptual_roughness = 0.1f;
               }),
      choiceOf(P::lamps, LampsPart::listed, "light", false,
               [](Case& asked) {
                 asked.settings.lights = {{{0, 0, 5}, glm::vec3(0.3f)}};
               }),
      choiceOf(P::coat, CoatPart::clear, "coat", true, [](Case& asked) { asked.material.clearcoat = 1.0f; }),
      choiceOf(P::coat, CoatPart::clear_mapped, "coat with a normal map", true,
               [](Case& asked) {
                 asked.material.clearcoat = 1.0f;
                 asked.material.clearcoat_normal_map.texture = 0;
               }),
      choiceOf(P::alpha, AlphaPart::mask, "alpha mask", true,
               [](Case& asked) { asked.material.alpha_mode = AlphaMode::mask; }),
      choiceOf(P::alpha, AlphaPart::blend, "alpha blend", true,
               [](Case& asked) { asked.material.alpha_mode = AlphaMode::blend; }),
  };
  return choices;
}

/// For each question the index of a choice, or −1: the usual answer.
using ChosenSurface = std::array<int, kParts>;

inline ChosenSurface nothingChosen() {
  ChosenSurface chosen;
  chosen.fill(-1);
  return chosen;
}

inline void choose(ChosenSurface& chosen, int choice) {
  chosen[static_cast<std::size_t>(surfaceChoices()[static_cast<std::size_t>(choice)].part)] = choice;
}

/// A white surface, neither a mirror nor matt, and what is chosen, in the order of the questions.
inline SurfaceCase caseOf(const ChosenSurface& chosen) {
  SurfaceCase asked;
  asked.material.base_color = glm::vec3(1.0f);
  asked.material.perceptual_roughness = 0.4f;
  asked.settings.size = {16, 16};
  asked.settings.samples = 1;
  asked.settings.resolve = Resolve::radiance;
  for (const int choice : chosen)
    if (choice >= 0) surfaceChoices()[static_cast<std::size_t>(choice)].make(asked);
  asked.settings.camera = {.azimuth_deg = 0.0f, .elevation_deg = 0.0f, .target = glm::vec3(0.0f)};
  if (asked.is_in_body) asked.settings.camera.distance = 0.3f;
  return asked;
}

inline std::string choicesWritten(const ChosenSurface& chosen) {
  std::string name;
  for (const int choice : chosen)
    if (choice >= 0) name += (name.empty() ? "" : " + ") + surfaceChoices()[static_cast<std::size_t>(choice)].name;
  return name.empty() ? "nothing" : name;
}

/// Whether a sun is to stand apart from the environment.
inline bool hasSuns(const FrameSettings& settings) { return settings.sunShown() == SunKind::split; }

/// A ball with that material.
inline Scene sceneOfCase(const SurfaceCase& asked) {
  Scene scene = meshScene(sphereMesh(16, 32), asked.material);
  Texture flat_normals{.image = Image8(4, 4, 4, 128)};
  for (int texel = 0; texel < 16; ++texel) flat_normals.image.edit().texel(texel % 4, texel / 4)[2] = 255;
  Texture towards_eye = flat_normals;  // the mesh's +Z
  scene.textures = {flat_normals, towards_eye};
  scene.slope_textures.push_back(Image(4, 4, 3, 0.05f));
  if (asked.material.height_texture >= 0) scene.height_textures.push_back(*heightTexture(hills(), MapEdges::tiled));
  if (asked.is_in_scene) {
    const std::size_t vertices = scene.meshes[0]->vertices.size();
    scene.instances[0].occlusion.resize(vertices);
    scene.instances[0].vertex_materials.resize(vertices);
  }
  return scene;
}

/// The answers that a case asks for, as SurfacePrograms chooses them.
inline SurfaceVariant variantOfCase(const SurfaceCase& asked) {
  Scene scene;
  scene.materials = {asked.material};
  const CoordinateChoice coordinates = coordinateChoice(scene, asked.settings);
  FrameSettings settings = asked.settings;
  if (!asked.is_in_scene) settings.occlusion = OcclusionKind::none;
  Material seen = asked.material;
  // Only bodies that are traced know who is in them.
  const bool is_inside = asked.is_in_body && isBody(seen) && settings.refraction == RefractionKind::traced;
  if (is_inside) static_cast<formula::Material&>(seen) = formula::openMaterial(seen);
  SurfaceVariant variant =
      surfaceVariant(seen, std::vector<MapSource>(materialMaps().size()), settings,
                     {.lamps = settings.lights.size(), .suns = hasSuns(settings) ? 1u : 0u}, coordinates);
  if (is_inside) variant.choose(Part::material, MaterialPart::from_inside);
  const bool reads_probe = settings.probes > 0 && !coordinates.is_sphere_map && !seen.unlit &&
                           !variant.has(Part::sky, SkyPart::occluded_traced);
  if (reads_probe) {
    variant.choose(Part::proxy, ProxyPart::captured);
    variant.choose(Part::arriving_light, ArrivingLightPart::distant);
    if (variant.has(Part::sky, SkyPart::occluded)) variant.choose(Part::sky, SkyPart::open);
  }
  return variant;
}

/// (question, answer, a later question, answer)
using AnswerPair = std::tuple<std::size_t, std::uint8_t, std::size_t, std::uint8_t>;

inline std::set<AnswerPair> pairsOf(const ChosenSurface& chosen) {
  const SurfaceVariant variant = variantOfCase(caseOf(chosen));
  std::set<AnswerPair> pairs;
  for (std::size_t a = 0; a < kParts; ++a)
    for (std::size_t b = a + 1; b < kParts; ++b) pairs.insert({a, variant.answers[a], b, variant.answers[b]});
  return pairs;
}

}  // namespace mirrorball::testing
