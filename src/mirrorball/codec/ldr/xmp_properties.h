#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/text.h"

namespace mirrorball {

inline constexpr std::string_view kXmlSpace = " \t\r\n";

/// A text without the white space before it. It looks at that alone: a search may call it at each of its many hits.
inline std::string_view withoutLeadingSpace(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(kXmlSpace), text.size()));
}

/// The values of the properties of one namespace in an XMP packet: attributes, or elements that hold one value or a
/// list. It does not read XML in general; comments and entities are not what writers put there. Where the packet
/// declares the namespace, only what may be in the scope of that counts: from its element to the end of the packet.
///
/// cost     of each call, at most one pass over the bytes, whatever they are
class XmpProperties {
 public:
  /// xmp      a packet, or any bytes with one among them; must outlive this
  /// uri      of the namespace
  /// prefix   that it usually has, where the packet does not state one
  XmpProperties(std::string_view xmp, std::string_view uri, std::string_view prefix) : xmp_(xmp), prefix_(prefix) {
    const std::optional<Declaration> declaration = findDeclaration(xmp, uri);
    if (!declaration) return;
    const std::size_t element = xmp.substr(0, declaration->at).rfind('<');
    xmp_ = xmp.substr(element == std::string_view::npos ? declaration->at : element);
    xmp_ = xmp_.substr(0, xmp_.find("</x:xmpmeta>"));
    prefix_ = declaration->prefix;
  }

  /// One value or those of a list; none where the property is absent.
  std::vector<std::string_view> values(std::string_view name) const {
    const std::string whole = prefix_ + ":" + std::string(name);
    for (std::size_t at = xmp_.find(whole); at != std::string_view::npos; at = xmp_.find(whole, at + 1)) {
      const std::string_view rest = withoutLeadingSpace(xmp_.substr(at + whole.size()));
      if (rest.starts_with('=')) {
        const std::string_view quoted = withoutLeadingSpace(rest.substr(1));
        if (quoted.empty() || (quoted[0] != '"' && quoted[0] != '\'')) continue;
        return {trimmed(quoted.substr(1, quoted.substr(1).find(quoted[0])))};
      }
      if (at > 0 && xmp_[at - 1] == '<' && rest.starts_with('>'))
        return listed(rest.substr(1, rest.find("</" + whole) - 1));
    }
    return {};
  }

 private:
  /// xmlns:hdrgm="http://…"
  struct Declaration {
    std::size_t at;  ///< where it begins
    std::string_view prefix;
  };

  /// The first declaration of a namespace; none with a longer prefix than writers choose, which would make each look-up
  /// of a property expensive.
  static std::optional<Declaration> findDeclaration(std::string_view xmp, std::string_view uri) {
    constexpr std::string_view kAttribute = "xmlns:";
    constexpr std::size_t kLongest = 64;  // from its beginning to the address
    for (std::size_t place = xmp.find(uri); place != std::string_view::npos; place = xmp.find(uri, place + 1)) {
      const std::size_t begin = place - std::min(place, kLongest);
      const std::string_view before = xmp.substr(begin, place - begin);
      const std::size_t attribute = before.rfind(kAttribute);
      if (attribute == std::string_view::npos) continue;
      const std::string_view rest = before.substr(attribute + kAttribute.size());
      const std::size_t equals = rest.find('=');
      if (equals != std::string_view::npos) return Declaration{begin + attribute, trimmed(rest.substr(0, equals))};
    }
    return std::nullopt;
  }

  static std::vector<std::string_view> listed(std::string_view inside) {
    constexpr std::string_view kBegin = "<rdf:li>", kEnd = "</rdf:li>";
    std::vector<std::string_view> values;
    const std::string_view whole = inside;
    for (std::size_t begin = inside.find(kBegin); begin != std::string_view::npos; begin = inside.find(kBegin)) {
      inside = inside.substr(begin + kBegin.size());
      const std::size_t end = inside.find(kEnd);
      if (end == std::string_view::npos) break;
      values.push_back(trimmed(inside.substr(0, end)));
      inside = inside.substr(end);
    }
    if (values.empty()) values.push_back(trimmed(whole));
    return values;
  }

  std::string_view xmp_;
  std::string prefix_;
};

}  // namespace mirrorball
