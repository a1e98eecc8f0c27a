// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/fiber_equations.h>

#include <algorithm>
#include <cmath>
#include <limits>

// FiberEquations, continued: norms and scales of forces and displacements.

namespace Setae
{
  using namespace dealii;

  double
  FiberEquations::force_norm(Vector forces) const
  {
    supports.project_force(forces);
    double sum = 0.;
    for (unsigned int i = 0; i < units.size(); ++i)
      {
        const double force = forces.begin()[i] / units[i];
        sum += force * force;
      }
    return std::sqrt(Utilities::MPI::sum(sum, communicator));
  }



  double
  FiberEquations::increment_norm(const Vector &increment) const
  {
    double sum = 0.;
    for (unsigned int i = 0; i < units.size(); ++i)
      {
        const double displacement = increment.begin()[i] * units[i];
        sum += displacement * displacement;
      }
    return std::sqrt(Utilities::MPI::sum(sum, communicator));
  }



  double
  FiberEquations::length_scale() const
  {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Fiber &fiber : fibers.fibers)
      smallest =
        std::min(smallest, fibers.parameters_of_cell(fiber.first_cell).radius);
    return smallest;
  }



  double
  FiberEquations::largest_stiffness() const
  {
    const Epetra_CrsMatrix &matrix  = system.tangent_matrix.trilinos_matrix();
    double                  largest = 0.;
    for (int row = 0; row < matrix.NumMyRows(); ++row)
      {
        int     n;
        double *values;
        int    *columns;
        matrix.ExtractMyRowView(row, n, values, columns);
        double sum = 0.;
        for (int k = 0; k < n; ++k)
          sum += std::abs(values[k]) * inverse_column_units[columns[k]];
        largest = std::max(largest, sum / units[row]);
      }
    return Utilities::MPI::max(largest, communicator);
  }



  double
  FiberEquations::largest_displacement(const Vector &increment) const
  {
    double largest = 0.;
    for (const unsigned int cell : fibers.owned_cells)
      for (const unsigned int shape : {0u, 2u})
        for (unsigned int c = 0; c < 3; ++c)
          {
            const auto dof = fibers.cell_dofs[cell][3 * shape + c];
            if (fibers.owned_dofs.is_element(dof))
              largest = std::max(largest, std::abs(increment(dof)));
          }
    return Utilities::MPI::max(largest, communicator);
  }
} // namespace Setae
