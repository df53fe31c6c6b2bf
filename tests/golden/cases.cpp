#include "golden/cases.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string_view>

namespace mirrorball::golden {
namespace {

// The golden pictures are Mesa 22.3's llvmpipe's. Its threads, the width of its vectors and the way through Vulkan
// (zink on lavapipe) do not change a bit of them. Two drivers that share no rasteriser and no texture filter with it
// were measured too: Mesa's softpipe, and Chromium's SwiftShader (through zink), which is the harshest that can be met,
// since it puts vertices on a grid of 1/16 pixel where llvmpipe and GPUs have 1/256. The greater difference of the two
// stands at each tolerance, as maximum / mean. No GPU was at hand.
//
// The mean allowed lies between that and what the least errors make, which are found by their mean; so are 2 % of
// exposure, in every case. The maximum is for holes and stray pixels.

const Tolerance kOnTheCpu{1, 0.02, "made on the CPU: another compiler's rounding may turn a texel to the next code"};

const Tolerance kFaceted{255, 0.2, "at an edge between facets a ray may meet the one or the other"};

// 44 / 0.27 (softpipe, on a column of pixels along a cube's edge; SwiftShader 1 / 0.01)
const Tolerance kFiltered{60, 0.4, "no outline; drivers weigh the texels on both sides of a cube's edge differently"};

// 45 / 0.19. One of 16 samples that sees a lamp instead of a wall of 0.1 turns code 89 to about 110.
const Tolerance kOutlined{120, 0.25, "at an outline, one of a pixel's 16 samples may see a lamp instead of a wall"};

// 65 / 0.26
const Tolerance kFinelyOutlined{120, 0.4, "the same, on thin parts that are nearly all outline"};

// 44 / 0.48
const Tolerance kBumpy{60, 0.65, "pores smaller than a pixel, whose slopes follow the last bits of the position"};

// 64 / 0.67
const Tolerance kFinelyLined{80, 1.0, "lines and letters smaller than a pixel, mirrored in a curved surface"};

// Why a picture is not what is traced of its command; docs/truth/renderer.md shows the distance without noise.
// Each bound is 1 dB below what was measured: a traced picture is the same each time.

constexpr const char* kExact = "exact but for the samples, whose noise lies at edges";

constexpr const char* kTexels = "exact but for the texels that the renderer makes of lines that are a function";

constexpr const char* kRefracts = "exact but for the noise of paths that are either reflected or refracted";

constexpr const char* kSplits = "of two ways that meet a surface, one is followed; the rest is noise of paths";

constexpr const char* kOneSurface = "faces that the eye does not see are not found; the rest is noise of paths";

constexpr const char* kChannels = "three wavelengths stand for all; the rest is noise of paths";

constexpr const char* kSpectrum = "paths of single wavelengths have noise of colours";

constexpr const char* kLobes = "four round lobes stand for one that is stretched; the rest is noise";

constexpr const char* kCloth = "light on cloth is gathered from twelve directions; the rest is noise";

constexpr const char* kFacets = "two kinds of facets stand for all: it is Schlick's power of 5 that chooses which";

constexpr const char* kByNormal = "wrong by construction: where the eye is does not count; the background is blurred";

constexpr const char* kBesideShadow = "the ball's light on the ground is missing, and what of the ground is seen in it";

constexpr const char* kFarAway = "wrong by construction: the rays of a sphere map are parallel";

constexpr const char* kPainted = "no reflection at all: the environment is painted on the object";

constexpr const char* kMipLevel = "a mip level for a lobe: too sharp or too blurred, with seams between the faces";

constexpr const char* kAtVertices = "wrong by construction: what the corners reflect is mixed between them";

constexpr const char* kHorizons =
    "eight horizons hide the sky, and a hidden place is as bright as what it hides; noise";

constexpr const char* kFlat = "the mesh is taken as flat around a pixel; and the horizons";

constexpr const char* kOffset = "wrong by construction: the place is guessed; and the horizons";

constexpr const char* kFadesEarly =
    "Mesa's anisotropic filter sees the whole pixel in each sample, in 16 reads at most, and stripes fade early; noise";

constexpr auto kCases = std::to_array<Case>({
    {"showcase", "render showcase -e studio --camera 30,15,2.9 --size 112x84", &kFinelyOutlined,
     "--exposure 0.0286",  // 2 %
     Truth{33.8, kLobes, "", 16, 32}},

    // The environment near by.
    {"proxy_box", "render sphere --material mirror -e uv --proxy box:-3,-1.5,-4,5,3,4 --camera 20,10,4 --size 72x54",
     &kOutlined, "--captured-at 1,0.75,0.02", Truth{35.5, kExact, "--proxy sphere:1,0.75,0,4.5", 16, 16}},
    {"ground",
     "render sphere --material gold -e sunset --proxy ground:2 --ground-roughness 0.25 --camera "
     "30,20 --size 72x54",
     &kOutlined, "--proxy ground:2.02", Truth{30.7, kBesideShadow, "--proxy ground:2.5", 16, 64}},

    // Every material, on a shape that shows it.
    {"mirror", "render sphere --material mirror --size 96x96", &kOutlined, "--env-rotation 0.5",
     Truth{46, kExact, "--env-rotation 2", 36, 16}},
    {"chrome", "render torus --material chrome --camera 30,40,3 --size 120x90", &kOutlined,
     "--set conductor_k=3.2,3.2,3.0", Truth{42.2, kExact, "", 16, 16}},
    {"gold", "render teapot --material gold --background transparent --camera 30,20,2.3 --size 144x96",
     &kFinelyOutlined, "--set conductor_n=0.2,0.5,1.4", Truth{35.8, kExact, "", 16, 16}},
    {"glass", "render sphere --material glass --size 96x96", &kOutlined, "--set ior=1.53",
     Truth{33, kRefracts, "--set ior=1.6", 16, 64}},
    {"water", "render knot --material water --background #336699 --size 96x96", &kOutlined, "--set ior=1.36",
     Truth{31.7, kRefracts, "", 16, 64}},
    {"diamond", "render torus --material diamond --camera 30,40,3 --size 120x90", &kOutlined, "--set ior=2.46",
     Truth{31.6, kRefracts, "", 16, 64}},
    {"traced_glass", "render tumbler-water --set dispersion=0 --refraction traced --camera 30,20,3 --size 56x56",
     &kOutlined, "--inner-bounces 2", Truth{28.2, kSplits, "--refraction single", 16, 64}},
    {"traced_diamond", "render brilliant --material diamond --refraction traced --camera 20,35 --size 72x72",
     &kFinelyOutlined, "--set dispersion=0", Truth{19, kChannels, "--refraction single", 16, 64}},
    {"spectral_prism",
     "render prism --material sf11 --refraction traced --dispersion spectral --camera 70,-30 --size 72x54",
     &kFinelyOutlined, "--dispersion channels", Truth{32.8, kSpectrum, "--dispersion channels", 16, 512}},
    {"image_space_glass",
     "render torus --material glass --set dispersion=0 --refraction image-space --camera 30,40,3 --size 80x60",
     &kFinelyOutlined, "--set ior=1.53", Truth{29.8, kOneSurface, "--refraction single", 16, 64}},
    {"eye_in_water",
     "render tumbler-water --set dispersion=0 --refraction traced --camera 30,-30,0.3 --target 0,0,0 --fov 100 "
     "--size 64x48",
     &kOutlined, "--inner-bounces 1", Truth{30.7, kSplits, "--refraction single", 16, 64}},
    {"rough_metal", "render knot --material rough-metal --size 96x96", &kOutlined, "--set perceptual_roughness=0.47",
     Truth{31.1, kLobes, "--set perceptual_roughness=0.3", 16, 32}},
    {"plastic", "render teapot --material plastic --camera 30,20,2.3 --size 96x64", &kOutlined,
     "--set base_color=0.66,0.03,0.03", Truth{29.7, kLobes, "", 16, 32}},
    {"orange", "render sphere --material orange --size 96x96", &kBumpy, "--set bump_height=0.0065",
     Truth{28.4, kLobes, "", 16, 32}},

    // What glTF's extensions lay on a surface.
    {"car_paint", "render sphere --material car-paint --size 96x96", &kOutlined, "--set clearcoat=0.7",
     Truth{30.6, kLobes, "--set clearcoat=0.5", 16, 32}},
    {"velvet", "render sphere --material velvet --size 96x96", &kOutlined, "--set sheen_roughness=0.45",
     Truth{31.1, kCloth, "--set sheen_color=0.4,0.1,0.2", 16, 32}},
    {"brushed_metal", "render sphere --material brushed-metal --size 96x96", &kOutlined, "--set anisotropy=0.68",
     Truth{25.8, kLobes, "--set anisotropy_rotation=1.57", 16, 32}},
    {"soap_bubble", "render sphere --material soap-bubble --size 96x96", &kOutlined, "--set iridescence_thickness=396",
     Truth{40, kExact, "--set iridescence_thickness=380", 16, 64}},

    // One material with two of its parameters in steps.
    {"roughness_grid", "render roughness-grid --camera 30,0 --size 160x100", &kOutlined, "--set specular=0.5",
     Truth{31, kLobes, "", 16, 32}},
    {"transmission_grid", "render transmission-grid --camera 30,0 --size 160x70", &kOutlined, "--set ior=1.53",
     Truth{26.6, kLobes, "", 16, 32}},
    {"index_grid", "render index-grid --camera 30,0 --size 160x70", &kOutlined, "--set base_color=0.97",
     Truth{28.9, kRefracts, "", 16, 32}},
    {"attenuation_grid", "render attenuation-grid --refraction traced --camera 30,0 --size 160x100", &kOutlined,
     "--set attenuation_distance=3", Truth{28.2, kSplits, "", 16, 32}},
    {"clearcoat_grid", "render clearcoat-grid --camera 30,0 --size 160x100", &kOutlined, "--set clearcoat=0.9",
     Truth{30.8, kLobes, "", 16, 32}},
    {"sheen_grid", "render sheen-grid --camera 30,0 --size 160x100", &kOutlined, "--set sheen_roughness=0.5",
     Truth{29.1, kCloth, "", 16, 32}},
    {"anisotropy_grid", "render anisotropy-grid --camera 30,0 --size 160x100", &kOutlined, "--set anisotropy=0.5",
     Truth{26, kLobes, "", 16, 32}},
    {"iridescence_grid", "render iridescence-grid --camera 30,0 --size 160x70", &kOutlined,
     "--set iridescence_ior=1.33", Truth{21.5, kLobes, "", 16, 32}},

    // Which way round the environment is, looking at its faces from inside.
    {"uv_along_minus_z", "render none -e uv --camera 0,0 --fov 100 --size 96x72", &kFiltered, "--fov 100.1",
     Truth{40.8, kTexels, "--env-rotation 2", 16, 16}},
    {"uv_along_plus_z", "render none -e uv --camera 180,0 --fov 100 --size 96x72", &kFiltered, "--fov 100.1",
     Truth{40.6, kTexels, "", 16, 16}},
    {"uv_along_minus_y", "render none -e uv --camera 180,90 --fov 100 --size 96x72", &kFiltered, "--fov 100.1",
     Truth{42, kTexels, "", 16, 16}},

    // Cameras, and the forms of looking a map up.
    {"orthographic", "render sphere -e uv --material mirror --orthographic 2 --camera 0,0 --size 96x96", &kFinelyLined,
     "--orthographic 2.005", Truth{35.2, kTexels, "", 16, 16}},
    {"mapping_normal",
     "render teapot -e uv --material mirror --mapping normal --background blur --camera 30,20,2.3 --size 96x64",
     &kFinelyLined, "--env-rotation 0.3", Truth{10.7, kByNormal, "", 16, 16}},
    {"mapping_sphere", "render teapot -e uv --material mirror --mapping sphere --camera 30,20,2.3 --size 96x64",
     &kFinelyLined, "--env-rotation 0.2", Truth{16.8, kFarAway, "", 16, 16}},
    {"reflect_at_vertex",
     "render cube -e uv --material mirror --reflect-at vertex --background 0.2,0.2,0.2 "
     "--camera 130,25,3.1 --size 96x72",
     &kFinelyLined, "--reflect-at fragment", Truth{22.4, kAtVertices, "", 16, 16}},
    // Not for softpipe, 220 / 4.1: it fetches texels of one mip level for four pixels, also where their levels differ.
    {"lookup_flat",
     "render sphere -e uv --material mirror --set perceptual_roughness=0.5 --blur mip --lookup flat --size 96x96",
     &kOutlined, "--lookup cube", Truth{22.9, kMipLevel, "", 16, 32}},

    // Coordinates generated: of the environment, and of a picture, which is nothing that light does.
    {"texgen_object_linear",
     "render teapot -e uv --material mirror --texgen object-linear --camera 30,20,2.3 --size 96x64", &kFinelyLined,
     "--env-rotation 0.2", Truth{12.6, kPainted, "", 16, 16}},
    {"texgen_eye_linear",
     "render teapot --set base_color_map=pictures/convert_cross.png --texgen eye-linear --camera 30,20,2.3 "
     "--texture-matrix 0.5,0,0,0.5,0,0.5,0,0.5,0,0,1,0,0,0,0,1 --size 96x64",
     &kFinelyLined, "--texture-matrix 0.5,0,0,0.505,0,0.5,0,0.5,0,0,1,0,0,0,0,1"},
    {"texgen_normal",
     "render teapot --set base_color_map=pictures/convert_sphere.png --texgen normal --camera 30,20,2.3 "
     "--texture-matrix 0.5,0,0,0.5,0,0.5,0,0.5,0,0,1,0,0,0,0,1 --size 96x64",
     &kFinelyLined, "--texture-matrix 0.5,0,0,0.505,0,0.5,0,0.5,0,0,1,0,0,0,0,1"},
    {"texgen_sphere",
     "render teapot --set base_color_map=pictures/convert_sphere.png --texgen sphere --camera 30,20,2.3 --size 96x64",
     &kFinelyLined, "--texture-matrix 1,0,0,0.005,0,1,0,0,0,0,1,0,0,0,0,1"},
    {"texgen_reflection", "render teapot -e uv --material mirror --texgen reflection --camera 30,20,2.3 --size 96x64",
     &kFinelyLined, "--env-rotation 0.2", Truth{33.1, kTexels, "", 16, 16}},
    {"texgen_light",
     "render teapot --set base_color_map=pictures/convert_cross.png --texgen light --light 2,2,3,0,0,0 "
     "--camera 30,20,2.3 --size 96x64",
     &kFinelyLined, "--texture-matrix 1,0,0,0.005,0,1,0,0,0,0,1,0,0,0,0,1"},

    // Relief by each kind, over heights of 128² so that it is quick; and what else bends normals.
    {"relief_parallax",
     "render plane --set height=heights/brick.png --set height_scale=0.08 --relief parallax --camera 30,35,0.9 --fov "
     "15 --size "
     "64x48",
     &kOutlined, "--set height_scale=0.085", Truth{22.3, kOffset, "--relief bump", 16, 32}},
    {"relief_occlusion",
     "render plane --set height=heights/brick.png --set height_scale=0.08 --relief occlusion --camera 30,20,0.9 --fov "
     "12 --size "
     "64x48",
     &kOutlined, "--set height_scale=0.085", Truth{25.8, kHorizons, "--relief parallax", 16, 32}},
    {"relief_cone",
     "render sphere --set height=heights/brick.png --set height_frequency=4 --set height_scale=0.1 --relief cone "
     "--camera 30,20,3 --fov 15 --size 64x48",
     &kOutlined, "--set height_scale=0.105", Truth{22.4, kFlat, "--relief bump", 16, 32}},
    {"relief_exact_plane",
     "render plane --set height=heights/brick.png --set height_scale=0.08 --relief exact --camera 30,15 --size 64x48",
     &kOutlined, "--set height_scale=0.085", Truth{30.6, kHorizons, "--relief linear-binary", 16, 32}},
    {"relief_exact",
     "render torus --set height=heights/brick.png --set height_frequency=2 --set height_scale=0.08 --relief exact "
     "--camera 30,25 --size 64x48",
     &kFinelyOutlined, "--set height_scale=0.085", Truth{27.3, kHorizons, "--relief linear-binary", 16, 32}},
    {"relief_geometry",
     "render torus --set height=heights/brick.png --set height_frequency=2 --set height_scale=0.08 --relief geometry "
     "--camera 30,25 --size 64x48",
     &kFinelyOutlined, "--set height_scale=0.085", Truth{31.9, kLobes, "--relief bump", 16, 32}},
    {"derivative_map",
     "render plane --set base_color=0.5 --set perceptual_roughness=0.4 --set derivative_map=pictures/slopes.png "
     "--camera 20,60 --size 64x48",
     &kBumpy, "--set derivative_scale=1.3", Truth{33.9, kLobes, "--set derivative_scale=-1", 16, 32}},
    {"object_normal_map",
     "render sphere --set base_color=0.5 --set normal_map=pictures/facets.png --set normal_space=object --size 64x64",
     &kOutlined, "--env-rotation 2", Truth{33.9, kLobes, "--set normal_space=tangent", 16, 32}},
    {"stripes",
     "render plane --set base_color_map=stripes --set base_color=1 --set specular=0 -e white "
     "--texture-filter anisotropic --camera 25,6,1.2 --size 96x48",
     &kFiltered, "--texture-filter trilinear", Truth{21.8, kFadesEarly, "", 16, 32}},

    // The rest of what has a code of its own.
    {"fresnel_empirical",
     "render sphere --material plastic --fresnel empirical --set fresnel_offset=0.1 --set fresnel_scale=0.9 "
     "--set fresnel_power=2 --size 96x96",
     &kOutlined, "--set fresnel_power=2.1", Truth{30.3, kFacets, "", 16, 32}},
    {"sky", "render sphere -e sky:elevation=30 --env-rotation 40 --material mirror --tone-map aces --size 96x96",
     &kOutlined, "-e sky:elevation=30,turbidity=2.6", Truth{51, kExact, "--env-rotation 42", 16, 16}},
    {"light",
     "render sphere --material plastic --set perceptual_roughness=0.3 --env-intensity 0.1 "
     "--light 3,4,3,0.8,0.7,0.6 --light -3,1,2,0.1,0.3,0.6 --camera 20,15 --size 96x96",
     &kOutlined, "--light 3,4,3,0.02,0.02,0.02", Truth{42, kLobes, "--set perceptual_roughness=0.35", 16, 32}},

    // The projections. What would be wrong with one is done to the golden picture itself, in comparison_test.cpp.
    {"convert_equirect", "convert uv --to equirect --size 80", &kOnTheCpu, ""},
    {"convert_sphere", "convert uv --to sphere --size 96", &kOnTheCpu, ""},
    {"convert_angular", "convert uv --to angular --size 96", &kOnTheCpu, ""},
    {"convert_cross", "convert uv --to cube --size 40", &kOnTheCpu, ""},

    // Maps of surfaces.
    {"slopes", "surface pictures/uv_along_plus_z.png --to derivative --scale 0.05", &kOnTheCpu,
     "--difference backward"},
    {"facets", "transfer brilliant sphere --cage 1 --space object --size 48", &kFaceted, "--space tangent"},
});

/// The command without the option and its value, if it has it.
std::string withoutOption(std::string command, std::string_view option) {
  const std::string found = " " + std::string(option) + " ";
  const std::size_t begin = command.find(found);
  if (begin != std::string::npos) command.erase(begin, command.find(' ', begin + found.size()) - begin);
  return command;
}

/// Whether light comes to the surface between heights, or to a ground, that hide it in the renderer, too: from all
/// around, and from each other.
bool hidesLight(std::string_view command) {
  if (command.find(" --proxy ground") != std::string_view::npos) return true;
  return command.find(" --relief ") != std::string_view::npos && command.find("geometry") == std::string_view::npos;
}

/// The command with an option and its value, which takes the place of the one that it may have.
std::string withOption(const std::string& command, const std::string& changed) {
  if (changed.empty()) return command;
  const std::string option = changed.substr(0, changed.find(' '));
  const bool adds_up = option == "--set" || option == "--light";
  return (adds_up ? command : withoutOption(command, option)) + " " + changed;
}

}  // namespace

std::span<const Case> cases() { return kCases; }

const Case& caseNamed(const std::string& name) {
  const auto* const found =
      std::find_if(kCases.begin(), kCases.end(), [&](const Case& known) { return known.name == name; });
  assert(found != kCases.end());
  return *found;
}

std::string commandOf(const Case& golden_case, const std::string& changed) {
  // So that one sample on the other side of an edge changes a pixel by a 16th of the contrast.
  return withOption(
      golden_case.command + std::string(needsGl(golden_case) ? " --quality draft --samples 16 --sampling all" : ""),
      changed);
}

std::string drawnCommandOf(const Case& golden_case, const std::string& changed) {
  const std::string samples = " --quality draft --samples " + std::to_string(golden_case.truth->samples);
  return withOption(golden_case.command + samples + " --resolve radiance", changed);
}

std::string tracedCommandOf(const Case& golden_case) {
  std::string command = golden_case.command;
  for (const std::string_view option :
       {"--mapping", "--reflect-at", "--texgen", "--blur", "--lookup", "--dispersion", "--texture-filter"})
    command = withoutOption(command, option);
  if (command.find("--background blur") != std::string::npos) command = withoutOption(command, "--background");
  command += " --samples " + std::to_string(golden_case.truth->paths) + " --reference";
  return hidesLight(command) ? command : command + " --bounces 1 --unoccluded";
}

bool wrapsPicture(const Case& golden_case) {
  const std::string_view command(golden_case.command);
  return command.find(" --set base_color_map=") != std::string_view::npos &&
         command.find(" --texgen ") != std::string_view::npos;
}

bool needsGl(const Case& golden_case) { return std::string_view(golden_case.command).starts_with("render"); }

}  // namespace mirrorball::golden
