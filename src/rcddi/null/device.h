// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The null device: accepts everything and traces nothing.
#pragma once

#include "rchal/device.h"

namespace rc::ddi::null {

std::unique_ptr<hal::Device> createDevice(const Workers &workers);

}  // namespace rc::ddi::null
