#include "avif_mutation.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "chance.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/color/icc_testing.h"
#include "obus.h"

namespace mirrorball::fuzz {
namespace {

constexpr std::size_t kFlags = 4;  // version and flags, at the beginning of many boxes

Bytes bytesOfText(std::string_view text) { return {text.begin(), text.end()}; }

Bytes bigNumbers(std::initializer_list<std::uint32_t> numbers) {
  Bytes bytes;
  for (const std::uint32_t number : numbers) appendBig(bytes, number, 4);
  return bytes;
}

/// Primaries, transfer and matrix by ITU-T H.273, and whether codes have their full range.
Bytes anyNclx(std::mt19937& random) {
  Bytes nclx = bytesOfText("nclx");
  appendBig(nclx, pick({0, 1, 2, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 22, 255, 65535}, random), 2);
  appendBig(nclx, onceIn(16, random) ? 300 : below(20, random), 2);
  appendBig(nclx, below(16, random), 2);
  nclx.push_back(onceIn(3, random) ? 0 : 0x80);
  return nclx;
}

Bytes anyAuxiliaryType(std::mt19937& random) {
  Bytes type(kFlags);
  const std::string_view name = pick<std::string_view>(
      {"urn:mpeg:mpegB:cicp:systems:auxiliary:alpha", "urn:mpeg:hevc:2015:auxid:1", "urn:mpeg:hevc:2015:auxid:2", ""},
      random);
  type.insert(type.end(), name.begin(), name.end());
  type.push_back(0);
  return type;
}

/// A clean aperture, in fractions, of a few texels, whole or not.
Bytes anyAperture(std::mt19937& random) {
  Bytes bytes;
  for (int i = 0; i < 4; ++i) {
    appendBig(bytes, onceIn(8, random) ? random() : below(12, random), 4);
    appendBig(bytes, onceIn(8, random) ? below(4, random) : 1, 4);
  }
  return bytes;
}

FileBox anyProperty(std::mt19937& random) {
  switch (below(9, random)) {
    case 0:
      return {"irot", {static_cast<std::uint8_t>(below(4, random))}};
    case 1:
      return {"imir", {static_cast<std::uint8_t>(below(2, random))}};
    case 2:
      return {"clap", anyAperture(random)};
    case 3:
      return {"colr", anyNclx(random)};
    case 4: {
      Bytes profile = bytesOfText(onceIn(2, random) ? "prof" : "rICC");
      const Bytes numbers = testing::iccDisplayP3();
      profile.insert(profile.end(), numbers.begin(), numbers.end());
      return {"colr", std::move(profile)};
    }
    case 5:
      return {"pasp", bigNumbers({1, static_cast<std::uint32_t>(below(3, random))})};
    case 6:
      return {"pixi", {0, 0, 0, 0, 3, 8, 8, static_cast<std::uint8_t>(below(17, random))}};
    case 7:
      return {"a1lx", {0, 0, 4, 0, 4, 0, 4}};
    default:
      return {"auxC", anyAuxiliaryType(random)};
  }
}

/// Changes a property to another of its kind, or, where little is known of it, its bytes.
void changeProperty(FileBox& property, std::mt19937& random) {
  const Bytes colr = bytesOfText("nclx");
  if (property.type == "ispe" && property.content.size() == kFlags + 8) {
    const std::size_t side = onceIn(2, random) ? 4 : 8;
    const std::uint32_t before = bigU32(property.content.data() + side);
    const std::uint32_t size = pick({before + 1, before - 1, 2 * before, 0u, 1u, 64u, 65536u, 0x7fffffffu}, random);
    Bytes number;
    appendBig(number, size, 4);
    std::ranges::copy(number, property.content.begin() + static_cast<std::ptrdiff_t>(side));
  } else if (property.type == "colr" && std::ranges::equal(std::span(property.content).first(4), colr)) {
    property.content = anyNclx(random);
  } else if (property.type == "colr") {
    changeBytes(property.content, 4, random);
  } else if (property.type == "clap") {
    property.content = anyAperture(random);
  } else if (property.type == "auxC") {
    property.content = anyAuxiliaryType(random);
  } else {
    changeBytes(property.content, 0, random);
  }
}

/// The properties of an item, by their numbers in `ipco` from 1 on; the highest bit says that one is essential.
struct PropertiesOfItem {
  std::uint32_t item = 0;
  std::vector<std::uint16_t> properties = {};
};

/// What `ipma` holds, of whatever version; nothing where it is cut.
std::optional<std::vector<PropertiesOfItem>> associationsIn(const Bytes& ipma) {
  constexpr std::size_t kCount = 4;
  if (ipma.size() < kFlags + kCount) return std::nullopt;
  const bool is_long = ipma[0] > 0, has_wide_numbers = (ipma[3] & 1u) != 0;
  const std::size_t of_item = is_long ? 4 : 2, of_property = has_wide_numbers ? 2 : 1;
  std::vector<PropertiesOfItem> all;
  std::size_t at = kFlags + kCount;
  while (at + of_item < ipma.size()) {
    PropertiesOfItem one{is_long ? bigU32(ipma.data() + at) : bigU16(ipma.data() + at)};
    std::size_t count = ipma[at + of_item];
    at += of_item + 1;
    for (; count > 0; --count, at += of_property) {
      if (at + of_property > ipma.size()) return std::nullopt;
      const unsigned number =
          has_wide_numbers ? bigU16(ipma.data() + at) : (ipma[at] & 0x7fu) | (ipma[at] & 0x80u) << 8;
      one.properties.push_back(static_cast<std::uint16_t>(number));
    }
    all.push_back(std::move(one));
  }
  if (all.empty()) return std::nullopt;
  return all;
}

Bytes ipmaOfAssociations(const std::vector<PropertiesOfItem>& all) {
  Bytes ipma{0, 0, 0, 1};  // numbers of two bytes
  appendBig(ipma, all.size(), 4);
  for (const PropertiesOfItem& one : all) {
    appendBig(ipma, one.item, 2);
    appendBig(ipma, one.properties.size(), 1);
    for (const std::uint16_t property : one.properties) appendBig(ipma, property, 2);
  }
  return ipma;
}

/// Gives an item another property, one more, or one less.
void changeAssociations(FileBox& iprp, bool adds, std::mt19937& random) {
  constexpr std::uint16_t kEssential = 0x8000;
  FileBox* ipco = firstBox(iprp.boxes, "ipco");
  FileBox* ipma = firstBox(iprp.boxes, "ipma");
  auto all = ipma == nullptr ? std::nullopt : associationsIn(ipma->content);
  if (!all || ipco == nullptr) return;
  std::vector<std::uint16_t>& properties = oneIn(*all, random).properties;
  if (adds) {
    ipco->boxes.push_back(anyProperty(random));
    const auto number = static_cast<std::uint16_t>(ipco->boxes.size());
    properties.push_back(onceIn(2, random) ? number | kEssential : number);
  } else if (properties.empty() || onceIn(3, random)) {
    properties.push_back(static_cast<std::uint16_t>(below(ipco->boxes.size() + 2, random)));
  } else if (onceIn(2, random)) {
    oneIn(properties, random) ^= kEssential;
  } else {
    properties.erase(properties.begin() + static_cast<std::ptrdiff_t>(below(properties.size(), random)));
  }
  ipma->content = ipmaOfAssociations(*all);
}

/// Changes which item is the picture, what an item is, or what it is to another.
void changeItems(FileBox& meta, std::mt19937& random) {
  constexpr std::size_t kItemType = 8;  // in `infe` of version 2
  FileBox* iinf = firstBox(meta.boxes, "iinf");
  FileBox* iref = firstBox(meta.boxes, "iref");
  FileBox* pitm = firstBox(meta.boxes, "pitm");
  if (iref != nullptr && !iref->boxes.empty() && onceIn(2, random)) {
    FileBox& reference = oneIn(iref->boxes, random);
    if (onceIn(2, random))
      reference.type = pick<std::string_view>({"auxl", "dimg", "prem", "cdsc", "thmb"}, random);
    else
      changeBytes(reference.content, 0, random);
  } else if (pitm != nullptr && onceIn(4, random)) {
    changeBytes(pitm->content, kFlags, random);
  } else if (iinf != nullptr && !iinf->boxes.empty()) {
    FileBox& item = oneIn(iinf->boxes, random);
    if (item.content.size() >= kItemType + 4 && onceIn(2, random))
      std::ranges::copy(pick<std::string_view>({"av01", "grid", "iden", "Exif", "mime"}, random),
                        item.content.begin() + kItemType);
    else
      changeBytes(item.content, 0, random);
  }
}

/// Changes a byte of a box or of one in it, whatever that is.
void changeAnyBox(std::vector<FileBox>& boxes, std::mt19937& random) {
  FileBox& box = oneIn(boxes, random);
  if (box.boxes.empty() || onceIn(8, random))
    changeBytes(box.content, 0, random);
  else
    changeAnyBox(box.boxes, random);
}

AvifPlaces anyPlaces(std::mt19937& random) {
  AvifPlaces places{.version = static_cast<int>(below(3, random))};
  places.is_in_meta = places.version > 0 && onceIn(3, random);
  places.has_base = onceIn(3, random);
  places.goes_back = onceIn(3, random);
  places.extents = onceIn(2, random) ? 1 : 1 + below(3, random);
  return places;
}

}  // namespace

Bytes changedAvif(const Bytes& file, std::mt19937& random) {
  auto parts = avifPartsIn(file);
  if (!parts) {
    Bytes bytes = file;
    changeBytes(bytes, 0, random);
    return bytes;
  }
  FileBox* meta = firstBox(parts->boxes, "meta");
  FileBox* iprp = firstBox(meta->boxes, "iprp");
  FileBox* ipco = iprp == nullptr ? nullptr : firstBox(iprp->boxes, "ipco");
  const std::size_t kind = below(16, random);
  if (kind == 0)
    changeAnyBox(meta->boxes, random);
  else if (kind == 1)
    changeItems(*meta, random);
  else if (kind < 5 && ipco != nullptr && !ipco->boxes.empty())
    changeProperty(oneIn(ipco->boxes, random), random);
  else if (kind < 7 && iprp != nullptr)
    changeAssociations(*iprp, kind == 5, random);
  else
    changeAv1(oneIn(parts->items, random).data, random);
  return avifOfParts(*parts, onceIn(4, random) ? anyPlaces(random) : AvifPlaces{});
}

}  // namespace mirrorball::fuzz
