// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// eglChooseConfig's rules: which configs satisfy a list, and which of them come first. [EGL 1.5, 3.4.1.1, 3.4.1.2]
#include <algorithm>
#include <map>
#include <tuple>

#include "egl/config.h"

namespace rc::egl {
namespace {

// What a list asks for: the initial value of each attribute, or what the list says last.
struct Wishes {
  std::map<EGLint, EGLint> values;
  bool pixmaps = true;  // the pixmap to be drawn to, if one is named, is a possible one
};

std::optional<Wishes> readWishes(Attributes list, const PixmapCheck &pixmapWorks) {
  Wishes wishes;
  for (const ConfigAttribute &row : configAttributes()) wishes.values[row.name] = row.initial;
  for (; list.more(); list.advance()) {
    if (list.name() == EGL_MATCH_NATIVE_PIXMAP) {
      if (list.number() == EGL_NONE || list.number() == EGL_DONT_CARE) continue;
      const std::optional<bool> works = pixmapWorks(static_cast<EGLNativePixmapType>(list.value()));
      if (!works) return std::nullopt;
      wishes.pixmaps = *works;
      continue;
    }
    const ConfigAttribute *row = findConfigAttribute(list.name());
    if (!row) return std::nullopt;
    const EGLint value = list.number();
    // Levels are always compared. [EGL 1.5, 3.4.1.1]
    if (value == EGL_DONT_CARE ? row->name == EGL_LEVEL : !row->valid(value)) return std::nullopt;
    wishes.values[row->name] = value;
  }
  return wishes;
}

bool satisfies(Match match, EGLint offered, EGLint wanted) {
  if (wanted == EGL_DONT_CARE) return true;
  switch (match) {
    case Match::AtLeast:
      return offered >= wanted;
    case Match::Exact:
      return offered == wanted;
    case Match::Mask:
      return (offered & wanted) == wanted;
    case Match::Ignored:
      break;
  }
  return true;
}

bool satisfies(const Config &config, const Wishes &wishes, const NativeTraits &native) {
  const EGLint id = wishes.values.at(EGL_CONFIG_ID);
  if (id != EGL_DONT_CARE) return config.id == id;  // nothing else counts
  return wishes.pixmaps && std::ranges::all_of(configAttributes(), [&](const ConfigAttribute &row) {
           return satisfies(row.match, row.value(config, native), wishes.values.at(row.name));
         });
}

// Of the colours that the list asks for; more is better.
EGLint wantedColourBits(const Config &config, const Wishes &wishes) {
  const std::pair<EGLint, EGLint> channels[] = {{EGL_RED_SIZE, config.red},
                                                {EGL_GREEN_SIZE, config.green},
                                                {EGL_BLUE_SIZE, config.blue},
                                                {EGL_ALPHA_SIZE, config.alpha}};
  EGLint bits = 0;
  for (const auto &[name, size] : channels) {
    const EGLint wanted = wishes.values.at(name);
    if (wanted != 0 && wanted != EGL_DONT_CARE) bits += size;
  }
  return bits;
}

// The rules in their order, less those in which all configs are alike.
auto rank(const Config &config, const Wishes &wishes) {
  return std::tuple(-wantedColourBits(config, wishes), config.bufferSize(), config.samples, config.depth, config.id);
}

}  // namespace

std::optional<std::vector<const Config *>> chooseConfigs(Attributes list, const NativeTraits &native,
                                                         const PixmapCheck &pixmapWorks) {
  const std::optional<Wishes> wishes = readWishes(list, pixmapWorks);
  if (!wishes) return std::nullopt;
  std::vector<const Config *> chosen;
  for (const Config &config : configs()) {
    if (satisfies(config, *wishes, native)) chosen.push_back(&config);
  }
  std::ranges::sort(chosen, {}, [&](const Config *config) { return rank(*config, *wishes); });
  return chosen;
}

}  // namespace rc::egl
