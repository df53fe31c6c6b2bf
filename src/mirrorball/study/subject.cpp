#include "mirrorball/study/subject.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"
#include "mirrorball/rays/seen_from.h"
#include "mirrorball/scene/material/material.h"
#include "mirrorball/scene/material/material_changes.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

using enum Technique::Maker;

constexpr std::string_view kKnownToMap = "bounces=1 unoccluded=yes";  // all that an environment map can know
constexpr std::string_view kComparedWithMap = "one bounce, and nothing blocks the light";

constexpr std::string_view kRoom = "proxy=box:-3,-1.5,-4,5,3,4";

constexpr auto kPlane = std::to_array<std::string_view>({"plane"});
constexpr auto kSphere = std::to_array<std::string_view>({"sphere"});
constexpr auto kBowl = std::to_array<std::string_view>({"bowl"});
constexpr auto kHidingThemselves = std::to_array<std::string_view>({"bowl", "spheres", "teapot"});
constexpr auto kOfEachKind = std::to_array<std::string_view>(
    {"showcase", "tumbler-water", "attenuation-grid", "spheres", "bowl", "teapot", "knot"});
constexpr auto kInterreflecting = std::to_array<std::string_view>({"spheres", "bowl"});

constexpr auto kLookUps = std::to_array<Technique>({{"cube, reflected ray", "mapping=reflection"},
                                                    {"sphere map", "mapping=sphere"},
                                                    {"cube, normal", "mapping=normal"},
                                                    {"sphere map for this camera", "texgen=sphere"}});

constexpr auto kTexels = std::to_array<Technique>({{"cube sampler", "blur=mip lookup=cube"},
                                                   {"flat picture, weighed", "blur=mip lookup=flat"},
                                                   {"flat picture, nearest", "blur=mip lookup=flat-nearest"}});

constexpr auto kFilters = std::to_array<Technique>({{"nearest texel", "texture-filter=nearest samples=1"},
                                                    {"four texels", "texture-filter=bilinear samples=1"},
                                                    {"mip levels", "texture-filter=trilinear samples=1"},
                                                    {"anisotropic", "texture-filter=anisotropic samples=1"}});

constexpr auto kReflectAt = std::to_array<Technique>({{"each fragment", "reflect-at=fragment"},
                                                      {"each vertex", "reflect-at=vertex"},
                                                      {"each triangle", "reflect-at=triangle"}});

constexpr auto kBlurs = std::to_array<Technique>({{"exact prefiltering", "blur=exact"},
                                                  {"GPU prefiltering", "blur=gpu"},
                                                  {"coarser mip level", "blur=mip"},
                                                  {"cone of 64 rays", "blur=cone"}});

constexpr auto kLobeTaps = std::to_array<Technique>({{"one round lobe", "blur=exact lobe-taps=1"},
                                                     {"a row of 2", "blur=exact lobe-taps=2"},
                                                     {"a row of 4", "blur=exact lobe-taps=4"},
                                                     {"a row of 6", "blur=exact lobe-taps=6"}});

constexpr auto kSteps = std::to_array<Technique>({{"distant map, drawn"},
                                                  {"what a map can know", kKnownToMap, "", path_tracer},
                                                  {"and occlusion", "bounces=1", "", path_tracer},
                                                  {"2 bounces", "bounces=2", "", path_tracer},
                                                  {"4 bounces", "bounces=4", "", path_tracer}});

constexpr auto kOcclusion = std::to_array<Technique>(
    {{"with the occlusion map", "", "occlusion_strength=1"}, {"without it", "", "occlusion_strength=0"}});

constexpr auto kReliefs = std::to_array<Technique>({{"none", "relief=none"},
                                                    {"bump", "relief=bump"},
                                                    {"parallax", "relief=parallax"},
                                                    {"steep", "relief=steep"},
                                                    {"occlusion", "relief=occlusion"},
                                                    {"linear-binary", "relief=linear-binary"},
                                                    {"cone", "relief=cone"},
                                                    {"exact", "relief=exact"},
                                                    {"geometry", "relief=geometry"}});

constexpr auto kHiding = std::to_array<Technique>({{"nothing is hidden", "occlusion=none"},
                                                   {"as vertices know", "occlusion=vertex"},
                                                   {"and by rays", "self-reflection=yes"},
                                                   {"probes", "probes=auto"}});

constexpr auto kProxies = std::to_array<Technique>(
    {{"infinitely far away", "proxy=none"}, {"on a sphere", "proxy=sphere:0,0,0,4"}, {"on the room's walls", kRoom}});

// `samples` is said by who studies.
constexpr auto kQualities = std::to_array<Technique>({{.name = "draft", .settings = "", .quality = Quality::draft},
                                                      {.name = "good", .settings = "", .quality = Quality::good},
                                                      {.name = "best", .settings = "", .quality = Quality::best}});

constexpr auto kDistantMap = std::to_array<Technique>({{"distant map, drawn"}});

constexpr auto kRoughnesses = std::to_array({0.05, 0.1, 0.2, 0.3, 0.45, 0.6, 0.8, 1.0});
constexpr auto kMipRoughnesses = std::to_array({0.0, 0.1, 0.2, 0.3, 0.45, 0.6});
constexpr auto kFields_deg = std::to_array({2.0, 10.0, 20.0, 35.0, 60.0, 90.0});
constexpr auto kRings = std::to_array({8.0, 16.0, 32.0, 64.0, 128.0});
constexpr auto kElevations_deg = std::to_array({60.0, 30.0, 10.0});
constexpr auto kGaps = std::to_array({0.0, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0});

void setRoughness(double value, Scene& scene, FrameSettings&) {
  for (Material& material : scene.materials) material.perceptual_roughness = static_cast<float>(value);
}

void setFieldOfView(double value_deg, Scene&, FrameSettings& frame) {
  frame.camera.fov_deg = static_cast<float>(value_deg);
}

void setElevation(double value_deg, Scene&, FrameSettings& frame) {
  frame.camera.elevation_deg = static_cast<float>(value_deg);
}

void setRings(double value, Scene& scene, FrameSettings&) {
  const int rings = static_cast<int>(value);
  const int material = scene.meshes[0]->material;
  scene.meshes[0] = sphereMesh(rings, 2 * rings);
  scene.meshes[0].edit().material = material;
}

/// Puts a red sphere beside the one that there is, and the camera where the first is seen whole and in one place, so
/// that pictures of all distances have the same pixels.
void setGap(double value, Scene& scene, FrameSettings& frame) {
  const glm::vec3 aside(2.0f + static_cast<float>(value), 0.0f, 0.0f);
  scene.instances.push_back({.mesh = 1, .world_from_object = glm::translate(glm::mat4(1.0f), aside)});
  scene.meshes.push_back(scene.meshes[0]);
  scene.meshes[1].edit().material = 1;
  scene.materials.push_back(*materialNamed("plastic"));
  frame.camera = {.azimuth_deg = -20.0f,
                  .elevation_deg = 10.0f,
                  .distance = 4.2f / boundingSphere(scene).radius,
                  .target = glm::vec3(0.0f)};
}

bool always(const Scene&) { return true; }
bool never(const Scene&) { return false; }

bool hasPictures(const Scene& scene) { return !scene.textures.empty(); }

bool hasOcclusionMap(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& m) { return m.occlusion_map.texture >= 0; });
}

/// Whether light may meet more than one of its surfaces: of a convex body all numbers of bounces are the same picture.
bool mayReflectItself(const Scene& scene) {
  return traitsOf(scene).lets_light_through || hidesItself(scene).value_or(true);
}

bool hasHeights(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& m) { return m.height != HeightKind::none; });
}

constexpr std::array kSubjects{
    Subject{.id = "look-up",
            .title = "What addresses the map",
            .teaches = "The reflected ray finds the light that a mirror shows. A sphere map is addressed by the normal "
                       "instead, as if all rays from the eye were parallel: the wider the field of view, the wronger. "
                       "The normal in a cube map only looks like something shiny. A sphere map that is made for the "
                       "camera and addressed by the reflected ray is right again for a mirror. Both are sharp on rough "
                       "surfaces too, which the cube has in all degrees of blur.",
            .models = kSphere,
            .material = "mirror",
            .reference = kKnownToMap,
            .compared_with = kComparedWithMap,
            .techniques = kLookUps,
            .series = Series{"field of view in degrees", kFields_deg, setFieldOfView, false},
            .applies = always},
    Subject{.id = "texels",
            .title = "From a direction to texels",
            .teaches = "A cube sampler weighs the texels around a direction, also beyond the edge of a face. A shader "
                       "that finds face and texels by itself in one flat picture does the same but for the edges, "
                       "where it has no neighbours: seams, the wider the fewer texels a mip level has.",
            .models = kSphere,
            .material = "mirror",
            .reference = kKnownToMap,
            .compared_with = kComparedWithMap,
            .techniques = kTexels,
            .series = Series{"perceptual roughness", kMipRoughnesses, setRoughness, true},
            .applies = always},
    Subject{.id = "texture-filter",
            .title = "Texels smaller than pixels",
            .teaches = "A striped floor with one sample a pixel. Where many texels lie in a pixel, one of them or four "
                       "say little of the rest: patterns that are not there, and that shimmer as the floor turns. A "
                       "mip level has their mean, but of a square: at a grazing angle it blurs along the stripes' "
                       "width too. Anisotropic filtering reads the long way piece by piece.",
            .models = kPlane,
            .view = "camera=25,6,1.2",
            .parameters = "base_color_map=stripes base_color=1 specular=0",
            .reference = kKnownToMap,
            .compared_with = kComparedWithMap,
            .techniques = kFilters,
            .applies = hasPictures},
    Subject{.id = "relief",
            .title = "Which one is fake?",
            .teaches =
                "Stones on a flat square. Bumps only turn the normals, and seen from the side they lie flat. The "
                "searches move the place in the texture, so that stones hide each other, but the square keeps "
                "its straight edges. Exact relief ends where the stones do, as true triangles (geometry) do.",
            .models = kPlane,
            .view = "camera=30,45,1.3",
            .parameters = "height=cobbles base_color=0.4",
            .shows = "relief=exact",
            .compared_with = "the exact surface, up to 16 bounces",
            .techniques = kReliefs,
            .series = Series{"degrees above the plane", kElevations_deg, setElevation, true},
            .applies = hasHeights},
    Subject{.id = "reflect-at",
            .title = "Where the ray is reflected",
            .teaches = "The first hardware reflected rays at the vertices and interpolated them. How wrong that is "
                       "depends on how large the triangles are; at each fragment, it is right on any mesh.",
            .models = kSphere,
            .material = "mirror",
            .reference = kKnownToMap,
            .compared_with = kComparedWithMap,
            .techniques = kReflectAt,
            .series = Series{"rings of the sphere", kRings, setRings, false, true},
            .applies = always},
    Subject{.id = "blur",
            .title = "Rough reflections and the split sum",
            .teaches = "Four ways to blur the map for a rough surface. All share the split sum: blurred light times "
                       "one number for the BRDF. Mip levels and cones take the lobe to be round. It stretches at "
                       "grazing angles, so a rough metal is most wrong where n·v is small.",
            .models = kSphere,
            .material = "rough-metal",
            .reference = kKnownToMap,
            .compared_with = kComparedWithMap,
            .techniques = kBlurs,
            .series = Series{"perceptual roughness", kRoughnesses, setRoughness, true},
            .by_angle = true,
            .applies = always},
    Subject{.id = "lobes",
            .title = "A round lobe, or a row of them",
            .teaches =
                "What a rough surface reflects is a round spot of light only where it is seen from above. "
                "At an angle, the spot is as long as ever but n·v as narrow, and bends away from the horizon. A row "
                "of narrower round lobes in the plane of incidence is nearly that.",
            .models = kSphere,
            .material = "rough-metal",
            .reference = kKnownToMap,
            .compared_with = kComparedWithMap,
            .techniques = kLobeTaps,
            .series = Series{"perceptual roughness", kRoughnesses, setRoughness, true},
            .by_angle = true,
            .applies = always},
    Subject{.id = "knowledge",
            .title = "What a map can know",
            .teaches = "A map has the light from far away. It does not know that objects block that light, nor that "
                       "they send light to each other: where rays bounce several times before they escape, it is wrong "
                       "by construction.",
            .models = kInterreflecting,
            .material = "mirror",
            .view = "camera=20,40",
            .compared_with = "up to 16 bounces",
            .techniques = kSteps,
            .applies = mayReflectItself},
    Subject{.id = "self-occlusion",
            .title = "What objects hide and mirror of themselves",
            .teaches =
                "Rays from each vertex tell, once, how much of the sky it sees and from where; what is hidden "
                "shows the object's own light. A ray from each pixel of a polished surface finds what it mirrors "
                "of its neighbours. Probes capture what is around whole objects, and so know nothing of folds.",
            .models = kHidingThemselves,
            .view = "camera=20,40",
            .compared_with = "up to 16 bounces",
            .techniques = kHiding,
            .applies = mayReflectItself},
    Subject{.id = "proxy",
            .title = "A room that is near",
            .teaches = "A mirror ball off the middle of a room shows the walls where they are only if the shader knows "
                       "where they are: a box fits, a sphere nearly, and an environment that is infinitely far away "
                       "shows what the middle of the room would see.",
            .models = kSphere,
            .material = "mirror",
            .shows = kRoom,
            .reference = kKnownToMap,
            .compared_with = "the same room, one bounce",
            .techniques = kProxies,
            .applies = never},
    Subject{.id = "quality",
            .title = "Draft, good and best",
            .teaches = "What `render` fills in of the options that are not given. A draft takes every surface to be "
                       "alone with its environment; good knows what hides it and what is behind glass; best traces all "
                       "glass. All have the same number of samples here.",
            .models = kOfEachKind,
            .compared_with = "up to 16 bounces",
            .techniques = kQualities,
            .applies = always},
    Subject{.id = "occlusion-map",
            .title = "What an occlusion map brings",
            .teaches =
                "An occlusion map says how much of the sky each place sees, but not which part. Inside of a "
                "spherical bowl that share is the same everywhere: the opening's share of the sphere. Compared with "
                "one bounce, which has the shadows themselves.",
            .models = kBowl,
            .view = "camera=20,40",
            .reference = "bounces=1",
            .compared_with = "one bounce, with shadows",
            .techniques = kOcclusion,
            .applies = hasOcclusionMap},
    Subject{.id = "distance",
            .title = "How far away is far away",
            .teaches = "A mirror sphere with a red one beside it. The map takes everything to be infinitely far; the "
                       "error falls as the neighbour moves away and fills less of the mirror.",
            .models = kSphere,
            .material = "mirror",
            .compared_with = "up to 16 bounces",
            .techniques = kDistantMap,
            .series = Series{"gap between the spheres, in radii", kGaps, setGap, false, true},
            .applies = never},
};

/// The words of a text, without those of no letters.
std::vector<std::string> wordsOf(std::string_view text) {
  std::vector<std::string> words = split(text, ' ');
  std::erase(words, "");
  return words;
}

template <typename Target>
Result<void> setByTable(std::span<const Option<Target>> table, std::string_view settings, Target& target) {
  for (const std::string& word : wordsOf(settings)) {
    const std::string name = word.substr(0, word.find('='));
    const auto row = findBy(table, name, [](const auto& option) { return option.text.name; });
    if (row == table.end()) return fail(ErrorCode::usage, "there is no option " + name);
    MIRRORBALL_TRY_VOID(assign(*row, target, std::string_view(word).substr(std::min(name.size() + 1, word.size()))));
  }
  return {};
}

}  // namespace

std::span<const Subject> subjects() { return kSubjects; }

Result<void> applySettings(std::string_view settings, FrameSettings& frame) {
  return setByTable(frameOptions(), settings, frame);
}

Result<void> applySettings(std::string_view settings, TraceSettings& trace) {
  return setByTable(traceOptions(), settings, trace);
}

std::set<std::string_view> namesOfSettings(std::string_view settings) {
  std::set<std::string_view> names;
  for (const Option<FrameSettings>& option : frameOptions())
    for (const std::string& word : wordsOf(settings))
      if (word.substr(0, word.find('=')) == option.text.name) names.insert(option.text.name);
  return names;
}

Result<void> applyParameters(std::string_view parameters, Scene& scene) {
  return changeMaterials(scene, {.set = wordsOf(parameters)});
}

}  // namespace mirrorball
