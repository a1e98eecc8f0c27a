// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>

#include <setae/assembly/load.h>
#include <setae/base/exceptions.h>

#include <algorithm>
#include <sstream>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    bool
    is_given(std::string moment)
    {
      moment.erase(std::remove(moment.begin(), moment.end(), ' '),
                   moment.end());
      return moment != "0;0;0";
    }
  } // namespace



  Load::Load(const FiberSystem &fibers, const LoadParameters &parameters)
    : fibers(fibers)
    , parameters(parameters)
    , has_moment(is_given(parameters.moment))
  {
    const std::string path = "loads/" + parameters.name + "/";
    const bool        is_common =
      !depends_on_copy(parameters.force + parameters.moment);
    for (const unsigned int fiber :
         fibers.select(parameters.fibers, parameters.copies, path + "copies"))
      {
        if (forces.empty() || !is_common)
          {
            const Constants constants =
              with_copy(fibers.scene.constants, fibers.fibers[fiber].copy);
            forces.emplace_back(path + "force",
                                parameters.force,
                                "s,t",
                                constants);
            moments.emplace_back(path + "moment",
                                 parameters.moment,
                                 "s,t",
                                 constants);
          }
        for (const std::string &place : parameters.at)
          if (place == "all")
            collect_line(fiber);
          else
            collect_point(fiber, place);
      }
    std::sort(sites.begin(), sites.end(), [](const Site &a, const Site &b) {
      return a.cell < b.cell;
    });
  }



  void
  Load::collect_line(const unsigned int fiber)
  {
    const QGauss<1> rule(4);
    const Fiber    &f = fibers.fibers[fiber];
    for (unsigned int i = 0; i < f.n_cells; ++i)
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const double       x    = rule.point(q)[0];
          const unsigned int cell = f.first_cell + i;
          if (std::binary_search(fibers.owned_cells.begin(),
                                 fibers.owned_cells.end(),
                                 cell))
            sites.push_back(
              {cell,
               x,
               f.arc_length[i] + x * (f.arc_length[i + 1] - f.arc_length[i]),
               rule.weight(q) * fibers.initial[cell].derivative(x).norm(),
               static_cast<unsigned int>(forces.size() - 1)});
        }
  }



  void
  Load::collect_point(const unsigned int fiber, const std::string &place)
  {
    const double end = fibers.fibers[fiber].arc_length.back();
    const double s =
      place == "start" ? 0. :
      place == "end"   ? end :
                         Expression("loads/" + parameters.name + "/at",
                                  place,
                                  "",
                                  with_copy(fibers.scene.constants,
                                            fibers.fibers[fiber].copy))();
    std::ostringstream length;
    length << end;
    AssertThrow(s >= 0. && s <= end * (1. + 1e-12),
                ExcParameter("loads/" + parameters.name + "/at",
                             place,
                             "at least 0 and at most the length " +
                               length.str()));
    const auto [cell, x] = fibers.locate(fiber, s);
    if (!first_point)
      first_point = {cell, x};
    if (std::binary_search(fibers.owned_cells.begin(),
                           fibers.owned_cells.end(),
                           cell))
      sites.push_back(
        {cell, x, s, 1., static_cast<unsigned int>(forces.size() - 1)});
  }



  Tensor<1, 3>
  Load::displacement(const State &state) const
  {
    Assert(has_point(), dealii::ExcInternalError());
    return state.displacement[first_point->first].position(first_point->second);
  }



  double
  Load::assemble(const State  &state,
                 const Request request,
                 GlobalSystem &system)
  {
    double          energy = 0.;
    LocalSystem<12> local;
    for (unsigned int i = 0; i < sites.size();)
      {
        const unsigned int cell = sites[i].cell;
        local.reset(request);
        for (; i < sites.size() && sites[i].cell == cell; ++i)
          add_site(sites[i], state, request, local);
        energy += local.energy;
        system.add(cell, local);
      }
    return energy;
  }



  void
  Load::add_external_work(const State               &state,
                          std::vector<ExternalWork> &work) const
  {
    for (const Site &site : sites)
      {
        const HermiteCell<> &cell = state.current[site.cell];
        const Tensor<1, 3>   u = state.displacement[site.cell].position(site.x);
        const Tensor<1, 3>   a = cell.derivative(site.x);
        const Tensor<1, 3>   f =
          forces[site.formula](site.arc_length, state.time);
        const Tensor<1, 3> m =
          moments[site.formula](site.arc_length, state.time);
        const Tensor<1, 3> on_a = cross_product_3d(m, a) / (a * a);
        for (unsigned int c = 0; c < 3; ++c)
          {
            work.push_back({-site.weight * u[c], f[c]});
            work.push_back({site.weight * on_a[c], a[c]});
          }
      }
  }



  void
  Load::add_site(const Site      &site,
                 const State     &state,
                 const Request    request,
                 LocalSystem<12> &local) const
  {
    const HermiteCell<> &cell = state.current[site.cell];
    const auto           N    = Hermite::shape_values(site.x, cell.h);
    const auto           N_x  = Hermite::shape_derivatives(site.x, cell.h);
    const Tensor<1, 3>   f =
      site.weight * forces[site.formula](site.arc_length, state.time);
    const Tensor<1, 3> m =
      site.weight * moments[site.formula](site.arc_length, state.time);

    // The force on r,x: p = m x a / A with A = a.a, and its derivative.
    const Tensor<1, 3> a       = cell.combine(N_x);
    const double       A       = a * a;
    const Tensor<1, 3> m_cross = cross_product_3d(m, a);
    const Tensor<1, 3> p       = m_cross / A;

    local.energy -= f * state.displacement[site.cell].combine(N);
    if (request < Request::residual)
      return;
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int c = 0; c < 3; ++c)
        local.residual[3 * i + c] -= N[i] * f[c] + N_x[i] * p[c];
    if (request < Request::tangent)
      return;

    Tensor<2, 3> p_a = (-2. / A) * outer_product(p, a);
    p_a[0][1] -= m[2] / A;
    p_a[0][2] += m[1] / A;
    p_a[1][0] += m[2] / A;
    p_a[1][2] -= m[0] / A;
    p_a[2][0] -= m[1] / A;
    p_a[2][1] += m[0] / A;
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int j = 0; j < 4; ++j)
        for (unsigned int c = 0; c < 3; ++c)
          for (unsigned int e = 0; e < 3; ++e)
            local.tangent[3 * i + c][3 * j + e] -= N_x[i] * N_x[j] * p_a[c][e];
  }
} // namespace Setae
