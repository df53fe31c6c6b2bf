#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/formatted.h"
#include "cli/number_maps.h"
#include "cli/standard_streams.h"
#include "cli/terminal.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/gltf/gltf_writer.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/model_origin.h"
#include "mirrorball/transfer/detail_transfer.h"
#include "mirrorball/transfer/simplify.h"
#include "mirrorball/transfer/unwrap/unwrap.h"

namespace mirrorball::cli {
namespace {

/// All that `transfer` was told.
struct TransferRequest {
  std::string high;
  std::string low;
  std::string output;
  std::string heights;
  std::string occlusion;
  std::string bent_normals;
  std::string model_out;
  int size = 1024;
  int samples = 1;  ///< 4 ^ samples a texel
  NormalSpace space = NormalSpace::tangent;
  bool directx = false;
  float cage = 0.0f;
  int padding = 8;
  int rays = 64;
  int triangles = 0;
  bool inside_only = false;
  GivenOptions given;

  std::vector<std::string> outputs() const {
    std::vector<std::string> all;
    for (const std::string* file : {&output, &heights, &occlusion, &bent_normals, &model_out})
      if (!file->empty()) all.push_back(*file);
    return all;
  }
};

const auto kTransferOptions = std::to_array<Option<TransferRequest>>({
    {{.name = "output",
      .value = "OUT",
      .help = "the normal map; .exr and textures hold signed floats, .png ½ + ½ n; -.png is standard output, likewise "
              "with the other extensions",
      .letter = "o",
      .group = "Output",
      .takes_path = true},
     &TransferRequest::output},
    {{.name = "height",
      .value = "FILE",
      .help = "also write how far HIGH lies outside LOW: in units of the model, or as .png from the lowest to the "
              "highest, which are printed",
      .group = "Output",
      .takes_path = true},
     &TransferRequest::heights},
    {{.name = "occlusion",
      .value = "FILE",
      .help = "also write the share of an even sky that HIGH leaves to itself",
      .group = "Output",
      .takes_path = true},
     &TransferRequest::occlusion},
    {{.name = "bent-normal",
      .value = "FILE",
      .help = "also write where that light comes from, in the space of the normals",
      .group = "Output",
      .takes_path = true},
     &TransferRequest::bent_normals},
    {{.name = "model-out",
      .value = "FILE",
      .help = "also write the light model with its normal map, as .glb",
      .group = "Output",
      .takes_path = true},
     &TransferRequest::model_out},
    {{.name = "size",
      .value = "N",
      .unit = "texels",
      .minimum = 1,
      .maximum = 32768,
      .help = "side of the maps",
      .group = "Maps"},
     &TransferRequest::size},
    {{.name = "samples", .choices = "1|4|16|64", .help = "rays a texel, in rows and columns", .group = "Maps"},
     choiceField<&TransferRequest::samples>},
    {{.name = "space",
      .choices = "tangent|object",
      .help = "in what normals are given: frames of LOW's tangents, or the axes of its mesh",
      .group = "Maps"},
     choiceField<&TransferRequest::space>},
    {{.name = "directx", .help = "normals with green down instead of up", .group = "Maps"}, &TransferRequest::directx},
    {{.name = "padding",
      .value = "N",
      .unit = "texels",
      .minimum = 0,
      .maximum = 32768,
      .help = "how far the maps go on beyond the edges of the surface in them",
      .group = "Maps"},
     &TransferRequest::padding},
    {{.name = "cage",
      .value = "D",
      .unit = "radii of LOW",
      .minimum = 0,
      .maximum = 10,
      .help =
          "rays begin that far outside and end as far inside, and the outermost surface counts; 0: they go both ways "
          "along LOW's normals, a twentieth of a radius, and the nearest counts",
      .group = "Rays"},
     &TransferRequest::cage},
    {{.name = "rays",
      .value = "N",
      .minimum = 1,
      .maximum = 65536,
      .help = "rays a texel to the sky, of --occlusion and --bent-normal",
      .group = "Rays"},
     &TransferRequest::rays},
    {{.name = "simplify",
      .value = "N",
      .unit = "triangles",
      .minimum = 0,
      .maximum = 100000000,
      .help = "make LOW of HIGH, with so many triangles at most, and unwrap it; 0: LOW is given",
      .group = "Light model"},
     &TransferRequest::triangles},
    {kInsideOnlyText, &TransferRequest::inside_only},
    {kMaxMemoryText, kMemoryLimitField<TransferRequest>},
});

/// errors   usage; io
Result<void> checkTransfer(const TransferRequest& request) {
  const std::vector<std::string> outputs = request.outputs();
  if (outputs.empty()) return fail(ErrorCode::usage, "transfer needs an output: -o FILE.png or FILE.exr");
  if (request.low.empty() && request.triangles == 0)
    return fail(ErrorCode::usage, "transfer needs a light model: HIGH LOW, or --simplify N to make one of HIGH");
  if (!request.low.empty() && request.triangles > 0)
    return fail(ErrorCode::usage, "--simplify makes the light model itself; leave " + request.low + " out");
  if (request.given.contains("rays") && request.occlusion.empty() && request.bent_normals.empty())
    return fail(ErrorCode::usage, changesNothing(std::array<std::string, 1>{"--rays"},
                                                 "neither --occlusion nor --bent-normal is made; leave it out"));
  for (const std::string& output : outputs)
    if (output != request.model_out) MIRRORBALL_TRY_VOID(numberFormat(output));
  if (!request.model_out.empty()) {
    if (extensionOf(request.model_out) != "glb")
      return fail(ErrorCode::usage, request.model_out + ": the light model is binary glTF; name the file FILE.glb");
    if (request.space == NormalSpace::object)
      return fail(ErrorCode::usage, "glTF's normal maps are in tangent space; leave --model-out or --space object out");
    MIRRORBALL_TRY_VOID(checkFolder(request.model_out));
  }
  MIRRORBALL_TRY_VOID(refuseSharedNames(outputs));
  return refuseOverwriting(std::array{request.high, request.low}, outputs);
}

Result<Scene> loaded(const std::string& model, const TransferRequest& request) {
  MIRRORBALL_TRY(scene, loadModel(model, {.inside_only = request.inside_only}));
  for (const std::string& warning : scene.warnings) remark(warning);
  return scene;
}

/// The numbers of a material without what needs texture coordinates.
Material withoutMaps(Material material) {
  for (const MaterialMap& map : materialMaps()) material.*map.slot = TextureSlot();
  material.height = HeightKind::none;
  material.height_texture = -1;
  return material;
}

/// HIGH with fewer triangles, unwrapped; says how.
Result<Scene> lightModelOf(const Scene& high, const TransferRequest& request) {
  MIRRORBALL_TRY(fewer, withName(request.high, simplified(high, std::size_t(request.triangles))));
  const std::size_t count = fewer.mesh.indices.size() / 3;
  if (count > std::size_t(request.triangles))
    remark(request.high + ": " + std::to_string(count) + " triangles are the fewest that its surface allows");
  constexpr int kMostGutter = 16;
  const int gutter = std::clamp(request.padding / 2, 1, kMostGutter);
  MIRRORBALL_TRY(flat, withName(request.high, unwrapped(fewer.mesh, request.size, gutter)));
  tell(counted(count, "triangle") + formatted(", moved by %.2g %% of the size; ", 100.0 * double(fewer.error)) +
       counted(flat.charts, "chart") +
       formatted(", stretch %.3f (%.2f at most), on %.0f %% of the map", flat.stretch, flat.worst_stretch,
                 100.0 * flat.used));
  Scene low = meshScene(std::move(flat.mesh), withoutMaps(materialOf(high, 0)));
  low.origin = high.origin;
  return low;
}

/// Says what of the maps may not be as it was meant.
void tellDoubts(const TransferredDetail& detail, const TransferRequest& request) {
  constexpr double kWorthTelling = 0.005;
  if (detail.missed > kWorthTelling)
    remark(formatted("%.1f %% of the rays met nothing of ", 100.0 * detail.missed) + request.high +
           "; --cage says how far they go");
  if (detail.overlapping > kWorthTelling)
    remark(
        (request.low.empty() ? request.high : request.low) +
        formatted(": %.1f %% of the samples are of several triangles, of which the first counts; mirrored halves that "
                  "share a map need the same detail",
                  100.0 * detail.overlapping));
}

/// Heights as .png holds them: from the lowest to the highest, which are printed.
MadeMap heightsFor(Image heights, const std::string& output) {
  if (extensionOf(output) != "png") return MadeMap{ImageSet(std::move(heights)), true};
  const auto [low, high] = std::ranges::minmax(heights.samples());
  const float range = high > low ? high - low : 1.0f;
  for (float& height : heights.samples()) height = (height - low) / range;
  tell(formatted("heights from %.5g to %.5g", double(low), double(high)));
  return MadeMap{ImageSet(std::move(heights))};
}

Result<void> writeMaps(TransferredDetail detail, const TransferRequest& request) {
  const auto writeNormals = [&](Image normals, const std::string& output) -> Result<void> {
    if (output.empty()) return {};
    if (request.directx) flipGreen(normals);
    return writeNumbers(MadeMap{ImageSet(std::move(normals)), true}, output);
  };
  MIRRORBALL_TRY_VOID(writeNormals(std::move(detail.normals), request.output));
  if (!request.bent_normals.empty())
    MIRRORBALL_TRY_VOID(writeNormals(std::move(detail.bent_normals), request.bent_normals));
  if (!request.heights.empty())
    MIRRORBALL_TRY_VOID(writeNumbers(heightsFor(std::move(detail.heights), request.heights), request.heights));
  if (!request.occlusion.empty())
    MIRRORBALL_TRY_VOID(writeNumbers(MadeMap{ImageSet(std::move(detail.visible))}, request.occlusion));
  return {};
}

/// The light model with the normal map on all of its surfaces.
Result<void> writeModel(Scene low, const Image& normals, const std::string& output) {
  const Image8 codes = pictureOf(MadeMap{ImageSet(normals), true}, output);
  Texture texture{.image = Image8(codes.width(), codes.height(), 4, 255)};
  for (int y = 0; y < codes.height(); ++y)
    for (int x = 0; x < codes.width(); ++x) std::copy_n(codes.texel(x, y), 3, texture.image.edit().texel(x, y));
  low.textures.push_back(std::move(texture));
  for (Material& material : low.materials) {
    material.normal_map = {.texture = int(low.textures.size()) - 1};
    material.normal_scale = 1.0f;
  }
  MIRRORBALL_TRY(encoded, encodeGlb(low));
  MIRRORBALL_TRY_VOID(writeFile(output, encoded.bytes));
  announce(output);
  for (const std::string& line : encoded.left_out) remark(output + ": " + line);
  return {};
}

Result<void> transfer(const TransferRequest& request) {
  MIRRORBALL_TRY_VOID(checkTransfer(request));
  MIRRORBALL_TRY(high, loaded(request.high, request));
  if (high.empty()) return fail(ErrorCode::bad_shape, request.high + ": has no triangles");
  MIRRORBALL_TRY(low, request.low.empty() ? lightModelOf(high, request) : loaded(request.low, request));
  // Far from the origin of their coordinates, each was moved to about its own middle.
  MIRRORBALL_TRY_VOID(withName(request.high, moveOrigin(high, low.origin)));
  const TransferSettings settings{.size = glm::ivec2(request.size),
                                  .samples_side = 1 << request.samples,
                                  .space = request.space,
                                  .cage = request.cage,
                                  .padding = request.padding,
                                  .wants_heights = !request.heights.empty(),
                                  .wants_occlusion = !request.occlusion.empty() || !request.bent_normals.empty(),
                                  .occlusion_rays = request.rays};
  MIRRORBALL_TRY(detail, withName(request.low.empty() ? request.high : request.low,
                                  transferDetail(high, low, settings, progressBar("transfer"))));
  tellDoubts(detail, request);
  if (!request.model_out.empty()) MIRRORBALL_TRY_VOID(writeModel(std::move(low), detail.normals, request.model_out));
  return writeMaps(std::move(detail), request);
}

}  // namespace

Command transferCommand() {
  auto request = std::make_shared<TransferRequest>();
  Command command{
      .name = "transfer",
      .help = "Makes maps of a dense model's detail for a light one",
      .about =
          "HIGH and LOW are files (" + modelExtensions() +
          ") or built-ins, at the same place. Rays from LOW's texels find HIGH's surface; its normals go into a normal "
          "map for LOW, in frames by MikkTSpace's rule, as glTF has them. What lies beside LOW's triangles in the map "
          "is "
          "filled some texels far. `--simplify N` makes LOW of HIGH.",
      .examples = {{"transfer scan.ply low.glb -o normal.png --occlusion occlusion.png",
                    "a scan's detail for a model that has texture coordinates"},
                   {"transfer scan.ply --simplify 5000 --size 2048 -o normal.png --model-out low.glb",
                    "a light model with a normal map, from a scan alone"}}};
  addArgument(command,
              {.name = "HIGH",
               .help = "the model with the detail, or - for standard input",
               .missing = "name a dense model, and a light one",
               .names = builtinModelNames,
               .takes_path = true},
              request->high);
  addArgument(command,
              {.name = "LOW",
               .help = "the model that gets it, with texture coordinates; none with --simplify",
               .names = builtinModelNames,
               .takes_path = true},
              request->low);
  addOptions<TransferRequest>(command, kTransferOptions, *request, &request->given);
  command.action = [request] {
    return withStandardStreams({&request->high, &request->low}, request->output, [&] { return transfer(*request); });
  };
  return command;
}

}  // namespace mirrorball::cli
