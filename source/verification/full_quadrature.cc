// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/timer.h>

#include <setae/interactions/double_sum.h>
#include <setae/verification/full_quadrature.h>

#include <cmath>
#include <limits>
#include <map>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    /** Collects energy, and force and moment on the sources. */
    class ResultantSum
    {
    public:
      DEAL_II_ALWAYS_INLINE void
      begin(const SolidSite &)
      {
        e = Lanes{};
        for (Lanes &component : f)
          component = Lanes{};
      }

      DEAL_II_ALWAYS_INLINE bool
      accepts(const Lanes &) const
      {
        return true;
      }

      DEAL_II_ALWAYS_INLINE void
      add(const SolidSite &,
          const SolidSites           &target,
          const std::array<Lanes, 3> &d,
          const Lanes &,
          const PointLaw::Derivatives<Lanes> &phi)
      {
        e += target.weight * phi.value;
        const Lanes slope = target.weight * phi.first_over_r;
        for (unsigned int c = 0; c < 3; ++c)
          f[c] -= slope * d[c];
      }

      DEAL_II_ALWAYS_INLINE void
      end(const SolidSite &source)
      {
        energy += source.weight * e;
        for (unsigned int c = 0; c < 3; ++c)
          {
            f[c] *= source.weight;
            force[c] += f[c];
          }
        moment[0] += source.y * f[2] - source.z * f[1];
        moment[1] += source.z * f[0] - source.x * f[2];
        moment[2] += source.x * f[1] - source.y * f[0];
      }

      /** Over all lanes and ranks. */
      SolidResultant
      result(const MPI_Comm communicator) const
      {
        SolidResultant total;
        total.energy = Utilities::MPI::sum(sum(energy), communicator);
        for (unsigned int c = 0; c < 3; ++c)
          {
            total.force[c]  = Utilities::MPI::sum(sum(force[c]), communicator);
            total.moment[c] = Utilities::MPI::sum(sum(moment[c]), communicator);
          }
        return total;
      }

    private:
      Lanes                energy = {};
      std::array<Lanes, 3> force  = {};
      std::array<Lanes, 3> moment = {};

      // Of the present source, per its weight.
      Lanes                e = {};
      std::array<Lanes, 3> f = {};
    };



    SETAE_FOR_EVERY_PROCESSOR
    void
    add_all_pairs(const std::vector<SolidSite>  &sources,
                  const std::vector<SolidSites> &targets,
                  const PointLaw                &law,
                  ResultantSum                  &total)
    {
      ResultantSum sum = total;
      double_sum(sources, targets, law, sum);
      total = sum;
    }



    /** The sites of the nodes of a body for each number of points, once used.
     */
    class SiteCache
    {
    public:
      explicit SiteCache(const SolidBody &body)
        : body(body)
      {}

      const std::vector<SolidSites> &
      operator()(const unsigned int node, const unsigned int n_points)
      {
        auto &of_nodes = sites[n_points];
        of_nodes.resize(body.nodes().size());
        auto &of_node = of_nodes[node];
        if (of_node.empty())
          of_node = body.sites(body.nodes()[node], n_points);
        return of_node;
      }

    private:
      const SolidBody                                             &body;
      std::map<unsigned int, std::vector<std::vector<SolidSites>>> sites;
    };



    /** The pairs of nodes over which a quadrature runs. */
    class NodePairs
    {
    public:
      NodePairs(SolidBody &first, SolidBody &second, const double min_ratio)
        : first(first)
        , second(second)
        , min_ratio(min_ratio)
      {}

      /**
       * Refine both meshes until they have no pair of cells that is too close.
       *
       * @return Whether @p max_n_cells sufficed.
       */
      bool
      refine(const double max_n_cells)
      {
        for (;;)
          {
            std::vector<bool> marked_1(first.nodes().size()),
              marked_2(second.nodes().size());
            bool is_complete = true;
            for_each([](const unsigned int,
                        const unsigned int,
                        const double) {},
                     [&](const unsigned int a, const unsigned int b) {
                       // Nearly equal cells both, or else the larger one.
                       const double extent_1 = first.nodes()[a].extent,
                                    extent_2 = second.nodes()[b].extent;
                       if (extent_1 > .7 * extent_2)
                         marked_1[a] = true;
                       if (extent_2 > .7 * extent_1)
                         marked_2[b] = true;
                       is_complete = false;
                     });
            if (is_complete)
              return true;
            if (n_cells() > max_n_cells)
              return false;
            first.refine(marked_1);
            second.refine(marked_2);
          }
      }

      double
      n_cells() const
      {
        return double(first.mesh().n_global_active_cells()) +
               double(second.mesh().n_global_active_cells());
      }

      /** The number of pairs of points with @p n_points in the closest cells. */
      double
      count(const unsigned int n_points) const
      {
        double n = 0.;
        for_each_separated([&](const unsigned int a,
                               const unsigned int b,
                               const double       distance) {
          n += n_sites(first, a, distance, n_points) *
               n_sites(second, b, distance, n_points);
        });
        return n;
      }

      SolidResultant
      sum(const unsigned int n_points, const PointLaw &law) const
      {
        const unsigned int rank =
          Utilities::MPI::this_mpi_process(first.communicator);
        SiteCache              sites_1(first), sites_2(second);
        std::vector<SolidSite> sources;
        ResultantSum           sum;
        for_each_separated([&](const unsigned int a,
                               const unsigned int b,
                               const double       distance) {
          if (first.nodes()[a].owner != rank)
            return;
          sources.clear();
          for (const SolidSites &block :
               sites_1(a, order(first, a, distance, n_points)))
            for (unsigned int l = 0; l < n_lanes; ++l)
              if (block.weight[l] != 0.)
                sources.push_back(
                  {block.x[l], block.y[l], block.z[l], block.weight[l]});
          add_all_pairs(sources,
                        sites_2(b, order(second, b, distance, n_points)),
                        law,
                        sum);
        });
        return sum.result(first.communicator);
      }

    private:
      /**
       * By which factor e^x the error of Gauss quadrature over an interval of
       * length one falls with two more points, if the integrand is singular at
       * @p ratio beside it: 2 ratio + sqrt(4 ratio^2 + 1), the sum of the
       * half-axes of the ellipse around [-1, 1] through 2i ratio.
       */
      static double
      rate(const double ratio)
      {
        return std::asinh(2. * ratio);
      }

      /**
       * As many points as have the same error as @p n_points close by. Not less
       * than two fewer, so that no pair is without influence on the changes
       * from which the error is estimated.
       */
      unsigned int
      order(const SolidBody   &body,
            const unsigned int node,
            const double       distance,
            const unsigned int n_points) const
      {
        const double ratio = distance / body.nodes()[node].extent;
        const double equal = n_points * rate(min_ratio) / rate(ratio);
        return std::max({1., n_points - 2., std::ceil(equal - 1e-6)});
      }

      double
      n_sites(const SolidBody   &body,
              const unsigned int node,
              const double       distance,
              const unsigned int n_points) const
      {
        const double n = order(body, node, distance, n_points);
        return body.distribution == Distribution::volume ? n * n * n : n * n;
      }

      template <typename Function>
      void
      for_each_separated(const Function &function) const
      {
        for_each(function, [](const unsigned int, const unsigned int) {
          Assert(false, ExcInternalError());
        });
      }

      template <typename Separated, typename TooClose>
      void
      for_each(const Separated &separated, const TooClose &too_close) const
      {
        for (unsigned int a = 0; a < first.n_roots(); ++a)
          for (unsigned int b = 0; b < second.n_roots(); ++b)
            visit(a, b, separated, too_close);
      }

      /** Go down to the highest pair that is separated, or to active cells. */
      template <typename Separated, typename TooClose>
      void
      visit(const unsigned int a,
            const unsigned int b,
            const Separated   &separated,
            const TooClose    &too_close) const
      {
        const SolidBody::Node &node_1 = first.nodes()[a];
        const SolidBody::Node &node_2 = second.nodes()[b];
        if (!first.is_populated(node_1) || !second.is_populated(node_2))
          return;

        const double distance = separation(node_1, node_2);
        if (distance >= min_ratio * std::max(node_1.extent, node_2.extent))
          separated(a, b, distance);
        else if (!node_1.is_active() &&
                 (node_1.extent >= node_2.extent || node_2.is_active()))
          for (unsigned int c = 0; c < 8; ++c)
            visit(node_1.first_child + c, b, separated, too_close);
        else if (!node_2.is_active())
          for (unsigned int c = 0; c < 8; ++c)
            visit(a, node_2.first_child + c, separated, too_close);
        else
          too_close(a, b);
      }

      SolidBody   &first, &second;
      const double min_ratio;
    };
  } // namespace



  FullQuadrature
  full_quadrature(SolidBody                      &first,
                  SolidBody                      &second,
                  const PointLaw                 &law,
                  const FullQuadratureParameters &parameters)
  {
    FullQuadrature result;
    Timer          timer(first.communicator, true);
    NodePairs      pairs(first, second, parameters.separation);
    const bool     is_refined   = pairs.refine(parameters.max_n_cells);
    double         change       = std::numeric_limits<double>::infinity();
    double         force_change = change;
    for (unsigned int n = 2; is_refined && n <= parameters.max_n_points &&
                             result.error > parameters.tolerance;
         ++n)
      {
        const double n_pairs = pairs.count(n);
        if (result.n_pairs + n_pairs > parameters.max_n_pairs)
          break;
        const SolidResultant previous = result.value;
        result.value                  = pairs.sum(n, law);
        result.n_points               = n;
        result.n_pairs += n_pairs;
        if (n == 2)
          continue;

        const double last_change = change, last_force_change = force_change;
        change       = std::abs((result.value.energy - previous.energy) /
                          result.value.energy);
        force_change = (result.value.force - previous.force).norm() /
                       result.value.force.norm();
        result.error       = std::max(change, .25 * last_change);
        result.force_error = std::max(force_change, .25 * last_force_change);
      }
    result.n_cells = pairs.n_cells();
    timer.stop();
    result.cpu_time = timer.cpu_time();
    return result;
  }
} // namespace Setae
