// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "foreign/obj_check.h"

#include <array>
#include <charconv>

#include "input/error.h"

namespace rc::tool::foreign {
namespace {

// Assimp cuts a polygon into triangles in a time that grows with the cube of its corners.
constexpr size_t kMostCorners = 2048;
constexpr std::string_view kBlank = " \t\r";

std::string_view nextWord(std::string_view &line) {
  line.remove_prefix(std::min(line.find_first_not_of(kBlank), line.size()));
  const std::string_view word = line.substr(0, std::min(line.find_first_of(kBlank), line.size()));
  line.remove_prefix(word.size());
  return word;
}

class Checker {
 public:
  Checker(const FileExists &exists, Scene &scene) : mExists(exists), mScene(scene) {}

  void line(std::string_view text) {
    ++mLine;
    const std::string_view record = nextWord(text);
    if (record == "v") countVertex(text);
    if (record == "vt") ++mCounts[1];
    if (record == "vn") ++mCounts[2];
    if (record == "f") face(text);
    if (record == "mtllib") library(text);
  }

 private:
  // The rest of the line is one name; Assimp says nothing where it finds no such file.
  void library(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size()));
    const std::string name(text.substr(0, text.find_last_not_of(kBlank) + 1));
    if (mExists(name)) return;
    mScene.note(fmt::format("line {}: the materials of \"{}\" cannot be opened; drawn without", mLine, name));
  }

  void countVertex(std::string_view text) {
    ++mCounts[0];
    for (int i = 0; i < 3; ++i) {
      if (nextWord(text).empty()) reject("line {}: a vertex with {} coordinates", mLine, i);
    }
  }

  void face(std::string_view text) {
    size_t corners = 0;
    for (std::string_view word = nextWord(text); !word.empty(); word = nextWord(text)) {
      if (word == "\\") break;
      corner(word);
      ++corners;
    }
    if (corners > kMostCorners)
      reject("line {}: a face with {} corners, at most {} are read", mLine, corners, kMostCorners);
    if (corners < 3) mScene.note(fmt::format("line {}: a face with {} corners; not drawn", mLine, corners));
  }

  // vertex/coordinate/normal, the last two optional; from 1 on, or back from the last one.
  void corner(std::string_view word) {
    static constexpr std::array kNames{"vertex", "texture coordinate", "normal"};
    for (size_t kind = 0; kind < kNames.size() && !word.empty(); ++kind) {
      const std::string_view part = word.substr(0, std::min(word.find('/'), word.size()));
      word.remove_prefix(std::min(part.size() + 1, word.size()));
      if (part.empty()) continue;
      long long index = 0;
      const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
      if (error == std::errc::invalid_argument) return mScene.note(fmt::format("line {}: not an index", mLine));
      const long long count = static_cast<long long>(mCounts[kind]);
      const bool fits = error == std::errc() && index != 0 && index <= count && index >= -count;
      if (!fits) reject("line {}: {} {} of {}", mLine, kNames[kind], part, count);
    }
  }

  const FileExists &mExists;
  Scene &mScene;
  size_t mLine = 0;
  std::array<size_t, 3> mCounts{};
};

}  // namespace

void checkObj(std::string_view text, const FileExists &exists, Scene &scene) {
  Checker checker(exists, scene);
  while (!text.empty()) {
    const size_t end = std::min(text.find('\n'), text.size());
    checker.line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

}  // namespace rc::tool::foreign
