// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "gltf/container.h"

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

namespace rc::tool::gltf {
namespace {

constexpr uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr size_t kHeader = 12, kChunkHeader = 8;

uint32_t wordAt(std::string_view bytes, size_t offset) {
  uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof word);
  return word;
}

std::shared_ptr<const Json> parse(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  try {
    auto json = std::make_shared<const Json>(Json::parse(text));
    if (!json->is_object()) reject("JSON: is not an object");
    return json;
  } catch (const Json::parse_error &error) {
    const size_t at = std::min(error.byte, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n');
    reject("JSON: line {}, byte {}: not valid", line, error.byte);
  } catch (const Json::out_of_range &) {
    reject("JSON: a number is larger than any that can be read");
  }
}

// One chunk at offset, which moves behind it.
std::pair<uint32_t, std::string_view> nextChunk(std::string_view bytes, size_t &offset) {
  if (bytes.size() < offset + kChunkHeader) reject("byte {}: the file ends within a chunk's header", offset);
  const size_t length = wordAt(bytes, offset);
  const uint32_t type = wordAt(bytes, offset + 4);
  offset += kChunkHeader;
  if (length > bytes.size() - offset) {
    reject("byte {}: a chunk of {} bytes, but only {} are left", offset - kChunkHeader, length, bytes.size() - offset);
  }
  const std::string_view data = bytes.substr(offset, length);
  offset += length;
  return {type, data};
}

Container openBinary(std::string_view bytes) {
  if (bytes.size() < kHeader + kChunkHeader) reject("byte {}: the file ends within its header", bytes.size());
  const uint32_t version = wordAt(bytes, 4), length = wordAt(bytes, 8);
  if (version != 2) reject("byte 4: the container's version is {}, not 2", version);
  if (length > bytes.size()) reject("byte 8: the header says {} bytes, the file has {}", length, bytes.size());
  bytes = bytes.substr(0, length);
  size_t offset = kHeader;
  const auto [type, json] = nextChunk(bytes, offset);
  if (type != kJsonChunk) reject("byte {}: the first chunk is not JSON", kHeader);
  Container container{parse(json), std::nullopt};
  while (offset + kChunkHeader <= bytes.size() && !container.binary) {
    const auto [kind, data] = nextChunk(bytes, offset);
    if (kind == kBinaryChunk) container.binary = data;
  }
  return container;
}

}  // namespace

bool isBinary(std::string_view bytes) { return bytes.size() >= 4 && wordAt(bytes, 0) == kMagic; }

Container open(std::string_view bytes) {
  if (bytes.empty()) reject("is empty");
  return isBinary(bytes) ? openBinary(bytes) : Container{parse(bytes), std::nullopt};
}

}  // namespace rc::tool::gltf
