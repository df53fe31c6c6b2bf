#include "cli/render_reference.h"

#include <array>
#include <atomic>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/formatted.h"
#include "cli/interruption.h"
#include "cli/stage_clock.h"
#include "cli/terminal.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/study/traced_frame.h"

namespace mirrorball::cli {
namespace {

const Option<ReferenceOptions> kReference{
    {.name = "reference",
     .help = "path-trace the picture instead of drawing it: slow, and right where objects block light and send it to "
             "each other; it needs no graphics driver",
     .group = "Reference",
     .is_daily = true},
    &ReferenceOptions::is_wanted};

/// All that a path tracer is told, of its own options and of those that the renderer has too.
TraceSettings traceSettings(const ReferenceOptions& options, const FrameSettings& frame, const GivenOptions& given) {
  TraceSettings trace = tracedFrame(frame, options.trace);
  if (given.contains("samples")) trace.samples = frame.samples;
  return trace;
}

/// As compositors and denoisers look for them; they are moved out of the picture.
std::vector<ImageLayer> layersOf(TracedPicture& picture) {
  if (!picture.layers) return {};
  std::vector<ImageLayer> layers;
  layers.push_back({"albedo", "RGB", std::move(picture.layers->albedo)});
  layers.push_back({"normal", "XYZ", std::move(picture.layers->normal)});
  layers.push_back({"variance", "RGB", std::move(picture.layers->variance)});
  return layers;
}

Result<void> writePicture(TracedPicture& picture, const FrameSettings& frame, const std::string& output,
                          const PictureForm& form) {
  Image& image = picture.radiance;
  if (storesLinearLight(output)) {
    if (frame.background == BackgroundKind::display_color) layOver(image, backdropOf(frame));
    convertFromRec709(image, form.primaries);
    return writeImage(output, image, {.metadata = {}, .layers = layersOf(picture), .primaries = form.primaries});
  }
  return writeShown(output, std::move(image), frame, form);
}

/// "64 paths a pixel, standard error at most 0.0031 of white"
std::string foundOut(const TracedPicture& picture) {
  return counted(std::size_t(picture.samples), "path") +
         formatted(" a pixel, standard error at most %.2g of white", double(picture.noise));
}

/// A progress bar with the noise so far. From the first whole pass on, an interruption waits for the picture so far to
/// be written.
///
/// first_pass   the paths of one pass
TraceObserver observerUntilInterrupted(std::size_t first_pass) {
  const auto noise = std::make_shared<std::atomic<float>>(0.0f);
  const auto label = [noise] {
    return "reference" + (*noise > 0.0f ? ", standard error " + formatted("%.2g", double(*noise)) : "");
  };
  TraceObserver observer{.progress = [bar = progressBar(label), first_pass](std::size_t done, std::size_t total) {
    if (bar(done, total)) return true;
    if (done > first_pass) claimEnd();
    return false;
  }};
  if (showsProgress()) observer.pass = [noise](int, float found) { *noise = found; };
  return observer;
}

Result<PathTracer> tracerOf(SceneInputs inputs, StageClock& clock) {
  return clock.time("scene: sort triangles and light",
                    [&] { return PathTracer::make(std::move(inputs.scene), std::move(inputs.environment)); });
}

/// The options that were given, which say how the renderer comes near to what the reference does.
std::vector<std::string> idleForReference(const ReferenceOptions& options, const FrameSettings& frame,
                                          const GivenOptions& given) {
  constexpr auto kOfRenderer = std::to_array<std::string_view>(
      {"sampling", "resolve", "blur", "lobe-taps", "mapping", "reflect-at", "texgen", "lookup", "texture-filter",
       "texture-matrix", "dispersion", "wavelengths", "occlusion", "self-reflection", "probes", "probe-size",
       "probe-bounces", "behind", "quality"});
  std::vector<std::string> idle;
  for (const std::string_view name : kOfRenderer)
    if (given.contains(name)) idle.push_back("--" + std::string(name));
  const bool ends_in_glass = options.trace.is_unoccluded && frame.refraction == RefractionKind::traced;
  if (given.contains("refraction") && !options.trace.is_unoccluded) idle.emplace_back("--refraction");
  if (given.contains("inner-bounces") && !ends_in_glass) idle.emplace_back("--inner-bounces");
  if (frame.background == BackgroundKind::blur) idle.emplace_back("--background blur");
  return idle;
}

}  // namespace

Result<void> tellTraced(const TracedPicture& picture, const std::string& output) {
  if (picture.lost_paths > 0)
    remark(countedAre(picture.lost_paths, "path") + " without a number as its light, and counted as black");
  if (picture.is_interrupted)
    return fail(ErrorCode::interrupted, "interrupted; " + output + " is the picture so far: " + foundOut(picture));
  tellAside(foundOut(picture));
  return {};
}

void addReference(Command& command, ReferenceOptions& options, GivenOptions& given) {
  addOptions(command, std::span(&kReference, 1), options);
  addOptions(command, traceOptions(), options.trace, &given);
}

Result<void> checkReference(const ReferenceOptions& options, const FrameSettings& frame, const GivenOptions& given) {
  if (!options.is_wanted) {
    for (const Option<TraceSettings>& option : traceOptions())
      if (given.contains(option.text.name))
        return fail(ErrorCode::usage, "--" + std::string(option.text.name) + " is for the reference; add --reference");
    return {};
  }
  for (const std::string_view name : {"turn", "frames"})
    if (given.contains(name))
      return fail(ErrorCode::usage, "--" + std::string(name) + ": the reference makes one picture; leave it out");
  if (options.trace.is_unoccluded && options.trace.bounces != 1 && frame.refraction != RefractionKind::traced)
    return fail(ErrorCode::usage, "--unoccluded knows no second surface; add --bounces 1");
  const std::vector<std::string> idle = idleForReference(options, frame, given);
  if (!idle.empty()) remark(changesNothing(idle, "the reference shows what is right in any case"));
  return {};
}

Result<TracedMap> traceCapture(SceneInputs inputs, const TracedCapture& capture, const FrameSettings& frame,
                               const ReferenceOptions& options, const GivenOptions& given, StageClock& clock) {
  MIRRORBALL_TRY(tracer, tracerOf(std::move(inputs), clock));
  const glm::ivec2 extent = imageSize(capture.projection, capture.size);
  const std::size_t first_pass =
      std::size_t(extent.x) * std::size_t(extent.y) * std::size_t(faceCount(capture.projection));
  return clock.time("map: trace", [&] {
    return tracer.capture(capture, traceSettings(options, frame, given), observerUntilInterrupted(first_pass));
  });
}

Result<void> renderReference(const SceneRequest& scene, const MaterialChanges& materials, const FrameSettings& frame,
                             const ReferenceOptions& options, const GivenOptions& given, const std::string& output,
                             const PictureForm& form) {
  if (options.trace.wants_layers && extensionOf(output) != "exr")
    return fail(ErrorCode::usage, "--layers: only OpenEXR files have layers; write an .exr");
  if (options.trace.wants_layers && form.primaries != OutputPrimaries::rec709)
    return fail(ErrorCode::usage,
                "--layers: the variance is that of Rec.709's channels, and cannot be converted; leave --primaries out");
  StageClock clock;
  MIRRORBALL_TRY(inputs, loadSceneFor(scene, materials, frame, {&output, 1}, clock));
  MIRRORBALL_TRY_VOID(checkShown(frame, inputs.scene));
  MIRRORBALL_TRY(camera, framedCamera(inputs.scene, boundingSphere(inputs.scene), inputs.frame.camera, frame.size));
  MIRRORBALL_TRY(tracer, tracerOf(std::move(inputs), clock));
  const auto first_pass = std::size_t(frame.size.x) * std::size_t(frame.size.y);
  MIRRORBALL_TRY(picture, clock.time("picture: trace", [&] {
    return tracer.render(camera, traceSettings(options, frame, given), observerUntilInterrupted(first_pass));
  }));
  MIRRORBALL_TRY_VOID(
      clock.time("picture: encode and write", [&] { return writePicture(picture, frame, output, form); }));
  announce(output);
  if (scene.timings) clock.print();
  return tellTraced(picture, output);
}

}  // namespace mirrorball::cli
