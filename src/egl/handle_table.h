// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// handle_table.h: the objects of a display by handle. A handle is a number that is given once: one that is none, or no
// longer one, is an error and never another object. [EGL 1.5, 2.1]
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <map>
#include <memory>

namespace rc::egl {

// What has a handle. What is current on a thread keeps it until it no longer is, destroyed or not.
struct Handled {
  void *handle = nullptr;
  bool current = false;
  bool destroyed = false;
};

// Never the same twice, whatever the object.
inline void *newHandle() {
  static constinit std::atomic<uintptr_t> last = 0;
  return reinterpret_cast<void *>(++last);
}

// Objects in use outlive their removal: whoever uses one shares it.
template <class Object>
class HandleTable {
 public:
  void *add(std::shared_ptr<Object> object) {
    object->handle = newHandle();
    return mObjects.emplace(object->handle, object).first->first;
  }
  std::shared_ptr<Object> find(void *handle) const {
    const auto found = mObjects.find(handle);
    return found == mObjects.end() ? nullptr : found->second;
  }
  void destroy(Object &object) {
    object.destroyed = true;
    release(object);
  }
  // To be called when an object is no longer current.
  void release(Object &object) {
    if (object.destroyed && !object.current) mObjects.erase(object.handle);
  }
  void clear() { mObjects.clear(); }
  size_t size() const { return mObjects.size(); }
  // Whether one that is not destroyed satisfies a condition.
  template <class Condition>
  bool any(Condition &&condition) const {
    return std::any_of(mObjects.begin(), mObjects.end(),
                       [&](const auto &entry) { return !entry.second->destroyed && condition(*entry.second); });
  }

 private:
  std::map<void *, std::shared_ptr<Object>> mObjects;
};

}  // namespace rc::egl
