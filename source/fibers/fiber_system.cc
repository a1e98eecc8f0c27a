// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/dofs/dof_tools.h>

#include <setae/base/exceptions.h>
#include <setae/beams/rigid.h>
#include <setae/fe/fe_hermite.h>
#include <setae/fibers/fiber_system.h>

#include <algorithm>
#include <sstream>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    double
    arc_length(const HermiteCell<> &cell)
    {
      static const QGauss<1> rule(8);
      double                 length = 0.;
      for (unsigned int q = 0; q < rule.size(); ++q)
        length += rule.weight(q) * cell.derivative(rule.point(q)[0]).norm();
      return length;
    }
  } // namespace



  FiberSystem::FiberSystem(const Scene &scene, MPI_Comm communicator)
    : scene(scene)
    , communicator(communicator)
    , triangulation(
        communicator,
        Triangulation<1, 3>::none,
        false,
        parallel::shared::Triangulation<1, 3>::partition_custom_signal)
    , fe(FE_Hermite<1, 3>(), scene.active_coordinates().size())
    , dof_handler(triangulation)
  {
    make_grid();
    distribute_dofs();
  }



  void
  FiberSystem::make_grid()
  {
    std::vector<Point<3>>    vertices;
    std::vector<CellData<1>> cells;
    for (unsigned int p = 0; p < scene.fibers.size(); ++p)
      {
        const FiberParameters        &section = scene.fibers[p];
        const std::vector<Centerline> lines =
          make_centerlines(section, scene.constants, notices);
        for (unsigned int l = 0; l < lines.size(); ++l)
          {
            const Centerline &line = lines[l];
            if (section.beam != Rigid::name)
              check_curvature(line,
                              "fibers/" + section.name +
                                (section.mesh_file.empty() ? "/centerline" :
                                                             "/mesh file"));
            parameters.push_back(section.of_copy(scene.constants, line.copy));
            check_distance(line, parameters.back());

            Fiber              fiber{p,
                        section.name +
                          (lines.size() > 1 ? " " + std::to_string(l) : ""),
                        line.copy,
                        static_cast<unsigned int>(initial.size()),
                        line.n_cells(),
                        line.closed,
                        {0.}};
            const unsigned int first_vertex = vertices.size();
            for (const Tensor<1, 3> &x : line.positions)
              vertices.emplace_back(x);
            for (unsigned int i = 0; i < line.n_cells(); ++i)
              {
                initial.push_back(line.cell(i));
                AssertThrow(initial.back().h > 0.,
                            ExcInput("The fiber '" + fiber.name +
                                     "' has a cell of length zero."));
                fiber.arc_length.push_back(fiber.arc_length.back() +
                                           arc_length(initial.back()));

                // Formulas of s need not be asked beyond the end by round-off.
                if (i + 1 < line.parameters.size() &&
                    std::abs(fiber.arc_length.back() - line.parameters[i + 1]) <
                      1e-12 * line.parameters.back())
                  fiber.arc_length.back() = line.parameters[i + 1];
                CellData<1> cell;
                cell.vertices[0] = first_vertex + i;
                cell.vertices[1] =
                  first_vertex + (i + 1) % line.positions.size();
                cell.material_id = 0;
                cells.push_back(cell);
                fiber_of_cell.push_back(fibers.size());
              }
            fibers.push_back(std::move(fiber));
          }
      }

    // Equal contiguous parts, so that few fibers are cut.
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    triangulation.signals.create.connect([this, n_ranks]() {
      for (const auto &cell : triangulation.active_cell_iterators())
        cell->set_subdomain_id(
          static_cast<unsigned long>(cell->active_cell_index()) * n_ranks /
          triangulation.n_active_cells());
    });
    triangulation.create_triangulation(vertices, cells, SubCellData());
  }



  void
  FiberSystem::distribute_dofs()
  {
    dof_handler.distribute_dofs(fe);
    owned_dofs = dof_handler.locally_owned_dofs();

    const std::vector<unsigned int> active = scene.active_coordinates();
    cell_dofs.resize(initial.size());
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        const unsigned int index = cell->active_cell_index();
        cell_dofs[index].fill(numbers::invalid_dof_index);
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const auto [component, shape] = fe.system_to_component_index(i);
            cell_dofs[index][3 * shape + active[component]] = dofs[i];
          }
        if (cell->is_locally_owned())
          owned_cells.push_back(index);
      }
  }



  void
  FiberSystem::check_curvature(const Centerline  &line,
                               const std::string &parameter) const
  {
    if (line.is_straight())
      return;
    const std::vector<unsigned int> active = scene.active_coordinates();
    AssertThrow(active.size() == 2,
                ExcParameter(parameter,
                             "curved",
                             "straight, since the torsion-free formulation can "
                             "bend an initially curved fiber only in a plane "
                             "(set 'coordinates' to two of x, y, z)"));
    const unsigned int off = 3 - active[0] - active[1];
    for (unsigned int i = 0; i < line.positions.size(); ++i)
      AssertThrow(std::abs(line.tangents[i][off]) < line.tangent_tolerance(),
                  ExcParameter(parameter,
                               "curved out of the plane",
                               "in the plane of the active coordinates"));
  }



  void
  FiberSystem::check_distance(const Centerline      &line,
                              const FiberParameters &fiber) const
  {
    // A millionth of a gap changes the forces of steep laws by about 1e-5.
    constexpr double largest = 1e-6;

    const auto check = [&](const std::string &parameter, const double length) {
      if (length <= 0.)
        return;
      const double epsilon = std::numeric_limits<double>::epsilon();
      for (const Tensor<1, 3> &x : line.positions)
        {
          std::ostringstream place, allowed;
          place << x[0] << "; " << x[1] << "; " << x[2];
          allowed << "within " << largest * length / epsilon
                  << " of the origin, since coordinates of that size are "
                     "rounded by "
                  << largest << " of '" << parameter << "', " << length;
          AssertThrow(x.norm() * epsilon <= largest * length,
                      ExcParameter("fibers/" + fiber.name + "/" +
                                     (fiber.mesh_file.empty() ? "centerline" :
                                                                "mesh file"),
                                   place.str(),
                                   allowed.str()));
        }
    };
    check("fibers/" + fiber.name + "/radius", fiber.radius);
    for (const InteractionParameters &interaction : scene.interactions)
      {
        const std::string path = "interactions/" + interaction.name + "/";
        check(path + "equilibrium gap", interaction.equilibrium_gap);
        check(path + "regularization gap", interaction.regularization);
        check(path + "cutoff", interaction.cutoff);
      }
  }



  bool
  FiberSystem::is_rigid(const unsigned int cell) const
  {
    return parameters_of_cell(cell).beam == Rigid::name;
  }



  CellPlace
  FiberSystem::place_of_cell(const unsigned int cell) const
  {
    const Fiber               &fiber = fibers[fiber_of_cell[cell]];
    const std::vector<double> &s     = fiber.arc_length;
    const unsigned int         i     = cell - fiber.first_cell;
    CellPlace                  result;
    result.length = s[i + 1] - s[i];
    if (!fiber.closed)
      {
        result.ends         = {i == 0, i + 1 == fiber.n_cells};
        result.from_left    = s[i];
        result.from_right   = s.back() - s[i + 1];
        result.fiber_length = s.back();
      }
    return result;
  }



  unsigned int
  FiberSystem::distance_along_fiber(const unsigned int cell_1,
                                    const unsigned int cell_2) const
  {
    const Fiber       &fiber = fibers[fiber_of_cell[cell_1]];
    const unsigned int n = cell_1 > cell_2 ? cell_1 - cell_2 : cell_2 - cell_1;
    return fiber.closed ? std::min(n, fiber.n_cells - n) : n;
  }



  std::vector<unsigned int>
  FiberSystem::select(const std::vector<std::string> &names) const
  {
    std::vector<unsigned int> result;
    for (unsigned int f = 0; f < fibers.size(); ++f)
      for (const std::string &name : names)
        if (name == "all" || name == scene.fibers[fibers[f].section].name)
          {
            result.push_back(f);
            break;
          }
    return result;
  }



  std::vector<unsigned int>
  FiberSystem::select(const std::vector<std::string> &names,
                      const std::string              &copies,
                      const std::string              &parameter) const
  {
    std::vector<unsigned int> result;
    for (const unsigned int f : select(names))
      if (copies == "all" ||
          Expression(parameter,
                     copies,
                     "",
                     with_copy(scene.constants, fibers[f].copy))() != 0.)
        result.push_back(f);
    AssertThrow(!result.empty(),
                ExcParameter(parameter,
                             copies,
                             "'all' or a condition in i, j, k that holds for "
                             "at least one of the fibers"));
    return result;
  }



  types::global_dof_index
  FiberSystem::node_dof(const unsigned int fiber,
                        const unsigned int node,
                        const bool         tangent,
                        const unsigned int coordinate) const
  {
    const Fiber       &f       = fibers[fiber];
    const bool         is_left = node < f.n_cells;
    const unsigned int cell    = f.first_cell + (is_left ? node : node - 1);
    const unsigned int shape   = (is_left ? 0 : 2) + (tangent ? 1 : 0);
    return cell_dofs[cell][3 * shape + coordinate];
  }



  Tensor<1, 3>
  FiberSystem::initial_tangent(const unsigned int fiber,
                               const unsigned int node) const
  {
    const Fiber &f       = fibers[fiber];
    const bool   is_left = node < f.n_cells;
    return initial[f.first_cell + (is_left ? node : node - 1)]
      .coefficients[is_left ? 1 : 3];
  }



  std::pair<unsigned int, double>
  FiberSystem::locate(const unsigned int fiber, const double s) const
  {
    const Fiber &f = fibers[fiber];
    const auto   next =
      std::upper_bound(f.arc_length.begin() + 1, f.arc_length.end() - 1, s);
    const unsigned int i = next - f.arc_length.begin() - 1;
    return {f.first_cell + i,
            (s - f.arc_length[i]) / (f.arc_length[i + 1] - f.arc_length[i])};
  }



  State
  FiberSystem::state(const TrilinosWrappers::MPI::Vector &solution,
                     const double                         time) const
  {
    State state;
    state.time         = time;
    state.displacement = initial;
    state.current      = initial;
    for (unsigned int cell = 0; cell < initial.size(); ++cell)
      for (unsigned int a = 0; a < 4; ++a)
        {
          Tensor<1, 3> &u = state.displacement[cell].coefficients[a];
          for (unsigned int c = 0; c < 3; ++c)
            {
              const auto dof = cell_dofs[cell][3 * a + c];
              u[c] = dof == numbers::invalid_dof_index ? 0. : solution(dof);
            }
          state.current[cell].coefficients[a] += u;
        }
    return state;
  }
} // namespace Setae
