// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// resample.h: pictures in the sizes the device takes: powers of two from 16 on.
#pragma once

#include "scene/scene.h"

namespace rc::tool {

bool isDeviceSize(int side);
// The next device size up, at most 8192.
int deviceSize(int side);
// Box filter where it shrinks, bilinear where it grows.
Image resampled(const Image &image, int width, int height);
Image forDevice(const Image &image);

}  // namespace rc::tool
