// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include <array>
#include <charconv>

#include "draw/stage.h"
#include "input/error.h"
#include "input/file.h"
#include "load/load.h"

namespace rc::tool {
namespace {

struct Named {
  std::string_view name;
  Vec3 colour;
};

constexpr std::array kNames{
    Named{"black", {0, 0, 0}},         Named{"white", {1, 1, 1}},         Named{"grey", {0.5f, 0.5f, 0.5f}},
    Named{"gray", {0.5f, 0.5f, 0.5f}}, Named{"red", {1, 0, 0}},           Named{"green", {0, 1, 0}},
    Named{"blue", {0, 0, 1}},          Named{"sky", {0.53f, 0.7f, 0.9f}},
};

std::optional<Vec3> hexColour(std::string_view text) {
  unsigned value = 0;
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + 7, value, 16);
  if (error != std::errc() || end != text.data() + 7) return std::nullopt;
  return Vec3(value >> 16 & 255, value >> 8 & 255, value & 255) / 255.0f;
}

std::optional<Vec3> colourFrom(const std::string &text) {
  for (const Named &named : kNames) {
    if (named.name == text) return named.colour;
  }
  if (const auto colour = hexColour(text)) return colour;
  Vec3 c;
  char rest = 0;
  const bool three = std::sscanf(text.c_str(), "%f,%f,%f%c", &c.x, &c.y, &c.z, &rest) == 3;
  return three ? std::optional(glm::clamp(c, Vec3(0), Vec3(1))) : std::nullopt;
}

Image gradient(const Vec3 &top, const Vec3 &bottom) {
  constexpr int kHeight = 256;
  Image image{"gradient", 16, kHeight, {}};
  for (int y = 0; y < kHeight; ++y) {
    const Vec3 c = glm::mix(top, bottom, (float(y) + 0.5f) / kHeight) * 255.0f + 0.5f;
    for (int x = 0; x < 16; ++x) image.rgba.insert(image.rgba.end(), {uint8_t(c.x), uint8_t(c.y), uint8_t(c.z), 255});
  }
  return image;
}

Image gradientFrom(const std::string &text) {
  const size_t colon = text.find(':'), comma = text.find(',');
  if (colon == text.npos) return gradient({0.32f, 0.47f, 0.68f}, {0.86f, 0.84f, 0.8f});
  const auto top = colourFrom(text.substr(colon + 1, comma - colon - 1));
  const auto bottom = comma == text.npos ? std::nullopt : colourFrom(text.substr(comma + 1));
  if (!top || !bottom) reject("--background: \"{}\" is not gradient:#rrggbb,#rrggbb", text);
  return gradient(*top, *bottom);
}

}  // namespace

Background backgroundFrom(const std::string &text) {
  if (text.empty()) return {};
  if (text.starts_with("gradient")) return {{}, gradientFrom(text)};
  if (const auto colour = colourFrom(text)) return {*colour, std::nullopt};
  if (extensionOf(text).empty()) reject("--background: \"{}\" is neither a colour nor a picture", text);
  try {
    return {{}, loadPicture(text)};
  } catch (const InputError &error) {
    reject("--background {}: {}", text, error.what());
  }
}

}  // namespace rc::tool
