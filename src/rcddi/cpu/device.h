// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The cpu device: tiles of the screen on all threads.
#pragma once

#include "rchal/device.h"

namespace rc::ddi::cpu {

std::unique_ptr<hal::Device> createDevice(const Workers &workers);

}  // namespace rc::ddi::cpu
