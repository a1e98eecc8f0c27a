// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_output_vtu_h
#define setae_output_vtu_h

#include <string>
#include <utility>
#include <vector>

namespace Setae
{
  /**
   * Points in space with fields, as an unstructured grid of VTK
   * (https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html) in
   * double precision: the library's own writer has single precision, in which
   * fibers far from the origin collapse, and no grid without points.
   */
  struct PointFields
  {
    /** Name and number of components of each field. */
    std::vector<std::pair<std::string, unsigned int>> fields;

    /**
     * As many consecutive points make a chain of lines; a single one is a point
     * by itself.
     */
    unsigned int n_points_of_chain = 1;

    /** Point by point: the position, then the components of all fields. */
    std::vector<double> values;

    /** The number of values of a point. */
    unsigned int
    n_values_of_point() const;
  };



  /** The contents of a .vtu file; @p comment says who has written it. */
  std::string
  vtu(const PointFields &points, const std::string &comment);

  /** The contents of a .pvd file: the files of a series in time. */
  std::string
  pvd(const std::vector<std::pair<double, std::string>> &files,
      const std::string                                 &comment);
} // namespace Setae

#endif
