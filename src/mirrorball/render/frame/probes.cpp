#include "mirrorball/render/frame/probes.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "mirrorball/render/surface/light_reads.h"
#include "mirrorball/render/surface/texture_coordinates.h"
#include "mirrorball/scene/camera/camera.h"

namespace mirrorball {
namespace {

/// A mirror ball shows a face of half its height in pixels in full: so one may be half as high as the picture.
int sideFor(const FrameSettings& settings) {
  if (settings.probe_size > 0) return settings.probe_size;
  const auto quarter = static_cast<unsigned>(settings.size.y + 3) / 4;
  return std::clamp(static_cast<int>(std::bit_ceil(quarter)), 64, 256);
}

/// How a face is drawn: what the frame shows, by another camera and over the environment.
FrameSettings settingsOfFace(const FrameSettings& settings) {
  FrameSettings of_face = settings;
  of_face.probe_size = sideFor(settings);
  of_face.size = glm::ivec2(of_face.probe_size);
  of_face.camera = {};
  of_face.display = {};
  of_face.samples = 1;
  of_face.resolve = Resolve::radiance;
  of_face.background = BackgroundKind::environment;
  of_face.background_color = glm::vec3(0.0f);
  of_face.proxy.ground_roughness = 1.0f;  // objects see no image in the ground that they reflect
  return of_face;
}

/// Those objects without a probe whose light is blended; of a thousand the smallest read the environment's.
constexpr std::size_t kMostBlended = FrameSettings::kMostProbes;

SurfaceLight surfaceLight(const ProbeLight& light, const FrameSettings& settings, float unit) {
  const PrefilteredChain chain{&light.chain, 0};
  return {.environment = &light.cube,
          .prefiltered = &light.chain,
          .irradiance = &light.irradiance,
          .blur = blurOf(settings, light.cube, chain),
          .intensity = unit};
}

}  // namespace

Result<const ProbeUniforms*> Probes::begin(gl::Api api, SceneDrawing& drawing, const EnvironmentLight& light,
                                           std::uint64_t environment, const FrameSettings& settings,
                                           const FrameUniforms& frame) {
  // A sphere map stands for all that is reflected.
  if (settings.probes == 0 || coordinateChoice(drawing.scene(), settings).is_sphere_map) return nullptr;
  const Captured wanted{settingsOfFace(settings), drawing.staged().version(StagePart::scene), environment};
  if (captured_ != wanted) {
    captured_.reset();
    const int most = settings.probes == FrameSettings::kAutoProbes ? FrameSettings::kSomeProbes : settings.probes;
    places_ = probePlaces(drawing.scene(), most);
    places_.others.resize(std::min(places_.others.size(), kMostBlended));
    FrameUniforms of_face = frame;
    of_face.sample = reflectedSample(frame.sample, settings);
    of_face.probes = nullptr;
    MIRRORBALL_TRY_VOID(makeLights(api, light, of_face.sample, wanted.settings));
    of_face.light.suns.are_seen = false;  // surfaces add them
    for (int bounce = 0; bounce < settings.probe_bounces; ++bounce) {
      for (std::size_t probe = 0; probe < lights_.size(); ++probe)
        MIRRORBALL_TRY_VOID(capture(probe, drawing, light, wanted.settings, of_face));
      blend();
      tell(drawing, wanted.settings);
      of_face.probes = &uniforms_;
    }
    captured_ = wanted;
  }
  return lights_.empty() ? nullptr : &uniforms_;
}

Result<void> Probes::makeLights(gl::Api api, const EnvironmentLight& light, const SampleUniforms& sample,
                                const FrameSettings& settings) {
  const int size = settings.probe_size;
  const gl::Format format = light.cube().format();
  const float unit = settings.env_intensity > 1.0f ? light.unit() * settings.env_intensity : light.unit();
  if (!filter_ || filter_->size() != size || filter_->format() != format || filter_->unit() != unit) {
    lights_.clear();
    blended_.clear();
    MIRRORBALL_TRY(made, ProbeFilter::make(api, size, format, unit));
    filter_ = std::move(made);
  }
  MIRRORBALL_TRY_VOID(gl::resize(picture_, gl::Format::rgba32f, glm::ivec2(size), depthsFor(sample)));
  const auto fill = [&](std::vector<ProbeLight>& lights, std::size_t count) -> Result<void> {
    while (lights.size() > count) lights.pop_back();
    while (lights.size() < count) {
      MIRRORBALL_TRY(made, filter_->makeLight());
      lights.push_back(std::move(made));
    }
    return {};
  };
  MIRRORBALL_TRY_VOID(fill(lights_, places_.probes.size()));
  return fill(blended_, lights_.empty() ? 0 : places_.others.size());
}

/// As captureEnvironment does from outside, but for the object that the probe stands in.
Result<void> Probes::capture(std::size_t probe, SceneDrawing& drawing, const EnvironmentLight& light,
                             const FrameSettings& settings, FrameUniforms frame) {
  const ReflectiveObject& object = places_.probes[probe];
  const DepthRange depths = depthsAround(object.middle, drawing.staged().bounds());
  frame.sample.hidden = object.instances;
  for (int face = 0; face < 6; ++face) {
    frame.sample.camera = cubeFaceCamera(face, object.middle, depths);
    MIRRORBALL_TRY(of_scene, drawing.begin(settings, frame.sample, *frame.light.proxy));
    frame.scene = of_scene;
    MIRRORBALL_TRY_VOID(drawing.draw(*picture_, light, frame, settings));
    filter_->setFace(lights_[probe], face, picture_->color());
    MIRRORBALL_TRY(nearness, drawing.drawNearness(*picture_, frame));
    filter_->setNearness(lights_[probe], face, *nearness);
  }
  filter_->finish(lights_[probe]);
  ++captures_;
  return {};
}

void Probes::blend() {
  for (std::size_t other = 0; other < blended_.size(); ++other) {
    filter_->clear(blended_[other]);
    const std::vector<float> shares = probeShares(places_.others[other], places_.probes);
    for (std::size_t probe = 0; probe < shares.size(); ++probe)
      if (shares[probe] > 0.0f) filter_->add(blended_[other], lights_[probe], shares[probe]);
  }
}

void Probes::tell(const SceneDrawing& drawing, const FrameSettings& settings) {
  uniforms_.lights.clear();
  uniforms_.light_of_instance.assign(drawing.scene().instances.size(), -1);
  const auto add = [&](const SurfaceLight& light, const ReflectiveObject& object) {
    for (const int instance : object.instances) {
      const bool is_seen_through = materialOf(drawing.scene(), std::size_t(instance)).transmission > 0.0f;
      if (settings.behind == BehindKind::far && is_seen_through) continue;
      uniforms_.light_of_instance[std::size_t(instance)] = static_cast<int>(uniforms_.lights.size());
    }
    uniforms_.lights.push_back(light);
  };
  for (std::size_t probe = 0; probe < lights_.size(); ++probe) {
    SurfaceLight light = surfaceLight(lights_[probe], settings, filter_->unit());
    light.captured_from = places_.probes[probe].middle;
    light.nearness_unit = drawing.staged().bounds().radius;
    light.nearness = &lights_[probe].nearness;
    add(light, places_.probes[probe]);
  }
  for (std::size_t other = 0; other < blended_.size(); ++other)
    add(surfaceLight(blended_[other], settings, filter_->unit()), places_.others[other]);
}

std::size_t Probes::bytes() const {
  std::size_t bytes = 0;
  for (const auto* lights : {&lights_, &blended_})
    for (const ProbeLight& light : *lights)
      bytes += light.cube.bytes() + light.chain.bytes() + light.irradiance.bytes() + light.nearness.bytes();
  return bytes;
}

}  // namespace mirrorball
