// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/fibers/centerline.h>

#include <algorithm>
#include <limits>

namespace Setae
{
  HermiteCell<>
  Centerline::cell(const unsigned int i) const
  {
    const unsigned int next = (i + 1) % positions.size();
    return {{{positions[i], tangents[i], positions[next], tangents[next]}},
            (positions[next] - positions[i]).norm()};
  }



  double
  Centerline::shortest_cell() const
  {
    double result = std::numeric_limits<double>::infinity();
    for (unsigned int i = 0; i < n_cells(); ++i)
      result =
        std::min(result,
                 (positions[(i + 1) % positions.size()] - positions[i]).norm());
    return result;
  }



  double
  Centerline::tangent_tolerance() const
  {
    return 1e-9 + 20. * rounding / shortest_cell();
  }



  bool
  Centerline::is_straight() const
  {
    if (closed)
      return false;
    const Tensor<1, 3> chord   = positions.back() - positions.front();
    const double       length  = chord.norm();
    const double       largest = 4. * rounding + 1e-10 * length;
    if (length == 0.)
      return false;
    const Tensor<1, 3> direction = chord / length;
    double             before    = -1.;
    for (unsigned int i = 0; i < positions.size(); ++i)
      {
        const Tensor<1, 3> r     = positions[i] - positions.front();
        const double       along = r * direction;
        if ((r - along * direction).norm() > largest || along <= before ||
            (tangents[i] - direction).norm() > tangent_tolerance())
          return false;
        before = along;
      }
    return true;
  }



  double
  Centerline::straighten()
  {
    const Tensor<1, 3> start     = positions.front();
    const Tensor<1, 3> chord     = positions.back() - start;
    const Tensor<1, 3> direction = chord / chord.norm();
    double             moved     = 0.;
    for (unsigned int i = 0; i < positions.size(); ++i)
      {
        const Tensor<1, 3> place =
          start + ((positions[i] - start) * direction) * direction;
        moved        = std::max(moved, (place - positions[i]).norm());
        positions[i] = place;
        tangents[i]  = direction;
      }
    return moved;
  }



  std::vector<Centerline>
  make_centerlines(const FiberParameters    &parameters,
                   const Constants          &constants,
                   std::vector<std::string> &notices)
  {
    if (!parameters.mesh_file.empty())
      return centerlines_of_mesh(parameters, notices);

    std::vector<Centerline> lines;
    for (const Constants &copy : parameters.copy_indices())
      lines.push_back(centerline_of_formula(
        parameters.of_copy(constants, copy), constants, copy, notices));
    return lines;
  }



  std::vector<Centerline>
  make_centerlines(const FiberParameters &parameters,
                   const Constants       &constants)
  {
    std::vector<std::string> notices;
    return make_centerlines(parameters, constants, notices);
  }
} // namespace Setae
