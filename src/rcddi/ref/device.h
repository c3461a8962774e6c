// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The ref device: the scalar oracle: one pixel after the other on one thread.
#pragma once

#include "rchal/device.h"

namespace rc::ddi::ref {

std::unique_ptr<hal::Device> createDevice(const Workers &workers);

}  // namespace rc::ddi::ref
