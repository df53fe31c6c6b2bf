// Drives a stage as a window would: two views of it, each with a technique of its own, and one change after the other.
// After each, both pictures are compared, bit by bit, with those of a device that never saw the changes; after every
// tenth with those of a process that did not, either.
//
// usage: live_stage CHANGES      makes that many changes; 0 is success
//        live_stage --after N    prints a number for the pictures after N changes, drawn by a new device

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "mirrorball/mirrorball.h"

using namespace mirrorball;

namespace {

constexpr int kViews = 2;

/// What is shown, as data: what a document of a program would hold.
struct Shown {
  Scene scene;
  int environment = 0;
  std::array<FrameSettings, kViews> looks;
};

/// The room, with a lamp that is bright enough for 32-bit floats, or the sky.
Environment environmentOf(int index) {
  const auto room = [index](glm::vec3 d) {
    const glm::vec3 lamp = glm::normalize(glm::vec3(1.0f, 2.0f, 1.5f));
    const float shine = glm::dot(d, lamp) > 0.96f ? (index == 1 ? 9e4f : 40.0f) : 0.0f;
    return glm::vec3(0.4f + 0.3f * d.x, 0.4f + 0.3f * d.y, 0.5f) + shine;
  };
  const auto sky = [](glm::vec3 d) { return glm::vec3(0.3f, 0.5f, 0.9f) * (1.2f + d.y); };
  return index == 2 ? Environment(sky, 32) : Environment(room, 64);
}

/// Where it is prefiltered once for all devices and processes.
std::optional<CacheFolder> cache() {
  return CacheFolder(std::filesystem::temp_directory_path() / "mirrorball_live_stage");
}

/// Numbers that are the same in every process.
class Random {
 public:
  int below(int count) { return static_cast<int>(generator_() % static_cast<unsigned>(count)); }
  float share() { return static_cast<float>(below(1 << 20)) / static_cast<float>(1 << 20); }
  template <typename Container>
  const auto& oneOf(const Container& container) {
    return container[static_cast<std::size_t>(below(static_cast<int>(std::size(container))))];
  }

 private:
  std::mt19937 generator_{7};
};

Texture checks() {
  Image8 image(16, 16, 4, 255);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) image.texel(x, y)[(x / 4 + y / 4) % 2] = 60;
  return {.image = std::move(image), .srgb = true};
}

/// Hills as heights.
HeightTexture hills() {
  Image heights(8, 8, 1);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      heights.texel(x, y)[0] = 0.5f + 0.25f * (std::sin(0.7854f * float(x)) + std::sin(1.5708f * float(y)));
  return {.heights = std::move(heights)};
}

/// Three things of a built-in shape, apart from each other.
Result<Scene> sceneOfThree(Random& random) {
  constexpr std::array<const char*, 4> kShapes{"cube", "prism", "brilliant", "plane"};
  Scene scene;
  scene.textures.push_back(checks());
  scene.height_textures.push_back(hills());
  for (int thing = 0; thing < 3; ++thing) {
    MIRRORBALL_TRY(model, loadModel(random.oneOf(kShapes)));
    Mesh mesh = *model.meshes.front();
    mesh.material = thing;
    const glm::vec3 place(1.6f * static_cast<float>(thing - 1), 0.0f, 0.0f);
    scene.instances.push_back({thing, glm::translate(glm::mat4(1.0f), place)});
    scene.meshes.push_back(std::move(mesh));
    scene.materials.emplace_back();
  }
  scene.materials[0].base_color_map.texture = 0;
  // The third hangs on the second.
  addNodes(scene);
  scene.rig.nodes[2].parent = 1;
  MIRRORBALL_TRY_VOID(poseAtRest(scene));
  return scene;
}

struct Technique {
  const char* option;
  std::vector<const char*> values;
};

const std::vector<Technique>& techniques() {
  static const std::vector<Technique> all{
      {"relief", {"none", "bump", "parallax", "cone", "exact", "geometry"}},
      {"occlusion", {"none", "vertex"}},
      {"self-reflection", {"no", "yes"}},
      {"mapping", {"reflection", "normal", "sphere"}},
      {"reflect-at", {"vertex", "fragment", "triangle"}},
      {"refraction", {"single", "image-space", "traced", "auto"}},
      {"behind", {"far", "probes", "screen"}},
      {"probes", {"0", "1", "auto"}},
      {"blur", {"exact", "gpu", "mip", "cone"}},
      {"proxy", {"none", "box:-4,-2,-4,4,3,4", "sphere:0,0,0,5", "ground"}},
      {"texture-filter", {"nearest", "bilinear", "trilinear"}},
      {"lookup", {"cube", "flat"}},
      {"background", {"env", "blur", "transparent"}},
      {"env-rotation", {"0", "40", "200"}},
      {"camera", {"0,10", "40,25", "200,-10"}},
      {"orthographic", {"0", "3"}},
      {"samples", {"1", "2", "4"}},
      {"sampling", {"adaptive", "all"}},
  };
  return all;
}

Result<void> setLook(FrameSettings& look, std::string_view name, const char* value) {
  for (const Option<FrameSettings>& option : frameOptions())
    if (option.text.name == name) return assign(option, look, value);
  return fail(ErrorCode::usage, std::string(name) + " is no option");
}

/// One change: made to what is shown, and told to the stage if there is one.
class Changes {
 public:
  Result<void> next(Shown& shown, Stage* stage);
  /// What the last one was.
  const std::string& what() const { return what_; }

 private:
  Result<void> changeMaterial(Shown& shown, Stage* stage);
  Result<void> changeTransform(Shown& shown, Stage* stage);
  Result<void> changeLights(Shown& shown, Stage* stage);
  Result<void> changeScene(Shown& shown, Stage* stage);
  Result<void> changeCopy(Shown& shown, Stage* stage);
  Result<void> changeNode(Shown& shown, Stage* stage);
  Result<void> workInThread(const Shown& shown, Stage* stage);
  Result<void> changeEnvironment(Shown& shown, Stage* stage);
  Result<void> changeLook(Shown& shown);
  void changeSize(Shown& shown);
  Result<void> loseContext(Stage* stage);

  Random random_;
  std::string what_;
};

Result<void> Changes::next(Shown& shown, Stage* stage) {
  if (shown.scene.empty()) return changeScene(shown, stage);
  switch (random_.below(22)) {
    case 0:
      return changeScene(shown, stage);
    case 1:
    case 2:
      return changeTransform(shown, stage);
    case 3:
      return changeLights(shown, stage);
    case 4:
      return changeEnvironment(shown, stage);
    case 5:
      changeSize(shown);
      return {};
    case 6:
      return loseContext(stage);
    case 7:
    case 8:
    case 9:
      return changeMaterial(shown, stage);
    case 10:
    case 11:
    case 12:
      return changeCopy(shown, stage);
    case 13:
    case 14:
      return changeNode(shown, stage);
    case 15:
      return workInThread(shown, stage);
    default:
      return changeLook(shown);
  }
}

Result<void> Changes::changeMaterial(Shown& shown, Stage* stage) {
  const auto index = static_cast<std::size_t>(random_.below(static_cast<int>(shown.scene.materials.size())));
  Material material = shown.scene.materials[index];
  // Without the orange, whose many bumps as triangles would take most of the time.
  constexpr std::array<const char*, 8> kNames{"mirror",    "rough-metal", "brushed-metal", "plastic",
                                              "car-paint", "velvet",      "soap-bubble",   "glass"};
  switch (random_.below(6)) {
    case 0: {
      const std::string name = random_.oneOf(kNames);
      what_ = "a material: " + name;
      MIRRORBALL_TRY(named, materialNamed(name));
      material = std::move(named);
      break;
    }
    case 1:
      what_ = "a texture";
      material.base_color_map.texture = material.base_color_map.texture < 0 ? 0 : -1;
      break;
    case 2:
      what_ = "heights";
      material.height = material.height == HeightKind::map ? HeightKind::none : HeightKind::map;
      material.height_texture = material.height == HeightKind::map ? 0 : -1;
      material.height_scale = 0.05f;
      material.height_frequency = 1.0f;
      break;
    case 3:
      what_ = "sides and alpha";
      material.double_sided = !material.double_sided;
      material.alpha_mode = random_.below(2) == 0 ? AlphaMode::opaque : AlphaMode::blend;
      material.opacity = 0.6f;
      break;
    default:
      what_ = "numbers of a material";
      material.perceptual_roughness = random_.share();
      material.base_color = {random_.share(), random_.share(), 0.5f};
  }
  shown.scene.materials[index] = material;
  return stage ? stage->setMaterial(index, material) : Result<void>();
}

Result<void> Changes::changeTransform(Shown& shown, Stage* stage) {
  what_ = "a transform";
  const auto index = static_cast<std::size_t>(random_.below(static_cast<int>(shown.scene.instances.size())));
  const glm::vec3 place(3.0f * random_.share() - 1.5f, random_.share() - 0.5f, 2.0f * random_.share() - 1.0f);
  const glm::mat4 turned = glm::rotate(glm::mat4(1.0f), 6.0f * random_.share(), glm::vec3(0.0f, 1.0f, 0.0f));
  const glm::mat4 placed = glm::translate(glm::mat4(1.0f), place) * turned;
  shown.scene.instances[index].world_from_object = placed;
  return stage ? stage->setTransform(index, placed) : Result<void>();
}

Result<void> Changes::changeLights(Shown& shown, Stage* stage) {
  what_ = "lights";
  shown.scene.lights.clear();
  for (int count = random_.below(3); count > 0; --count) {
    ModelLight light;
    light.position = {4.0f * random_.share() - 2.0f, 3.0f, 2.0f};
    light.color = glm::vec3(20.0f * random_.share());
    shown.scene.lights.push_back(light);
  }
  return stage ? stage->setLights(shown.scene.lights) : Result<void>();
}

Result<void> Changes::changeScene(Shown& shown, Stage* stage) {
  what_ = "a scene";
  MIRRORBALL_TRY(scene, sceneOfThree(random_));
  shown.scene = std::move(scene);
  return stage ? stage->setScene(shown.scene) : Result<void>();
}

/// What a scene has no setter for: the whole is set again, and shares with the one before what has not changed.
Result<void> Changes::changeCopy(Shown& shown, Stage* stage) {
  Scene& scene = shown.scene;
  switch (random_.below(3)) {
    case 0: {
      what_ = "a mesh";
      const auto mesh = static_cast<std::size_t>(random_.below(static_cast<int>(scene.meshes.size())));
      const float factor = 0.8f + 0.3f * random_.share();
      for (Vertex& vertex : scene.meshes[mesh].edit().vertices) vertex.position.y *= factor;
      break;
    }
    case 1: {
      what_ = "pixels";
      const auto level = static_cast<std::uint8_t>(random_.below(256));
      for (int x = 0; x < 16; ++x) scene.textures[0].image.edit().texel(x, 5)[1] = level;
      break;
    }
    default:
      what_ = "an instance that comes or goes";
      if (scene.instances.size() > 2)
        scene.instances.pop_back();
      else
        scene.instances.push_back(
            {.mesh = 2, .world_from_object = glm::translate(glm::mat4(1.0f), {0.2f, 0.9f, 0.0f})});
  }
  return stage ? stage->setScene(scene) : Result<void>();
}

Result<void> Changes::changeNode(Shown& shown, Stage* stage) {
  const int count = static_cast<int>(shown.scene.rig.nodes.size());
  const auto node = static_cast<std::size_t>(random_.below(count));
  what_ = "node " + std::to_string(node);
  NodePlace place;
  place.translation = {2.0 * double(random_.share()) - 1.0, double(random_.share()), 0.0};
  place.scale = glm::dvec3(random_.below(5) == 0 ? 0.0 : 0.5 + double(random_.share()));
  MIRRORBALL_TRY_VOID(placeNode(shown.scene, node, place));
  return stage ? stage->setNode(node, place) : Result<void>();
}

/// What the frames need is made in another thread, while the stage draws something else.
Result<void> Changes::workInThread(const Shown& shown, Stage* stage) {
  what_ = "work in a thread";
  const bool picks = random_.below(2) == 0;
  if (!stage) return {};
  MIRRORBALL_TRY(work, stage->workFor(shown.looks[0], picks));
  Result<void> done;
  std::thread thread([&] { done = work.run(); });
  View meanwhile(*stage);
  const Result<void> drawn = meanwhile.draw({.size = {16, 16}, .samples = 1});
  thread.join();
  MIRRORBALL_TRY_VOID(drawn);
  MIRRORBALL_TRY_VOID(done);
  MIRRORBALL_TRY_VOID(stage->take(std::move(work)));
  return {};
}

Result<void> Changes::changeEnvironment(Shown& shown, Stage* stage) {
  what_ = "an environment";
  shown.environment = random_.below(3);
  return stage ? stage->setEnvironment(environmentOf(shown.environment), cache()) : Result<void>();
}

Result<void> Changes::changeLook(Shown& shown) {
  FrameSettings& look = shown.looks[static_cast<std::size_t>(random_.below(kViews))];
  const Technique& technique = random_.oneOf(techniques());
  const char* value = random_.oneOf(technique.values);
  what_ = std::string("--") + technique.option + " " + value;
  return setLook(look, technique.option, value);
}

void Changes::changeSize(Shown& shown) {
  what_ = "a size";
  shown.looks[static_cast<std::size_t>(random_.below(kViews))].size = {48 + 8 * random_.below(4), 64};
}

Result<void> Changes::loseContext(Stage* stage) {
  what_ = "a lost context";
  if (!stage) return {};
  MIRRORBALL_TRY(device, Device::headless());
  return stage->moveTo(device);
}

/// One as a display shows it, one as radiance: their bytes.
using Pictures = std::array<std::vector<std::uint8_t>, kViews>;

Result<std::vector<std::uint8_t>> bytesOf(View& view, Resolve resolve) {
  if (resolve == Resolve::display) {
    MIRRORBALL_TRY(picture, view.picture());
    return std::vector<std::uint8_t>(picture.samples().begin(), picture.samples().end());
  }
  MIRRORBALL_TRY(radiance, view.radiance());
  std::vector<std::uint8_t> bytes(radiance.samples().size_bytes());
  std::memcpy(bytes.data(), radiance.samples().data(), bytes.size());
  return bytes;
}

/// Draws both views, a sample of each in turns. A view whose settings are as before finds by itself what has changed.
///
/// looks   those of their last frames; none at first
Result<Pictures> drawn(std::array<View, kViews>& views, const Shown& shown,
                       std::array<std::optional<FrameSettings>, kViews>& looks) {
  for (std::size_t i = 0; i < kViews; ++i) {
    if (looks[i] == shown.looks[i]) continue;
    MIRRORBALL_TRY_VOID(views[i].begin(shown.looks[i]));
    looks[i] = shown.looks[i];
  }
  // As a window that shows its first view at once, and its second when nothing is left to wait for.
  for (int left = 1; left > 0;) {
    MIRRORBALL_TRY(still, views[1].makeProgram());
    left = still;
  }
  for (bool is_whole = false; !is_whole;) {
    is_whole = true;
    for (std::size_t i = 0; i < kViews; ++i) {
      MIRRORBALL_TRY(samples, views[i].drawSample());
      is_whole = is_whole && samples == shown.looks[i].samples;
    }
  }
  Pictures pictures;
  for (std::size_t i = 0; i < kViews; ++i) {
    MIRRORBALL_TRY(bytes, bytesOf(views[i], shown.looks[i].resolve));
    pictures[i] = std::move(bytes);
  }
  return pictures;
}

/// The pictures of a device that is made for them.
Result<Pictures> drawnAnew(const Shown& shown) {
  MIRRORBALL_TRY(device, Device::headless());
  Stage stage(device);
  MIRRORBALL_TRY_VOID(stage.setEnvironment(environmentOf(shown.environment), cache()));
  MIRRORBALL_TRY_VOID(stage.setScene(shown.scene));
  std::array<View, kViews> views{View(stage), View(stage)};
  std::array<std::optional<FrameSettings>, kViews> looks;
  return drawn(views, shown, looks);
}

/// A number for them (FNV-1a).
std::uint64_t numberOf(const Pictures& pictures) {
  std::uint64_t number = 14695981039346656037u;
  for (const std::vector<std::uint8_t>& picture : pictures)
    for (const std::uint8_t byte : picture) number = (number ^ byte) * 1099511628211u;
  return number;
}

Result<Shown> firstShown() {
  Shown shown;
  for (FrameSettings& look : shown.looks) {
    look.size = {64, 64};
    look.samples = 2;
  }
  shown.looks[1].resolve = Resolve::radiance;
  return shown;
}

Result<std::uint64_t> numberAfter(int changes) {
  MIRRORBALL_TRY(shown, firstShown());
  Changes random;
  for (int change = 0; change < changes; ++change) MIRRORBALL_TRY_VOID(random.next(shown, nullptr));
  MIRRORBALL_TRY(pictures, drawnAnew(shown));
  return numberOf(pictures);
}

/// What another process of this program says of the pictures after so many changes.
std::optional<std::uint64_t> numberOfOther(const std::string& program, int changes) {
  std::FILE* other = ::popen(("'" + program + "' --after " + std::to_string(changes)).c_str(), "r");
  if (!other) return std::nullopt;
  unsigned long long number = 0;
  const bool is_read = std::fscanf(other, "%llu", &number) == 1;
  return ::pclose(other) == 0 && is_read ? std::optional<std::uint64_t>(number) : std::nullopt;
}

Result<bool> drive(const std::string& program, int changes) {
  MIRRORBALL_TRY(shown, firstShown());
  MIRRORBALL_TRY(device, Device::headless());
  Stage stage(device);
  stage.setCache(cache());
  MIRRORBALL_TRY_VOID(stage.setEnvironment(environmentOf(shown.environment), cache()));
  std::array<View, kViews> views{View(stage), View(stage)};
  std::array<std::optional<FrameSettings>, kViews> looks;
  Changes random;
  bool are_same = true;
  for (int change = 1; change <= changes; ++change) {
    MIRRORBALL_TRY_VOID(random.next(shown, &stage));
    MIRRORBALL_TRY(pictures, drawn(views, shown, looks));
    MIRRORBALL_TRY(anew, drawnAnew(shown));
    for (std::size_t i = 0; i < kViews; ++i) {
      if (pictures[i] == anew[i]) continue;
      are_same = false;
      std::printf("change %d (%s): view %zu differs from that of a new device\n", change, random.what().c_str(), i);
    }
    if (change % 10 == 0 && numberOfOther(program, change) != numberOf(pictures)) {
      are_same = false;
      std::printf("change %d (%s): the pictures differ from those of a new process\n", change, random.what().c_str());
    }
  }
  return are_same;
}

int told(const Error& error) {
  std::fprintf(stderr, "%s\n", error.message.c_str());
  return 1;
}

}  // namespace

int main(int count, char** words) {
  if (count == 3 && std::strcmp(words[1], "--after") == 0) {
    const Result<std::uint64_t> number = numberAfter(std::atoi(words[2]));
    if (!number) return told(number.error());
    std::printf("%llu\n", static_cast<unsigned long long>(*number));
    return 0;
  }
  if (count != 2) {
    std::fprintf(stderr, "usage: live_stage CHANGES\n");
    return 2;
  }
  const Result<bool> are_same = drive(words[0], std::atoi(words[1]));
  if (!are_same) return told(are_same.error());
  return *are_same ? 0 : 1;
}
