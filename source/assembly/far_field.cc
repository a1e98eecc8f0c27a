// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/assembly/far_field.h>
#include <setae/assembly/interaction.h>
#include <setae/laws/multipole.h>

#include <algorithm>
#include <cmath>

namespace Setae
{
  using namespace dealii;

  FarField::FarField(const FiberSystem           &fibers,
                     const InteractionParameters &parameters,
                     const InteractionRoles      &roles,
                     const Quadrature<1>         &rule)
    : fibers(fibers)
    , roles(roles)
    , rule(rule)
    , tolerance(parameters.far_field_tolerance)
    , self_interaction(parameters.self_interaction)
    , n_excluded_neighbors(parameters.n_excluded_neighbors)
    , expansion(point_potential(parameters, {}), order_for(tolerance))
    , skin(parameters.skin)
  {
    std::vector<bool> is_source(fibers.fibers.size(), false),
      is_target(fibers.fibers.size(), false);
    for (const unsigned int f : fibers.select(parameters.source))
      is_source[f] = true;
    for (const unsigned int f : fibers.select(parameters.target))
      is_target[f] = true;

    for (unsigned int f = 0; f < fibers.fibers.size(); ++f)
      {
        const Fiber &fiber = fibers.fibers[f];
        chains.push_back({fiber.first_cell, fiber.n_cells});
        const FiberParameters &section = fibers.parameters[f];
        const SectionPair sections = section_pair(parameters, section, section);
        charge_per_length.push_back(points_per_length(sections.radius_1,
                                                      sections.density_1,
                                                      sections.distribution));
        if (is_source[f] && is_target[f])
          groups[2].push_back(f);
        else if (is_source[f])
          groups[0].push_back(f);
        else if (is_target[f])
          groups[1].push_back(f);
      }

    // A tenth of a cell: longer lists of near pairs against fewer searches.
    if (skin == 0.)
      {
        skin = std::numeric_limits<double>::infinity();
        for (const HermiteCell<> &cell : fibers.initial)
          skin = std::min(skin, .1 * cell.h);
      }
  }



  unsigned int
  FarField::order_for(const double tolerance)
  {
    // Measured: the time is nearly the same for orders around this one, and the
    // matrix of near pairs is small.
    return std::clamp(2 + static_cast<int>(std::ceil(-std::log10(tolerance))),
                      3,
                      12);
  }



  bool
  FarField::needs_rebuild(const State &state) const
  {
    if (reference.size() != state.current.size())
      return true;
    for (unsigned int i = 0; i < reference.size(); ++i)
      {
        const auto points = state.current[i].control_points();
        for (unsigned int k = 0; k < 4; ++k)
          if ((points[k] - reference[i][k]).norm() > .5 * skin)
            return true;
      }
    return false;
  }



  void
  FarField::build(const State &state, const std::vector<unsigned int> &sources)
  {
    reference.clear();
    for (const HermiteCell<> &cell : state.current)
      reference.push_back(cell.control_points());

    tree.clear(reference.size());
    std::array<unsigned int, 3> roots;
    roots.fill(ClusterTree::none);
    for (unsigned int g = 0; g < 3; ++g)
      if (!groups[g].empty())
        roots[g] = tree.add_tree(reference, chains, groups[g]);
    find_powers(state);
    find_owned_clusters();

    const auto is_far = [this](const unsigned int A, const unsigned int B) {
      const ClusterTree::Cluster &a = tree.clusters[A], &b = tree.clusters[B];
      const double                D     = (a.center - b.center).norm();
      const double                radii = a.radius + b.radius + skin;
      return D > radii && !has_excluded_cells(A, B) &&
             expansion.relative_error(powers[A], powers[B], radii, D) <=
               tolerance;
    };
    pairs = {};
    for (const auto &[g, h] : {std::make_pair(0, 1),
                               std::make_pair(0, 2),
                               std::make_pair(1, 2),
                               std::make_pair(2, 2)})
      if (roots[g] != ClusterTree::none && roots[h] != ClusterTree::none)
        tree.find_pairs(roots[g], roots[h], self_interaction, is_far, pairs);

    std::vector<unsigned int> index_of_source(reference.size(),
                                              ClusterTree::none);
    for (unsigned int i = 0; i < sources.size(); ++i)
      index_of_source[sources[i]] = i;
    near.assign(sources.size(), {});
    for (const auto &[A, B] : pairs.near)
      {
        const unsigned int a = tree.clusters[A].begin,
                           b = tree.clusters[B].begin;
        for (const auto &[source, target] :
             {std::make_pair(a, b), std::make_pair(b, a)})
          if (index_of_source[source] != ClusterTree::none &&
              roles.interact(source, target))
            near[index_of_source[source]].push_back(target);
      }
    for (std::vector<unsigned int> &targets : near)
      std::sort(targets.begin(), targets.end());

    // What other ranks compute is no concern of this one any more.
    pairs.far.erase(std::remove_if(pairs.far.begin(),
                                   pairs.far.end(),
                                   [this](const auto &pair) {
                                     return !is_owned[pair.first] &&
                                            !is_owned[pair.second];
                                   }),
                    pairs.far.end());
  }



  bool
  FarField::has_excluded_cells(const unsigned int A, const unsigned int B) const
  {
    const ClusterTree::Cluster &a = tree.clusters[A], &b = tree.clusters[B];
    if (a.chain == ClusterTree::none || a.chain != b.chain)
      return false;
    // The ends of two parts of a fiber are nearest along it.
    for (const unsigned int i : {a.begin, a.end - 1})
      for (const unsigned int j : {b.begin, b.end - 1})
        if (fibers.distance_along_fiber(i, j) <= n_excluded_neighbors)
          return true;
    return false;
  }



  void
  FarField::find_powers(const State &state)
  {
    powers.assign(tree.clusters.size(),
                  std::vector<double>(expansion.order() + 1, 0.));
    std::vector<LineSite> sites;
    for (unsigned int cell = 0; cell < tree.cluster_of_cell.size(); ++cell)
      {
        if (tree.cluster_of_cell[cell] == ClusterTree::none)
          continue;
        evaluate_sites(rule, fibers.initial[cell], state.current[cell], sites);
        const double density =
          std::abs(charge_per_length[fibers.fiber_of_cell[cell]]);
        for (unsigned int i = tree.cluster_of_cell[cell];
             i != ClusterTree::none;
             i = tree.clusters[i].parent)
          for (const LineSite &site : sites)
            {
              const double distance =
                (site.r - tree.clusters[i].center).norm() + .5 * skin;
              double power = density * site.weight;
              for (double &sum : powers[i])
                {
                  sum += power;
                  power *= distance;
                }
            }
      }
  }



  void
  FarField::find_owned_clusters()
  {
    is_owned.assign(tree.clusters.size(), false);
    for (const unsigned int cell : fibers.owned_cells)
      for (unsigned int i = tree.cluster_of_cell[cell];
           i != ClusterTree::none && !is_owned[i];
           i = tree.clusters[i].parent)
        is_owned[i] = true;
  }



  /**
   * The moments of all clusters. @p add_point adds those of a site with a given
   * charge at a given offset from the center of the cell it is on.
   */
  template <typename AddPoint>
  std::vector<double>
  FarField::moments(const std::vector<HermiteCell<>> &cells,
                    const AddPoint                   &add_point) const
  {
    std::vector<double>   result(tree.clusters.size() * expansion.size(), 0.);
    std::vector<LineSite> sites;
    for (unsigned int i = tree.clusters.size(); i-- > 0;)
      {
        const ClusterTree::Cluster &cluster = tree.clusters[i];
        if (cluster.is_cell())
          {
            const unsigned int cell = cluster.begin;
            evaluate_sites(rule, fibers.initial[cell], cells[cell], sites);
            for (const LineSite &site : sites)
              add_point(cell,
                        site,
                        charge_per_length[cluster.chain] * site.weight,
                        Tensor<1, 3>(site.r - cluster.center),
                        of_cluster(result, i));
          }
        if (cluster.parent != ClusterTree::none)
          expansion.shift_moments(cluster.center -
                                    tree.clusters[cluster.parent].center,
                                  of_cluster(result, i),
                                  of_cluster(result, cluster.parent));
      }
    return result;
  }



  /** The local coefficients of all clusters in which this rank has cells. */
  std::vector<double>
  FarField::potential_of(const std::vector<double> &moments) const
  {
    std::vector<double>     result(moments.size(), 0.);
    TaylorExpansion::Kernel kernel;
    for (const auto &[A, B] : pairs.far)
      {
        expansion.evaluate_kernel(tree.clusters[A].center -
                                    tree.clusters[B].center,
                                  kernel);
        if (is_owned[A])
          expansion.interact(kernel,
                             of_cluster(moments, B),
                             of_cluster(result, A));
        if (is_owned[B])
          expansion.interact_reversed(kernel,
                                      of_cluster(moments, A),
                                      of_cluster(result, B));
      }
    for (unsigned int i = 0; i < tree.clusters.size(); ++i)
      if (is_owned[i] && tree.clusters[i].parent != ClusterTree::none)
        expansion.shift_local(tree.clusters[i].center -
                                tree.clusters[tree.clusters[i].parent].center,
                              of_cluster(result, tree.clusters[i].parent),
                              of_cluster(result, i));
    return result;
  }



  double
  FarField::assemble(const State  &state,
                     const double  strength,
                     const Request request,
                     GlobalSystem &system)
  {
    local =
      potential_of(moments(state.current,
                           [this](const unsigned int,
                                  const LineSite &,
                                  const double        charge,
                                  const Tensor<1, 3> &offset,
                                  double             *moments) {
                             expansion.add_charge(charge, offset, moments);
                           }));
    double energy = 0.;
    for (const unsigned int cell : fibers.owned_cells)
      if (tree.cluster_of_cell[cell] != ClusterTree::none)
        energy +=
          add_cell(cell, state.current[cell], strength, request, system);

    if (request >= Request::tangent)
      {
        linearization       = state.current;
        linearized_strength = strength;
      }
    return energy;
  }



  /** @return Half of the energy of the cell in the potential of all others. */
  double
  FarField::add_cell(const unsigned int   cell,
                     const HermiteCell<> &current,
                     const double         strength,
                     const Request        request,
                     GlobalSystem        &system) const
  {
    const unsigned int          i       = tree.cluster_of_cell[cell];
    const ClusterTree::Cluster &cluster = tree.clusters[i];

    LocalSystem<12>       contribution;
    std::vector<LineSite> sites;
    evaluate_sites(rule, fibers.initial[cell], current, sites);
    for (const LineSite &site : sites)
      {
        const double charge =
          strength * charge_per_length[cluster.chain] * site.weight;
        const Tensor<1, 3> a = site.r - cluster.center;
        if (request == Request::energy)
          {
            contribution.energy +=
              .5 * charge * expansion.value(of_cluster(local, i), a);
            continue;
          }
        const auto V = expansion.derivatives(of_cluster(local, i), a);
        contribution.energy += .5 * charge * V.value;
        for (unsigned int b = 0; b < 4; ++b)
          for (unsigned int c = 0; c < 3; ++c)
            contribution.residual[3 * b + c] +=
              charge * site.N[b] * V.gradient[c];
        if (request >= Request::tangent)
          for (unsigned int b = 0; b < 4; ++b)
            for (unsigned int d = 0; d < 4; ++d)
              contribution.add_block(3 * b,
                                     3 * d,
                                     charge * site.N[b] * site.N[d],
                                     V.hessian);
      }
    system.add(cell, contribution);
    return contribution.energy;
  }



  void
  FarField::add_tangent_product(const State &direction, Vector &product) const
  {
    const std::vector<double> change =
      potential_of(moments(linearization,
                           [&](const unsigned int  cell,
                               const LineSite     &site,
                               const double        charge,
                               const Tensor<1, 3> &offset,
                               double             *moments) {
                             expansion.add_moving_charge(
                               charge,
                               offset,
                               direction.displacement[cell].combine(site.N),
                               moments);
                           }));

    std::vector<LineSite>                sites;
    std::vector<types::global_dof_index> dofs;
    std::vector<double>                  values;
    for (const unsigned int cell : fibers.owned_cells)
      {
        const unsigned int i = tree.cluster_of_cell[cell];
        if (i == ClusterTree::none)
          continue;
        evaluate_sites(rule, fibers.initial[cell], linearization[cell], sites);
        const std::vector<Tensor<1, 3>> forces =
          forces_of(change, cell, sites, linearized_strength);
        std::array<double, 12> residual = {};
        for (unsigned int q = 0; q < sites.size(); ++q)
          for (unsigned int b = 0; b < 4; ++b)
            for (unsigned int c = 0; c < 3; ++c)
              residual[3 * b + c] -=
                sites[q].weight * sites[q].N[b] * forces[q][c];

        dofs.clear();
        values.clear();
        for (unsigned int k = 0; k < 12; ++k)
          if (fibers.cell_dofs[cell][k] != numbers::invalid_dof_index)
            {
              dofs.push_back(fibers.cell_dofs[cell][k]);
              values.push_back(residual[k]);
            }
        product.add(dofs, values);
      }
  }



  std::vector<Tensor<1, 3>>
  FarField::site_forces(const unsigned int           cell,
                        const std::vector<LineSite> &sites,
                        const double                 strength) const
  {
    return forces_of(local, cell, sites, strength);
  }



  /** Forces per length in the potential of the coefficients @p local. */
  std::vector<Tensor<1, 3>>
  FarField::forces_of(const std::vector<double>   &local,
                      const unsigned int           cell,
                      const std::vector<LineSite> &sites,
                      const double                 strength) const
  {
    const unsigned int        i = tree.cluster_of_cell[cell];
    std::vector<Tensor<1, 3>> result(sites.size());
    if (i == ClusterTree::none)
      return result;
    const ClusterTree::Cluster &cluster = tree.clusters[i];
    for (unsigned int q = 0; q < sites.size(); ++q)
      result[q] =
        -strength * charge_per_length[cluster.chain] *
        expansion.derivatives(of_cluster(local, i), sites[q].r - cluster.center)
          .gradient;
    return result;
  }
} // namespace Setae
