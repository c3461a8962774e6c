// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "gltf/document.h"

#include <algorithm>
#include <array>

#include "input/file.h"

namespace rc::tool::gltf {
namespace {

int base64Digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

std::string fromBase64(const Value &uri, std::string_view text) {
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() * 3 / 4);
  uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const int digit = base64Digit(c);
    if (digit < 0) uri.complain("is not valid base64");
    bits = bits << 6 | uint32_t(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<char>(bits >> count & 255));
  }
  return bytes;
}

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

std::string percentDecoded(std::string_view text) {
  std::string result;
  for (size_t i = 0; i < text.size(); ++i) {
    const bool coded =
        text[i] == '%' && i + 2 < text.size() && hexDigit(text[i + 1]) >= 0 && hexDigit(text[i + 2]) >= 0;
    result.push_back(coded ? static_cast<char>(16 * hexDigit(text[i + 1]) + hexDigit(text[i + 2])) : text[i]);
    if (coded) i += 2;
  }
  return result;
}

void stayInFolder(const Value &uri, const std::string &name) {
  if (name.find("://") != std::string::npos) uri.complain("is on a network: only files beside the model are read");
  std::string_view rest = name;
  bool outside = rest.starts_with('/') || rest.find('\0') != rest.npos;
  while (!rest.empty()) {
    const size_t slash = std::min(rest.find_first_of("/\\"), rest.size());
    outside = outside || rest.substr(0, slash) == "..";
    rest.remove_prefix(std::min(slash + 1, rest.size()));
  }
  if (outside) uri.complain("leaves the model's folder");
}

}  // namespace

std::string fetch(const Value &uri, const std::string &folder) {
  const std::string text = uri.text();
  if (text.starts_with("data:")) {
    const size_t comma = text.find(',');
    if (comma == std::string::npos) uri.complain("is a data URI without data");
    const std::string_view data = std::string_view(text).substr(comma + 1);
    const bool base64 = std::string_view(text).substr(0, comma).ends_with(";base64");
    return base64 ? fromBase64(uri, data) : percentDecoded(data);
  }
  const std::string name = percentDecoded(text);
  stayInFolder(uri, name);
  try {
    return readFile(folder + "/" + name);
  } catch (const InputError &error) {
    uri.complain("\"{}\" {}", name, error.what());
  }
}

Document::Document(std::string_view bytes, std::string folder) : mContainer(open(bytes)), mFolder(std::move(folder)) {
  scene.format = isBinary(bytes) ? "glTF 2.0 binary" : "glTF 2.0";
}

std::string_view Document::buffer(int index) {
  const Value about = root()["buffers"][size_t(index)];
  const size_t length = about.at("byteLength").count(0);
  std::string_view bytes;
  if (about["uri"]) {
    if (!mFetched.contains(index)) mFetched[index] = fetch(about["uri"], mFolder);
    bytes = mFetched[index];
  } else {
    if (index != 0 || !mContainer.binary) about.complain("has no uri, and there is no binary chunk for it");
    bytes = *mContainer.binary;
  }
  if (length > bytes.size()) about["byteLength"].complain("is {}, but there are only {} bytes", length, bytes.size());
  return bytes.substr(0, length);
}

Document::View Document::view(int index) {
  const Value about = root()["bufferViews"][size_t(index)];
  const std::string_view bytes = buffer(about.at("buffer").index(countOf("buffers")));
  const size_t offset = about["byteOffset"].count(0), length = about.at("byteLength").count(0);
  if (offset > bytes.size() || length > bytes.size() - offset) {
    about.complain("bytes {} + {} are not within its buffer of {}", offset, length, bytes.size());
  }
  return {bytes.substr(offset, length), about["byteStride"].count(0)};
}

}  // namespace rc::tool::gltf
