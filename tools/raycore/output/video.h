// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// video.h: numbered pictures -> a film, by the system's ffmpeg.
#pragma once

#include <string>

#include "output/sequence.h"

namespace rc::tool {

// Throws InputError: it is not installed.
void checkFfmpeg();

// Where the pictures of a film wait until it is made; a film that was interrupted goes on from there.
std::string framesFolder(const std::string &video);

// frames: a pattern with %06d. Written beside the name and renamed. Throws InputError.
void makeVideo(const std::string &frames, const FrameRange &range, double fps, const std::string &video);

}  // namespace rc::tool
