// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "view/switches.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace rc::tool {
namespace {

constexpr int kMostBounces = 14;

struct Filter {
  const char *name;
  TextureFilter filter;
  RCenum mipmaps;  // RC_NICEST: none, the base level is read
};

constexpr Filter kFilters[] = {{"anisotropic", {}, RC_DONT_CARE},
                               {"trilinear", {RC_LINEAR_MIPMAP_LINEAR, 1}, RC_DONT_CARE},
                               {"bilinear", {RC_LINEAR_MIPMAP_NEAREST, 1}, RC_DONT_CARE},
                               {"base level alone", {RC_LINEAR, 1}, RC_NICEST}};

struct Structure {
  const char *name;
  RCenum kind;
};

constexpr Structure kStructures[] = {{"BVH", RC_STRUCTURE_BVH}, {"KD-tree", RC_STRUCTURE_KD_TREE}};

}  // namespace

void Switches::changeBounces(int by) { mBounces = std::clamp(mBounces + by, 0, kMostBounces); }

void Switches::nextFilter() { mFilter = (mFilter + 1) % std::size(kFilters); }

void Switches::nextStructure() { mStructure = (mStructure + 1) % std::size(kStructures); }

void Switches::apply(Show &show) const {
  rcDepthBounce(RCuint(mBounces));
  (mShadows ? rcEnable : rcDisable)(RC_USE_SHADOW);
  show.setFilter(kFilters[mFilter].filter);
  rcHint(RC_MIPMAP_HINT, kFilters[mFilter].mipmaps);
  RCint structure = 0;
  rcGetIntegerv(RC_STRUCTURE_HINT, &structure);
  if (RCenum(structure) != kStructures[mStructure].kind) {
    rcHint(RC_STRUCTURE_HINT, kStructures[mStructure].kind);
    show.touch();
  }
  checkErrors("changing how it is traced");
}

std::string Switches::text() const {
  return fmt::format("{} bounce{}, shadows {}, {}, {}", mBounces, mBounces == 1 ? "" : "s", mShadows ? "on" : "off",
                     kFilters[mFilter].name, kStructures[mStructure].name);
}

}  // namespace rc::tool
