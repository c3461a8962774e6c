// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// name_table.h: objects by name; a new name is the lowest free one. [reference 3.3]
#pragma once

#include <map>
#include <memory>

#include "RC/rctypes.h"

namespace rc::api {

template <class Object>
class NameTable {
 public:
  // Makes an object under the lowest free name from 1 on.
  RCuint generate() {
    while (mObjects.contains(mLowestFree)) ++mLowestFree;
    mObjects.emplace(mLowestFree, std::make_shared<Object>());
    return mLowestFree;
  }

  // The object of a name, made if the name is not in use.
  const std::shared_ptr<Object> &bind(RCuint name) {
    const auto found = mObjects.find(name);
    if (found != mObjects.end()) return found->second;
    return mObjects.emplace(name, std::make_shared<Object>()).first->second;
  }

  // Null for names that are not in use.
  std::shared_ptr<Object> find(RCuint name) const {
    const auto found = mObjects.find(name);
    return found == mObjects.end() ? nullptr : found->second;
  }

  void remove(RCuint name) {
    if (name == 0 || mObjects.erase(name) == 0) return;
    if (name < mLowestFree) mLowestFree = name;
  }

  // Calls visit(object) for each, by name.
  template <class Visit>
  void forEach(Visit &&visit) const {
    for (const auto &[name, object] : mObjects) visit(*object);
  }

  bool contains(RCuint name) const { return name == 0 || mObjects.contains(name); }

 private:
  std::map<RCuint, std::shared_ptr<Object>> mObjects;
  RCuint mLowestFree = 1;  // no name below is free
};

}  // namespace rc::api
