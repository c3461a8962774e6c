/* SPDX-License-Identifier: Apache-2.0
 * SPDX-FileCopyrightText: The raycore authors
 *
 * rces11.h: the functions of OpenGL ES 1.1 that the vendor's API does not have, so that a program written for
 * OpenGL ES 1.1 finds each of them. rc.h includes it. [OpenGL ES 1.1; beyond the guide: RC_RCX_es11_functions]
 *
 * What has a meaning for rays acts. The rest is checked, kept and returned by the gets, and no picture depends on it.
 * Initial values are those of OpenGL ES 1.1 where nothing else is said. Errors are abbreviated as in rc.h.
 */
#ifndef RC_RCES11_H
#define RC_RCES11_H

#include <RC/rctokens.h>
#include <RC/rctypes.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Camera --------------------------------------------------------------------------------- */

/* Parallel rays through the window left ... right, bottom ... top, world units from the eye. They start at distance
 * zNear, which may lie behind the eye; zFar is not used. Replaces rcFrustum. IV: a side of the box is empty. */
RC_APICALL void RC_APIENTRY rcOrtho(RCdouble left, RCdouble right, RCdouble bottom, RCdouble top, RCdouble zNear,
                                    RCdouble zFar);
RC_APICALL void RC_APIENTRY rcOrthof(RCfloat left, RCfloat right, RCfloat bottom, RCfloat top, RCfloat zNear,
                                     RCfloat zFar);
RC_APICALL void RC_APIENTRY rcOrthox(RCfixed left, RCfixed right, RCfixed bottom, RCfixed top, RCfixed zNear,
                                     RCfixed zFar);
/* Plane RC_CLIP_PLANE0 ... 5: geometry drawn while it is enabled is cut off where a x + b y + c z + d < 0. The
 * modelview matrix of this call takes the plane to the world. Initially (0, 0, 0, 0). IE: plane. */
RC_APICALL void RC_APIENTRY rcClipPlanef(RCenum plane, const RCfloat *equation);
RC_APICALL void RC_APIENTRY rcClipPlanex(RCenum plane, const RCfixed *equation);
/* The plane in world space. IE: plane. */
RC_APICALL void RC_APIENTRY rcGetClipPlanef(RCenum plane, RCfloat eqn[4]);
RC_APICALL void RC_APIENTRY rcGetClipPlanex(RCenum plane, RCfixed eqn[4]);

/* ---- Surfaces: captured by each draw call ----------------------------------------------------- */

/* While RC_CULL_FACE is on, rays do not see the sides RC_FRONT, RC_BACK (initially) or RC_FRONT_AND_BACK. IE. */
RC_APICALL void RC_APIENTRY rcCullFace(RCenum mode);
/* Winding of the front: RC_CCW (initially) or RC_CW. Refraction enters at the front. IE. */
RC_APICALL void RC_APIENTRY rcFrontFace(RCenum mode);
/* While RC_ALPHA_TEST is on, points whose opacity (0 ... 1, in steps of 1/255) does not compare with ref as func
 * says, RC_NEVER ... RC_ALWAYS (initially), are not there for any ray. IE: func. */
RC_APICALL void RC_APIENTRY rcAlphaFunc(RCenum func, RCclampf ref);
RC_APICALL void RC_APIENTRY rcAlphaFuncx(RCenum func, RCclampx ref);
/* RC_FLAT: normal and colour of a primitive's last vertex count for all of it; RC_SMOOTH (initially). IE. */
RC_APICALL void RC_APIENTRY rcShadeModel(RCenum mode);
/* Texture coordinates of vertices without an array, initially (0, 0, 0, 1). target RC_TEXTURE0. IE. */
RC_APICALL void RC_APIENTRY rcMultiTexCoord4f(RCenum target, RCfloat s, RCfloat t, RCfloat r, RCfloat q);
RC_APICALL void RC_APIENTRY rcMultiTexCoord4x(RCenum target, RCfixed s, RCfixed t, RCfixed r, RCfixed q);
/* Kept, RC_CURRENT_NORMAL: vertices without an array have the flat normal of their triangle. */
RC_APICALL void RC_APIENTRY rcNormal3f(RCfloat nx, RCfloat ny, RCfloat nz);
RC_APICALL void RC_APIENTRY rcNormal3x(RCfixed nx, RCfixed ny, RCfixed nz);

/* ---- Light and fog ---------------------------------------------------------------------------- */

/* RC_LIGHT_MODEL_AMBIENT: light without a source while RC_LIGHTING is on; unlike in GL it starts at (0, 0, 0, 1).
 * RC_LIGHT_MODEL_TWO_SIDE is kept: surfaces always have two sides. IE: pname. */
RC_APICALL void RC_APIENTRY rcLightModelf(RCenum pname, RCfloat param);
RC_APICALL void RC_APIENTRY rcLightModelx(RCenum pname, RCfixed param);
RC_APICALL void RC_APIENTRY rcLightModelfv(RCenum pname, const RCfloat *params);
RC_APICALL void RC_APIENTRY rcLightModelxv(RCenum pname, const RCfixed *params);
/* While RC_FOG is on, surfaces fade to RC_FOG_COLOR by the length of the ray's way from the eye, mirrors included:
 * RC_FOG_MODE RC_EXP (initially), RC_EXP2 with RC_FOG_DENSITY, or RC_LINEAR from RC_FOG_START to RC_FOG_END, world
 * units. The background keeps the clear colour. IE: pname, mode; IV: density < 0. */
RC_APICALL void RC_APIENTRY rcFogf(RCenum pname, RCfloat param);
RC_APICALL void RC_APIENTRY rcFogx(RCenum pname, RCfixed param);
RC_APICALL void RC_APIENTRY rcFogfv(RCenum pname, const RCfloat *params);
RC_APICALL void RC_APIENTRY rcFogxv(RCenum pname, const RCfixed *params);

/* ---- Textures --------------------------------------------------------------------------------- */

/* RC_TEXTURE0, the only unit. IE. */
RC_APICALL void RC_APIENTRY rcActiveTexture(RCenum texture);
RC_APICALL void RC_APIENTRY rcClientActiveTexture(RCenum texture);
/* target RC_TEXTURE_ENV. RC_TEXTURE_ENV_MODE: what a texel makes of ambient and diffuse of the bound material:
 * RC_REPLACE (initially, unlike in GL), RC_MODULATE, RC_DECAL, RC_BLEND with RC_TEXTURE_ENV_COLOR, RC_ADD; RC_COMBINE
 * is traced as RC_MODULATE. The combiner's parameters, and RC_COORD_REPLACE_OES of RC_POINT_SPRITE_OES, are kept.
 * Mode and colour belong to the bound material. IE: target, pname, token; IV: a scale that is not 1, 2 or 4. */
RC_APICALL void RC_APIENTRY rcTexEnvf(RCenum target, RCenum pname, RCfloat param);
RC_APICALL void RC_APIENTRY rcTexEnvi(RCenum target, RCenum pname, RCint param);
RC_APICALL void RC_APIENTRY rcTexEnvx(RCenum target, RCenum pname, RCfixed param);
RC_APICALL void RC_APIENTRY rcTexEnvfv(RCenum target, RCenum pname, const RCfloat *params);
RC_APICALL void RC_APIENTRY rcTexEnviv(RCenum target, RCenum pname, const RCint *params);
RC_APICALL void RC_APIENTRY rcTexEnvxv(RCenum target, RCenum pname, const RCfixed *params);
RC_APICALL void RC_APIENTRY rcGetTexEnvfv(RCenum env, RCenum pname, RCfloat *params);
RC_APICALL void RC_APIENTRY rcGetTexEnviv(RCenum env, RCenum pname, RCint *params);
RC_APICALL void RC_APIENTRY rcGetTexEnvxv(RCenum env, RCenum pname, RCfixed *params);
/* Replaces a rectangle of the current texture, and its mip levels. format is that of rcTexImage2D.
 * IE: target, format, type; IV: level, rectangle; IO: no image yet, other format. */
RC_APICALL void RC_APIENTRY rcTexSubImage2D(RCenum target, RCint level, RCint xoffset, RCint yoffset, RCsizei width,
                                            RCsizei height, RCenum format, RCenum type, const RCvoid *pixels);
/* Load from the picture, lower left corner (x, y); a frame that is not traced yet is traced. Beside the picture:
 * transparent black. Errors as those of rcTexImage2D and rcTexSubImage2D; IO: no surface. */
RC_APICALL void RC_APIENTRY rcCopyTexImage2D(RCenum target, RCint level, RCenum internalformat, RCint x, RCint y,
                                             RCsizei width, RCsizei height, RCint border);
RC_APICALL void RC_APIENTRY rcCopyTexSubImage2D(RCenum target, RCint level, RCint xoffset, RCint yoffset, RCint x,
                                                RCint y, RCsizei width, RCsizei height);
/* Loads paletted data, RC_PALETTE4_RGB8_OES ... RC_PALETTE8_RGB5_A1_OES. level: 0, or minus the number of mip levels
 * that follow the first, which are made anew. IE: target, format; IV: level, border, size, imageSize; OOM. */
RC_APICALL void RC_APIENTRY rcCompressedTexImage2D(RCenum target, RCint level, RCenum internalformat, RCsizei width,
                                                   RCsizei height, RCint border, RCsizei imageSize, const RCvoid *data);
/* No format can be changed in part. IO; IE: target, format. */
RC_APICALL void RC_APIENTRY rcCompressedTexSubImage2D(RCenum target, RCint level, RCint xoffset, RCint yoffset,
                                                      RCsizei width, RCsizei height, RCenum format, RCsizei imageSize,
                                                      const RCvoid *data);

/* ---- Picture ---------------------------------------------------------------------------------- */

/* While RC_SCISSOR_TEST is on, only this rectangle of the picture is traced and written. Pixels from the lower left;
 * initially the first surface. IV: width or height < 0. */
RC_APICALL void RC_APIENTRY rcScissor(RCint x, RCint y, RCsizei width, RCsizei height);
/* Channels of the picture that are written; initially all. */
RC_APICALL void RC_APIENTRY rcColorMask(RCboolean red, RCboolean green, RCboolean blue, RCboolean alpha);
/* RC_UNPACK_ALIGNMENT (initially 1, unlike in GL), RC_PACK_ALIGNMENT (4): rows of images in memory begin at multiples
 * of 1, 2, 4 or 8 bytes. IE: pname; IV: param. */
RC_APICALL void RC_APIENTRY rcPixelStorei(RCenum pname, RCint param);
/* Reads the picture, the lowest row first; a frame that is not traced yet is traced. format RC_RGBA or RC_RGB, type
 * RC_UNSIGNED_BYTE. What lies beside the picture is left alone. IE: format, type; IV: size < 0; IO: another type, no
 * surface. */
RC_APICALL void RC_APIENTRY rcReadPixels(RCint x, RCint y, RCsizei width, RCsizei height, RCenum format, RCenum type,
                                         RCvoid *pixels);

/* ---- Kept without effect: blending, depth, stencil, points and lines --------------------------- */

/* Factors of blending, initially RC_ONE, RC_ZERO. IE. */
RC_APICALL void RC_APIENTRY rcBlendFunc(RCenum sfactor, RCenum dfactor);
/* RC_CLEAR ... RC_SET, initially RC_COPY. IE. */
RC_APICALL void RC_APIENTRY rcLogicOp(RCenum opcode);
/* RC_NEVER ... RC_ALWAYS, initially RC_LESS. IE. */
RC_APICALL void RC_APIENTRY rcDepthFunc(RCenum func);
RC_APICALL void RC_APIENTRY rcDepthMask(RCboolean flag);
/* Clamped to 0 ... 1; initially 0, 1 and 1. */
RC_APICALL void RC_APIENTRY rcDepthRangef(RCclampf zNear, RCclampf zFar);
RC_APICALL void RC_APIENTRY rcDepthRangex(RCclampx zNear, RCclampx zFar);
RC_APICALL void RC_APIENTRY rcClearDepthf(RCclampf depth);
RC_APICALL void RC_APIENTRY rcClearDepthx(RCclampx depth);
/* RC_NEVER ... RC_ALWAYS (initially), 0, all bits. IE: func. */
RC_APICALL void RC_APIENTRY rcStencilFunc(RCenum func, RCint ref, RCuint mask);
RC_APICALL void RC_APIENTRY rcStencilMask(RCuint mask);
/* RC_KEEP (initially), RC_ZERO, RC_REPLACE, RC_INCR, RC_DECR, RC_INVERT. IE. */
RC_APICALL void RC_APIENTRY rcStencilOp(RCenum fail, RCenum zfail, RCenum zpass);
RC_APICALL void RC_APIENTRY rcClearStencil(RCint s);
/* Pixels, initially 1. IV: not above 0. */
RC_APICALL void RC_APIENTRY rcLineWidth(RCfloat width);
RC_APICALL void RC_APIENTRY rcLineWidthx(RCfixed width);
RC_APICALL void RC_APIENTRY rcPointSize(RCfloat size);
RC_APICALL void RC_APIENTRY rcPointSizex(RCfixed size);
/* RC_POINT_SIZE_MIN, RC_POINT_SIZE_MAX, RC_POINT_FADE_THRESHOLD_SIZE; through v RC_POINT_DISTANCE_ATTENUATION (3).
 * IE: pname; IV: < 0. */
RC_APICALL void RC_APIENTRY rcPointParameterf(RCenum pname, RCfloat param);
RC_APICALL void RC_APIENTRY rcPointParameterx(RCenum pname, RCfixed param);
RC_APICALL void RC_APIENTRY rcPointParameterfv(RCenum pname, const RCfloat *params);
RC_APICALL void RC_APIENTRY rcPointParameterxv(RCenum pname, const RCfixed *params);
/* Sizes of points: type RC_FIXED or RC_FLOAT. IE: type; IV: stride < 0. */
RC_APICALL void RC_APIENTRY rcPointSizePointerOES(RCenum type, RCsizei stride, const RCvoid *pointer);
RC_APICALL void RC_APIENTRY rcPolygonOffset(RCfloat factor, RCfloat units);
RC_APICALL void RC_APIENTRY rcPolygonOffsetx(RCfixed factor, RCfixed units);
/* Clamped to 0 ... 1; initially 1, RC_FALSE. */
RC_APICALL void RC_APIENTRY rcSampleCoverage(RCclampf value, RCboolean invert);
RC_APICALL void RC_APIENTRY rcSampleCoveragex(RCclampx value, RCboolean invert);

#ifdef __cplusplus
}
#endif

#endif /* RC_RCES11_H */
