#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <variant>

#include <glm/vec4.hpp>

#include "mirrorball/base/shared.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// A texture's picture of 4 channels, which its copies share: codes of 8 bits, or floats where its file has finer ones.
class SharedPicture {
  std::variant<Shared<Image8>, Shared<Image>> texels_;

  template <typename Function>
  auto visit(const Function& function) const {
    return std::visit([&](const auto& shared) { return function(*shared); }, texels_);
  }

 public:
  SharedPicture(Image8 codes = {}) : texels_(Shared<Image8>(std::move(codes))) {}
  SharedPicture(Image numbers) : texels_(Shared<Image>(std::move(numbers))) {}
  SharedPicture(Texels texels)
      : SharedPicture(std::visit([](auto& image) { return SharedPicture(std::move(image)); }, texels)) {}

  bool hasNumbers() const { return texels_.index() == 1; }
  const Image8& codes() const { return *std::get<0>(texels_); }  ///< unless it has numbers
  const Image& numbers() const { return *std::get<1>(texels_); }

  int width() const {
    return visit([](const auto& image) { return image.width(); });
  }
  int height() const {
    return visit([](const auto& image) { return image.height(); });
  }
  int channels() const {
    return visit([](const auto& image) { return image.channels(); });
  }
  bool empty() const {
    return visit([](const auto& image) { return image.empty(); });
  }
  std::size_t texelCount() const { return std::size_t(width()) * std::size_t(height()); }
  std::size_t bytes() const {
    return visit([](const auto& image) { return image.samples().size_bytes(); });
  }

  /// A texel as it is stored, codes as fractions of 255.
  glm::vec4 at(int x, int y) const {
    if (hasNumbers()) {
      const float* const number = numbers().texel(x, y);
      return {number[0], number[1], number[2], number[3]};
    }
    const std::uint8_t* const code = texel(x, y);
    return glm::vec4(code[0], code[1], code[2], code[3]) / 255.0f;
  }

  // Of codes:
  std::span<const std::uint8_t> samples() const { return codes().samples(); }
  const std::uint8_t* texel(int x, int y) const { return codes().texel(x, y); }
  Image8& edit() { return std::get<0>(texels_).edit(); }

  Image& editNumbers() { return std::get<1>(texels_).edit(); }

  /// What its copies have in common, and no other picture.
  const void* identity() const {
    return visit([](const auto& image) { return static_cast<const void*>(&image); });
  }
  bool isSameAs(const SharedPicture& other) const { return identity() == other.identity(); }
};

}  // namespace mirrorball
