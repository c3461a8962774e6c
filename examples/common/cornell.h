// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// cornell.h: the box of the Cornell University Program of Computer Graphics, as published, in units of 10 mm.
// Each quadrilateral is two triangles; x runs to the left, y up, z away from the viewer.
#pragma once

#define CORNELL_QUAD(a, b, c, d) a, b, c, a, c, d
#define CORNELL_P(x, y, z) x, y, z

static const float kFloor[] = {
    CORNELL_QUAD(CORNELL_P(55.28f, 0, 0), CORNELL_P(0, 0, 0), CORNELL_P(0, 0, 55.92f), CORNELL_P(54.96f, 0, 55.92f))};
static const float kCeiling[] = {CORNELL_QUAD(CORNELL_P(55.6f, 54.88f, 0), CORNELL_P(55.6f, 54.88f, 55.92f),
                                              CORNELL_P(0, 54.88f, 55.92f), CORNELL_P(0, 54.88f, 0))};
static const float kBackWall[] = {CORNELL_QUAD(CORNELL_P(54.96f, 0, 55.92f), CORNELL_P(0, 0, 55.92f),
                                               CORNELL_P(0, 54.88f, 55.92f), CORNELL_P(55.6f, 54.88f, 55.92f))};
static const float kRightWall[] = {
    CORNELL_QUAD(CORNELL_P(0, 0, 55.92f), CORNELL_P(0, 0, 0), CORNELL_P(0, 54.88f, 0), CORNELL_P(0, 54.88f, 55.92f))};
static const float kLeftWall[] = {CORNELL_QUAD(CORNELL_P(55.28f, 0, 0), CORNELL_P(54.96f, 0, 55.92f),
                                               CORNELL_P(55.6f, 54.88f, 55.92f), CORNELL_P(55.6f, 54.88f, 0))};

// Five faces: the box stands on the floor.
#define CORNELL_BOX(h, ax, az, bx, bz, cx, cz, dx, dz)                                                      \
  CORNELL_QUAD(CORNELL_P(ax, h, az), CORNELL_P(bx, h, bz), CORNELL_P(cx, h, cz), CORNELL_P(dx, h, dz)),     \
      CORNELL_QUAD(CORNELL_P(dx, 0, dz), CORNELL_P(dx, h, dz), CORNELL_P(cx, h, cz), CORNELL_P(cx, 0, cz)), \
      CORNELL_QUAD(CORNELL_P(ax, 0, az), CORNELL_P(ax, h, az), CORNELL_P(dx, h, dz), CORNELL_P(dx, 0, dz)), \
      CORNELL_QUAD(CORNELL_P(bx, 0, bz), CORNELL_P(bx, h, bz), CORNELL_P(ax, h, az), CORNELL_P(ax, 0, az)), \
      CORNELL_QUAD(CORNELL_P(cx, 0, cz), CORNELL_P(cx, h, cz), CORNELL_P(bx, h, bz), CORNELL_P(bx, 0, bz))

static const float kShortBlock[] = {CORNELL_BOX(16.5f, 13.0f, 6.5f, 8.2f, 22.5f, 24.0f, 27.2f, 29.0f, 11.4f)};
static const float kTallBlock[] = {CORNELL_BOX(33.0f, 42.3f, 24.7f, 26.5f, 29.6f, 31.4f, 45.6f, 47.2f, 40.6f)};
