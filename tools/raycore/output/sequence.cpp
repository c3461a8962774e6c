// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "output/sequence.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string_view>

#include "input/error.h"
#include "input/file.h"

namespace rc::tool {
namespace {

constexpr size_t kMostDigits = 7;

// Takes the digits at the front of text.
std::optional<int> takeNumber(std::string_view &text) {
  const size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  if (digits == 0 || digits > kMostDigits) return std::nullopt;
  const int number = std::stoi(std::string(text.substr(0, digits)));
  text.remove_prefix(digits);
  return number;
}

// A name with its place for the number cut out: %d or %04d.
struct Pattern {
  std::string before, after;
  int width = 1;
};

std::optional<Pattern> patternIn(const std::string &name) {
  for (size_t at = name.find('%'); at != name.npos; at = name.find('%', at + 1)) {
    std::string_view rest = std::string_view(name).substr(at + 1);
    const int width = takeNumber(rest).value_or(1);
    if (rest.starts_with('d')) return Pattern{name.substr(0, at), std::string(rest.substr(1)), std::clamp(width, 1, 9)};
  }
  return std::nullopt;
}

}  // namespace

FrameRange rangeFrom(const std::string &text) {
  std::string_view rest = text;
  const std::optional<int> first = takeNumber(rest);
  const bool two = rest.starts_with('-');
  if (two) rest.remove_prefix(1);
  const std::optional<int> last = two ? takeNumber(rest) : first;
  if (!first || !last || !rest.empty()) refuseOption("--frames: \"{}\" is not a range such as 0-99", text);
  if (*last < *first) refuseOption("--frames: {} comes after {}", *first, *last);
  return {*first, *last};
}

std::string fileOfFrame(const std::string &pattern, int frame) {
  const std::filesystem::path path(pattern);
  const Pattern plain{path.stem().string() + "-", path.extension().string(), 4};
  const Pattern parts = patternIn(path.filename().string()).value_or(plain);
  return (path.parent_path() / fmt::format("{}{:0{}}{}", parts.before, frame, parts.width, parts.after)).string();
}

bool isNumbered(const std::string &name) {
  return patternIn(std::filesystem::path(name).filename().string()).has_value();
}

bool isVideo(const std::string &name) {
  const std::string extension = extensionOf(name);
  return extension == ".mp4" || extension == ".webm";
}

}  // namespace rc::tool
