/* SPDX-License-Identifier: Apache-2.0
 * SPDX-FileCopyrightText: The raycore authors
 *
 * rc1.h: the name under which old sources include the API; it forwards to RC/rc.h and RC/rcu.h.
 */
#ifndef RC1_RC1_H
#define RC1_RC1_H

#include <RC/rc.h>
#include <RC/rcu.h>

#endif /* RC1_RC1_H */
