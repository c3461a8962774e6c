// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "scene/keyframes.h"

#include <algorithm>
#include <span>

namespace rc::tool {
namespace {

using Values = std::span<const float>;

// Part 0 ... 2 of a key: in-tangent, value, out-tangent; other interpolations have only values.
Values keyOf(const Channel &channel, size_t key, size_t part = 1) {
  const size_t width = size_t(channel.width);
  const size_t at = channel.interpolation == Interpolation::Cubic ? 3 * key + part : key;
  return Values(channel.values).subspan(at * width, width);
}

Quat quatOf(Values v) { return Quat(v[3], v[0], v[1], v[2]); }

std::vector<float> normalised(std::vector<float> v) {
  const Quat q = glm::normalize(quatOf(v));
  return {q.x, q.y, q.z, q.w};
}

std::vector<float> cubic(const Channel &channel, size_t key, float s, float span) {
  const Values from = keyOf(channel, key), out = keyOf(channel, key, 2);
  const Values to = keyOf(channel, key + 1), in = keyOf(channel, key + 1, 0);
  const float s2 = s * s, s3 = s2 * s;
  std::vector<float> result(from.size());
  for (size_t i = 0; i < result.size(); ++i) {
    result[i] = (2 * s3 - 3 * s2 + 1) * from[i] + span * (s3 - 2 * s2 + s) * out[i] + (3 * s2 - 2 * s3) * to[i] +
                span * (s3 - s2) * in[i];
  }
  return channel.path == Path::Rotation ? normalised(result) : result;
}

std::vector<float> linear(const Channel &channel, Values from, Values to, float s) {
  if (channel.path == Path::Rotation) {
    const Quat q = glm::slerp(quatOf(from), quatOf(to), s);
    return {q.x, q.y, q.z, q.w};
  }
  std::vector<float> result(from.size());
  for (size_t i = 0; i < result.size(); ++i) result[i] = glm::mix(from[i], to[i], s);
  return result;
}

}  // namespace

std::vector<float> sampleChannel(const Channel &channel, float seconds) {
  const std::vector<float> &times = channel.times;
  if (times.empty()) return {};
  const auto after = std::upper_bound(times.begin(), times.end(), seconds);
  const size_t next = size_t(after - times.begin());
  const auto copy = [](Values v) { return std::vector<float>(v.begin(), v.end()); };
  if (next == 0) return copy(keyOf(channel, 0));
  const size_t key = next - 1;
  if (next == times.size() || channel.interpolation == Interpolation::Step) return copy(keyOf(channel, key));
  const float span = times[next] - times[key];
  const float s = span > 0 ? (seconds - times[key]) / span : 0;
  if (channel.interpolation == Interpolation::Cubic) return cubic(channel, key, s, span);
  return linear(channel, keyOf(channel, key), keyOf(channel, next), s);
}

}  // namespace rc::tool
