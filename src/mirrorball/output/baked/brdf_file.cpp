#include "mirrorball/output/baked/brdf_file.h"

#include <filesystem>
#include <utility>

#include <nlohmann/json.hpp>

#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "mirrorball/environment/file/recognize.h"
#include "mirrorball/output/baked/table_file.h"

namespace mirrorball {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kManifestKey = "brdf";
constexpr const char* kDistributionKey = "mirrorball:brdf_distribution";
constexpr const char* kAxesKey = "mirrorball:brdf_axes";
constexpr const char* kChannelsKey = "mirrorball:brdf_channels";

Metadata brdfMetadata(const BrdfTableFacts& facts) {
  Metadata metadata = metadataOfBrdfTable();
  metadata[kDistributionKey] = facts.distribution;
  metadata[kAxesKey] = facts.axes;
  metadata[kChannelsKey] = std::to_string(facts.channels);
  return metadata;
}

std::optional<BrdfTableFacts> factsIn(const Metadata& metadata) {
  const auto find = [&](const char* key) {
    const auto entry = metadata.find(key);
    return entry == metadata.end() ? std::string() : excerpt(entry->second);
  };
  if (!isBrdfTable(metadata)) return {};
  return BrdfTableFacts{find(kDistributionKey), find(kAxesKey), find(kChannelsKey) == "2" ? 2 : 3};
}

/// What the manifest in the file's folder says of it, for .dds, which has no place for words.
std::optional<BrdfTableFacts> factsBeside(const std::filesystem::path& path) {
  const auto text = readFile(path.parent_path() / "manifest.json");
  if (!text) return {};
  const Json manifest = Json::parse(text->begin(), text->end(), nullptr, false);
  if (!manifest.is_object() || !manifest.contains(kManifestKey) || !manifest[kManifestKey].is_object()) return {};
  const Json& brdf = manifest[kManifestKey];
  const auto word = [&](const char* key) {
    return brdf.contains(key) && brdf[key].is_string() ? excerpt(brdf[key].get<std::string>()) : std::string();
  };
  if (word("file") != path.filename().string()) return {};
  const std::string axes = word("axes");
  const bool has_two = brdf.contains("channels") && brdf["channels"].is_array() && brdf["channels"].size() == 2;
  return BrdfTableFacts{word("distribution"), axes.substr(0, axes.find(':')), has_two ? 2 : 3};
}

/// Pictures have one or three channels: of two, the third is black.
Image withThreeChannels(const Image& image) {
  if (image.channels() == 3) return image;
  Image wide(image.width(), image.height(), 3);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; c < image.channels(); ++c) wide.texel(x, y)[c] = image.texel(x, y)[c];
  return wide;
}

}  // namespace

Result<void> writeBrdf(Image table, const BrdfFile& file) {
  const Metadata metadata = brdfMetadata(file.facts);
  if (file.isTexture())
    MIRRORBALL_TRY_VOID(
        writeImageSet(file.path, ImageSet(std::move(table)),
                      {.format = file.format, .zstandard_level = file.zstandard_level, .metadata = metadata}));
  else
    MIRRORBALL_TRY_VOID(writeImage(file.path, withThreeChannels(table),
                                   {.half = file.format == TexelFormat::half, .metadata = metadata}));
  return {};
}

Result<std::optional<FoundBrdfTable>> brdfTableIn(const std::string& path) {
  MIRRORBALL_TRY(file, tableFileIn(path));
  if (file) {
    auto facts = factsIn(file->metadata);
    if (!facts) return std::nullopt;
    return FoundBrdfTable{std::move(*facts), std::move(file->format), std::move(file->table)};
  }
  if (extensionOf(path) != "dds") return std::nullopt;
  auto facts = factsBeside(path);
  if (!facts) return std::nullopt;
  MIRRORBALL_TRY(texture, readImageSet(path));
  return FoundBrdfTable{std::move(*facts), texture.format, std::move(texture.images.at(0, 0))};
}

}  // namespace mirrorball
