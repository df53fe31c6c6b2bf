#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mirrorball {

/// A text without the white space around it.
inline std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n";
  const std::size_t begin = std::min(text.find_first_not_of(kSpace), text.size());
  return text.substr(begin, text.find_last_not_of(kSpace) + 1 - begin);
}

/// The values of the properties of one namespace in an XMP packet: attributes, or elements that hold one value or a
/// list. It does not read XML in general; comments and entities are not what writers put there.
class XmpProperties {
 public:
  /// xmp      a packet, or any bytes with one among them; must outlive this
  /// uri      of the namespace
  /// prefix   that it usually has, where the packet does not state one
  XmpProperties(std::string_view xmp, std::string_view uri, std::string_view prefix)
      : xmp_(xmp), prefix_(prefixIn(xmp, uri).value_or(std::string(prefix))) {}

  /// One value or those of a list; none where the property is absent.
  std::vector<std::string_view> values(std::string_view name) const {
    const std::string whole = prefix_ + ":" + std::string(name);
    for (std::size_t at = xmp_.find(whole); at != std::string_view::npos; at = xmp_.find(whole, at + 1)) {
      const std::string_view rest = trimmed(xmp_.substr(at + whole.size()));
      if (rest.starts_with('=')) {
        const std::string_view quoted = trimmed(rest.substr(1));
        if (quoted.empty() || (quoted[0] != '"' && quoted[0] != '\'')) continue;
        return {trimmed(quoted.substr(1, quoted.substr(1).find(quoted[0])))};
      }
      if (at > 0 && xmp_[at - 1] == '<' && rest.starts_with('>'))
        return listed(rest.substr(1, rest.find("</" + whole) - 1));
    }
    return {};
  }

 private:
  /// The name that the packet gives the namespace: xmlns:hdrgm="http://…".
  static std::optional<std::string> prefixIn(std::string_view xmp, std::string_view uri) {
    const std::size_t place = xmp.find(uri);
    const std::size_t at = place == std::string_view::npos ? place : xmp.substr(0, place).rfind("xmlns:");
    if (at == std::string_view::npos) return std::nullopt;
    const std::string_view before = xmp.substr(0, place);
    const std::string_view rest = before.substr(at + 6);
    return std::string(trimmed(rest.substr(0, rest.find('='))));
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
