// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// parts.h: the parts of a glTF file, in the order in which read.cpp reads them. Each appends to document.scene.
#pragma once

#include "gltf/document.h"

namespace rc::tool::gltf {

void readTextures(Document &document);  // and images
void readMaterials(Document &document);
void readMeshes(Document &document);
void readCameras(Document &document);
void readLights(Document &document);
void readNodes(Document &document);  // and the scene's order
void readSkins(Document &document);
void readAnimations(Document &document);

// Reads the whole. folder: where files beside it are.
Scene readGltf(std::string_view bytes, const std::string &folder);

}  // namespace rc::tool::gltf
