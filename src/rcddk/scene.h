// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// scene.h: the static scene and the frame's dynamic geometry, and how long each lives. [spec 3.7; G 9]
#pragma once

#include "rcddk/geometry.h"

namespace rc::ddk {

class Scene {
 public:
  const GeometrySet &statics() const { return mStatics; }
  const GeometrySet &dynamics() const { return mDynamics; }
  bool inStaticScene() const { return mInStaticScene; }
  // Of the structure of the static scene.
  double staticBuildMilliseconds() const { return mStaticBuildMilliseconds; }

  // Drops everything. [rcSceneAllInit]
  void clear();

  // The new static scene replaces the old one at once.
  void beginStatic();
  // Builds the structure.
  void endStatic(AccelKind kind, const Workers &workers);
  // A begin whose end is missing: there is no static scene.
  void abandonStatic();

  // Where a draw call's triangles go. The first ones after a traced frame begin the next frame.
  GeometrySet &target();

  // Builds the structure of what is dynamic; called once everything of the frame is there.
  void buildDynamic(AccelKind kind, const Workers &workers);
  // Dynamic geometry lives for one frame: after the picture is shown it is gone. True if there was some.
  bool endFrame();

 private:
  GeometrySet mStatics, mDynamics;
  double mStaticBuildMilliseconds = 0;
  bool mInStaticScene = false;
  bool mDynamicsTraced = false;  // they belong to a picture that is done
};

}  // namespace rc::ddk
