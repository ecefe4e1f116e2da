// Copyright (c) 2026  The Boundary_recovery_3 authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Boundary_recovery_3 authors
//
// Place holder: in CGAL this file is generated from license/gpl_package_list.txt.

#ifndef CGAL_LICENSE_BOUNDARY_RECOVERY_3_H
#define CGAL_LICENSE_BOUNDARY_RECOVERY_3_H

#include <CGAL/config.h>

#endif // CGAL_LICENSE_BOUNDARY_RECOVERY_3_H
