// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// registry.cpp: devices by name. A new device is a folder beside this file and a row here; its name also
// goes into base/settings.cpp.
#include "rcddi/cpu/device.h"
#include "rcddi/null/device.h"
#include "rcddi/ref/device.h"

namespace rc::hal {
namespace {

struct Row {
  std::string_view name;
  std::unique_ptr<Device> (*create)(const Workers &workers);
};

constexpr Row kDevices[] = {
    {"cpu", ddi::cpu::createDevice}, {"ref", ddi::ref::createDevice}, {"null", ddi::null::createDevice}};

}  // namespace

std::unique_ptr<Device> createDevice(std::string_view name, const Workers &workers) {
  for (const Row &row : kDevices) {
    if (row.name == name) return row.create(workers);
  }
  return nullptr;
}

}  // namespace rc::hal
