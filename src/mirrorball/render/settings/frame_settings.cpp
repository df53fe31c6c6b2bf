#include "mirrorball/render/settings/frame_settings.h"

#include <array>

#include <glm/gtc/matrix_transform.hpp>

#include "formula/color.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/render/settings/frame_fields.h"

namespace mirrorball {
namespace {

const auto kOptions = std::to_array<Option<FrameSettings>>({
    {{.name = "size",
      .value = "WxH|W",
      .unit = "pixels",
      .min_count = 2,
      .max_count = 2,
      .help = "width and height of the picture; of a width alone, the height keeps the default's shape",
      .group = "Picture",
      .is_daily = true,
      .between_numbers = 'x'},
     frame_fields::kSize},
    {{.name = "samples",
      .value = "N",
      .minimum = 1,
      .maximum = 4096,
      .help = "number of samples per pixel, spread evenly over its area",
      .group = "Picture",
      .is_daily = true},
     &FrameSettings::samples},
    {{.name = "sampling",
      .choices = "adaptive|all",
      .help = "which pixels take all samples: adaptive draws a quarter of them, at least two, everywhere, and goes on "
              "where a display would show more: at outlines, highlights, bumps, and where something is seen through a "
              "surface; files of radiance take all samples of all pixels",
      .group = "Picture"},
     choiceField<&FrameSettings::sampling>},
    {{.name = "resolve",
      .choices = "display|radiance",
      .help = "what is averaged over the samples of a pixel: display averages the tone-mapped light that a display "
              "shows, so that outlines against very bright light are smooth; radiance averages radiance, which is tone "
              "mapped afterwards; .exr and .hdr always hold radiance",
      .group = "Picture"},
     choiceField<&FrameSettings::resolve>},
    {exposureText(), numberField<&FrameSettings::display, &Display::exposure_ev>},
    {toneMapText(), choiceField<&FrameSettings::display, &Display::tone_map>},
    {ditherText(), choiceField<&FrameSettings::display, &Display::dither>},
    {{.name = "background",
      .value = "env|blur|COLOR|transparent",
      .help = "what is shown behind the model; COLOR is #rrggbb, a colour that the picture shows unchanged (maps and "
              "radiance files hold its linear light), or R,G,B, a radiance that is exposed and tone mapped",
      .group = "Picture",
      .is_daily = true},
     frame_fields::kBackground},

    {{.name = "camera",
      .value = "AZIMUTH,ELEVATION[,DISTANCE]|NAME",
      .unit = "degrees and model radii",
      .min_count = 2,
      .max_count = 3,
      .help = "where the camera stands around the model: azimuth 0 is on +Z and looks along -Z, azimuth 90 is on +X, "
              "elevation 90 is on +Y; without DISTANCE the model fills the picture and is centred in it; or the name "
              "of one of the model's own cameras, which `mirrorball info` lists",
      .group = "Camera",
      .is_daily = true},
     frame_fields::kOrbit},
    {{.name = "target",
      .value = "X,Y,Z",
      .unit = "world units",
      .min_count = 3,
      .max_count = 3,
      .help =
          "point that the camera looks at; without it, the model's centre, or the middle of its outline in the picture",
      .group = "Camera"},
     frame_fields::kTarget},
    {{.name = "fov",
      .value = "DEG",
      .unit = "degrees",
      .minimum = 1,
      .maximum = 170,
      .help = "vertical field of view",
      .group = "Camera",
      .is_daily = true,
      .soft_minimum = 10,
      .soft_maximum = 90,
      .step = 1,
      .is_number = true},
     numberField<&FrameSettings::camera, &CameraOptions::fov_deg>},
    {{.name = "orthographic",
      .value = "HEIGHT",
      .unit = "model radii",
      .minimum = 0,
      .maximum = 1e4,
      .help = "use an orthographic projection of this height; 2 just fits a sphere; 0: the model fills the picture",
      .implied = "0",
      .group = "Camera",
      .soft_maximum = 4,
      .step = 0.01,
      .is_number = true},
     frame_fields::kOrthographic},

    {{.name = "env-rotation",
      .value = "YAW[,PITCH[,ROLL]]",
      .unit = "degrees",
      .max_count = 3,
      .help = "turn the environment about +Z by ROLL, then about +X by PITCH, then about +Y by YAW, from +Z towards +X",
      .group = "Environment",
      .also = "rotate",
      .is_daily = true,
      .soft_minimum = -180,
      .soft_maximum = 180,
      .step = 1},
     frame_fields::kRotation},
    {{.name = "env-intensity",
      .value = "FACTOR",
      .minimum = 0,
      .maximum = 1e6,
      .help = "factor on the environment's light",
      .group = "Environment",
      .is_daily = true,
      .soft_maximum = 4,
      .step = 0.01},
     &FrameSettings::env_intensity},
    {{.name = "stand",
      .help = "stand the model on the floor that the panorama shows: the same as {option:proxy} ground, and a camera "
              "that also holds the floor beside it, half a radius wide, and the shadow that a sun throws, up to four "
              "radii from the model's middle, where it fades out. With "
              "{option:background} transparent the shadow is all that is left of the floor",
      .group = "Environment",
      .is_daily = true},
     &FrameSettings::stands},
    {{.name = "proxy",
      .value = "box:X0,Y0,Z0,X1,Y1,Z1|sphere:X,Y,Z,RADIUS|ground[:HEIGHT[,RADIUS]]|MODEL|none",
      .unit = "world units",
      .help = "surface that the environment's light comes from, so that reflections move as in a real room: a box, a "
              "sphere, the triangles of a model, or a level ground below the model, over which the panorama's camera "
              "stood at HEIGHT and which bends up into a dome at RADIUS; without it, light comes from infinitely far "
              "away",
      .group = "Environment",
      .is_daily = true},
     frame_fields::kProxy},
    {{.name = "captured-at",
      .value = "X,Y,Z",
      .unit = "world units",
      .min_count = 3,
      .max_count = 3,
      .help = "with {option:proxy}, where the environment map was captured; without it in the middle, or on the ground "
              "above "
              "the model's middle",
      .group = "Environment"},
     frame_fields::kCapturedAt},
    {{.name = "ground-roughness",
      .value = "ROUGHNESS",
      .minimum = 0,
      .maximum = 1,
      .help = "with {option:proxy} ground, how rough the ground is: below 1 it is polished and shows the mirror image "
              "of the "
              "model; 1 is matt",
      .group = "Environment",
      .step = 0.01,
      .is_number = true},
     frame_fields::kGroundRoughness},
    {{.name = "probes",
      .value = "N|auto",
      .minimum = 0,
      .maximum = FrameSettings::kMostProbes,
      .help = "number of the largest glossy objects, at most, that reflect the others: what is around each is captured "
              "in a cube map of its own; further ones read a blend of the nearest; auto: 8. Without it objects reflect "
              "the environment alone",
      .group = "Environment"},
     frame_fields::kProbes},
    {{.name = "probe-size",
      .value = "N",
      .unit = "texels",
      .minimum = 0,
      .maximum = 1024,
      .help = "with {option:probes}, side of the faces of their cubes, which a power of two suits best; 0: a quarter "
              "of the "
              "picture's height, but 64 to 256",
      .group = "Environment"},
     &FrameSettings::probe_size},
    {{.name = "probe-bounces",
      .value = "N",
      .minimum = 1,
      .maximum = 8,
      .help = "with {option:probes}, number of times that they are captured: the second time objects show each other "
              "in each "
              "other",
      .group = "Environment"},
     &FrameSettings::probe_bounces},
    {{.name = "sun",
      .choices = "map|split",
      .help =
          "how the sun and other lamps of up to 2 degrees light the scene: by the map that they are in, or as discs "
          "of their size that are taken out of it and throw shadows",
      .group = "Environment"},
     choiceField<&FrameSettings::sun>},
    {{.name = "blur",
      .choices = "exact|gpu|mip|cone",
      .help = "how the environment is blurred for rough surfaces: prefiltered exactly, prefiltered on the GPU in a few "
              "milliseconds, by a coarser mip level, or by the mean of 64 rays in a cone",
      .group = "Look"},
     choiceField<&FrameSettings::blur>},
    {{.name = "lobe-taps",
      .choices = "1|2|4|6",
      .help = "with {option:blur} exact or gpu, number of places at which the prefiltered environment is read for one "
              "rough "
              "reflection; with 1 it is right only where the surface is seen from above",
      .group = "Look"},
     choiceField<&FrameSettings::lobe_taps>},
    {{.name = "mapping",
      .choices = "reflection|normal|sphere",
      .help = "what addresses the environment map: the reflected ray, the surface normal, or the normal as texture "
              "coordinates of a sphere map, which is always sharp",
      .group = "Environment"},
     choiceField<&FrameSettings::mapping>},
    {{.name = "reflect-at",
      .choices = "vertex|fragment|triangle",
      .help = "where the reflected ray, or what else {option:mapping} or {option:texgen} says, is computed: at the "
              "vertices and then "
              "interpolated, at each fragment, or once per triangle, like a mirror made of tiles",
      .group = "Environment"},
     choiceField<&FrameSettings::reflect_at>},
    {{.name = "relief",
      .choices = "none|bump|parallax|steep|occlusion|linear-binary|cone|exact|geometry",
      .help =
          "how the heights of a surface are shown: not at all; by normals; by normals and the place in the texture, "
          "which is guessed (parallax), found in equal steps (steep, occlusion, linear-binary) or in steps as wide "
          "as the space (cone); exact finds where the ray meets the surface, with silhouettes; geometry cuts the "
          "mesh into small triangles",
      .group = "Look"},
     choiceField<&FrameSettings::relief>},
    {{.name = "relief-steps",
      .value = "N",
      .minimum = 4,
      .maximum = 1024,
      .help = "number of steps of {option:relief} steep, occlusion, linear-binary and cone",
      .group = "Look",
      .soft_maximum = 256},
     &FrameSettings::relief_steps},
    {{.name = "refraction",
      .choices = "single|image-space|traced|auto",
      .help =
          "how light passes through glass: bent by the one surface that is seen; by this and the back face behind it, "
          "which is found in a picture of them; or traced through the whole body with its inner reflections, "
          "absorption and what is in it; auto traces through bodies of at most 500 triangles, as cut stones are, and "
          "takes image-space for others",
      .group = "Look"},
     choiceField<&FrameSettings::refraction>},
    {{.name = "behind",
      .choices = "far|probes|screen",
      .help = "what is seen through glass: the environment far away; with {option:probes} what was captured around it; "
              "or the "
              "opaque surfaces in the picture, where the ray that leaves the glass meets them there, and else that "
              "light. far leaves glass without a probe",
      .group = "Look"},
     choiceField<&FrameSettings::behind>},
    {{.name = "inner-bounces",
      .value = "N",
      .minimum = 1,
      .maximum = 32,
      .help = "number of surfaces that light meets after the first, where glass is traced; what is not out by then is "
              "the light from far away",
      .group = "Look"},
     &FrameSettings::inner_bounces},
    {{.name = "dispersion",
      .choices = "channels|spectral",
      .help = "which kinds of light go their own ways through glass that disperses: red, green and blue, which show "
              "three images, or {option:wavelengths} of the spectrum, which run into each other",
      .group = "Look"},
     choiceField<&FrameSettings::dispersion>},
    {{.name = "wavelengths",
      .value = "N",
      .minimum = 8,
      .maximum = formula::kMostWavelengths,
      .help = "with {option:dispersion} spectral, number of wavelengths that each sample of a pixel is drawn of; they "
              "differ "
              "from sample to sample and from pixel to pixel",
      .group = "Look"},
     &FrameSettings::wavelengths},
    {{.name = "wavelength",
      .value = "NM",
      .unit = "nanometres",
      .minimum = 380,
      .maximum = 780,
      .help = "refract all light as this one wavelength, by each material's index there: the directions in which a "
              "prism bends it can be measured; the light keeps the environment's colours, and metals their own",
      .group = "Look",
      .step = 1,
      .is_number = true},
     frame_fields::kWavelength},
    {{.name = "occlusion",
      .choices = "none|vertex",
      .help = "whether the model hides the environment from itself: not at all, or as each vertex knows by rays, which "
              "are traced once for the model; what is hidden shows the model's own light",
      .group = "Look"},
     choiceField<&FrameSettings::occlusion>},
    {{.name = "self-reflection",
      .help = "smooth surfaces reflect the model itself, by a ray a sample of each pixel; also sets {option:occlusion} "
              "vertex",
      .group = "Look"},
     &FrameSettings::self_reflection},
    {{.name = "lookup",
      .choices = "cube|flat|flat-nearest",
      .help = "how surfaces find the light of a direction: by a cube sampler, or by face and texels computed in the "
              "shader from one picture of six faces side by side, weighed or the nearest; faces then end in seams",
      .group = "Environment"},
     choiceField<&FrameSettings::look_up>},
    {{.name = "texture-filter",
      .choices = "nearest|bilinear|trilinear|anisotropic",
      .aliases = "linear=bilinear|mipmap=trilinear",
      .help =
          "how textures and the mirrored environment are read between texels: the nearest one; the four around; the "
          "same in mip levels whose texels are as large as a pixel; or up to 16 such reads along a pixel's longer "
          "side. The first two shimmer where texels are smaller than pixels; the blur of rough surfaces stays",
      .group = "Look"},
     choiceField<&FrameSettings::texture_filter>},
    {{.name = "texgen",
      .choices = "none|object-linear|eye-linear|sphere|reflection|normal|light",
      .help =
          "generate texture coordinates, as OpenGL's glTexGen did, for base_color_map, or where no material has one "
          "for the environment: the place on the object or before the eye, the reflected ray on a sphere map or as it "
          "is, the normal, or the place in the picture of a projector where the first light is",
      .group = "Look"},
     choiceField<&FrameSettings::texgen>},
    {{.name = "texture-matrix",
      .value = "16 NUMBERS",
      .min_count = 16,
      .max_count = 16,
      .help = "matrix, row after row, by which the texture coordinates (s,t,r,q) are multiplied that address "
              "base_color_map, or where no material has one the environment; s and t are then divided by q",
      .group = "Look"},
     frame_fields::kTextureMatrix},
    {{.name = "light",
      .value = "X,Y,Z,R,G,B",
      .unit = "world units and radiance",
      .min_count = 6,
      .max_count = 6,
      .help = "add a point light (Phong's model) by its position and its colour; may be repeated",
      .group = "Environment",
      .is_daily = true},
     frame_fields::kLight},
    {{.name = "light-intensity",
      .value = "FACTOR",
      .minimum = 0,
      .maximum = 1e6,
      .help = "factor on the model's own lights (KHR_lights_punctual), whose cd and lx make radiance in cd/m²",
      .group = "Environment"},
     &FrameSettings::light_intensity},

});

}  // namespace

std::span<const Option<FrameSettings>> frameOptions() { return kOptions; }

void standOnGround(FrameSettings& settings) {
  constexpr float kReach = 0.5f;
  if (!settings.stands) return;
  if (settings.proxy.kind == ProxyKind::none) settings.proxy.kind = ProxyKind::ground;
  settings.camera.ground_reach = kReach;
}

void holdShadow(FrameSettings& settings, std::optional<glm::vec3> sun) {
  const bool is_shown = settings.camera.ground_reach > 0.0f && sun.has_value();
  settings.camera.ground_light = is_shown ? *sun * settings.environmentFromWorld() : glm::vec3(0.0f);
}

int lobesOf(const FrameSettings& settings) {
  constexpr std::array<int, 4> kLobes{1, 2, 4, 6};
  const bool is_prefiltered = settings.blur == BlurKind::exact || settings.blur == BlurKind::gpu;
  return is_prefiltered ? kLobes[static_cast<std::size_t>(settings.lobe_taps)] : 1;
}

bool FrameSettings::canSplitSuns() const {
  const bool is_far = proxy.kind == ProxyKind::none || proxy.kind == ProxyKind::ground;
  const bool is_reflected = mapping == Mapping::reflection && reflect_at == ReflectAt::fragment &&
                            texgen == Texgen::none && texture_matrix == glm::mat4(1.0f);
  return is_far && is_reflected;
}

glm::mat3 FrameSettings::environmentFromWorld() const {
  const glm::vec3 turn = glm::radians(env_rotation_deg);
  const glm::mat3 unturned(glm::rotate(glm::mat4(1.0f), -turn.x, glm::vec3(0, 1, 0)));
  return glm::transpose(turnedBy(0.0f, turn.y, turn.z)) * unturned;
}

}  // namespace mirrorball
