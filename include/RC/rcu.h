/* SPDX-License-Identifier: Apache-2.0
 * SPDX-FileCopyrightText: The raycore authors
 *
 * rcu.h: the utility functions of the RayCore API. C99 and C++11. [G 2]
 */
#ifndef RC_RCU_H
#define RC_RCU_H

#include <RC/rc.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Puts the viewer at eye, looking at centre, in world space; no matrix changes. Initially
 * (0,0,0, 0,0,-1, 0,1,0). up is made perpendicular to the view.
 * RC_INVALID_VALUE: eye = centre, up = 0 or parallel to the view, or a value that is not finite. */
RC_APICALL void RC_APIENTRY rcuLookAt(RCfloat eyex, RCfloat eyey, RCfloat eyez, RCfloat centerx, RCfloat centery,
                                      RCfloat centerz, RCfloat upx, RCfloat upy, RCfloat upz);
/* Window of height 2 * zNear * tan(fovy / 2) and width aspect * height. fovy: degrees, vertical, in (0, 180);
 * aspect: width / height > 0. zNear and zFar clip nothing.
 * RC_INVALID_VALUE: fovy or aspect out of range, near or far <= 0, near = far. */
RC_APICALL void RC_APIENTRY rcuPerspective(RCfloat fovy, RCfloat aspect, RCfloat zNear, RCfloat zFar);

#ifdef __cplusplus
}
#endif

#endif /* RC_RCU_H */
