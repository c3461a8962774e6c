// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "output/sequence.h"

#include <cstdio>
#include <filesystem>
#include <regex>

#include "load/error.h"
#include "load/file.h"

namespace rc::tool {

FrameRange rangeFrom(const std::string &text) {
  std::smatch parts;
  static const std::regex kRange("(\\d{1,7})(?:-(\\d{1,7}))?");
  if (!std::regex_match(text, parts, kRange)) reject("--frames: \"{}\" is not a range such as 0-99", text);
  const int first = std::stoi(parts[1]), last = parts[2].matched ? std::stoi(parts[2]) : first;
  if (last < first) reject("--frames: {} comes after {}", first, last);
  return {first, last};
}

std::string fileOfFrame(const std::string &pattern, int frame) {
  static const std::regex kNumber("%0?(\\d*)d");
  std::smatch found;
  const std::filesystem::path path(pattern);
  const std::string name = path.filename().string();
  if (!std::regex_search(name, found, kNumber)) {
    return (path.parent_path() / fmt::format("{}-{:04}{}", path.stem().string(), frame, path.extension().string()))
        .string();
  }
  const int width = found[1].length() > 0 ? std::min(std::stoi(found[1]), 9) : 1;
  const std::string numbered = found.prefix().str() + fmt::format("{:0{}}", frame, width) + found.suffix().str();
  return (path.parent_path() / numbered).string();
}

bool isVideo(const std::string &name) {
  const std::string extension = extensionOf(name);
  return extension == ".mp4" || extension == ".webm";
}

}  // namespace rc::tool
