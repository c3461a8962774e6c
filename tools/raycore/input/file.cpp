// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "input/file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "input/error.h"

namespace rc::tool {

std::string readFile(const std::string &name) {
  std::error_code error;
  if (std::filesystem::is_directory(name, error)) reject("is a folder");
  std::ifstream file(name, std::ios::binary);
  if (!file) reject("cannot be opened: {}", std::strerror(errno));
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) reject("cannot be read: {}", std::strerror(errno));
  return bytes;
}

std::string extensionOf(const std::string &name) {
  std::string extension = std::filesystem::path(name).extension().string();
  for (char &c : extension) {
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  }
  return extension;
}

}  // namespace rc::tool
