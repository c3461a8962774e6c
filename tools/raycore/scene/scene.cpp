// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "scene/scene.h"

#include <algorithm>

namespace rc::tool {

float Animation::duration() const {
  float end = 0;
  for (const Channel &channel : channels) {
    if (!channel.times.empty()) end = std::max(end, channel.times.back());
  }
  return end;
}

void Scene::note(const std::string &text) {
  if (std::find(notes.begin(), notes.end(), text) == notes.end()) notes.push_back(text);
}

}  // namespace rc::tool
