/* SPDX-License-Identifier: Apache-2.0
 * SPDX-FileCopyrightText: The raycore authors
 *
 * A library that has some of OpenGL ES 1.1, as a real one would.
 */
unsigned char glIsTexture(unsigned int texture);
unsigned char glIsTexture(unsigned int texture) { return texture == 7; }
